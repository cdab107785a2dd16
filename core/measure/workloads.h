// Triangles to time a rasterizer with: what games, meshes, scans and careless scenes are made of.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/scene/triangles_file.h"

namespace texelscope {

struct Workload {
    std::string_view name, summary;
    TrianglesFile (*make)(std::uint64_t seed);  ///< the same seed gives the same triangles everywhere
};

/// In the order in which tables show them.
[[nodiscard]] std::span<const Workload> workloads();
/// Null where there is none of that name.
[[nodiscard]] const Workload* find_workload(std::string_view name);

/// Moves each corner by up to `most` px along both axes; corners in the same place stay together. Workloads lie on a
/// grid of 1/256 px, which hides what it costs to decide near ties.
void jitter(TrianglesFile& file, float most, std::uint64_t seed);

/// Samples drawn, those drawn again counted again, depth and culling applied; decided exactly.
[[nodiscard]] std::uint64_t covered_samples(const TrianglesFile& file);

}  // namespace texelscope
