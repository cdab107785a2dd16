// Two methods over one scene: their pictures beside each other, and each pixel that differs with the reason why.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_map.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"

namespace texelscope::canvas {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Difference", kAgainst = "against {}";
constexpr std::string_view kNothing = "There is no shape, so no two pictures to compare.";
constexpr std::string_view kPrevious = "previous method", kNext = "next method",
                           kTip = "Compares with another method, run as its source meant it.";
constexpr std::string_view kMap = "what differs";
constexpr std::string_view kEqual = "both read the same texel everywhere";
constexpr std::string_view kPixelTip = "pixel **{}, {}**: {}", kApart = ", {} apart in $u$, {} in $v$";
constexpr float kMarksFrom = 5;  ///< window pixels per pixel: from here each pixel has its cause's mark

struct CauseInfo {
    Cause cause;
    Role role;
    std::string_view name, says;
};
constexpr std::array<CauseInfo, 4> kShown{{
    {Cause::coverage, Role::error, "coverage", "only one of them draws it"},
    {Cause::rounding, Role::section_1, "rounding", "the same place, rounded to two sides of a texel's border"},
    {Cause::offset, Role::section_2, "offset", "as far apart as everywhere on this face"},
    {Cause::warp, Role::section_3, "warp", "farther apart here than elsewhere on this face"},
}};

[[nodiscard]] const CauseInfo* info_of(Cause cause) {
    const auto at = std::find_if(kShown.begin(), kShown.end(), [=](const CauseInfo& i) { return i.cause == cause; });
    return at == kShown.end() ? nullptr : &*at;
}

/// The methods that the state's own can be compared with.
[[nodiscard]] std::vector<const Method*> others(const Derived& derived) {
    std::vector<const Method*> found;
    for (const Method* method : methods())
        if (method != &derived.method()) found.push_back(method);
    return found;
}

[[nodiscard]] Rgba rgba(ui::Color c) {
    const auto byte = [c](unsigned shift) { return static_cast<std::uint8_t>(c >> shift & 0xFFU); };
    return {byte(0), byte(8), byte(16), 255};
}

/// Each cause has a shape of its own: cross, dot, bar, two strokes.
void draw_mark(ImDrawList& list, Cause cause, const ui::Area& at, ui::Color color) {
    const glm::vec2 c = at.centre();
    const float r = at.w / 4, width = std::max(1.0F, at.w / 9);
    switch (cause) {
        case Cause::coverage: return ui::cross(list, c, r, width, color);
        case Cause::rounding: return list.AddCircleFilled(ui::to_im(c), r * .8F, color, 8);
        case Cause::offset: return ui::line(list, {c.x - r, c.y}, {c.x + r, c.y}, width, color);
        case Cause::warp:
            ui::line(list, {c.x - r, c.y}, {c.x, c.y - r}, width, color);
            return ui::line(list, {c.x, c.y + r}, {c.x + r, c.y}, width, color);
        default: return;
    }
}

class DifferenceView {
public:
    DifferenceView(const ViewContext& ctx, const ui::Area& area) : ctx_(ctx), ui_(ctx.ui), area_(area) {}

    /// Where there is no room for the pictures above their legend, all can be scrolled.
    void draw_scrolled() {
        const float content = std::max(area_.h, bar_height() + legend_height() + 3 * line() + ui_.px(72));
        foresee(ui_, "difference/scroll", content);
        const ui::Area inner = ui_.begin_scroll("difference/scroll", area_);
        area_ = {inner.x, inner.y, inner.w, content};
        draw();
        ui_.end_scroll(content);
    }

private:
    void draw() {
        const std::vector<const Method*> all = others(ctx_.derived);
        auto at = std::find_if(all.begin(), all.end(), [&](const Method* m) { return m->id == ctx_.state.look.other; });
        if (at == all.end()) at = all.begin();
        const float bar = bar_height();
        draw_choice({area_.x, area_.y, area_.w, bar}, all, at - all.begin());
        const float legend = legend_height();
        const ui::Area pictures{area_.x, area_.y + bar, area_.w, std::max(1.0F, area_.h - bar - legend)};
        draw_pictures(pictures, **at);
        draw_legend({area_.x, pictures.bottom(), area_.w, legend});
    }

    [[nodiscard]] float bar_height() const { return std::max(ui_.px(28), pitch(ui_, 24, ui::Face::title)); }
    [[nodiscard]] float line() const { return pitch(ui_, 18, ui::Face::title); }
    [[nodiscard]] float legend_width() const {
        float widest = 0;
        for (const CauseInfo& cause : kShown)
            widest = std::max(widest, ui::text_width(ui_.font(ui::Face::title), cause.name));
        return widest + ui_.px(34) + ui::text_width(ui_.font(ui::Face::code), "00000");
    }
    [[nodiscard]] int legend_columns() const {
        return std::clamp(static_cast<int>(area_.w / legend_width()), 1, static_cast<int>(kShown.size()));
    }
    [[nodiscard]] float legend_height() const {
        const int columns = legend_columns(), rows = (static_cast<int>(kShown.size()) + columns - 1) / columns;
        return static_cast<float>(rows) * line() + ui_.px(4);
    }

