// Who drives the loop? Two pictures of one shape in lockstep: what its texture has written so far (forward), and what
// the screen would have (backward). Pixels left empty are hatched, those written again are marked.
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "app/state/lockstep.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"
#include "app/views/tuning.h"

namespace texelscope::canvas::lockstep_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Lockstep";
constexpr std::string_view kOther = "Lockstep is for the methods **forward** and **backward**.";
constexpr std::string_view kOutside = "Nothing of the shape lies on the screen.";
constexpr std::array<std::string_view, 2> kTitles{"Forward", "Backward"};
constexpr std::array<std::string_view, 2> kRows{"{} of {} rows of texels", "{} of {} rows of pixels"};
constexpr std::string_view kFewRows = "{} of {} rows";  // where there is little room
constexpr std::string_view kEmpty = "{:.1f} % empty: {} of {}", kShare = "{:.1f} % empty", kAgain = "{} written again";
constexpr std::string_view kOnce = "{} drawn, each once", kTwice = "{} drawn, {} of them again";
constexpr std::string_view kSoFar = "{} written so far", kNothing = "nothing written yet";
constexpr std::string_view kTip = "pixel **{}, {}**: written {} times by the texture, {} by the screen";
constexpr float kRoomy = 8, kNumbersFrom = 15;  ///< window pixels per pixel at 100 %: whole shapes; counts as numbers
constexpr int kSnap = 8;                        ///< the part in view moves by so many pixels at a time

[[nodiscard]] Rgba opaque(Rgb c) { return {c.r, c.g, c.b, 255}; }

/// Which pixels are in view, and where.
struct Part {
    Rect pixels;
    ui::Area area;
    float zoom = 1;

    [[nodiscard]] ui::Area place_of(const Rect& r) const {
        return {area.x + static_cast<float>(r.x0 - pixels.x0) * zoom,
                area.y + static_cast<float>(r.y0 - pixels.y0) * zoom, static_cast<float>(r.width()) * zoom,
                static_cast<float>(r.height()) * zoom};
    }
    [[nodiscard]] ui::Area place_of(glm::ivec2 p) const { return place_of(Rect{p.x, p.y, p.x + 1, p.y + 1}); }
};

class LockstepView {
public:
    LockstepView(const ViewContext& ctx, const ui::Area& area)
        : ctx_(ctx), ui_(ctx.ui), theme_(ctx.ui.theme()), made_(ctx.derived.lockstep()), area_(area) {
        const Selection& pinned = ctx.state.pinned;
        if (pinned.kind == Selection::Kind::pixel && made_.rect.contains(pinned.at.x, pinned.at.y))
            focus_ = pinned.at;
        else if (made_.begun && !made_.done)
            focus_ = (made_.forward_last + made_.backward_last) / 2;
        else
            focus_ = {(made_.rect.x0 + made_.rect.x1) / 2, (made_.rect.y0 + made_.rect.y1) / 2};
    }

    void draw() {
        const float row = tuning_height(ui_) + ui_.px(4), line = pitch(ui_, 18, ui::Face::prose);
        ui::Area rest = area_;
        if (has_pose_tuning(ctx_) && rest.h > row + 4 * line + ui_.px(90)) {
            rest.h -= row;
            draw_pose_tuning(ctx_, {rest.x, rest.bottom(), rest.w, tuning_height(ui_)}, true);
        }
        const float gap = ui_.px(16);
        const bool beside = rest.w > rest.h;
        for (int way = 0; way < 2; ++way) {
            const auto n = static_cast<float>(way);
            const float w = std::floor((rest.w - gap) / 2), h = std::floor((rest.h - ui_.px(6)) / 2);
            draw_way(way,
                     beside ? ui::Area{rest.x + n * (w + gap), rest.y, w, rest.h}
                            : ui::Area{rest.x, rest.y + n * (h + ui_.px(6)), rest.w, h},
                     line);
        }
    }

private:
    [[nodiscard]] const LockstepCell& cell(glm::ivec2 p) const {
        return made_.cells.at(p.x - made_.rect.x0, p.y - made_.rect.y0);
    }
    [[nodiscard]] bool written(int way, glm::ivec2 p) const {
        const LockstepCell& c = cell(p);
        return way == 0 ? c.writes > 0 : c.drawn;
    }

