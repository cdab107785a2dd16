// Small scenes whose pictures are known by their hashes, for every compiler, -O, SIMD level, number of threads and
// order of a triangle's corners.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/fast/raster.h"

namespace texelscope {

struct DeterminedScene {
    std::string name;
    std::vector<Vertex> vertices;
    int texture_width = 0, texture_height = 0;
    Wrap wrap = Wrap::repeat;
    bool perspective = false, cull_back = false, depth = false, light = false;
};

/// A part of each workload's picture, with textures of several sizes and wraps, on its grid and shaken; and ties.
[[nodiscard]] std::vector<DeterminedScene> determined_scenes();

/// FNV-1a of the bytes of the pixels and of the depths, row by row, as core/fast draws them.
[[nodiscard]] std::uint64_t hash_of_fast(const DeterminedScene& scene, const RasterSettings& settings);
/// The same as core/exact decides them.
[[nodiscard]] std::uint64_t hash_of_exact(const DeterminedScene& scene);

/// Each triangle starts at its next corner.
void turn_corners(DeterminedScene& scene);

}  // namespace texelscope
