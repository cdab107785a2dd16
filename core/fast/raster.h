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
    int x0 = 0, y0 = 0;         ///< the pixel at the top left, absolute
    float* depth = nullptr;     ///< as `pixels` lie; needed where the job tests depth
};

struct RasterTexture {
    const std::uint32_t* texels = nullptr;  ///< row-major from the top left
    int width = 0, height = 0;              ///< [texels]
    Wrap wrap = Wrap::repeat;               ///< mask: both sizes are powers of two
    int pitch = 0;  ///< from one row to the next [texels]; 0: width. Rows a power of two of bytes apart share their
                    ///< places in the cache, which costs a third of the speed
    int apron = 0;  ///< so many texels beyond the end of a row, and rows beyond the last, go on as the texture wraps.
                    ///< With kTexelApron of them triangles are drawn faster; RasterTexels makes them
};
inline constexpr int kTexelApron = 16;

/// What each value of a channel becomes under a light.
using ChannelTable = std::array<std::uint32_t, 256>;

struct RasterJob {
    std::span<const Vertex> vertices;     ///< three a triangle
    int u_texels = 1, v_texels = 1;       ///< how many texels one unit of u and v is
    bool perspective = false;             ///< else every w counts as 1
    bool cull_back = false;               ///< of core/conventions.h
    bool depth = false;                   ///< LESS, against z rounded to float32
    const ChannelTable* light = nullptr;  ///< for the lowest three bytes of a texel; null: they stay. Looks up every
                                          ///< texel of the texture once
};

/// The instructions to use; each gives the same pixels.
enum class SimdLevel : std::uint8_t { best, scalar, sse4, avx2, avx512 };
struct SimdLevelInfo {
    SimdLevel level;
    std::string_view id;
};
inline constexpr std::array<SimdLevelInfo, 4> kSimdLevels{{{SimdLevel::scalar, "scalar"},
                                                           {SimdLevel::sse4, "sse4"},
                                                           {SimdLevel::avx2, "avx2"},
                                                           {SimdLevel::avx512, "avx512"}}};
/// Whether this machine has the level's instructions, and the program was built for them.
[[nodiscard]] bool is_supported(SimdLevel level);

/// Work that need not be done. Where `certain` is on, the pixels are the same without any of them.
enum class RasterSkip : std::uint8_t {
    off_screen,     ///< triangles outside the target
    no_sample,      ///< triangles between samples
    zero_area,      ///< triangles without area
    back_face,      ///< culled triangles: before they are set up
    hidden,         ///< triangles behind all that stands in the tiles that they meet (hierarchical z)
    hidden_tile,    ///< tiles of wide affine triangles behind all that stands there
    early_z,        ///< looking up texels of samples behind what stands there: the depth test comes first
    equal_w,        ///< perspective where all corners are equally far
    level_w,        ///< a division a pixel where w stays along rows, as on floors
    zero_gradient,  ///< looking up a row's texels where neither u nor v changes along it
    one_texel,      ///< looking up texels where all corners lie in the same one
    level_z,        ///< a depth a pixel where all corners are equally deep
    overdrawn,      ///< without depth, tiles that a later triangle covers whole
};
struct RasterSkipInfo {
    RasterSkip skip;
    std::string_view id, sentence;
};
inline constexpr std::array<RasterSkipInfo, 13> kRasterSkips{{
    {RasterSkip::off_screen, "off-screen", "Triangles outside the picture are dropped before they are set up."},
    {RasterSkip::no_sample, "no-sample", "Triangles whose box lies between samples are dropped before set-up."},
    {RasterSkip::zero_area, "zero-area", "Triangles without area are dropped before set-up."},
    {RasterSkip::back_face, "back-face", "Triangles seen from behind are dropped before set-up."},
    {RasterSkip::hidden, "hidden", "Triangles behind the farthest depth of every 16 x 16 tile they meet are dropped."},
    {RasterSkip::hidden_tile, "hidden-tile",
     "Tiles in which a wide affine triangle lies behind the farthest depth are dropped."},
    {RasterSkip::early_z, "early-z", "The depth test comes before the texels: what lies behind is not looked up."},
    {RasterSkip::equal_w, "equal-w", "Triangles with equal w at all corners are drawn without a division a pixel."},
    {RasterSkip::level_w, "level-w",
     "Triangles whose w stays along rows are drawn with a division a row, not a pixel."},
    {RasterSkip::zero_gradient, "zero-gradient",
     "Without depth, rows of wide triangles along which u and v stay are filled with one texel."},
    {RasterSkip::one_texel, "one-texel", "Triangles whose corners lie in one texel are filled with it."},
    {RasterSkip::level_z, "level-z", "Triangles with equal depth at all corners compare it without computing it."},
    {RasterSkip::overdrawn, "overdrawn",
     "Without depth, tiles of 8 x 16 that a later triangle covers whole are left to it."},
}};

inline constexpr int kMaxRasterThreads = 64;

struct RasterWatch;  // core/fast/watch.h

struct RasterSettings {
    SimdLevel level = SimdLevel::best;  ///< must be supported
    std::uint32_t skips = ~0U;          ///< bit n: RasterSkip n is on
    bool certain = true;  ///< off: what lies in doubt stays as it is, to measure what deciding it costs; only for
                          ///< textures of powers of two that repeat, without depth
    int threads = 1;      ///< they draw bands of the target, [1, kMaxRasterThreads]; two bytes a triangle if several
    RasterWatch* watch = nullptr;  ///< is told who decided what; null: nobody asks. On one thread only

    [[nodiscard]] constexpr bool skip(RasterSkip which) const {
        return (skips >> static_cast<unsigned>(which) & 1U) != 0;
    }
};

/// How often each decision was made, and what for. Where threads draw bands of the target, a triangle counts once in
/// each of those that it is drawn in, but for what is found before: that it is outside, between samples, without area,
/// culled.
struct RasterCounters {
    std::uint64_t triangles = 0;  ///< looked at
    std::uint64_t drawn = 0;      ///< set up
    std::uint64_t refused = 0;  ///< with a number that is not finite, or w <= 0 where that matters; some of those that
                                ///< skips hide are not looked at so closely
    std::array<std::uint64_t, kRasterSkips.size()> skipped{};
    std::uint64_t by_blocks = 0;  ///< triangles whose texels were looked up in patches (core/fast/blocks-inl.h)
    std::uint64_t slow = 0;       ///< triangles whose coordinates are not exact in double's differences
    std::uint64_t samples = 0;  ///< inside a triangle; those behind others count, too, those left to later ones do not
    std::uint64_t crossings = 0;  ///< ends of rows decided again, in 128 bits
    std::uint64_t in_double = 0;  ///< texels decided again
    std::uint64_t in_whole = 0;   ///< texels and depths that double could not decide either

    RasterCounters& operator+=(const RasterCounters& other);
    [[nodiscard]] std::uint64_t& of(RasterSkip skip) { return skipped[static_cast<std::size_t>(skip)]; }
};

/// A triangle with a number that is not finite, or with w <= 0 in perspective, draws nothing.
void draw(const RasterTarget& target, const RasterTexture& texture, const RasterJob& job,
          const RasterSettings& settings, RasterCounters& counters);

}  // namespace texelscope
