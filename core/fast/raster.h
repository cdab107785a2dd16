// The production rasterizer: textured triangles into 32-bit pixels, sample for sample what core/exact/triangle.h
// decides. How: cheap arithmetic with a bound on its error; what lies within the bound is decided again in double, in
// the end exactly (core/fast/decide.h). The bounds are derived where they are computed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/geometry/vertex.h"
#include "core/image/wrap.h"

namespace texelscope {

/// Where it draws. Rows that are no power of two of bytes apart are faster.
struct RasterTarget {
    std::uint32_t* pixels = nullptr;
    std::ptrdiff_t pitch = 0;   ///< from one row to the next [px]
    int width = 0, height = 0;  ///< [px], at most kMaxSize
};

struct RasterTexture {
    const std::uint32_t* texels = nullptr;  ///< row-major from the top left
    int width = 0, height = 0;              ///< [texels]
};

struct RasterJob {
    std::span<const Vertex> vertices;  ///< three a triangle
    int u_texels = 1, v_texels = 1;    ///< how many texels one unit of u and v is
    bool perspective = false;          ///< else every w counts as 1
    bool cull_back = false;
};

/// The instructions to use; each gives the same pixels.
enum class SimdLevel : std::uint8_t { best, sse4, avx2, avx512 };
struct SimdLevelInfo {
    SimdLevel level;
    std::string_view id;
};
inline constexpr std::array<SimdLevelInfo, 3> kSimdLevels{
    {{SimdLevel::sse4, "sse4"}, {SimdLevel::avx2, "avx2"}, {SimdLevel::avx512, "avx512"}}};
/// Whether this machine has the level's instructions, and the program was built for them.
[[nodiscard]] bool is_supported(SimdLevel level);

struct RasterSettings {
    SimdLevel level = SimdLevel::best;  ///< must be supported
};

/// How often each decision was made, and what for.
struct RasterCounters {
    std::uint64_t triangles = 0, not_finite = 0, off_screen = 0, zero_area = 0, culled = 0;
    std::uint64_t slow = 0;       ///< triangles whose coordinates are not exact in double's differences
    std::uint64_t samples = 0;    ///< written, those written again counted again
    std::uint64_t crossings = 0;  ///< ends of rows decided again, in 128 bits
    std::uint64_t in_double = 0;  ///< texels decided again
    std::uint64_t in_whole = 0;   ///< texels that double could not decide either
};

void draw(const RasterTarget& target, const RasterTexture& texture, const RasterJob& job,
          const RasterSettings& settings, RasterCounters& counters);

}  // namespace texelscope
