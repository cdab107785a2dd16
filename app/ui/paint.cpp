#include "app/ui/paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace texelscope::ui {
namespace {

constexpr std::array<float, 2> kEdgeB{9, 5}, kEdgeC{2, 4.5F};
constexpr float kMostStrokes = 10'000;

float cross_of(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

float signed_area(std::span<const glm::vec2> polygon) {
    float twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross_of(polygon[i], polygon[(i + 1) % polygon.size()]);
    return twice / 2;
}

}  // namespace

DashPattern edge_pattern(int edge) {
    if (edge == 1) return kEdgeB;
    if (edge == 2) return kEdgeC;
    return {};
}

std::vector<Segment> dashes(std::span<const glm::vec2> path, DashPattern pattern) {
    std::vector<Segment> out;
    float period = 0, length = 0;
    for (const float part : pattern) period += part;
    for (std::size_t i = 1; i < path.size(); ++i) length += glm::distance(path[i - 1], path[i]);
    const bool solid = pattern.empty() || period < 0.5F || !(length / period < kMostStrokes);
    std::size_t part = 0;
    float left = solid ? 0 : pattern[0];
    for (std::size_t i = 1; i < path.size(); ++i) {
        const glm::vec2 a = path[i - 1], b = path[i];
        const float whole = glm::distance(a, b);
        if (!(whole > 0)) continue;
        if (solid) {
            out.push_back({a, b});
            continue;
        }
        const glm::vec2 way = (b - a) / whole;
        for (float at = 0; at < whole;) {
            const float end = std::min(whole, at + left);
            if (part % 2 == 0 && end > at) out.push_back({a + way * at, a + way * end});
            left -= end - at;
            at = end;
            if (at >= whole) break;
            part = (part + 1) % pattern.size();
            left = pattern[part];
        }
    }
    return out;
}

void draw_dashed(ImDrawList& list, std::span<const glm::vec2> path, DashPattern pattern, float width, Color color) {
    for (const Segment& s : dashes(path, pattern)) line(list, s.from, s.to, width, color);
}

std::optional<Segment> clipped(Segment s, std::span<const glm::vec2> convex) {
    if (convex.size() < 3) return std::nullopt;
    const float turn = signed_area(convex) < 0 ? -1.0F : 1.0F;
    const glm::vec2 way = s.to - s.from;
    float enter = 0, leave = 1;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const glm::vec2 a = convex[i], side = convex[(i + 1) % convex.size()] - a;
        const float inside = turn * cross_of(side, s.from - a), slope = turn * cross_of(side, way);
        if (slope == 0) {
            if (inside < 0) return std::nullopt;
            continue;
        }
        const float t = -inside / slope;
        (slope > 0 ? enter : leave) = slope > 0 ? std::max(enter, t) : std::min(leave, t);
    }
    if (!(enter < leave)) return std::nullopt;
    return Segment{s.from + way * enter, s.from + way * leave};
}

std::vector<glm::vec2> clipped_to_half_plane(std::span<const glm::vec2> convex, glm::vec2 normal, float offset) {
    std::vector<glm::vec2> out;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const glm::vec2 a = convex[i], b = convex[(i + 1) % convex.size()];
        const float da = glm::dot(normal, a) - offset, db = glm::dot(normal, b) - offset;
        if (da <= 0) out.push_back(a);
        if ((da < 0 && db > 0) || (da > 0 && db < 0)) out.push_back(a + (b - a) * (da / (da - db)));
    }
    return out.size() < 3 ? std::vector<glm::vec2>{} : out;
}

std::vector<Segment> hatch(std::span<const glm::vec2> convex, float degrees, float step, glm::vec2 origin) {
    std::vector<Segment> out;
    if (convex.size() < 3 || !(step > 0)) return out;
    const float turn = degrees * std::numbers::pi_v<float> / 180;
    const glm::vec2 way{std::cos(turn), std::sin(turn)}, across{-way.y, way.x};
    float low = INFINITY, high = -INFINITY, begin = INFINITY, end = -INFINITY;
    for (const glm::vec2 p : convex) {
        low = std::min(low, glm::dot(across, p - origin)), high = std::max(high, glm::dot(across, p - origin));
        begin = std::min(begin, glm::dot(way, p - origin)), end = std::max(end, glm::dot(way, p - origin));
    }
    if (!((high - low) / step < kMostStrokes)) return out;
    for (float n = std::ceil(low / step); n * step <= high; ++n) {
        const glm::vec2 foot = origin + across * (n * step);
        if (const auto s = clipped({foot + way * (begin - 1), foot + way * (end + 1)}, convex)) out.push_back(*s);
    }
    return out;
}

void draw_hatch(ImDrawList& list, std::span<const glm::vec2> convex, float degrees, float step, glm::vec2 origin,
                float width, Color color) {
    for (const Segment& s : hatch(convex, degrees, step, origin)) line(list, s.from, s.to, width, color);
}

float section_degrees(int section) {
    static constexpr std::array<float, 5> kDegrees{45, -45, 0, 90, 45};
    return kDegrees[static_cast<std::size_t>(section % 5)];
}

void fill_convex(ImDrawList& list, std::span<const glm::vec2> convex, Color color) {
    if (convex.size() < 3) return;
    std::vector<ImVec2> points;
    for (const glm::vec2 p : convex) points.push_back(to_im(p));
    // ImGui's anti-aliasing fringe points outwards only for polygons that run clockwise on the screen.
    if (signed_area(convex) < 0) std::reverse(points.begin(), points.end());
    list.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), color);
}

void fill(ImDrawList& list, const Area& area, Color color, float radius) {
    if (!area.empty()) list.AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, color, radius);
}

void frame(ImDrawList& list, const Area& area, Color color, float width, float radius) {
    if (area.empty()) return;
    if (radius > 0) {
        const float half = width / 2;
        list.AddRect({area.x + half, area.y + half}, {area.right() - half, area.bottom() - half}, color, radius, 0,
                     width);
        return;
    }
    const float x = std::round(area.x), y = std::round(area.y), r = std::round(area.right()),
                b = std::round(area.bottom()), w = std::max(1.0F, std::round(width));
    fill(list, {x, y, r - x, w}, color);
    fill(list, {x, b - w, r - x, w}, color);
    fill(list, {x, y + w, w, b - y - 2 * w}, color);
    fill(list, {r - w, y + w, w, b - y - 2 * w}, color);
}

void pixel_ring(ImDrawList& list, const Area& pixel, Color now, Color outline, float width, float outline_px) {
    const float inner = std::max(1.0F, std::round(outline_px)), ring = std::max(1.0F, std::round(width));
    const auto around = [&](float by) { return Area{pixel.x - by, pixel.y - by, pixel.w + 2 * by, pixel.h + 2 * by}; };
    frame(list, around(inner), outline, inner);
    frame(list, around(inner + ring), now, ring);
    frame(list, around(2 * inner + ring), outline, inner);
}

}  // namespace texelscope::ui
