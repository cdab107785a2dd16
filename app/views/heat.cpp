// The error of every pixel as a colour: how far its texel coordinates lie from those in perspective, and where most.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "app/ui/ramp.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_map.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"
#include "app/views/tuning.h"

namespace texelscope::canvas::heat_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Error against perspective", kTab = "Error";
constexpr std::string_view kNote = "distance of (u, v) in texels";
constexpr std::string_view kNothing = "No pixel is drawn, so there is no error to show.";
constexpr std::string_view kNoError = "no error: (u, v) is that in perspective";
constexpr std::string_view kWorst = "worst at {}, {}: {} texels", kParts = "{} in u, {} in v";
constexpr std::string_view kWorstLabel = "worst place";
constexpr std::string_view kWorstTip = "Click to go to the step that draws the worst pixel.";
constexpr std::string_view kPixelTip = "pixel **{}, {}**: {} texels off, {} in $u$ and {} in $v$";
constexpr std::string_view kOneOnlyTip = "pixel **{}, {}**: only one of the two runs draws it";
constexpr std::string_view kUnit = "texels";
constexpr double kNone = 1e-6;  ///< below it an error is that of the reference's own doubles [texels]

[[nodiscard]] std::string decimals(double value, int places = 2) { return ui::format_number(value, places).text; }

/// The scale's upper end: the next of 1, 1.5, 2, 3, 5, 8 times a power of ten [texels].
[[nodiscard]] double scale_end(double worst) {
    if (!(worst > kNone)) return 1;
    const double power = std::pow(10, std::floor(std::log10(worst)));
    for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 8.0})
        if (worst <= step * power) return step * power;
    return 10 * power;
}

[[nodiscard]] Rgba rgba(ui::Color c) {
    const auto byte = [c](unsigned shift) { return static_cast<std::uint8_t>(c >> shift & 0xFFU); };
    return {byte(0), byte(8), byte(16), 255};
}

/// The scale and the worst place.
[[nodiscard]] float legend_height(const ui::Ui& ui) { return 2 * pitch(ui, 18, ui::Face::title) + ui.px(6); }

/// The depth of a corner can be tuned, and the picture stays about as large as it is without that.
[[nodiscard]] bool has_room_for_tuning(const ViewContext& ctx, const ui::Area& picture) {
    constexpr double kLeastShare = .75;
    const Framebuffer& frame = ctx.derived.scene().framebuffer;
    const ui::Area lower{picture.x, picture.y, picture.w, picture.h - tuning_height(ctx.ui) - ctx.ui.px(4)};
    return has_depth_tuning(ctx) && lower.h > 0 && fit_zoom(lower, frame) >= kLeastShare * fit_zoom(picture, frame);
}

class HeatView {
public:
    HeatView(const ViewContext& ctx, const ui::Area& area)
        : ctx_(ctx), ui_(ctx.ui), line_(pitch(ctx.ui, 18, ui::Face::title)), area_(area) {
        const Framebuffer& frame = ctx.derived.scene().framebuffer;
        ui::Area picture{area.x, area.y, area.w, std::max(1.0F, area.h - legend_height(ui_))};
        if (has_room_for_tuning(ctx, picture)) {
            tuning_ = {area.x, area.bottom() - tuning_height(ui_), area.w, tuning_height(ui_)};
            picture.h -= tuning_.h + ui_.px(4);
        }
        map_ = make_map(picture, frame, Look{});
        errors_ = &ctx.derived.errors(window_in_view(map_, frame));
        end_ = scale_end(errors_->worst ? errors_->error.length() : 0);
    }

    void draw() {
        draw_picture();
        draw_outlines();
        take_pixel();
        draw_current();
        if (!tuning_.empty()) draw_depth_tuning(ctx_, tuning_);
        draw_legend(
            {area_.x, map_.area.bottom() + ui_.px(4), area_.w, area_.bottom() - map_.area.bottom() - ui_.px(4)});
    }

private:
    [[nodiscard]] bool wrong() const { return errors_->worst && errors_->error.length() > kNone; }

    [[nodiscard]] Rgba shown(const UvError& e) const {
        if (e.kind == UvError::Kind::nothing) return {0, 0, 0, 0};
        if (e.kind == UvError::Kind::one_only) return rgba(ui_.theme()[Role::error]);
        return rgba(ui::viridis(e.length() / end_));
    }

