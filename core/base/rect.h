// Whole-pixel rectangles.
#pragma once

#include <algorithm>
#include <cstdint>

namespace texelscope {

/// Half-open: columns [x0, x1), rows [y0, y1), in absolute pixels. Empty where x0 >= x1 or y0 >= y1.
struct Rect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    [[nodiscard]] constexpr bool empty() const { return x0 >= x1 || y0 >= y1; }
    [[nodiscard]] constexpr int width() const { return empty() ? 0 : x1 - x0; }
    [[nodiscard]] constexpr int height() const { return empty() ? 0 : y1 - y0; }
    [[nodiscard]] constexpr bool contains(std::int64_t x, std::int64_t y) const {
        return x >= x0 && x < x1 && y >= y0 && y < y1;
    }
    friend constexpr bool operator==(const Rect&, const Rect&) = default;
};

[[nodiscard]] constexpr Rect intersection(const Rect& a, const Rect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

}  // namespace texelscope
