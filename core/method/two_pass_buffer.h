// The buffer between the two passes, as a picture of its own: which texel came to which column.
#pragma once

#include <vector>

#include "core/method/method.h"

namespace texelscope {

/// tmp[x][v] after the first pass.
struct TwoPassBuffer {
    static constexpr Integer kNone = INT64_MIN;
    Integer x0 = 0, x1 = 0;  ///< columns of the picture [px], half-open
    Integer v0 = 0, v1 = 0;  ///< rows of the texture [texels], half-open; one more than the shape's on either side
    std::vector<Integer> u;  ///< the texel's column before wrapping, row by row; kNone where none came
    double width = 0;        ///< columns that the shape's middle row of texels takes up [px]
    double texels = 0;       ///< texels in that row

    [[nodiscard]] bool empty() const { return u.empty(); }
    [[nodiscard]] Integer at(Integer x, Integer v) const {
        return u[static_cast<std::size_t>((v - v0) * (x1 - x0) + x - x0)];
    }
};

/// Runs the first pass of two-pass alone. Empty where the method draws nothing of the shape.
/// @param job  of the method two-pass: its quirks decide which way the pass goes.
[[nodiscard]] TwoPassBuffer two_pass_buffer(NumberFormat format, const Job& job);

}  // namespace texelscope
