#include "core/fast/raster.h"

#include <bit>
#include <optional>
#include <vector>

#include "core/fast/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fast/raster.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/base/assert.h"
#include "core/fast/bands.h"
#include "core/fast/dispatch.h"
#include "core/fast/triangles-inl.h"

#if HWY_ONCE
namespace texelscope {
namespace {

struct Target {
    std::int64_t bits;  ///< Highway's; a lower bit is a better target
    DrawAll draw;
};
/// Filled before main: a loop over the targets is compiled for each of them.
std::vector<Target>& targets() {
    static std::vector<Target> all;
    return all;
}

[[nodiscard]] std::int64_t bits_of(SimdLevel level) {
    switch (level) {
        case SimdLevel::sse4: return HWY_SSE4;
        case SimdLevel::avx2: return HWY_AVX2;
        case SimdLevel::avx512: return HWY_AVX3;
        case SimdLevel::best: break;
    }
    return ~std::int64_t{0};
}

/// The best of the level's targets that the machine has; null where there is none.
[[nodiscard]] DrawAll find_draw(SimdLevel level) {
    static const std::int64_t kSupported = hwy::SupportedTargets();  // asks the machine, which takes 20 microseconds
    const Target* best = nullptr;
    for (const Target& target : targets())
        if ((target.bits & kSupported & bits_of(level)) != 0 && (best == nullptr || target.bits < best->bits))
            best = &target;
    return best != nullptr ? best->draw : nullptr;
}

[[nodiscard]] int log2_of(int size) { return std::countr_zero(static_cast<unsigned>(size)); }

/// Sizes of 1 leave no bits to shift by.
[[nodiscard]] Addressing addressing_of(const RasterTexture& texture) {
    if (texture.wrap == Wrap::clamp) return Addressing::clamped;
    const auto power = [](int size) { return size > 1 && (size & (size - 1)) == 0; };
    return power(texture.width) && power(texture.height) ? Addressing::powers : Addressing::any_size;
}

}  // namespace

RegisterTarget::RegisterTarget(std::int64_t bits, DrawAll draw) { targets().push_back({bits, draw}); }

bool is_supported(SimdLevel level) { return find_draw(level) != nullptr; }

RasterCounters& RasterCounters::operator+=(const RasterCounters& other) {
    triangles += other.triangles, drawn += other.drawn, refused += other.refused, slow += other.slow,
        samples += other.samples;
    crossings += other.crossings, in_double += other.in_double, in_whole += other.in_whole;
    for (std::size_t n = 0; n < skipped.size(); ++n) skipped[n] += other.skipped[n];
    return *this;
}

namespace {

void draw_band(const RasterTarget& target, const RasterTexture& texture, const RasterJob& job,
               const RasterSettings& settings, RasterCounters& counters) {
    std::optional<DepthTiles> tiles;
    if (job.depth) tiles.emplace(target);
    Canvas canvas{.target = target,
                  .texture = texture,
                  .job = &job,
                  .settings = &settings,
                  .counters = &counters,
                  .tiles = tiles ? &*tiles : nullptr,
                  .addressing = addressing_of(texture),
                  .u_unit = 0x1p32 * job.u_texels / texture.width,
                  .v_unit = 0x1p32 * job.v_texels / texture.height};
    if (texture.pitch == 0) canvas.texture.pitch = texture.width;
    if (canvas.addressing == Addressing::powers)
        canvas.u_bits = log2_of(texture.width), canvas.v_bits = log2_of(texture.height);
    find_draw(settings.level)(canvas);
}

[[nodiscard]] std::vector<std::uint32_t> lit(const RasterTexture& texture, const ChannelTable& light) {
    const int pitch = texture.pitch == 0 ? texture.width : texture.pitch;
    const auto length = static_cast<std::size_t>(pitch) * static_cast<std::size_t>(texture.height - 1) +
                        static_cast<std::size_t>(texture.width);
    std::vector<std::uint32_t> texels(texture.texels, texture.texels + length);
    for (std::uint32_t& t : texels)
        t = light[t & 255] | light[t >> 8 & 255] << 8 | light[t >> 16 & 255] << 16 | (t & 0xFF000000U);
    return texels;
}

}  // namespace

void draw(const RasterTarget& target, const RasterTexture& texture, const RasterJob& job,
          const RasterSettings& settings, RasterCounters& counters) {
    TEXELSCOPE_ASSERT(is_supported(settings.level) && (!job.depth || target.depth != nullptr));
    TEXELSCOPE_ASSERT(settings.threads >= 1 && settings.threads <= kMaxRasterThreads);
    if (job.vertices.size() < 3 || target.width <= 0 || target.height <= 0) return;
    if (job.light != nullptr) {
        const std::vector<std::uint32_t> texels = lit(texture, *job.light);
        RasterTexture bright = texture;
        bright.texels = texels.data();
        RasterJob plain = job;
        plain.light = nullptr;
        return draw(target, bright, plain, settings, counters);
    }
    if (settings.threads == 1) return draw_band(target, texture, job, settings, counters);
    std::vector<RasterCounters> each(static_cast<std::size_t>(settings.threads));
    for_each_band(settings.threads, target.height, [&](int band, int first, int last) {
        RasterTarget rows = target;
        rows.pixels += first * target.pitch, rows.height = last - first, rows.y0 += first;
        if (rows.depth != nullptr) rows.depth += first * target.pitch;
        draw_band(rows, texture, job, settings, each[static_cast<std::size_t>(band)]);
    });
    for (const RasterCounters& one : each) counters += one;
}

}  // namespace texelscope
#endif
