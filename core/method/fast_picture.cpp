#include "core/method/fast_picture.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "core/fast/raster.h"
#include "core/method/blend.h"
#include "core/method/drawing.h"
#include "core/method/exact.h"

namespace texelscope {
namespace {

/// What the corners define of a method's u and v.
enum class Mapping : std::uint8_t { other, affine, perspective };
struct MappingOf {
    std::string_view method;
    Mapping mapping;
};
constexpr MappingOf kMappings[] = {{"barycentric", Mapping::perspective}, {"edge-equations", Mapping::affine},
                                   {"edge-walk", Mapping::affine},        {"exact", Mapping::perspective},
                                   {"fast", Mapping::perspective},        {"sections", Mapping::affine}};

[[nodiscard]] Mapping mapping_of(const Method& method) {
    const auto* const found = std::find_if(std::begin(kMappings), std::end(kMappings),
                                           [&](const MappingOf& m) { return m.method == method.id; });
    return found == std::end(kMappings) ? Mapping::other : found->mapping;
}

constexpr std::uint32_t kNone = ~0U;
constexpr int kGap = 16;  ///< behind a row, so that rows are no power of two apart [px]

/// What one thread draws addresses with. All pixels are kNone whenever nothing is being drawn.
struct Scratch {
    std::vector<std::uint32_t> pixels, addresses;
    std::vector<Vertex> vertices;

    [[nodiscard]] RasterTarget target(const Rect& rect) {
        const int pitch = rect.width() + kGap;
        const auto needed = static_cast<std::size_t>(pitch) * static_cast<std::size_t>(rect.height());
        if (pixels.size() < needed) pixels.resize(needed, kNone);
        return {.pixels = pixels.data(),
                .pitch = pitch,
                .width = rect.width(),
                .height = rect.height(),
                .x0 = rect.x0,
                .y0 = rect.y0};
    }
    [[nodiscard]] RasterTexture texture(const Texture& texture) {
        for (auto n = static_cast<std::uint32_t>(addresses.size()); n < texture.texels.size(); ++n)
            addresses.push_back(n);
        return {addresses.data(), texture.width(), texture.height(), texture.wrap};
    }
};
[[nodiscard]] Scratch& scratch() {
    thread_local Scratch kept;
    return kept;
}

/// Draws the triangles in `s.vertices` as the job says and calls put(x, y, colour) for each pixel of `rect` that they
/// cover, with what the last of them leaves there.
void draw_batch(Scratch& s, const DrawSettings& settings, const Job& job, const Rect& rect, auto&& put) {
    if (s.vertices.empty() || rect.empty()) return s.vertices.clear();
    const RasterTarget target = s.target(rect);
    RasterCounters counters;
    draw(target, s.texture(*job.texture),
         {.vertices = s.vertices,
          .perspective = mapping_of(*settings.method) == Mapping::perspective,
          .cull_back = job.cull_back},
         {}, counters);
    s.vertices.clear();
    const Rgb* const texels = job.texture->texels.data();
    const auto lit = exactly_lit(job);
    for (int y = 0; y < target.height; ++y) {
        std::uint32_t* const row = target.pixels + y * target.pitch;
        for (int x = 0; x < target.width; ++x) {
            if (row[x] == kNone) continue;
            const Rgb& texel = texels[row[x]];
            put(rect.x0 + x, rect.y0 + y, Rgb{lit[texel.r], lit[texel.g], lit[texel.b]});
            row[x] = kNone;
        }
    }
}

[[nodiscard]] Rect hull(const Rect& a, const Rect& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace

bool draws_the_same_as_fast(const DrawSettings& settings) {
    return mapping_of(*settings.method) != Mapping::other && settings.format == NumberFormat::exact &&
           settings.quirks == 0;
}

bool draws_the_same_as_fast(const DrawSettings& settings, const Job& job) {
    if (!draws_the_same_as_fast(settings) || job.corners.size() != 3) return false;
    const Texture& texture = *job.texture;
    const auto power_of_two = [](int size) { return (size & (size - 1)) == 0; };
    if (texture.wrap == Wrap::mask && !(power_of_two(texture.width()) && power_of_two(texture.height()))) return false;
    return std::all_of(job.corners.begin(), job.corners.end(), [](const Vertex& corner) {
        return double{std::abs(corner.u)} < kIntegerLimit && double{std::abs(corner.v)} < kIntegerLimit;
    });
}

Fate render_fast(const DrawSettings& settings, const Job& job, Image& picture) {
    const Fate fate = exact_fate(job);
    if (fate != Fate::written) return fate;
    Scratch& s = scratch();
    s.vertices.assign(job.corners.begin(), job.corners.end());
    draw_batch(s, settings, job, exact_box(job),
               [&](int x, int y, const Rgb& colour) { picture.at(x - job.frame.x0, y - job.frame.y0) = colour; });
    return fate;
}

Fate paint_fast(const DrawSettings& settings, const Job& job, const Window& part, int shape, Layer& layer) {
    const Fate fate = exact_fate(job);
    if (fate != Fate::written) return fate;
    Scratch& s = scratch();
    s.vertices.assign(job.corners.begin(), job.corners.end());
    auto put = layer.put(shape, job.half, [](const Rgb& colour) { return colour; });
    draw_batch(s, settings, job, intersection(exact_box(job), part.rect),
               [&](int x, int y, const Rgb& colour) { put(x, y, Painted{colour}); });
    return fate;
}

void draw_fast(const Drawing& drawing, Image& picture) {
    Scratch& s = scratch();
    Job batch;
    Rect box;
    const Rect frame = drawing.scene().framebuffer.rect();
    const auto finish = [&] {
        draw_batch(s, drawing.settings(), batch, box, [&](int x, int y, const Rgb& colour) {
            Rgb& pixel = picture.at(x - frame.x0, y - frame.y0);
            pixel = blended(pixel, colour, batch.half);
        });
        box = {};
    };
    for (int n = 0; n < drawing.shape_count(); ++n) {
        if (drawing.refusal(n) != Fate::written) continue;
        const Job job = drawing.job(n);
        if (!draws_the_same_as_fast(drawing.settings(), job)) {
            finish();
            draw_shape(drawing, n, picture);
            continue;
        }
        const Rect own = exact_box(job);
        if (own.empty()) continue;
        // Neighbours go together: not where they blend, as a pixel then shows more than the last of them.
        if (job.texture != batch.texture || job.light != batch.light || job.half || batch.half) finish();
        batch = job, box = hull(box, own);
        s.vertices.insert(s.vertices.end(), job.corners.begin(), job.corners.end());
    }
    finish();
}

}  // namespace texelscope
