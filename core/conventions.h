// The only place that fixes the conventions; every other file refers to it.
//   Screen    x right, y down, row-major from the top left.
//   Sample    pixel (i, j) is sampled at (i + kSample, j + kSample).
//   Ownership the top-left rule: a side owns the samples on it if it is a left side, or exactly horizontal with
//             the interior below. Closed meshes then draw each pixel exactly once.
//   Front     a positive doubled area (x1-x0)(y2-y0) - (x2-x0)(y1-y0): clockwise as seen on the screen.
//   Depth     z in [0, 1], 0 near.
//   Texel     (0, 0) is the texture's top left; the texel of a sample is (floor u, floor v), then wrapped.
#pragma once

namespace texelscope {

inline constexpr double kSample = 0.5;  ///< where in its pixel a sample lies, along both axes [px]

}  // namespace texelscope
