// The five lanes of the timeline, each with the children of the unit above. One target, nearest lane by y, so that low
// lanes are no obstacle.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/math_of_tape.h"
#include "app/views/screen_parts.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kLanes = "Timeline: press or drag to go to a step";
constexpr float kCellGap = 1, kLeastCell = 3, kLeastTick = 2;

[[nodiscard]] std::size_t at(int n) { return static_cast<std::size_t>(n); }

/// The unit whose children a lane shows.
[[nodiscard]] Path above(const Path& step, Level level) {
    return level == Level::expression ? step.unit() : step.prefix(static_cast<int>(level));
}
[[nodiscard]] Path child(const Path& step, const Lane& lane, Integer n) {
    if (lane.level == Level::expression) return above(step, lane.level).child('e', n);
    return above(step, lane.level).child(lane.letter, lane.first + n * lane.step);
}
/// The lane's child that a path is or lies in.
[[nodiscard]] std::optional<Integer> place_of(const Path& path, const Path& step, const Lane& lane) {
    const Path parent = above(step, lane.level);
    const std::size_t depth = parent.parts.size();
    if (path.parts.size() <= depth || path.prefix(static_cast<int>(depth)) != parent) return std::nullopt;
    const PathPart& part = path.parts[depth];
    if (part.letter != (lane.level == Level::expression ? 'e' : lane.letter)) return std::nullopt;
    const Integer n = lane.level == Level::expression ? part.index : (part.index - lane.first) * lane.step;
    return n >= 0 && n < lane.count ? std::optional(n) : std::nullopt;
}

constexpr double kFolded = .5;  ///< width of a trivial expression, in widths of any other

[[nodiscard]] bool is_folded(const Lane& lane, Integer n) {
    const auto k = static_cast<std::size_t>(n);
    return k < lane.folded.size() && lane.folded[k] != 0;
}
/// Where child `n` begins, in widths of a child that is not folded; of `count` the lane's whole width.
[[nodiscard]] double begin_of(const Lane& lane, Integer n) {
    if (lane.folded.empty()) return static_cast<double>(n);
    double at = 0;
    for (Integer k = 0; k < n; ++k) at += is_folded(lane, k) ? kFolded : 1;
    return at;
}
/// The child at a share [0, 1] of the lane's width.
[[nodiscard]] Integer child_at(const Lane& lane, double share) {
    double left = share * begin_of(lane, lane.count);
    if (lane.folded.empty()) return std::min(lane.count - 1, static_cast<Integer>(left));
    for (Integer n = 0; n < lane.count; ++n) {
        left -= is_folded(lane, n) ? kFolded : 1;
        if (left < 0) return n;
    }
    return lane.count - 1;
}

struct Span {
    float x0 = 0, x1 = 0;
};

/// Draws one lane; knows where its children stand.
class LaneDrawer {
public:
    LaneDrawer(const ViewContext& context, const Lane& lane, const Area& area, bool labels)
        : c_(context), lane_(lane), area_(area), labels_(labels && area.h >= c_.ui.font(Face::count).cap + 2) {}

    [[nodiscard]] Span span(Integer n) const {
        const double all = begin_of(lane_, lane_.count);
        const auto x = [&](Integer k) {
            return area_.x + static_cast<float>(static_cast<double>(area_.w) * begin_of(lane_, k) / all);
        };
        return {std::round(x(n)), std::round(x(n + 1))};
    }
    [[nodiscard]] Span current() const {
        Span s = span(lane_.current);
        s.x1 = std::max(s.x1, s.x0 + kLeastTick);
        return s;
    }
    [[nodiscard]] float cell() const { return area_.w / static_cast<float>(std::max<Integer>(1, lane_.count)); }