    void draw_way(int way, const ui::Area& place, float line) {
        const ui::Font& lead = ui_.font(ui::Face::lead);
        const float used = ui_.text_within(ui::Face::lead, {place.x, place.y + line * .72F}, place.w, Role::text,
                                           kTitles[static_cast<std::size_t>(way)]) +
                           lead.em * .8F;
        const Integer all = way == 0 ? made_.forward_rows : made_.backward_rows;
        const Integer rows = std::min(made_.rows, all);
        write({place.x + used, place.y + line * .72F}, std::max(0.0F, place.w - used), Role::muted,
              fmt::format(fmt::runtime(kRows[static_cast<std::size_t>(way)]), rows, all),
              fmt::format(kFewRows, rows, all));
        const int lines = 2;
        const ui::Area room{place.x, place.y + line, place.w, std::max(1.0F, place.h - line * (1 + lines) - ui_.px(4))};
        const Part part = part_in(room);
        ui_.begin_clip(room);
        draw_picture(way, part);
        if (way == 0) draw_marks(part);
        draw_selections(way, part);
        ui_.end_clip();
        take_input(way, part, room);
        draw_figures(way, {place.x, room.bottom() + ui_.px(4), place.w, line * static_cast<float>(lines)}, line);
    }

    /// The text, or a shorter one where it does not fit.
    void write(glm::vec2 pen, float width, Role role, const std::string& text, const std::string& shorter) {
        const bool fits = ui::text_width(ui_.font(ui::Face::prose), text) <= width;
        ui_.text_within(ui::Face::prose, pen, width, role, fits ? text : shorter);
    }

    /// The whole shape where its pixels are large enough, else what lies round the focus.
    [[nodiscard]] Part part_in(const ui::Area& room) const {
        const Rect& all = made_.rect;
        const float fits =
            std::floor(std::min(room.w / static_cast<float>(all.width()), room.h / static_cast<float>(all.height())));
        Part part{.pixels = all, .area = room, .zoom = std::max(fits, ui_.px(kRoomy))};
        const auto cut = [&](float length, int focus, int low, int high) {
            const int count = std::max(1, static_cast<int>(length / part.zoom));
            if (count >= high - low) return std::pair(low, high);
            const int first = (focus - count / 2) / kSnap * kSnap;
            const int from = std::clamp(first, low, high - count);
            return std::pair(from, from + count);
        };
        std::tie(part.pixels.x0, part.pixels.x1) = cut(room.w, focus_.x, all.x0, all.x1);
        std::tie(part.pixels.y0, part.pixels.y1) = cut(room.h, focus_.y, all.y0, all.y1);
        part.area.w = static_cast<float>(part.pixels.width()) * part.zoom;
        part.area.h = static_cast<float>(part.pixels.height()) * part.zoom;
        return part;
    }

    void draw_picture(int way, const Part& part) {
        Grid<Rgba> pixels(part.pixels.width(), part.pixels.height());
        for (int y = part.pixels.y0; y < part.pixels.y1; ++y) {
            for (int x = part.pixels.x0; x < part.pixels.x1; ++x) {
                const LockstepCell& c = cell({x, y});
                pixels.at(x - part.pixels.x0, y - part.pixels.y0) =
                    written(way, {x, y}) ? opaque(way == 0 ? c.forward : c.backward) : Rgba{0, 0, 0, 0};
            }
        }
        ui::fill(ui_.list(), part.area, theme_.canvas);
        const ImTextureID id =
            ctx_.textures.image(ui::id_of(fmt::format("lockstep/{}", way)), version_of(pixels), pixels);
        ui_.list().AddImage(id, {part.area.x, part.area.y}, {part.area.right(), part.area.bottom()});
        ui::frame(ui_.list(), part.area, theme_[Role::faint], 1);
    }

