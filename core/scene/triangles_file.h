// `.tri`: raw triangles for measuring. A header of 64 bytes, then three vertices a triangle; all little endian.
//   char magic[8] = "TRIWL01\0"
//   u32  width, height, triangles, flags, tex_w, tex_h, bytes of a vertex (24), 0
//   u64  seed, covered samples (0 = unknown), 0
//   f32  x, y [px], z, w, u, v [repeats: 1 = the whole texture] of each vertex
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/vertex.h"

namespace texelscope {

inline constexpr std::uint32_t kMaxFileTriangles = 10'000'000;
inline constexpr std::size_t kMaxFileBytes = 64 + std::size_t{kMaxFileTriangles} * 72;

struct TrianglesFile {
    int width = 0, height = 0;  ///< of the framebuffer [px], [1, kMaxSize]
    bool perspective = false;   ///< else every w counts as 1
    bool depth = false;         ///< LESS against 1.0
    bool cull_back = false;
    bool no_wrap = false;                       ///< all samples lie inside the texture
    int texture_width = 0, texture_height = 0;  ///< what u and v were made for [texels], [1, kMaxSize]
    std::uint64_t seed = 0, covered = 0;        ///< of the generator; samples drawn, those drawn again counted again
    std::vector<Vertex> vertices;               ///< three a triangle; u, v in repeats
    friend bool operator==(const TrianglesFile&, const TrianglesFile&) = default;
};

/// Fails on anything but a whole file of finite numbers, w > 0 where it is in perspective. `name` is for the error.
[[nodiscard]] Result<TrianglesFile> parse_triangles(std::string_view bytes, const std::string& name);
/// Requires what parse_triangles demands.
[[nodiscard]] std::string print_triangles(const TrianglesFile& file);

}  // namespace texelscope
