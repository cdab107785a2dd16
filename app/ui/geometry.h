// Places on the window, in pixels with y down.
#pragma once

#include <algorithm>

#include <imgui.h>
#include <glm/vec2.hpp>

namespace texelscope::ui {

/// Half-open in both directions: a point on the right or bottom border lies outside.
struct Area {
    float x = 0, y = 0, w = 0, h = 0;

    [[nodiscard]] constexpr float right() const { return x + w; }
    [[nodiscard]] constexpr float bottom() const { return y + h; }
    [[nodiscard]] constexpr bool empty() const { return !(w > 0 && h > 0); }
    [[nodiscard]] constexpr bool contains(glm::vec2 p) const {
        return p.x >= x && p.x < right() && p.y >= y && p.y < bottom();
    }
    /// True where `b` lies inside this, give or take `slack` pixels.
    [[nodiscard]] constexpr bool covers(const Area& b, float slack = 0) const {
        return b.x >= x - slack && b.y >= y - slack && b.right() <= right() + slack && b.bottom() <= bottom() + slack;
    }
    [[nodiscard]] glm::vec2 centre() const { return {x + w / 2, y + h / 2}; }
    [[nodiscard]] constexpr Area inset(float dx, float dy) const {
        return {x + dx, y + dy, std::max(0.0F, w - 2 * dx), std::max(0.0F, h - 2 * dy)};
    }
    [[nodiscard]] constexpr Area moved(float dx, float dy) const { return {x + dx, y + dy, w, h}; }
    friend constexpr bool operator==(const Area&, const Area&) = default;
};

[[nodiscard]] constexpr Area intersection(const Area& a, const Area& b) {
    const float x0 = std::max(a.x, b.x), y0 = std::max(a.y, b.y);
    return {x0, y0, std::max(0.0F, std::min(a.right(), b.right()) - x0),
            std::max(0.0F, std::min(a.bottom(), b.bottom()) - y0)};
}

/// `a` grown about its centre to at least `least` in each direction.
[[nodiscard]] constexpr Area grown_to(const Area& a, float least) {
    const float dx = std::max(0.0F, least - a.w) / 2, dy = std::max(0.0F, least - a.h) / 2;
    return {a.x - dx, a.y - dy, a.w + 2 * dx, a.h + 2 * dy};
}

[[nodiscard]] inline ImVec2 to_im(glm::vec2 p) { return {p.x, p.y}; }

}  // namespace texelscope::ui
