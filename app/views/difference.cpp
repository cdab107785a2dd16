// Two runs over one scene: their pictures beside each other, and each pixel that differs with the reason why.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/state/compared_run.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_map.h"
#include "app/views/canvas_values.h"
#include "app/views/difference_choice.h"
#include "app/views/screen_parts.h"
#include "app/views/terms.h"

namespace texelscope::canvas::difference_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Difference";
constexpr std::string_view kNothing = "There is no shape, so no two pictures to compare.";
constexpr std::string_view kRun = "{}, {}", kSwitched = "switched";
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
    {Cause::rounding, Role::section_1, "rounding", "the same place in exact numbers, rounded to two sides"},
    {Cause::offset, Role::section_2, "offset", "as far apart as everywhere on this face"},
    {Cause::warp, Role::section_3, "warp", "how far apart changes from place to place on this face"},
}};

[[nodiscard]] const CauseInfo* info_of(Cause cause) {
    const auto at = std::find_if(kShown.begin(), kShown.end(), [=](const CauseInfo& i) { return i.cause == cause; });
    return at == kShown.end() ? nullptr : &*at;
}

/// What sets one run of a method apart from another: "as printed, f32".
[[nodiscard]] std::string run_of(const DrawSettings& settings) {
    const auto& variants = settings.method->variants;
    const auto at = std::find_if(variants.rbegin(), variants.rend(),
                                 [&](const VariantInfo& v) { return v.quirks == settings.quirks; });
    return fmt::format(kRun, at == variants.rend() ? std::string(kSwitched) : spaced(at->id), id_of(settings.format));
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
    DifferenceView(const ViewContext& ctx, const ui::Area& area)
        : ctx_(ctx), ui_(ctx.ui), area_(area), choice_(ctx, area.w) {}

    /// Where there is no room for the pictures above their legend, all can be scrolled.
    void draw_scrolled() {
        const float content = std::max(area_.h, choice_.height() + legend_height() + 3 * line() + ui_.px(72));
        foresee(ui_, "difference/scroll", content);
        const ui::Area inner = ui_.begin_scroll("difference/scroll", area_);
        area_ = {inner.x, inner.y, inner.w, content};
        draw();
        ui_.end_scroll(content);
    }

private:
    void draw() {
        const float bar = choice_.height();
        choice_.draw({area_.x, area_.y, area_.w, bar});
        const float legend = legend_height();
        const ui::Area pictures{area_.x, area_.y + bar, area_.w, std::max(1.0F, area_.h - bar - legend)};
        draw_pictures(pictures);
        draw_legend({area_.x, pictures.bottom(), area_.w, legend});
    }

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

    /// Where the three pictures may stand, each below its caption: in a row, in a column, or the map large and the
    /// other two at its left, or above it.
    [[nodiscard]] std::array<std::array<ui::Area, 3>, 4> arrangements(const ui::Area& a) const {
        const float gap = ui_.px(8), w = (a.w - 2 * gap) / 3, h = (a.h - 2 * gap) / 3;
        const float half_w = (a.w - gap) / 2, half_h = (a.h - gap) / 2;
        const float x1 = a.x + w + gap, x2 = x1 + w + gap, y1 = a.y + h + gap, y2 = y1 + h + gap;
        const ui::Area right{x1, a.y, a.right() - x1, a.h}, below{a.x, y1, a.w, a.bottom() - y1};
        return {{{{{a.x, a.y, w, a.h}, {x1, a.y, w, a.h}, {x2, a.y, w, a.h}}},
                 {{{a.x, a.y, a.w, h}, {a.x, y1, a.w, h}, {a.x, y2, a.w, h}}},
                 {{{a.x, a.y, w, half_h}, {a.x, a.y + half_h + gap, w, half_h}, right}},
                 {{{a.x, a.y, half_w, h}, {a.x + half_w + gap, a.y, half_w, h}, below}}}};
    }
    [[nodiscard]] ui::Area without_caption(const ui::Area& a) const { return {a.x, a.y + line(), a.w, a.h - line()}; }

    /// As they stand largest.
    void draw_pictures(const ui::Area& area) {
        const Framebuffer& frame = ctx_.derived.scene().framebuffer;
        std::array<ui::Area, 3> best{};
        double largest = 0;
        for (const auto& places : arrangements(area)) {
            double sum = 0;
            for (const ui::Area& place : places) sum += fit_zoom(without_caption(place), frame);
            if (sum > largest) largest = sum, best = places;
        }
        // All three show the samples of the largest, whatever their own size.
        const CanvasMap large = make_map(without_caption(best[2]), frame, Look{});
        difference_ = &ctx_.derived.difference(window_in_view(large, frame));
        const DrawSettings &own = ctx_.derived.drawing().settings(), other = settings_of(ctx_.state.look.other, own);
        const bool same = own.method == other.method;
        const std::array<std::string, 3> titles{same ? run_of(own) : std::string(own.method->title),
                                                same ? run_of(other) : std::string(other.method->title),
                                                std::string(kMap)};
        for (int n = 0; n < 3; ++n) {
            const ui::Area &place = best[static_cast<std::size_t>(n)], picture = without_caption(place);
            if (picture.w < 8 || picture.h < 8) return;
            const ui::Font& font = ui_.font(ui::Face::title);
            ui_.text_within(ui::Face::title, {place.x, ui::baseline_at_middle(font, place.y + line() / 2)}, place.w,
                            Role::muted, titles[static_cast<std::size_t>(n)]);
            const CanvasMap map = make_map(picture, frame, Look{});
            draw_picture(map, n);
        }
    }

    [[nodiscard]] Rgba shown(const DifferenceCell& cell, int picture) const {
        constexpr Rgba kNone{0, 0, 0, 0};
        if (picture < 2) {
            const std::optional<Rgb>& c = picture == 0 ? cell.own : cell.others;
            return c ? Rgba{c->r, c->g, c->b, 255} : kNone;
        }
        if (cell.cause == Cause::nothing) return kNone;
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
        const auto ring = [&](glm::ivec2 at_pixel, float width) {
            ui::pixel_ring(ui_.list(), ui::grown_to(map.place_of(at_pixel), 4), ui_.theme()[Role::now],
                           ui_.theme().outline, width, 1);
        };
        if (ctx_.hover.pixels.size() == 1) ring(ctx_.hover.pixels.front(), 1);
        if (ctx_.pinned.pixels.size() == 1) ring(ctx_.pinned.pixels.front(), 2);
        if (const auto pixel = ctx_.derived.pixel()) ring(*pixel, 1.5F);
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
        if (region.clicked && on) point_or_pin(ctx_, what);
    }

    void draw_legend(const ui::Area& area) {
        if (difference_ == nullptr) return;
        const ui::Font& font = ui_.font(ui::Face::title);
        const auto count = [&](Cause cause) { return difference_->of(cause); };
        if (std::all_of(kShown.begin(), kShown.end(), [&](const CauseInfo& i) { return count(i.cause) == 0; })) {
            ui_.text_within(ui::Face::title, {area.x, ui::baseline_at_middle(font, area.y + line() / 2)}, area.w,
                            Role::muted, kEqual);
            return;
        }
        const int columns = legend_columns();
        const float width = std::floor(area.w / static_cast<float>(columns)),
                    side = std::max(ui_.px(14), std::round(font.em * .7F));
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
    RunChoice choice_;
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
}  // namespace texelscope::canvas::difference_view
