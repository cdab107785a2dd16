// The lists that the header opens below its buttons: number formats, and a method's variants with their quirks.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/screen_parts.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kFormats = "Number format", kOverflow = "Where a result leaves the range",
                           kFloorProducts = "Products round down", kVariants = "Variant", kMethod = "Method",
                           kQuirks = "Quirks";
constexpr std::string_view kFloorTip = "A product's shift rounds down, so that (−a) b differs from −(a b)";
constexpr std::array<std::string_view, 3> kPolicies{"mark", "saturate", "wrap"};
constexpr std::array<std::string_view, 3> kPolicyTips{"Go on with the true value in 64 bits, and mark it",
                                                      "The nearest value inside the range, marked",
                                                      "Modulo the range, as the processor does it, marked"};
constexpr std::string_view kHeaderListVariantTip = "Sets every quirk as this variant has it";

/// A list below its button, over the panels.
class DropPanel {
public:
    DropPanel(const ViewContext& c, Area area) : ui_(c.ui), pad_(c.ui.px(10)) {
        ui_.begin_panel("drop", area, {}, {}, ui_.theme().panel);
        static_cast<void>(ui_.control({"drop/ground", area, ui::Kind::region, "list", {}, false, false}));
        content_ = ui_.begin_scroll("drop/scroll", area.inset(pad_, pad_));
        y_ = content_.y;
        area_ = area;
    }
    DropPanel(const DropPanel&) = delete;
    DropPanel& operator=(const DropPanel&) = delete;
    ~DropPanel() {
        ui_.end_scroll(y_ - content_.y);
        ui::frame(ui_.list(), area_, ui_.theme()[Role::faint]);
        ui_.end_panel();
    }

    [[nodiscard]] Area row(float height) {
        const Area area{content_.x, y_, content_.w, height};
        y_ += height;
        return area;
    }
    void heading(std::string_view text) {
        const Area area = row(ui_.px(24));
        ui_.text_within(Face::title, {area.x, ui::baseline_at_middle(ui_.font(Face::title), area.centre().y)}, area.w,
                        Role::muted, text);
    }
    /// A row to choose or turn over: a mark, a name, and what it means.
    [[nodiscard]] bool entry(std::string_view name, std::string_view label, std::string_view note, std::string_view tip,
                             bool on, bool many) {
        const Area area = row(ui_.px(28));
        const ui::Control control = ui_.control({name, area, many ? ui::Kind::toggle : ui::Kind::choice, label, tip});
        if (control.hovered) ui::frame(ui_.list(), area, ui_.theme()[Role::now], 1, ui::size::kRadius);
        if (on && !many) ui::current_row(ui_, area);
        const ui::Color ground = on && !many
                                     ? ui::over(ui_.theme()[Role::now], ui::alpha::kChosenRow, ui_.theme().panel)
                                     : ui_.theme().panel;
        ui_.set_ground(ground);
        float x = area.x + ui_.px(10);
        if (many) {
            const float side = ui_.px(14);
            const Area box{x, std::round(area.centre().y - side / 2), side, side};
            if (on)
                ui::fill(ui_.list(), box, ui_.theme()[Role::now], ui::size::kBadgeRadius);
            else
                ui::frame(ui_.list(), box, ui_.theme()[Role::muted], 1, ui::size::kBadgeRadius);
            if (on) ui::draw_icon(ui_.list(), ui::Icon::tick, box, ui_.theme()[Role::on_now]);
            x += side + ui_.px(8);
        }
        const Face face = many ? Face::title : Face::code_note;
        const float baseline = ui::baseline_at_middle(ui_.font(face), area.centre().y),
                    right = area.right() - ui_.px(8);
        x += ui_.text_within(face, {x, baseline}, right - x, Role::text, label);
        if (!note.empty()) {
            x = std::max(x + ui_.px(10), area.x + ui_.px(84));
            ui_.text_within(Face::note, {x, baseline}, right - x, Role::muted, note);
        }
        ui_.set_ground(ui_.theme().panel);
        return control.clicked;
    }
    [[nodiscard]] ui::Ui& ui() { return ui_; }
    void space() { y_ += ui_.px(8); }

private:
    ui::Ui& ui_;
    Area area_, content_;
    float pad_ = 0, y_ = 0;
};

