// What all of the rasterizer's loops know: where to draw, from what, and how texels are found.
#pragma once

#include "core/fast/last_covers.h"
#include "core/fast/raster.h"
#include "core/fast/strips.h"
#include "core/fast/tiles.h"

namespace texelscope {

/// How u becomes a column. Units are such that int32 keeps what is needed of u.
enum class Addressing : std::uint8_t {
    powers,    ///< 2^-32 of the texture, which repeats as the number overflows; sizes are powers of two
    any_size,  ///< the same, and the column is the upper half of a product with the size
    clamped,   ///< 2^-shift texel, the shift a triangle's own
    halves,    ///< powers, but counted in 2^-16 texel: how some rows are drawn (halves-inl.h), no canvas's own
};

struct Canvas {
    RasterTarget target;
    RasterTexture texture;
    const RasterJob* job;
    const RasterSettings* settings;
    RasterCounters* counters;
    DepthTiles* tiles = nullptr;         ///< null without a depth test
    bool overdrawn = false;              ///< what later triangles cover is worth finding
    const LastCovers* covers = nullptr;  ///< null: nobody knows
    const Band* band = nullptr;          ///< null: all triangles are looked at
    Addressing addressing;
    int u_bits = 0, v_bits = 0;  ///< log2 of the size, where addressing is by powers
    double u_unit, v_unit;       ///< units in one unit of the vertices' u and v, but where clamped

    [[nodiscard]] int triangles() const { return static_cast<int>(job->vertices.size() / 3); }
    [[nodiscard]] const Vertex* corners(int triangle) const {
        return job->vertices.data() + std::ptrdiff_t{triangle} * 3;
    }
};

}  // namespace texelscope