    void draw_choice(const ui::Area& bar, const std::vector<const Method*>& all, std::ptrdiff_t now) {
        const float side = std::min(ui_.px(24), bar.h);
        const auto button = [&](float x, ui::Icon icon, std::string_view name, std::string_view label) {
            const std::string full = fmt::format("difference/{}", name);
            const ui::Area place{x, bar.y + std::floor((bar.h - side) / 2), side, side};
            return ui::icon_button(ui_, full, place, icon, label, kTip, {.quiet = true}).clicked;
        };
        const auto count = static_cast<std::ptrdiff_t>(all.size());
        std::ptrdiff_t chosen = now;
        if (button(bar.x, ui::Icon::previous, "previous", kPrevious)) chosen = (now + count - 1) % count;
        if (button(bar.x + side + ui_.px(4), ui::Icon::next, "next", kNext)) chosen = (now + 1) % count;
        if (chosen != now) {
            Look look = ctx_.state.look;
            look.other = all[static_cast<std::size_t>(chosen)]->id;
            ctx_.act(action::SetLook{look});
        }
        const float x = bar.x + 2 * side + ui_.px(12);
        ui_.text_within(ui::Face::title, {x, ui::baseline_at_middle(ui_.font(ui::Face::title), bar.centre().y)},
                        bar.right() - x, Role::text, fmt::format(kAgainst, all[static_cast<std::size_t>(now)]->title));
    }

    /// Three pictures, as large as they can be: beside each other, or below.
    void draw_pictures(const ui::Area& area, const Method& other) {
        const Framebuffer& frame = ctx_.derived.scene().framebuffer;
        const float gap = ui_.px(8), caption = line();
        const ui::Area beside{0, 0, (area.w - 2 * gap) / 3, area.h - caption},
            below{0, 0, area.w, (area.h - 2 * gap) / 3 - caption};
        const bool row = fit_zoom(beside, frame) >= fit_zoom(below, frame);
        const ui::Area size = row ? beside : below;
        if (size.w < 8 || size.h < 8) return;
        const std::array<std::string_view, 3> titles{ctx_.derived.method().title, other.title, kMap};
        for (int n = 0; n < 3; ++n) {
            const float step = static_cast<float>(n);
            const glm::vec2 at = row ? glm::vec2(area.x + step * (size.w + gap), area.y)
                                     : glm::vec2(area.x, area.y + step * (size.h + caption + gap));
            const ui::Font& font = ui_.font(ui::Face::title);
            ui_.text_within(ui::Face::title, {at.x, ui::baseline_at_middle(font, at.y + caption / 2)}, size.w,
                            Role::muted, titles[static_cast<std::size_t>(n)]);
            const CanvasMap map = make_map({at.x, at.y + caption, size.w, size.h}, frame, Look{});
            difference_ = &ctx_.derived.difference(window_in_view(map, frame), other);
            draw_picture(map, n);
        }
    }

    [[nodiscard]] Rgba shown(const DifferenceCell& cell, int picture) const {
        if (cell.cause == Cause::nothing) return {0, 0, 0, 0};
        if (picture < 2) {
            const Rgb c = picture == 0 ? cell.own : cell.others;
            return {c.r, c.g, c.b, 255};
        }
        const CauseInfo* info = info_of(cell.cause);
        const ui::Theme& theme = ui_.theme();
        return rgba(info != nullptr ? theme[info->role] : ui::over(theme[Role::covered], .3F, theme.canvas));
    }