    /// Empty in the end, and beside what is written already: no later texel comes there.
    [[nodiscard]] bool is_hole(glm::ivec2 p) const {
        const LockstepCell& c = cell(p);
        if (!c.inside || c.writes_in_all > 0) return false;
        for (int y = std::max(p.y - 1, made_.rect.y0); y <= std::min(p.y + 1, made_.rect.y1 - 1); ++y)
            for (int x = std::max(p.x - 1, made_.rect.x0); x <= std::min(p.x + 1, made_.rect.x1 - 1); ++x)
                if (cell({x, y}).writes > 0) return true;
        return false;
    }
    void draw_hatched(const ui::Area& a, glm::vec2 origin) {
        const std::array<glm::vec2, 4> quad{{{a.x, a.y}, {a.right(), a.y}, {a.right(), a.bottom()}, {a.x, a.bottom()}}};
        ui::draw_hatch(ui_.list(), quad, 45, ui_.px(4), origin, 1.3F, theme_[Role::error]);
    }
    void draw_again(const ui::Area& a, int times) {
        const float side = std::max(3.0F, std::round(std::min(a.w, a.h) * .5F));
        const ui::Area mark{std::round(a.centre().x - side / 2), std::round(a.centre().y - side / 2), side, side};
        const std::string text = times > 9 ? "+" : fmt::format("{}", times);
        const ui::Font& font = ui_.font(ui::Face::ruler);
        if (a.w >= ui_.px(kNumbersFrom) && a.h >= font.em * 1.2F && a.w >= font.em * 1.2F) {
            const ui::Color plain = ui_.ground();
            ui_.set_ground(theme_.canvas);
            const ui::Area plate{std::round(a.centre().x - font.em * .5F), std::round(a.centre().y - font.em * .6F),
                                 std::round(font.em), std::round(font.em * 1.2F)};
            ui::fill(ui_.list(), plate, theme_.canvas, 2);
            ui_.text_centred(ui::Face::ruler, plate, Role::text, text);
            ui_.set_ground(plain);
            return;
        }
        ui::fill(ui_.list(), mark.inset(-1, -1), theme_.outline);
        ui::fill(ui_.list(), mark, IM_COL32(255, 255, 255, 255));
    }
    void draw_marks(const Part& part) {
        const glm::vec2 origin(part.area.x, part.area.y);
        for (int y = part.pixels.y0; y < part.pixels.y1; ++y) {
            for (int x = part.pixels.x0; x < part.pixels.x1; ++x) {
                int end = x;
                while (end < part.pixels.x1 && is_hole({end, y})) ++end;
                if (end > x) draw_hatched(part.place_of(Rect{x, y, end, y + 1}), origin);
                x = std::max(x, end - 1);
            }
        }
        for (int y = part.pixels.y0; y < part.pixels.y1; ++y)
            for (int x = part.pixels.x0; x < part.pixels.x1; ++x)
                if (const int times = cell({x, y}).writes; times > 1)
                    draw_again(part.place_of(glm::ivec2(x, y)), times);
    }

    [[nodiscard]] static bool shows(const Part& part, glm::ivec2 p) { return part.pixels.contains(p.x, p.y); }
    void draw_selections(int way, const Part& part) {
        for (const glm::ivec2 p : ctx_.pinned.pixels)
            if (shows(part, p)) ui::frame(ui_.list(), part.place_of(p).inset(-2, -2), theme_[Role::now], 2);
        for (const glm::ivec2 p : ctx_.hover.pixels)
            if (shows(part, p)) ui::frame(ui_.list(), part.place_of(p).inset(-1, -1), theme_[Role::now], 1);
        for (const glm::ivec2 p : pointing(ctx_.state, Prediction::Kind::pixel).places) {
            if (!shows(part, p)) continue;
            ui::frame(ui_.list(), part.place_of(p).inset(-2, -2), theme_.outline, 4);
            ui::frame(ui_.list(), part.place_of(p).inset(-1, -1), IM_COL32(255, 255, 255, 255), 2);
        }
        if (!made_.begun || made_.done) return;
        const glm::ivec2 last = way == 0 ? made_.forward_last : made_.backward_last;
        if (shows(part, last)) ui::pixel_ring(ui_.list(), part.place_of(last), theme_[Role::now], theme_.outline, 2.5F);
    }