    void draw() const {
        if (lane_.count <= 0) {
            ui::fill(list(), area_, ui::with_alpha(theme()[Role::rejected], .25F));
            return;
        }
        if (lane_.kinds.size() != static_cast<std::size_t>(lane_.count) && lane_.count > kMaxTicks) {
            draw_run({area_.x, area_.right()}, TickKind::rejected, 0);
        } else if (cell() < kLeastCell) {
            draw_runs();
        } else {
            draw_cells();
        }
        draw_current();
    }

private:
    [[nodiscard]] ImDrawList& list() const { return c_.ui.list(); }
    [[nodiscard]] const ui::Theme& theme() const { return c_.ui.theme(); }
    [[nodiscard]] TickKind kind(Integer n) const {
        const auto k = static_cast<std::size_t>(n);
        return k < lane_.kinds.size() ? lane_.kinds[k] : TickKind::rejected;
    }
    [[nodiscard]] bool later(Integer n) const { return lane_.current >= 0 ? n > lane_.current : true; }
    [[nodiscard]] ui::Color color(TickKind kind, Integer n) const {
        const bool loop = lane_.level == Level::scanline || lane_.level == Level::pixel;
        const bool covered = kind == TickKind::covered && loop;
        const ui::Color plain = theme()[covered ? Role::covered : Role::rejected];
        const float alpha = kind == TickKind::empty ? ui::alpha::kLaneFuture * .6F
                            : later(n)              ? ui::alpha::kLaneFuture
                                                    : 1.0F;
        return ui::over(plain, alpha, theme().bg);
    }
    void draw_mark(Span s) const {
        const float h = std::max(2.0F, c_.ui.px(3));
        ui::fill(list(), {s.x0, area_.y, std::max(kLeastTick, s.x1 - s.x0), h}, theme()[Role::error]);
    }
    void draw_run(Span s, TickKind kind, Integer n) const {
        ui::fill(list(), {s.x0, area_.y, s.x1 - s.x0, area_.h}, color(kind, n));
        if (kind == TickKind::mark) draw_mark(s);
    }
    void draw_runs() const {
        Integer from = 0;
        for (Integer n = 1; n <= lane_.count; ++n) {
            if (n < lane_.count && kind(n) == kind(from) && later(n) == later(from)) continue;
            draw_run({span(from).x0, span(n - 1).x1}, kind(from), from);
            from = n;
        }
    }
    void draw_cells() const {
        for (Integer n = 0; n < lane_.count; ++n) {
            Span s = span(n);
            s.x1 = std::max(s.x0 + 1, s.x1 - kCellGap);
            const ui::Color ground = color(kind(n), n);
            ui::fill(list(), {s.x0, area_.y, s.x1 - s.x0, area_.h}, ground);
            if (kind(n) == TickKind::mark) draw_mark(s);
            if (n != lane_.current) draw_label(n, s, ground, false);
        }
    }
    [[nodiscard]] std::string label(Integer n) const {
        const auto k = static_cast<std::size_t>(n);
        if (lane_.labels.empty()) return std::to_string(lane_.first + n * lane_.step);
        if (k >= lane_.labels.size()) return {};
        return lane_.labels[k] == "delta" ? "Δ" : lane_.labels[k];
    }
    void draw_label(Integer n, Span s, ui::Color ground, bool on_now) const {
        if (!labels_ || lane_.level == Level::triangle) return;
        const bool number = lane_.labels.empty(), expression = lane_.level == Level::expression;
        if (number && (lane_.level != Level::scanline || c_.state.cursor.level != Level::scanline)) return;
        const std::string text = label(n);
        const float pad = c_.ui.px(4), room = s.x1 - s.x0 - 2 * pad;
        const Face face = number ? Face::count : Face::note;
        const ui::Font& font = c_.ui.font(face);
        const ui::Expr name = expression ? symbol_of_name(text) : ui::word(text);
        const std::string &base = name.text, &sub = name.sub;
        const ui::Font& small = c_.ui.font(Face::ruler);
        const float width = ui::text_width(font, base) + (sub.empty() ? 0 : ui::text_width(small, sub) + 1);
        if (width > room) return;
        c_.ui.set_ground(ground);
        const bool dark_text = ui::contrast(theme()[Role::on_now], ground) > ui::contrast(theme()[Role::text], ground);
        const Role role = on_now || dark_text ? Role::on_now : Role::text;
        const float y = ui::baseline_at_middle(font, area_.centre().y), x = std::round((s.x0 + s.x1 - width) / 2);
        const float drawn = c_.ui.text(face, {x, y}, role, base);
        if (!sub.empty()) c_.ui.text(Face::ruler, {x + drawn + 1, y + 1}, role, sub);
        c_.ui.set_ground(theme().bg);
    }
    void draw_current() const {
        if (lane_.current < 0 || lane_.current >= lane_.count) return;
        const Span s = current();
        const float right = s.x1 - s.x0 > kLeastCell ? s.x1 - kCellGap : s.x1;
        const Area tick{s.x0, area_.y, right - s.x0, area_.h};
        const ui::Color now = theme()[Role::now];
        const bool here = lane_.level >= c_.state.cursor.level;
        const ui::Color ground =
            here ? now : ui::over(now, ui::alpha::kCoarseLane, color(kind(lane_.current), lane_.current));
        ui::fill(list(), tick, ground, here ? ui::size::kBadgeRadius - 1 : 0);
        if (!here) ui::fill(list(), {tick.x, tick.bottom() - 2, tick.w, 2}, now);
        if (cell() >= kLeastCell) draw_label(lane_.current, {tick.x, tick.right()}, ground, here);
    }

