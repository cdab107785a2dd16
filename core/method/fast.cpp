// The production rasterizer (core/fast/raster.h) as a method. Its pixels are first the addresses of their texels, then
// looked up: so one table of addresses serves every texture under every light.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/fast/raster.h"
#include "core/method/drawing.h"
#include "core/method/exact.h"
#include "core/method/shortcut.h"

namespace texelscope {
namespace {

constexpr std::uint32_t kNone = ~0U;
constexpr int kGap = 16;  ///< behind a row, so that rows are no power of two apart [px]

/// What one thread draws addresses with. All pixels are kNone whenever nothing is being drawn.
struct Scratch {
    std::vector<std::uint32_t> pixels, addresses;
    std::vector<Vertex> vertices;

    [[nodiscard]] RasterTarget target(const Rect& frame) {
        const int pitch = frame.width() + kGap;
        const auto needed = static_cast<std::size_t>(pitch) * static_cast<std::size_t>(frame.height());
        if (pixels.size() < needed) pixels.resize(needed, kNone);
        return {.pixels = pixels.data(),
                .pitch = pitch,
                .width = frame.width(),
                .height = frame.height(),
                .x0 = frame.x0,
                .y0 = frame.y0};
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

/// Whether the rasterizer draws such jobs as the definition does, which masks textures of any size and whose indices
/// saturate farther out; the others are drawn exactly, one by one.
[[nodiscard]] bool is_served(const Job& job) {
    const Texture& texture = *job.texture;
    const auto power_of_two = [](int size) { return (size & (size - 1)) == 0; };
    if (texture.wrap == Wrap::mask && !(power_of_two(texture.width()) && power_of_two(texture.height()))) return false;
    return std::all_of(job.corners.begin(), job.corners.end(), [](const Vertex& corner) {
        return double{std::abs(corner.u)} < kIntegerLimit && double{std::abs(corner.v)} < kIntegerLimit;
    });
}

/// Draws the triangles in `s.vertices` as the job says, all of them inside `box`.
void draw_batch(Scratch& s, const Job& job, const Rect& box, Image& picture) {
    if (s.vertices.empty()) return;
    const RasterTarget target = s.target(job.frame);
    RasterCounters counters;
    draw(target, s.texture(*job.texture), {.vertices = s.vertices, .perspective = true, .cull_back = job.cull_back}, {},
         counters);
    s.vertices.clear();
    const Rgb* const texels = job.texture->texels.data();
    const auto lit = exactly_lit(job);
    for (int y = box.y0; y < box.y1; ++y) {
        std::uint32_t* const row = target.pixels + (y - target.y0) * target.pitch;
        for (int x = box.x0 - target.x0; x < box.x1 - target.x0; ++x) {
            if (row[x] == kNone) continue;
            const Rgb& texel = texels[row[x]];
            picture.at(x, y - target.y0) = {lit[texel.r], lit[texel.g], lit[texel.b]};
            row[x] = kNone;
        }
    }
}

Fate render(NumberFormat, const Job& job, Image& picture) {
    if (!is_served(job)) return render_exactly(job, picture);
    const Fate fate = exact_fate(job);
    if (fate != Fate::written) return fate;
    Scratch& s = scratch();
    s.vertices.assign(job.corners.begin(), job.corners.end());
    draw_batch(s, job, exact_box(job), picture);
    return fate;
}

Fate paint(NumberFormat, const Job& job, const Window& part, int shape, Layer& layer) {
    return paint_exactly(job, part, shape, layer);
}

[[nodiscard]] Rect hull(const Rect& a, const Rect& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// Neighbours in the drawing with the same texture and light go in one batch.
void picture(const Drawing& drawing, Image& picture) {
    Scratch& s = scratch();
    Job batch;
    Rect box;
    const auto finish = [&] { draw_batch(s, batch, box, picture), box = {}; };
    for (int n = 0; n < drawing.shape_count(); ++n) {
        if (drawing.refusal(n) != Fate::written) continue;
        const Job job = drawing.job(n);
        const Rect own = exact_box(job);
        if (own.empty()) continue;
        if (!is_served(job)) {
            finish();
            (void)render_exactly(job, picture);
            continue;
        }
        if (job.texture != batch.texture || job.light != batch.light) finish();
        batch = job, box = hull(box, own);
        s.vertices.insert(s.vertices.end(), job.corners.begin(), job.corners.end());
    }
    finish();
}

constexpr Method kMethod = shown_by_definition({.id = "fast", .title = "Fast", .render = render, .paint = paint});
const RegisterMethod kRegistered(kMethod);
constexpr Shortcut kShortcut{&kMethod, kDefinition, picture};
const RegisterShortcut kRegisteredShortcut(kShortcut);

}  // namespace
}  // namespace texelscope
