// The rasterizer's loops are compiled once for each SIMD target; each of these says here where it is.
#pragma once

#include <cstdint>

#include "core/fast/canvas.h"
#include "core/fast/strips.h"

namespace texelscope {

struct Loops {
    void (*draw)(const Canvas&);  ///< all triangles, or those of the canvas' band
    /// Notes which strips of the canvas' target the triangles [first, last) meet.
    void (*sort_out)(const Canvas&, int first, int last, const Strips&);
    /// Finds which of the triangles that draw() would draw is the last to cover each tile.
    void (*find_covers)(const Canvas&, LastCovers&);
};

struct RegisterTarget {
    RegisterTarget(std::int64_t bits, Loops loops);  ///< `bits` as in Highway's HWY_TARGET
};

}  // namespace texelscope
