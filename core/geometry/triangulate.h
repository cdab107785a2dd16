// Triangles of a convex polygon: a fan from its first corner.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/assert.h"
#include "core/geometry/vertex.h"

namespace texelscope {

using Triangle = std::array<Vertex, 3>;

/// How many triangles the fan of a polygon of `corners` corners has.
[[nodiscard]] constexpr int fan_size(std::size_t corners) noexcept {
    return corners < 3 ? 0 : static_cast<int>(corners) - 2;
}

/// Corners 0, i + 1, i + 2: triangle `i` of the fan, in the polygon's winding. Requires 0 <= i < fan_size.
[[nodiscard]] constexpr Triangle fan_triangle(std::span<const Vertex> corners, int i) noexcept {
    TEXELSCOPE_ASSERT(i >= 0 && i < fan_size(corners.size()));
    const auto at = static_cast<std::size_t>(i);
    return {corners[0], corners[at + 1], corners[at + 2]};
}

}  // namespace texelscope
