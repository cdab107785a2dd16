// Rounding of screen positions to a grid, as hardware does before it draws.
#pragma once

#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/vertex.h"

namespace texelscope {

inline constexpr int kMaxSnapBits = 60;

/// The nearest multiple of 2^-bits, of two equally near ones the even multiple; exact, since the result needs no more
/// digits than `value` has. Not a number and infinities stay. Requires 0 <= bits <= kMaxSnapBits.
[[nodiscard]] inline float snap(float value, int bits) noexcept {
    TEXELSCOPE_ASSERT(bits >= 0 && bits <= kMaxSnapBits);
    return static_cast<float>(std::ldexp(std::nearbyint(std::ldexp(double{value}, bits)), -bits));
}

/// The polygon with x and y snapped; the rest stays as it is.
[[nodiscard]] inline Polygon snapped(Polygon polygon, int bits) {
    for (Vertex& vertex : polygon.vertices) vertex.x = snap(vertex.x, bits), vertex.y = snap(vertex.y, bits);
    polygon.unrounded.corners.clear();
    return polygon;
}

}  // namespace texelscope
