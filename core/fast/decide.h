// What the fast rasterizer asks where its own arithmetic is in doubt.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/exact/triangle.h"
#include "core/fast/raster.h"

namespace texelscope {

/// The first pixel of row `row` at or right of the line through a and b: ceil(x(row + 1/2) - 1/2), by 128-bit division.
/// Requires coordinates that are 0 or from 2^-6 to 2^21, and a.y != b.y.
[[nodiscard]] int first_pixel(const Vertex& a, const Vertex& b, int row);

/// One triangle's texels, decided as cheaply as may be.
class TexelDecider {
public:
    TexelDecider(std::span<const Vertex, 3> corners, const RasterJob& job, const RasterTexture& texture,
                 RasterCounters& counters);
    /// The texel's place in the texture.
    [[nodiscard]] std::uint32_t at(int x, int y);

private:
    std::array<Vertex, 3> corners_;
    const RasterJob* job_;
    const RasterTexture* texture_;
    RasterCounters* counters_;
    std::optional<ExactTriangle> exact_;
};

}  // namespace texelscope