    void draw_picture() {
        const Grid<UvError>& cells = errors_->cells;
        if (cells.width() < 1 || cells.height() < 1) return;
        Grid<Rgba> pixels(cells.width(), cells.height());
        std::transform(cells.data(), cells.data() + cells.size(), pixels.data(),
                       [this](const UvError& e) { return shown(e); });
        const Window& w = errors_->window;
        const ui::Area at = map_.place_of(
            Rect{w.rect.x0, w.rect.y0, w.rect.x0 + cells.width() * w.stride, w.rect.y0 + cells.height() * w.stride});
        const ImTextureID image = ctx_.textures.image(ui::id_of("heat"), version_of(pixels), pixels);
        ui_.list().AddImage(image, {at.x, at.y}, {at.right(), at.bottom()});
        const ui::Area all = ui::intersection(map_.place_of(ctx_.derived.scene().framebuffer.rect()), map_.area);
        ui::frame(ui_.list(), all, ui_.theme().hairline);
        for (int y = 0; y < cells.height(); ++y)
            for (int x = 0; x < cells.width(); ++x) {
                if (cells.at(x, y).kind != UvError::Kind::one_only || map_.zoom < 4) continue;
                const ui::Area p = map_.place_of(glm::ivec2(w.rect.x0 + x * w.stride, w.rect.y0 + y * w.stride));
                ui::cross(ui_.list(), p.centre(), p.w / 4, 1, ui_.theme().outline);
            }
    }

    /// The sides of all shapes, those inside a polygon too: the seam lies on one of them.
    void draw_outlines() {
        constexpr int kMost = 64;
        const Drawing& drawing = ctx_.derived.drawing();
        ui_.begin_clip(map_.area);
        for (int shape = 0; shape < std::min(kMost, drawing.shape_count()); ++shape) {
            const auto corners = drawing.corners(shape);
            for (std::size_t n = 0; n < corners.size(); ++n) {
                const Vertex &a = corners[n], &b = corners[(n + 1) % corners.size()];
                if (drawing.refusal(shape) != Fate::written) continue;
                const auto at = [&](const Vertex& v) {
                    return glm::vec2(glm::clamp(glm::dvec2(map_.to_window({v.x, v.y})), -1e4, 1e4));
                };
                // In two tones, so that it shows on every colour of the ramp and beside it.
                ui::line(ui_.list(), at(a), at(b), 2.5F, ui::with_alpha(ui::hex(0x000000), .5F));
                ui::line(ui_.list(), at(a), at(b), 1, ui::with_alpha(ui::hex(0xFFFFFF), .75F));
            }
        }
        ui_.end_clip();
    }

    [[nodiscard]] const UvError* cell(glm::ivec2 pixel) const {
        const Window& w = errors_->window;
        if (!w.rect.contains(pixel.x, pixel.y)) return nullptr;
        return &errors_->cells.at((pixel.x - w.rect.x0) / w.stride, (pixel.y - w.rect.y0) / w.stride);
    }

    void take_pixel() {
        const glm::ivec2 pixel = map_.pixel_at(ui_.input().mouse);
        const UvError* under = map_.area.contains(ui_.input().mouse) ? cell(pixel) : nullptr;
        std::string tip;
        if (under != nullptr && under->kind == UvError::Kind::one_only)
            tip = fmt::format(kOneOnlyTip, pixel.x, pixel.y);
        if (under != nullptr && under->kind == UvError::Kind::both)
            tip = fmt::format(kPixelTip, pixel.x, pixel.y, decimals(under->length(), 4), decimals(under->u, 4),
                              decimals(under->v, 4));
        const ui::Control region = ui_.control({.name = "heat/picture",
                                                .area = map_.area,
                                                .kind = ui::Kind::region,
                                                .label = kTitle,
                                                .tip = tip,
                                                .focusable = false});
        const Selection what{.kind = Selection::Kind::pixel, .at = pixel};
        tell_hover(ctx_, map_.area, under != nullptr && region.hovered, what);
        if (region.clicked && under != nullptr) ctx_.act(action::Pin{what});
    }

    void draw_current() {
        ui_.begin_clip(map_.area);
        const auto ring = [&](glm::ivec2 pixel, float width) {
            ui::pixel_ring(ui_.list(), ui::grown_to(map_.place_of(pixel), 6), ui_.theme()[Role::now],
                           ui_.theme().outline, width);
        };
        if (wrong()) draw_worst(*errors_->worst);
        for (const glm::ivec2 p : ctx_.hover.pixels)
            if (ctx_.hover.pixels.size() == 1) ring(p, 1);
        for (const glm::ivec2 p : ctx_.pinned.pixels)
            if (ctx_.pinned.pixels.size() == 1) ring(p, 2);
        if (const auto pixel = ctx_.derived.pixel()) ring(*pixel, 2);
        ui_.end_clip();
    }

