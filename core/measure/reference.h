// What a triangle draws, decided exactly, in the form that others are compared with.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/base/rect.h"
#include "core/exact/triangle.h"

namespace texelscope {

struct DecidedSample {
    Integer x = 0, y = 0;
    TexelIndex texel;  ///< before wrapping
};

/// Row by row from the left. None where a number is not finite or some w <= 0.
[[nodiscard]] std::vector<DecidedSample> decided_samples(std::span<const Vertex, 3> corners, const Rect& frame);

/// u and v of a triangle's samples: in units of at most 2^-60 of the largest at a corner, or of whole texels beyond
/// 2^60.
class ExactCoordinates {
public:
    explicit ExactCoordinates(std::span<const Vertex, 3> corners);
    /// u and v of a sample that the triangle owns, in those units.
    [[nodiscard]] TexelIndex at(Integer x, Integer y) const { return triangle_.texel(x, y); }
    /// How far u, v are from those of at(), at least; infinite for NaN [texels].
    [[nodiscard]] std::array<double, 2> distance(const TexelIndex& at, double u, double v) const;

private:
    std::array<int, 2> bits_{};  ///< behind the point
    ExactTriangle triangle_;     ///< u and v in these units
};

/// The corners as hexadecimal floats: x, y, w, u, v.
[[nodiscard]] std::string text_of(std::span<const Vertex> corners);

}  // namespace texelscope