    void draw_figures(int way, const ui::Area& place, float line) {
        glm::vec2 pen{place.x, place.y + line * .72F};
        Integer so_far = 0;
        for (std::size_t n = 0; n < made_.cells.size(); ++n)
            so_far += way == 0 ? made_.cells.data()[n].writes > 0 : made_.cells.data()[n].drawn;
        if (!made_.done) {
            ui_.text_within(ui::Face::prose, pen, place.w, Role::muted,
                            so_far > 0 ? fmt::format(kSoFar, so_far) : std::string(kNothing));
            return;
        }
        if (way == 1) {
            const std::string text = made_.backward_again == 0
                                         ? fmt::format(kOnce, made_.inside)
                                         : fmt::format(kTwice, made_.inside, made_.backward_again);
            ui_.text_within(ui::Face::prose, pen, place.w, Role::text, text);
            return;
        }
        const float side = ui_.px(12), indent = side + ui_.px(6);
        const auto swatch = [&] { return ui::Area{pen.x, std::round(pen.y - side * .9F), side, side}; };
        draw_hatched(swatch(), {pen.x, pen.y});
        ui::frame(ui_.list(), swatch(), theme_[Role::error], 1);
        const double share =
            made_.inside > 0 ? 100.0 * static_cast<double>(made_.holes) / static_cast<double>(made_.inside) : 0;
        write({pen.x + indent, pen.y}, place.w - indent, Role::text,
              fmt::format(kEmpty, share, made_.holes, made_.inside), fmt::format(kShare, share));
        pen.y += line;
        ui::fill(ui_.list(), swatch(), theme_[Role::covered]);
        draw_again(swatch(), 2);
        ui_.text_within(ui::Face::prose, {pen.x + indent, pen.y}, place.w - indent, Role::text,
                        fmt::format(kAgain, made_.again));
    }

    void take_input(int way, const Part& part, const ui::Area& room) {
        const ui::Area area = ui::intersection(part.area, room);
        const glm::vec2 mouse = ui_.input().mouse;
        const bool inside = area.contains(mouse) && ui_.clip().contains(mouse);
        const glm::vec2 in = inside ? (mouse - glm::vec2(part.area.x, part.area.y)) / part.zoom : glm::vec2(0);
        const glm::ivec2 pixel = glm::ivec2(part.pixels.x0, part.pixels.y0) + glm::ivec2(glm::floor(in));
        const bool on_pixel = inside && shows(part, pixel);
        const std::string tip = on_pixel
                                    ? fmt::format(kTip, pixel.x, pixel.y, cell(pixel).writes, cell(pixel).drawn ? 1 : 0)
                                    : std::string();
        const ui::Control region = ui_.control({.name = fmt::format("lockstep/{}", way),
                                                .area = area,
                                                .kind = ui::Kind::region,
                                                .label = kTitles[static_cast<std::size_t>(way)],
                                                .tip = tip,
                                                .focusable = false});
        const Selection here{.kind = Selection::Kind::pixel, .at = pixel};
        tell_hover(ctx_, area, on_pixel && region.hovered, here);
        if (region.clicked && on_pixel) point_or_pin(ctx_, here);
    }

    const ViewContext& ctx_;
    ui::Ui& ui_;
    const ui::Theme& theme_;
    const Lockstep& made_;
    ui::Area area_;
    glm::ivec2 focus_{0};
};

void draw(const ViewContext& ctx, const ui::Area& place) {
    const ui::Area area = begin_view(ctx, "lockstep", place, kTitle);
    if (ctx.derived.shape() < 0 || !has_directions(ctx.derived.method()))
        draw_empty(ctx, area, kOther);
    else if (ctx.derived.lockstep().rect.empty())
        draw_empty(ctx, area, kOutside);
    else
        LockstepView(ctx, area).draw();
    ctx.ui.end_panel();
}

constexpr View kView{"lockstep", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::lockstep_view
