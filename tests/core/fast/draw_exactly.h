// What the fast rasterizer must draw: every sample decided in whole numbers.
#pragma once

#include <algorithm>
#include <array>

#include "core/exact/triangle.h"
#include "core/fast/raster.h"

namespace texelscope {

/// As draw() takes them, for corners that are finite, with w > 0 where that counts.
inline void draw_exactly(const RasterTarget& target, const RasterTexture& texture, const RasterJob& job) {
    const auto lit = [&](std::uint32_t texel) {
        if (job.light == nullptr) return texel;
        std::uint32_t sum = texel & 0xFF000000U;
        for (int shift = 0; shift < 24; shift += 8) sum += (*job.light)[texel >> shift & 255U] << shift;
        return sum;
    };
    for (std::size_t n = 0; n < job.vertices.size(); n += 3) {
        std::array<Vertex, 3> corners{job.vertices[n], job.vertices[n + 1], job.vertices[n + 2]};
        if (!job.perspective)
            for (Vertex& c : corners) c.w = 1;
        const ExactTriangle triangle(corners, job.u_texels, job.v_texels);
        if (triangle.winding() == 0 || (job.cull_back && triangle.winding() < 0)) continue;
        for (int y = target.y0; y < target.y0 + target.height; ++y) {
            const PixelRange row = triangle.row(y, target.x0, target.x0 + target.width);
            for (Integer x = row.x0; x < row.x1; ++x) {
                const auto at = (y - target.y0) * target.pitch + (x - target.x0);
                if (job.depth) {
                    const float z = triangle.depth(x, y);
                    if (!(z < target.depth[at])) continue;
                    target.depth[at] = z;
                }
                const TexelIndex texel = triangle.texel(x, y);
                target.pixels[at] = lit(texture.texels[wrap_index(texel.v, texture.height, texture.wrap) *
                                                           std::max(texture.width, texture.pitch) +
                                                       wrap_index(texel.u, texture.width, texture.wrap)]);
            }
        }
    }
}

}  // namespace texelscope