void draw_formats(const ViewContext& c, DropPanel& drop) {
    drop.heading(kFormats);
    for (const NumberFormatInfo& info : kNumberFormats) {
        if (drop.entry(fmt::format("format/{}", info.id), info.id, info.title, info.title,
                       c.state.work.format == info.format, false))
            c.act(action::SetFormat{info.format});
    }
    if (c.state.work.format != NumberFormat::fx16_16 && c.state.work.format != NumberFormat::fx8_8) return;
    drop.space();
    drop.heading(kOverflow);
    NumberMode mode = c.state.work.mode;
    if (const auto chosen = ui::segments(drop.ui(), "overflow", drop.row(drop.ui().px(28)), kPolicies,
                                         static_cast<int>(mode.overflow), kPolicyTips, Face::title)) {
        mode.overflow = static_cast<Overflow>(*chosen);
        c.act(action::SetMode{mode});
    }
    drop.space();
    if (drop.entry("floor-products", kFloorProducts, {}, kFloorTip, mode.floor_products, true)) {
        mode.floor_products = !mode.floor_products;
        c.act(action::SetMode{mode});
    }
}

void draw_quirks(const ViewContext& c, DropPanel& drop) {
    const Method& method = c.derived.method();
    if (!c.state.document->lesson && methods().size() > 1) {
        drop.heading(kMethod);
        for (const Method* other : methods()) {
            if (drop.entry(fmt::format("method/{}", other->id), other->title, other->source, other->title,
                           other == &method, false))
                c.act(action::SetMethod{std::string(other->id)});
        }
        drop.space();
    }
    drop.heading(kVariants);
    for (const VariantInfo& variant : method.variants) {
        if (drop.entry(fmt::format("variant/{}", variant.id), spaced(variant.id), {}, kHeaderListVariantTip,
                       c.state.work.variant == variant.id, false))
            c.act(action::SetVariant{std::string(variant.id)});
    }
    if (method.quirks.empty()) return;
    drop.space();
    drop.heading(kQuirks);
    for (std::size_t n = 0; n < method.quirks.size(); ++n) {
        const QuirkInfo& quirk = method.quirks[n];
        const bool on = (c.state.work.quirks >> n & 1U) != 0;
        if (drop.entry(fmt::format("quirk/{}", quirk.field), quirk.title, {}, quirk.sentence, on, true))
            c.act(action::SetQuirk{static_cast<int>(n), !on});
    }
}

/// Rows and headings of the list, to know how high it wants to be [px at 100 %].
[[nodiscard]] float list_height(const ViewContext& c) {
    constexpr float kRow = 28, kHeading = 24, kGap = 8, kBorder = 20;
    if (c.state.overlay == Overlay::formats) {
        const bool fixed = c.state.work.format == NumberFormat::fx16_16 || c.state.work.format == NumberFormat::fx8_8;
        return kBorder + kHeading + kRow * 5 + (fixed ? kHeading + 2 * kRow + 2 * kGap : 0);
    }
    const Method& method = c.derived.method();
    const auto rows = static_cast<float>(method.variants.size() + method.quirks.size());
    const bool choice = !c.state.document->lesson && methods().size() > 1;
    return kBorder + 2 * kHeading + kGap + kRow * rows +
           (choice ? kHeading + kGap + kRow * static_cast<float>(methods().size()) : 0);
}

}  // namespace

void draw_header_list(const ViewContext& c, const ScreenLayout& layout) {
    if (!c.state.document || (c.state.overlay != Overlay::formats && c.state.overlay != Overlay::quirks)) return;
    ui::Ui& ui = c.ui;
    const Area button = header_button(ui, layout.header, c.state.overlay);
    const float width = std::min(ui.px(320), c.ui.input().size.x - 8), top = layout.header.bottom() + ui.px(4);
    const float height = std::min(std::round(list_height(c) * ui.fonts().spec().scale * (ui.presenting() ? 2 : 1)),
                                  layout.timeline.y - top - 8);
    const float x = std::clamp(button.right() - width, 4.0F, std::max(4.0F, c.ui.input().size.x - width - 4));
    DropPanel drop(c, {std::round(x), top, width, height});
    if (c.state.overlay == Overlay::formats)
        draw_formats(c, drop);
    else
        draw_quirks(c, drop);
}

}  // namespace texelscope