    void draw_picture(const CanvasMap& map, int picture) {
        const Grid<DifferenceCell>& cells = difference_->cells;
        if (cells.width() < 1 || cells.height() < 1) return;
        const Window& w = difference_->window;
        Grid<Rgba> pixels(cells.width(), cells.height());
        std::transform(cells.data(), cells.data() + cells.size(), pixels.data(),
                       [&](const DifferenceCell& cell) { return shown(cell, picture); });
        const Rect all{w.rect.x0, w.rect.y0, w.rect.x0 + cells.width() * w.stride,
                       w.rect.y0 + cells.height() * w.stride};
        const ui::Area at = map.place_of(all);
        const std::string key = fmt::format("difference/{}", picture);
        const ImTextureID image = ctx_.textures.image(ui::id_of(key), version_of(pixels), pixels);
        ui_.begin_clip(map.area);
        ui_.list().AddImage(image, {at.x, at.y}, {at.right(), at.bottom()});
        ui::frame(ui_.list(), at, ui_.theme().hairline);
        if (picture == 2 && map.zoom * w.stride >= double{kMarksFrom}) draw_marks(map);
        take_pixel(map, key);
        if (const auto pixel = ctx_.derived.pixel())
            ui::pixel_ring(ui_.list(), ui::grown_to(map.place_of(*pixel), 4), ui_.theme()[Role::now],
                           ui_.theme().outline, 1.5F, 1);
        ui_.end_clip();
    }
    void draw_marks(const CanvasMap& map) {
        const Window& w = difference_->window;
        for (int y = 0; y < difference_->cells.height(); ++y)
            for (int x = 0; x < difference_->cells.width(); ++x) {
                const glm::ivec2 pixel(w.rect.x0 + x * w.stride, w.rect.y0 + y * w.stride);
                draw_mark(ui_.list(), difference_->cells.at(x, y).cause, map.place_of(pixel), ui_.theme().outline);
            }
    }
    void take_pixel(const CanvasMap& map, const std::string& name) {
        const Window& w = difference_->window;
        const glm::ivec2 pixel = map.pixel_at(ui_.input().mouse);
        const bool on = map.area.contains(ui_.input().mouse) && w.rect.contains(pixel.x, pixel.y);
        std::string tip;
        if (on) {
            const DifferenceCell& cell =
                difference_->cells.at((pixel.x - w.rect.x0) / w.stride, (pixel.y - w.rect.y0) / w.stride);
            const CauseInfo* info = info_of(cell.cause);
            if (info != nullptr) tip = fmt::format(kPixelTip, pixel.x, pixel.y, info->says);
            if (info != nullptr && cell.cause != Cause::coverage)
                tip += fmt::format(kApart, ui::format_number(cell.u).text, ui::format_number(cell.v).text);
        }
        const ui::Control region = ui_.control({.name = name,
                                                .area = map.area,
                                                .kind = ui::Kind::region,
                                                .label = kTitle,
                                                .tip = tip,
                                                .focusable = false});
        const Selection what{.kind = Selection::Kind::pixel, .at = pixel};
        tell_hover(ctx_, map.area, on && region.hovered, what);
        if (region.clicked && on) ctx_.act(action::Pin{what});
    }

    void draw_legend(const ui::Area& area) {
        if (difference_ == nullptr) return;
        const ui::Font& font = ui_.font(ui::Face::title);
        const auto count = [&](Cause cause) { return difference_->count[static_cast<std::size_t>(cause)]; };
        if (std::all_of(kShown.begin(), kShown.end(), [&](const CauseInfo& i) { return count(i.cause) == 0; })) {
            ui_.text_within(ui::Face::title, {area.x, ui::baseline_at_middle(font, area.y + line() / 2)}, area.w,
                            Role::muted, kEqual);
            return;
        }
        const int columns = legend_columns();
        const float width = std::floor(area.w / static_cast<float>(columns)), side = ui_.px(14);
        for (std::size_t n = 0; n < kShown.size(); ++n) {
            const int column = static_cast<int>(n) % columns, row = static_cast<int>(n) / columns;
            const float x = area.x + static_cast<float>(column) * width;
            const float middle = area.y + (static_cast<float>(row) + .5F) * line() + ui_.px(2);
            const ui::Area swatch{x, std::round(middle - side / 2), side, side};
            ui::fill(ui_.list(), swatch, ui_.theme()[kShown[n].role]);
            draw_mark(ui_.list(), kShown[n].cause, swatch, ui_.theme().outline);
            const bool any = count(kShown[n].cause) > 0;
            const float text = x + side + ui_.px(6), right = x + width - ui_.px(4);
            const float used = ui_.text_within(ui::Face::title, {text, ui::baseline_at_middle(font, middle)},
                                               right - text, any ? Role::text : Role::muted, kShown[n].name);
            const float number = text + used + ui_.px(8);
            ui_.text_within(ui::Face::code, {number, ui::baseline_at_middle(ui_.font(ui::Face::code), middle)},
                            std::max(0.0F, right - number), any ? Role::text : Role::muted,
                            std::to_string(count(kShown[n].cause)));
        }
    }

    const ViewContext& ctx_;
    ui::Ui& ui_;
    ui::Area area_;
    const Difference* difference_ = nullptr;
};

void draw(const ViewContext& context, const ui::Area& place) {
    const ui::Area area = begin_view(context, "difference", place, kTitle);
    if (context.derived.shape() < 0)
        draw_empty(context, area, kNothing);
    else
        DifferenceView(context, area).draw_scrolled();
    context.ui.end_panel();
}

constexpr View kView{"difference", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas
