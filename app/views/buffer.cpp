// Two passes: the texture, the buffer tmp[x][v] that the first pass fills, and the picture that the second one makes of
// it, side by side, with the row or column under work and how wide the buffer is.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_texture.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"
#include "app/views/tuning.h"
#include "core/image/wrap.h"
#include "core/method/two_pass_buffer.h"

namespace texelscope::canvas::buffer_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Buffer";
constexpr std::string_view kOther = "The buffer is for the method **two-pass**.";
constexpr std::string_view kNone = "Nothing of the shape lies on the screen: there is no buffer.";
constexpr std::array<std::string_view, 3> kTitles{"texture", "tmp[x][v]", "image"};
constexpr std::string_view kWidth = "{} of {} columns", kShortWidth = "{} of {}", kHidden = "How wide?";
constexpr std::string_view kTexelTip = "texel **{}, {}**", kCellTip = "tmp[{}][{}] holds texel **{}, {}**",
                           kNoTexelTip = "tmp[{}][{}] holds nothing", kPixelTip = "pixel **{}, {}**";
constexpr std::uint8_t kRepeated = 60, kLater = 51;  ///< alphas: outside the shape's texels; not yet there

/// One of the three pictures.
struct Sheet3 {
    Rect range;
    ui::Area area;
    float zoom = 1;

    [[nodiscard]] ui::Area place_of(const Rect& r) const {
        return {std::round(area.x + static_cast<float>(r.x0 - range.x0) * zoom),
                std::round(area.y + static_cast<float>(r.y0 - range.y0) * zoom),
                std::max(1.0F, std::round(static_cast<float>(r.width()) * zoom)),
                std::max(1.0F, std::round(static_cast<float>(r.height()) * zoom))};
    }
    [[nodiscard]] glm::ivec2 at(glm::vec2 mouse) const {
        return {range.x0 + static_cast<int>(std::floor((mouse.x - area.x) / zoom)),
                range.y0 + static_cast<int>(std::floor((mouse.y - area.y) / zoom))};
    }
};

/// Where the two passes stand.
struct Passes {
    int pass = 0;              ///< at work or done last: 0 before the first, 1, 2
    std::optional<Integer> v;  ///< the row that the first pass works on
    std::optional<Integer> x;  ///< the column, of either pass
    bool whole = true;         ///< the pass has come to its end
};

[[nodiscard]] Passes passes_of(const Derived& derived, const Path& step) {
    Passes at;
    const std::string_view stage = stage_name(derived);
    if (step.unit().depth() < 2)
        at.pass = 2;
    else
        at.pass = stage == "pass 1" ? 1 : stage == "pass 2" ? 2 : 0;
    at.x = step.index_of('x');
    at.v = step.index_of('v');
    at.whole = !at.x && !at.v;
    return at;
}

[[nodiscard]] Rect reach_of(std::span<const Vertex> corners) {
    double u0 = 1e9, u1 = -1e9, v0 = 1e9, v1 = -1e9;
    for (const Vertex& c : corners) {
        u0 = std::min(u0, double{c.u}), u1 = std::max(u1, double{c.u});
        v0 = std::min(v0, double{c.v}), v1 = std::max(v1, double{c.v});
    }
    const auto whole = [](double a) { return static_cast<int>(std::clamp(a, -1e6, 1e6)); };
    return {whole(std::floor(u0)), whole(std::floor(v0)), whole(std::ceil(u1)), whole(std::ceil(v1))};
}

class BufferView {
public:
    BufferView(const ViewContext& ctx, const ui::Area& area)
        : ctx_(ctx),
          ui_(ctx.ui),
          theme_(ctx.ui.theme()),
          texture_(ctx.derived.texture()),
          tmp_(ctx.derived.two_pass_buffer()),
          at_(passes_of(ctx.derived, ctx.state.cursor.step)),
          texels_(reach_of(corners_of(ctx.derived))) {
        line_ = pitch(ui_, 18, ui::Face::prose);
        place(area);
        if (!has_pose_tuning(ctx)) return;
        // Below the texture, where that leaves room, else below all.
        const float row = tuning_height(ui_) + ui_.px(8);
        const float left =
            below_ ? sheets_[0].area.bottom() : std::max(sheets_[0].area.bottom(), sheets_[1].area.bottom());
        const float width = std::min(ui_.px(360), (below_ ? captions_[1].x : captions_[2].x) - area.x - ui_.px(24));
        if (area.bottom() - left > row && width > ui_.px(180)) {
            tuning_ = {area.x, area.bottom() - row + ui_.px(4), width, tuning_height(ui_)};
        } else if (area.h > row + 3 * line_ + ui_.px(60)) {
            place({area.x, area.y, area.w, area.h - row});
            tuning_ = {area.x, area.bottom() - row + ui_.px(4), std::min(area.w, ui_.px(360)), tuning_height(ui_)};
        }
    }

    void draw() {
        if (!tuning_.empty()) draw_pose_tuning(ctx_, tuning_, false);
        for (int n = 0; n < 3; ++n) {
            draw_caption(n);
            draw_picture(n);
        }
        draw_extent();
        draw_now();
        for (int n = 0; n < 2; ++n) draw_arrow(n);
        for (int n = 0; n < 3; ++n) take_input(n);
    }

private:
    [[nodiscard]] static Rect rect_of(Integer x0, Integer y0, Integer x1, Integer y1) {
        return {static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1), static_cast<int>(y1)};
    }
    /// At one zoom; side by side or, where that is no smaller, with the image below tmp, whose columns it has.
    void place(const ui::Area& area) {
        sheets_[0].range = texels_;
        sheets_[1].range = rect_of(tmp_.x0, texels_.y0, tmp_.x1, texels_.y1);
        sheets_[2].range = image_range();
        const float gap = ui_.px(34), caption = 2 * line_ + ui_.px(8);
        const auto wide = [&](std::size_t n) { return static_cast<float>(std::max(1, sheets_[n].range.width())); };
        const auto high = [&](std::size_t n) { return static_cast<float>(std::max(1, sheets_[n].range.height())); };
        const auto zoom_in = [](float w, float columns, float h, float rows) {
            const float zoom = std::min(std::max(1.0F, w) / columns, std::max(1.0F, h) / rows);
            return zoom > 1 ? std::floor(zoom) : zoom;
        };
        const float beside = zoom_in(area.w - 2 * gap, wide(0) + wide(1) + wide(2), area.h - caption,
                                     std::max({high(0), high(1), high(2)}));
        const float below = zoom_in(area.w - gap, wide(0) + std::max(wide(1), wide(2)), area.h - 2 * caption,
                                    std::max(high(0), high(1)) + high(2));
        below_ = below >= beside && below >= 1;
        const float zoom = below_ ? below : beside;
        const auto put = [&](std::size_t n, float x, float y, float room) {
            Sheet3& s = sheets_[n];
            s.zoom = zoom;
            s.area = {std::round(x), std::round(y + caption), wide(n) * zoom, high(n) * zoom};
            captions_[n] = {s.area.x, y, std::max(1.0F, room), caption};
        };
        if (below_) {
            const float second = std::max(area.x + wide(0) * zoom + gap, area.x + area.w * .4F);
            const float x = std::min(second, area.right() - std::max(wide(1), wide(2)) * zoom);
            put(0, area.x, area.y, x - area.x - gap * .8F);
            put(1, x, area.y, area.right() - x);
            const auto shift = static_cast<float>(sheets_[2].range.x0 - sheets_[1].range.x0) * zoom;
            put(2, x + shift, area.y + caption + std::max(high(0), high(1)) * zoom, area.right() - x - shift);
            return;
        }
        // Captions need more room than a narrow picture has: each place is as wide as its share of the whole.
        const float spare = std::max(0.0F, area.w - 2 * gap - zoom * (wide(0) + wide(1) + wide(2))) / 3;
        float x = area.x;
        for (std::size_t n = 0; n < 3; ++n) {
            put(n, x, area.y, wide(n) * zoom + spare + (n < 2 ? gap * .2F : 0));
            x += wide(n) * zoom + spare + gap;
        }
    }
    /// The pixels that the shape's box touches.
    [[nodiscard]] Rect image_range() const {
        float x0 = 1e6F, x1 = -1e6F, y0 = 1e6F, y1 = -1e6F;
        for (const Vertex& c : corners_of(ctx_.derived)) {
            x0 = std::min(x0, c.x), x1 = std::max(x1, c.x);
            y0 = std::min(y0, c.y), y1 = std::max(y1, c.y);
        }
        const auto whole = [](float a) { return static_cast<int>(std::clamp(a, -1e6F, 1e6F)); };
        return intersection({whole(std::floor(x0)), whole(std::floor(y0)), whole(std::ceil(x1)), whole(std::ceil(y1))},
                            ctx_.derived.scene().framebuffer.rect());
    }

    void draw_caption(int n) {
        const ui::Area& place = captions_[static_cast<std::size_t>(n)];
        const bool now = (at_.pass == 1 && n == 1) || (at_.pass == 2 && n == 2);
        const float first = place.y + line_ * .72F;
        ui_.text_within(ui::Face::lead, {place.x, first}, place.w, now ? Role::now : Role::text,
                        kTitles[static_cast<std::size_t>(n)]);
        std::string text = fmt::format("{} × {}", texels_.width(), texels_.height());
        if (n == 1) {
            const bool whole = std::abs(tmp_.width - std::round(tmp_.width)) < 5e-3;
            const std::string width = fmt::format(fmt::runtime(whole ? "{:.0f}" : "{:.1f}"), std::abs(tmp_.width)),
                              texels = fmt::format("{:.6g}", std::round(tmp_.texels * 1e3) / 1e3);
            text = at_.pass == 0 ? std::string(kHidden) : fmt::format(kWidth, width, texels);
            if (at_.pass > 0 && ui::text_width(ui_.font(ui::Face::prose), text) > place.w)
                text = fmt::format(kShortWidth, width, texels);
        }
        if (n == 2) text = fmt::format("{} × {}", sheets_[2].range.width(), sheets_[2].range.height());
        ui_.text_within(ui::Face::prose, {place.x, first + line_}, place.w, n == 1 ? Role::text : Role::muted, text);
    }

    [[nodiscard]] Rgba texel(Integer u, Integer v, bool later) const {
        const Rgb c = texture_.texels.at(wrap_index(u, texture_.width(), texture_.wrap),
                                         wrap_index(v, texture_.height(), texture_.wrap));
        const bool own = u >= texels_.x0 && u < texels_.x1 && v >= texels_.y0 && v < texels_.y1;
        return {c.r, c.g, c.b, later ? kLater : own ? std::uint8_t{255} : kRepeated};
    }
    [[nodiscard]] Integer tmp_at(Integer x, Integer v) const {
        const bool in = x >= tmp_.x0 && x < tmp_.x1 && v >= tmp_.v0 && v < tmp_.v1;
        return in ? tmp_.at(x, v) : TwoPassBuffer::kNone;
    }
    [[nodiscard]] bool filled(Integer x, Integer v) const {
        if (at_.pass != 1 || at_.whole) return at_.pass > 0;
        return v < *at_.v || (v == *at_.v && (!at_.x || x <= *at_.x));
    }
    [[nodiscard]] Rgba cell(int n, int x, int y) const {
        if (n == 0) return texel(x, y, false);
        if (n == 1) {
            const Integer u = tmp_at(x, y);
            if (u == TwoPassBuffer::kNone || !filled(x, y)) return {0, 0, 0, 0};
            return texel(u, y, false);
        }
        const CanvasPicture& picture = ctx_.derived.canvas({ctx_.derived.scene().framebuffer.rect(), 1});
        const Rect& frame = picture.window.rect;
        if (!frame.contains(x, y)) return {0, 0, 0, 0};
        const CanvasCell& c = picture.cells.at(x - frame.x0, y - frame.y0);
        if (!c.will_be_visited) return {0, 0, 0, 0};
        return c.visited && c.written ? Rgba{c.now.r, c.now.g, c.now.b, 255} : Rgba{0, 0, 0, 0};
    }
    void draw_picture(int n) {
        const Sheet3& s = sheets_[static_cast<std::size_t>(n)];
        if (s.range.empty()) return;
        Grid<Rgba> pixels(s.range.width(), s.range.height());
        for (int y = s.range.y0; y < s.range.y1; ++y)
            for (int x = s.range.x0; x < s.range.x1; ++x) pixels.at(x - s.range.x0, y - s.range.y0) = cell(n, x, y);
        ui::fill(ui_.list(), s.area, theme_.canvas);
        const ImTextureID id = ctx_.textures.image(ui::id_of(fmt::format("buffer/{}", n)), version_of(pixels), pixels);
        ui_.list().AddImage(id, {s.area.x, s.area.y}, {s.area.right(), s.area.bottom()});
        ui::frame(ui_.list(), s.area.inset(-1, -1), theme_[Role::faint], 1);
    }

    /// What the step works on: a row of texture and buffer in the first pass, a column of buffer and image in the
    /// other.
    void draw_now() {
        const auto ring = [&](int n, Integer x0, Integer y0, Integer x1, Integer y1, float width) {
            const Sheet3& s = sheets_[static_cast<std::size_t>(n)];
            const Rect in = intersection(rect_of(x0, y0, x1, y1), s.range);
            if (in.empty()) return;
            const ui::Area place = s.place_of(in);
            ui::frame(ui_.list(), place.inset(-width - 1, -width - 1), theme_.outline, width + 2);
            ui::frame(ui_.list(), place.inset(-width, -width), theme_[Role::now], width);
        };
        const Rect &t = sheets_[0].range, &b = sheets_[1].range, &p = sheets_[2].range;
        if (at_.pass == 1 && at_.v) {
            ring(0, t.x0, *at_.v, t.x1, *at_.v + 1, 1.5F);
            ring(1, b.x0, *at_.v, b.x1, *at_.v + 1, 1.5F);
            if (!at_.x) return;
            ring(1, *at_.x, *at_.v, *at_.x + 1, *at_.v + 1, 2.5F);
            const Integer u = tmp_at(*at_.x, std::clamp(*at_.v, tmp_.v0, tmp_.v1 - 1));
            if (u != TwoPassBuffer::kNone) ring(0, u, *at_.v, u + 1, *at_.v + 1, 2.5F);
        }
        if (at_.pass == 2 && at_.x) {
            ring(1, *at_.x, b.y0, *at_.x + 1, b.y1, 1.5F);
            ring(2, *at_.x, p.y0, *at_.x + 1, p.y1, 1.5F);
            if (const auto pixel = ctx_.derived.pixel()) ring(2, pixel->x, pixel->y, pixel->x + 1, pixel->y + 1, 2.5F);
            if (const auto row = ctx_.derived.texel()) {
                ring(1, *at_.x, row->y, *at_.x + 1, row->y + 1, 2.5F);
                ring(0, row->x, row->y, row->x + 1, row->y + 1, 2.5F);
            }
        }
    }

    void draw_arrow(int n) {
        const Sheet3 &from = sheets_[static_cast<std::size_t>(n)], &to = sheets_[static_cast<std::size_t>(n) + 1];
        const bool now = at_.pass == n + 1;
        const ui::Color color = theme_[now ? Role::now : Role::muted];
        const float width = now ? 2.5F : 1.5F;
        if (n == 1 && below_) {
            const float x = to.area.x - ui_.px(14), y = captions_[2].y;
            ui::arrow(ui_.list(), {x, y + ui_.px(2)}, {x, y + captions_[2].h - ui_.px(4)}, width, color, ui_.px(7));
            return;
        }
        const float y = captions_[0].y + line_ * .5F, begin = to.area.x - ui_.px(26), end = to.area.x - ui_.px(6);
        if (begin > from.area.x) ui::arrow(ui_.list(), {begin, y}, {end, y}, width, color, ui_.px(7));
    }

    /// How far the row reaches that the first pass works on, or the middle one.
    void draw_extent() {
        if (at_.pass == 0) return;
        const Sheet3& s = sheets_[1];
        const Integer row = at_.v.value_or((texels_.y0 + texels_.y1) / 2);
        Integer first = tmp_.x1, last = tmp_.x0;
        for (Integer x = tmp_.x0; x < tmp_.x1; ++x) {
            const Integer u = tmp_at(x, row);
            if (u < texels_.x0 || u >= texels_.x1) continue;
            first = std::min(first, x), last = x + 1;
        }
        if (first >= last) return;
        const ui::Area place = s.place_of(rect_of(first, row, last, row + 1));
        const float y = s.area.y - ui_.px(3), tick = ui_.px(4);
        for (const bool halo : {true, false}) {
            const ui::Color color = halo ? theme_.panel : theme_[Role::text];
            const float width = halo ? 4 : 2;
            ui::line(ui_.list(), {place.x, y}, {place.right(), y}, width, color);
            ui::line(ui_.list(), {place.x, y - tick}, {place.x, y + tick}, width, color);
            ui::line(ui_.list(), {place.right(), y - tick}, {place.right(), y + tick}, width, color);
        }
    }

    void take_input(int n) {
        const Sheet3& s = sheets_[static_cast<std::size_t>(n)];
        const ui::Area area = ui::intersection(s.area, ui_.clip());
        const glm::vec2 mouse = ui_.input().mouse;
        const bool inside = area.contains(mouse);
        const glm::ivec2 at = inside ? s.at(mouse) : glm::ivec2(0);
        Selection here;
        std::string tip;
        if (inside && s.range.contains(at.x, at.y)) {
            const auto texel_at = [&](Integer u, Integer v) {
                return Selection{.kind = Selection::Kind::texel,
                                 .at = {wrap_index(u, texture_.width(), texture_.wrap),
                                        wrap_index(v, texture_.height(), texture_.wrap)}};
            };
            if (n == 0) here = texel_at(at.x, at.y), tip = fmt::format(kTexelTip, here.at.x, here.at.y);
            if (n == 2) {
                here = {.kind = Selection::Kind::pixel, .at = at};
                tip = fmt::format(kPixelTip, at.x, at.y);
            }
            if (n == 1) {
                const Integer u = tmp_at(at.x, at.y);
                const bool any = u != TwoPassBuffer::kNone && filled(at.x, at.y);
                if (any) here = texel_at(u, at.y);
                tip = any ? fmt::format(kCellTip, at.x, at.y, here.at.x, here.at.y)
                          : fmt::format(kNoTexelTip, at.x, at.y);
            }
        }
        const ui::Control region = ui_.control({.name = fmt::format("buffer/{}", n),
                                                .area = area,
                                                .kind = ui::Kind::region,
                                                .label = kTitles[static_cast<std::size_t>(n)],
                                                .tip = tip,
                                                .focusable = false});
        const bool on_it = region.hovered && here.kind != Selection::Kind::none;
        tell_hover(ctx_, area, on_it, here);
        if (region.clicked && on_it) point_or_pin(ctx_, here);
    }

    const ViewContext& ctx_;
    ui::Ui& ui_;
    const ui::Theme& theme_;
    const Texture& texture_;
    const TwoPassBuffer& tmp_;
    Passes at_;
    Rect texels_;
    ui::Area tuning_;
    float line_ = 0;
    bool below_ = false;  ///< the image stands below tmp
    std::array<Sheet3, 3> sheets_;
    std::array<ui::Area, 3> captions_;
};

void draw(const ViewContext& ctx, const ui::Area& place) {
    const ui::Area area = begin_view(ctx, "buffer", place, kTitle);
    if (ctx.derived.shape() < 0 || ctx.derived.method().id != "two-pass")
        draw_empty(ctx, area, kOther);
    else if (ctx.derived.two_pass_buffer().empty())
        draw_empty(ctx, area, kNone);
    else
        BufferView(ctx, area).draw();
    ctx.ui.end_panel();
}

constexpr View kView{"buffer", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::buffer_view