    /// Four strokes that point at the pixel, in two tones, so that they show on every colour of the ramp.
    void draw_worst(glm::ivec2 pixel) {
        const glm::vec2 at = map_.place_of(pixel).centre();
        const float near = ui_.px(6), far = ui_.px(14);
        for (const auto& [width, color] : {std::pair{5.0F, ui_.theme().outline}, {2.0F, ui::hex(0xFFFFFF)}}) {
            for (const glm::vec2 way : {glm::vec2(1, 0), {-1, 0}, {0, 1}, {0, -1}})
                ui::line(ui_.list(), at + way * near, at + way * far, width, color);
        }
        const std::string value = decimals(errors_->error.length());
        const float wide = ui::text_width(ui_.font(ui::Face::code), value) + ui_.px(24), gap = ui_.px(4);
        const float right = at.x + far + gap, left = at.x - far - gap - wide;
        const float x = right + wide <= map_.area.right() ? right : left;
        if (x >= map_.area.x && at.y - ui_.px(16) >= map_.area.y) ui::badge(ui_, ui::Face::code, {x, at.y}, value);
    }

    /// The scale with its two ends, then the worst place in words.
    void draw_legend(const ui::Area& area) {
        const ui::Font& font = ui_.font(ui::Face::count);
        const std::string low = "0", high = fmt::format("{} {}", decimals(end_), kUnit);
        const float gap = ui_.px(6), left = ui::text_width(font, low) + gap, bar = ui_.px(10);
        const float right = ui::text_width(font, high) + gap;
        const ui::Area ramp{area.x + left, std::round(area.y + (line_ - bar) / 2),
                            std::max(ui_.px(24), std::min(area.w - left - right, ui_.px(320))), bar};
        constexpr int kBands = 64;
        for (int n = 0; n < kBands; ++n) {
            const float x0 = std::round(ramp.x + ramp.w * static_cast<float>(n) / kBands);
            const float x1 = std::round(ramp.x + ramp.w * static_cast<float>(n + 1) / kBands);
            ui::fill(ui_.list(), {x0, ramp.y, x1 - x0, ramp.h}, ui::viridis((n + .5) / kBands));
        }
        ui::frame(ui_.list(), ramp, ui_.theme().hairline);
        const float baseline = ui::baseline_at_middle(font, ramp.centre().y);
        ui_.text(ui::Face::count, {area.x, baseline}, Role::muted, low);
        ui_.text_within(ui::Face::count, {ramp.right() + gap, baseline}, area.right() - ramp.right() - gap, Role::muted,
                        high);
        draw_words({area.x, area.y + line_, area.w, line_});
    }
    void draw_words(const ui::Area& area) {
        const float baseline = ui::baseline_at_middle(ui_.font(ui::Face::code), area.centre().y);
        if (!wrong()) {
            ui_.text_within(ui::Face::title, {area.x, baseline}, area.w, Role::muted,
                            errors_->worst ? kNoError : kNothing);
            return;
        }
        const glm::ivec2 p = *errors_->worst;
        const UvError& e = errors_->error;
        const ui::Control control = ui_.control({"heat/worst", area, ui::Kind::button, kWorstLabel, kWorstTip});
        if (control.clicked) {
            if (const auto step = ctx_.derived.last_write(p)) ctx_.act(action::StepTo{*step});
        }
        if (control.hovered) ui::frame(ui_.list(), area, ui_.theme()[Role::now], 1, ui::size::kRadius);
        const float width = ui_.text_within(ui::Face::code, {area.x, baseline}, area.w, Role::text,
                                            fmt::format(kWorst, p.x, p.y, decimals(e.length(), 3)));
        const float x = area.x + width + ui_.px(16);
        ui_.text_within(ui::Face::code, {x, baseline}, std::max(0.0F, area.right() - x), Role::muted,
                        fmt::format(kParts, decimals(e.u, 3), decimals(e.v, 3)));
    }

    const ViewContext& ctx_;
    ui::Ui& ui_;
    float line_;
    ui::Area area_, tuning_;  ///< tuning_: empty where corners are not to be moved
    CanvasMap map_;
    const ErrorMap* errors_ = nullptr;
    double end_ = 1;
};

/// Where there is no room for the picture above its legend, the two can be scrolled.
void draw_scrolled(const ViewContext& context, const ui::Area& area) {
    const float least = legend_height(context.ui) + context.ui.px(70);
    const float content = std::max(area.h, least);
    foresee(context.ui, "heat/scroll", content);
    const ui::Area inner = context.ui.begin_scroll("heat/scroll", area);
    HeatView(context, {inner.x, inner.y, inner.w, content}).draw();
    context.ui.end_scroll(content);
}

void draw(const ViewContext& context, const ui::Area& place) {
    const ui::Area area = begin_view(context, "heat", place, kTitle, kNote);
    if (context.derived.shape() < 0)
        draw_empty(context, area, kNothing);
    else
        draw_scrolled(context, area);
    context.ui.end_panel();
}

constexpr View kView{"heat", kTab, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::heat_view
