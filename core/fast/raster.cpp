#include "core/fast/raster.h"

#include <algorithm>
#include <bit>
#include <cmath>
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
#include "core/fast/raster_texels.h"
#include "core/fast/triangles-inl.h"
#include "core/image/image.h"

#if HWY_ONCE
namespace texelscope {
namespace {

struct Target {
    std::int64_t bits;  ///< Highway's; a lower bit is a better target
    Loops loops;
};
/// Filled before main: a loop over the targets is compiled for each of them.
std::vector<Target>& targets() {
    static std::vector<Target> all;
    return all;
}

[[nodiscard]] std::int64_t bits_of(SimdLevel level) {
    switch (level) {
        case SimdLevel::scalar: return HWY_SCALAR;
        case SimdLevel::sse4: return HWY_SSE4;
        case SimdLevel::avx2: return HWY_AVX2;
        case SimdLevel::avx512: return HWY_AVX3;
        case SimdLevel::best: break;
    }
    return ~std::int64_t{0};
}

/// The best of the level's targets that the machine has; null where there is none.
[[nodiscard]] const Loops* find_loops(SimdLevel level) {
    static const std::int64_t kSupported = hwy::SupportedTargets();  // asks the machine, which takes 20 microseconds
    const Target* best = nullptr;
    for (const Target& target : targets())
        if ((target.bits & kSupported & bits_of(level)) != 0 && (best == nullptr || target.bits < best->bits))
            best = &target;
    return best != nullptr ? &best->loops : nullptr;
}

[[nodiscard]] int log2_of(int size) { return std::countr_zero(static_cast<unsigned>(size)); }

/// Sizes of 1 leave no bits to shift by.
[[nodiscard]] Addressing addressing_of(const RasterTexture& texture) {
    if (texture.wrap == Wrap::clamp) return Addressing::clamped;
    const auto power = [](int size) { return size > 1 && (size & (size - 1)) == 0; };
    return power(texture.width) && power(texture.height) ? Addressing::powers : Addressing::any_size;
}

}  // namespace

RegisterTarget::RegisterTarget(std::int64_t bits, Loops loops) { targets().push_back({bits, loops}); }

bool is_supported(SimdLevel level) { return find_loops(level) != nullptr; }

RasterCounters& RasterCounters::operator+=(const RasterCounters& other) {
    triangles += other.triangles, drawn += other.drawn, refused += other.refused, by_blocks += other.by_blocks,
        slow += other.slow, samples += other.samples;
    crossings += other.crossings, in_double += other.in_double, in_whole += other.in_whole;
    for (std::size_t n = 0; n < skipped.size(); ++n) skipped[n] += other.skipped[n];
    return *this;
}

namespace {

[[nodiscard]] Canvas canvas_of(const RasterTarget& target, const RasterTexture& texture, const RasterJob& job,
                               const RasterSettings& settings, RasterCounters& counters) {
    Canvas canvas{.target = target,
                  .texture = texture,
                  .job = &job,
                  .settings = &settings,
                  .counters = &counters,
                  .addressing = addressing_of(texture),
                  .u_unit = 0x1p32 * job.u_texels / texture.width,
                  .v_unit = 0x1p32 * job.v_texels / texture.height};
    if (texture.pitch == 0) canvas.texture.pitch = texture.width;
    if (canvas.addressing == Addressing::powers)
        canvas.u_bits = log2_of(texture.width), canvas.v_bits = log2_of(texture.height);
    return canvas;
}

/// Whether triangles are so large, and lie over each other so much, that it pays to find out first which tiles they
/// cover: by some of them.
[[nodiscard]] bool is_overdrawn(const Canvas& canvas) {
    constexpr int kAsked = 64;
    constexpr double kLeastHigh = 32;                  ///< over its longest side, else it covers hardly any tile [px]
    constexpr double kLarge = 500, kLeastLarge = .25;  ///< [px]; the share of such: one background decides nothing
    constexpr double kLeastLayers = 1.25,
                     kWorth = 10'000;  ///< an area, times how many lie over each other [px]: measured
    if (canvas.job->depth || canvas.settings->watch != nullptr || !canvas.settings->skip(RasterSkip::overdrawn))
        return false;
    const RasterTarget& target = canvas.target;
    const int all = canvas.triangles(), asked = std::min(all, kAsked);
    double area = 0;
    int large = 0;
    for (int n = 0; n < asked; ++n) {
        const Vertex* const p = canvas.corners(static_cast<int>(std::int64_t{n} * all / asked));
        const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
        const auto within = [](float low, float high, int first, int size) {
            const double most = static_cast<double>(first) + size;
            return std::clamp<double>(high, first, most) - std::clamp<double>(low, first, most);
        };
        const double box = within(left, right, target.x0, target.width) * within(top, bottom, target.y0, target.height);
        const double twice = std::abs((double{p[1].x} - p[0].x) * (double{p[2].y} - p[0].y) -
                                      (double{p[2].x} - p[0].x) * (double{p[1].y} - p[0].y));
        const double longest = std::max(double{right} - left, double{bottom} - top);
        if (!(twice >= kLeastHigh * longest)) continue;
        area += std::min(box, twice / 2);
        large += twice / 2 >= kLarge ? 1 : 0;
    }
    const double mean = area / asked, layers = mean * all / target.width / target.height;
    return large >= kLeastLarge * asked && layers >= kLeastLayers && mean * layers >= kWorth;
}

void draw_canvas(Canvas canvas, const Loops& loops) {
    std::optional<DepthTiles> tiles;
    if (canvas.job->depth) canvas.tiles = &tiles.emplace(canvas.target);
    std::optional<LastCovers> covers;
    if (canvas.overdrawn) loops.find_covers(canvas, covers.emplace(canvas.target)), canvas.covers = &*covers;
    loops.draw(canvas);
}

/// The canvas' rows [first, last).
[[nodiscard]] Canvas rows_of(Canvas canvas, int first, int last) {
    RasterTarget& rows = canvas.target;
    rows.pixels += first * rows.pitch, rows.height = last - first, rows.y0 += first;
    if (rows.depth != nullptr) rows.depth += first * rows.pitch;
    return canvas;
}

/// Threads look at slices of the triangles, then draw bands of the target: more bands than threads, as some have more
/// to draw than others. Four for each thread were up to 7 % more work than one, where triangles lie in no order.
void draw_bands(const Canvas& whole, const Loops& loops) {
    constexpr int kSlice = 64 * Strips::kBlock, kBandsOfThread = 2;
    const int threads = whole.settings->threads, all = whole.triangles();
    const Strips strips(all, whole.target.height);
    const int slices = (strips.bytes + kSlice - 1) / kSlice, bands = std::min(strips.count, threads * kBandsOfThread);
    std::vector<RasterCounters> of_slices(static_cast<std::size_t>(slices)), of_bands(static_cast<std::size_t>(bands));
    const auto sort_out = [&](int slice) {
        Canvas canvas = whole;
        canvas.counters = &of_slices[static_cast<std::size_t>(slice)];
        loops.sort_out(canvas, slice * kSlice, std::min(strips.bytes, (slice + 1) * kSlice), strips);
    };
    const auto draw = [&](int n) {
        const Band band{&strips, n * strips.count / bands, (n + 1) * strips.count / bands};
        const int first = band.begin << strips.shift, last = band.end << strips.shift;
        Canvas canvas = rows_of(whole, first, std::min(whole.target.height, last));
        canvas.counters = &of_bands[static_cast<std::size_t>(n)], canvas.band = &band;
        draw_canvas(canvas, loops);
    };
    run_stages(threads, {{slices, sort_out}, {bands, draw}});
    for (const auto* const all_of : {&of_slices, &of_bands})
        for (const RasterCounters& one : *all_of) *whole.counters += one;
}

}  // namespace

void draw(const RasterTarget& target, const RasterTexture& texture, const RasterJob& job,
          const RasterSettings& settings, RasterCounters& counters) {
    TEXELSCOPE_ASSERT(is_supported(settings.level) && (!job.depth || target.depth != nullptr));
    TEXELSCOPE_ASSERT(target.width <= kMaxSize && target.height <= kMaxSize);
    TEXELSCOPE_ASSERT(settings.threads >= 1 && settings.threads <= kMaxRasterThreads);
    if (job.vertices.size() < 3 || target.width <= 0 || target.height <= 0) return;
    RasterTexels lit;
    if (job.light != nullptr) lit = RasterTexels(texture, job.light);
    Canvas canvas = canvas_of(target, job.light == nullptr ? texture : lit.texture(), job, settings, counters);
    const Loops& loops = *find_loops(settings.level);
    counters.triangles += static_cast<std::uint64_t>(canvas.triangles());
    canvas.overdrawn = is_overdrawn(canvas);
    if (settings.threads == 1) return draw_canvas(canvas, loops);
    draw_bands(canvas, loops);
}

}  // namespace texelscope
#endif
