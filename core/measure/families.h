// Inputs that rasterizers fail on: families of triangles and closed meshes, each made of a seed.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/rect.h"
#include "core/geometry/vertex.h"

namespace texelscope {

struct HardShape {
    std::vector<Vertex> vertices;  ///< three a triangle; u, v in texels
    Rect frame;                    ///< what is drawn of it
    int texture_width = 64, texture_height = 64;
    bool closed = false;  ///< its triangles own each sample of the frame once
};

struct Family {
    std::string_view name, summary;
    HardShape (*make)(std::uint64_t seed);  ///< the same seed gives the same shape everywhere
    int cost = 1;         ///< so many times as many triangles or samples as others have: fewer shapes are drawn
    bool depths = false;  ///< its point is how w differs: nothing of interest where affine
};

/// In the order in which tables show them.
[[nodiscard]] std::span<const Family> families();
/// Null where there is none of that name.
[[nodiscard]] const Family* find_family(std::string_view name);

/// How a family's shapes are drawn.
struct StressMode {
    bool snapped = false;      ///< x and y to 1/256 px first, as graphics cards do
    bool perspective = false;  ///< else every w is 1
};
inline constexpr StressMode kStressModes[]{{false, false}, {true, false}, {false, true}, {true, true}};
[[nodiscard]] HardShape in_mode(HardShape shape, StressMode mode);

/// The seed of the n-th shape of a family.
[[nodiscard]] std::uint64_t seed_of(std::uint64_t seed, const Family& family, int n);

}  // namespace texelscope