    const ViewContext& c_;
    const Lane& lane_;
    Area area_;
    bool labels_;
};

/// From the current tick down to the lane of its children.
void draw_funnel(const ViewContext& c, Span tick, const Area& from, const Area& to) {
    const std::array<glm::vec2, 4> shape{glm::vec2{tick.x0, from.bottom()}, glm::vec2{tick.x1, from.bottom()},
                                         glm::vec2{to.right(), to.y}, glm::vec2{to.x, to.y}};
    const ui::Color now = c.ui.theme()[Role::now];
    ui::fill_convex(c.ui.list(), shape, ui::with_alpha(now, ui::alpha::kFunnel));
    ui::line(c.ui.list(), shape[0], shape[3], 1, ui::with_alpha(now, ui::alpha::kFunnelEdge));
    ui::line(c.ui.list(), shape[1], shape[2], 1, ui::with_alpha(now, ui::alpha::kFunnelEdge));
}

void draw_selection(const ViewContext& c, const Highlight& highlight, float width, const Lane& lane,
                    const LaneDrawer& drawer, const Area& area) {
    for (const Path& tick : highlight.ticks) {
        const auto n = place_of(tick, c.state.cursor.step, lane);
        if (!n) continue;
        const Span s = drawer.span(*n);
        ui::frame(c.ui.list(), Area{s.x0, area.y, std::max(kLeastCell, s.x1 - s.x0), area.h}.inset(-width, -width),
                  c.ui.theme()[Role::now], width);
    }
}

void draw_bookmarks(const ViewContext& c, const Lane& lane, const LaneDrawer& drawer, const Area& area) {
    for (const Path& mark : c.state.bookmarks) {
        const auto n = place_of(mark, c.state.cursor.step, lane);
        if (!n) continue;
        const Span s = drawer.span(*n);
        const float x = (s.x0 + s.x1) / 2, r = c.ui.px(4), y = area.y - 1;
        const std::array<glm::vec2, 3> flag{glm::vec2{x - r, y - r / 2}, glm::vec2{x + r, y - r / 2},
                                            glm::vec2{x, y + r}};
        ui::fill_convex(c.ui.list(), flag, c.ui.theme()[Role::text]);
    }
}

