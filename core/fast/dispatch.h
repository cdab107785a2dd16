// The rasterizer's loops are compiled once for each SIMD target; each of these says here where it is.
#pragma once

#include <cstdint>

#include "core/fast/canvas.h"

namespace texelscope {

using DrawAll = void (*)(const Canvas&);

struct RegisterTarget {
    RegisterTarget(std::int64_t bits, DrawAll draw);  ///< `bits` as in Highway's HWY_TARGET
};

}  // namespace texelscope