struct Target {
    int lane = -1;  ///< -1: none, every lane is empty
    Integer tick = 0;
};
[[nodiscard]] Target target_at(const std::vector<Lane>& lanes, const Area& place, float pitch, glm::vec2 press,
                               float x) {
    Target best;
    float nearest = 0;
    for (int n = 0; n < kLevels; ++n) {
        if (lanes[at(n)].count <= 0) continue;
        const float away = std::abs(press.y - lane_place(place, pitch, n).centre().y);
        if (best.lane >= 0 && away >= nearest) continue;
        const auto share = static_cast<double>(std::clamp((x - place.x) / std::max(1.0F, place.w), 0.0F, 1.0F));
        best = Target{n, child_at(lanes[at(n)], share)};
        nearest = away;
    }
    return best;
}

[[nodiscard]] std::string describe(const ViewContext& c, const Lane& lane, Integer n) {
    const Path path = child(c.state.cursor.step, lane, n);
    const auto k = static_cast<std::size_t>(n);
    std::string name =
        k < lane.labels.size() ? lane.labels[k]
        : path.parts.back().letter == 't'
            ? fmt::format("triangle {}", n + 1)
            : fmt::format("{} {}",
                          lane.level == Level::scanline && lane.letter == 'y' ? "row"
                          : lane.level == Level::pixel && lane.letter == 'x'  ? "pixel"
                                                                              : std::string(1, lane.letter),
                          path.parts.back().index);
    if (lane.level == Level::expression || lane.level == Level::stage) return name;
    const Visit& visit = c.derived.steps().at(path);
    const auto fate = lane.level == Level::triangle ? std::optional(visit.shape_fate)
                      : visit.units.empty()         ? std::nullopt
                                                    : visit.unit().fate;
    return fate ? fmt::format("{}: {}", name, text_of(*fate)) : name;
}

}  // namespace

Area lane_place(const Area& place, float pitch, int n) {
    const float height = std::max(2.0F, std::round(pitch * .65F));
    return {place.x, std::round(place.y + pitch * static_cast<float>(n)), place.w, height};
}

void draw_lanes(const ViewContext& c, const Area& place, const LaneStyle& style) {
    const std::vector<Lane> lanes = c.derived.lanes();
    if (lanes.size() < at(kLevels)) return;
    const glm::vec2 mouse = c.ui.input().mouse;
    const Path& step = c.state.cursor.step;
    std::string tip;
    const Target hovered = place.contains(mouse) ? target_at(lanes, place, style.pitch, mouse, mouse.x) : Target{};
    if (hovered.lane >= 0) tip = describe(c, lanes[at(hovered.lane)], hovered.tick);
    const ui::Control control = c.ui.control({"timeline/lanes", place, ui::Kind::slider, kLanes, tip});

    for (int n = 0; n < kLevels; ++n) {
        const Area area = lane_place(place, style.pitch, n);
        const LaneDrawer drawer(c, lanes[at(n)], area, style.labels);
        const bool below = n + 1 < kLevels && lanes[at(n + 1)].count > 0;
        if (lanes[at(n)].current >= 0 && below)
            draw_funnel(c, drawer.current(), area, lane_place(place, style.pitch, n + 1));
    }
    for (int n = 0; n < kLevels; ++n) {
        const Lane& lane = lanes[at(n)];
        const Area area = lane_place(place, style.pitch, n);
        const LaneDrawer drawer(c, lane, area, style.labels);
        drawer.draw();
        if (lane.count <= 0) continue;
        draw_bookmarks(c, lane, drawer, area);
        draw_selection(c, c.hover, 1, lane, drawer, area);
        draw_selection(c, c.pinned, 2, lane, drawer, area);
    }

    if (control.held) {
        const Target target = target_at(lanes, place, style.pitch, c.ui.memory().press, mouse.x);
        if (target.lane < 0) return;
        const Path path = child(step, lanes[at(target.lane)], target.tick);
        if (path != step || static_cast<int>(c.state.cursor.level) != target.lane) c.act(action::StepTo{path});
    } else if (control.hovered && hovered.lane >= 0) {
        Selection selection;
        selection.kind = Selection::Kind::tick;
        selection.tick = child(step, lanes[at(hovered.lane)], hovered.tick);
        c.act(action::Hover{selection});
    }
}

}  // namespace texelscope
