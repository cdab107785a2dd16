#include "tests/core/fast/determined_scenes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

#include "core/fast/raster_texels.h"
#include "core/measure/dice.h"
#include "core/measure/workloads.h"
#include "tests/core/fast/draw_exactly.h"

namespace texelscope::determined_scenes_detail {
namespace {

constexpr int kLeft = 448, kTop = 448, kWidth = 96, kHeight = 64, kPadding = 16;
constexpr float kShaken = 0.03F;  ///< [px]
constexpr std::uint64_t kSeed = 1;

struct Look {
    int width, height;  ///< of the texture
    Wrap wrap;
    bool light, depth;
};
/// Of the workloads in their order.
constexpr std::array<Look, 8> kLooks{{{256, 256, Wrap::repeat, false, false},
                                      {48, 80, Wrap::clamp, true, false},
                                      {64, 16, Wrap::mask, false, false},
                                      {37, 61, Wrap::repeat, true, false},
                                      {256, 256, Wrap::repeat, false, false},
                                      {48, 80, Wrap::repeat, true, true},
                                      {256, 256, Wrap::repeat, false, true},
                                      {128, 32, Wrap::clamp, false, false}}};

class Picture {
public:
    [[nodiscard]] RasterTarget target() {
        return {.pixels = pixels_.data(),
                .pitch = kWidth + kPadding,
                .width = kWidth,
                .height = kHeight,
                .x0 = kLeft,
                .y0 = kTop,
                .depth = depth_.data()};
    }
    [[nodiscard]] std::uint64_t hash() {
        std::uint64_t sum = 0xCBF29CE484222325U;
        const auto take = [&sum](std::uint32_t word) {
            for (int shift = 0; shift < 32; shift += 8) sum = (sum ^ (word >> shift & 255U)) * 0x100000001B3U;
        };
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const auto at = static_cast<std::size_t>(y * (kWidth + kPadding) + x);
                take(pixels_[at]), take(std::bit_cast<std::uint32_t>(depth_[at]));
            }
        return sum;
    }

private:
    std::vector<std::uint32_t> pixels_ = std::vector<std::uint32_t>(std::size_t{kWidth + kPadding} * kHeight);
    std::vector<float> depth_ = std::vector<float>(pixels_.size(), 1.0F);
};

/// No two texels alike.
[[nodiscard]] std::vector<std::uint32_t> texels_of(const DeterminedScene& scene) {
    std::vector<std::uint32_t> texels(static_cast<std::size_t>(scene.texture_width * scene.texture_height));
    for (std::size_t n = 0; n < texels.size(); ++n) texels[n] = static_cast<std::uint32_t>(n) * 0x9E3779B1U;
    return texels;
}

[[nodiscard]] ChannelTable light() {
    ChannelTable table{};
    for (std::uint32_t n = 0; n < table.size(); ++n) table[n] = n * 7 / 10;
    return table;
}

/// What the frame does not show is left away: the exact triangle would take seconds to find that out.
[[nodiscard]] bool in_view(std::span<const Vertex> corners) {
    const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    return right >= kLeft && left <= kLeft + kWidth && bottom >= kTop && top <= kTop + kHeight;
}

[[nodiscard]] DeterminedScene scene_of(const Workload& workload, const Look& look, bool shaken) {
    TrianglesFile file = workload.make(kSeed);
    std::vector<Vertex> seen;
    for (std::size_t n = 0; n < file.vertices.size(); n += 3)
        if (const std::span corners = std::span(file.vertices).subspan(n, 3); in_view(corners))
            seen.insert(seen.end(), corners.begin(), corners.end());
    file.vertices = std::move(seen);
    if (shaken) jitter(file, kShaken, kSeed);
    if (look.depth && !file.depth) {
        Dice dice(kSeed);
        for (Vertex& c : file.vertices) c.z = dice.share();
    }
    return {.name = std::string(workload.name) + (shaken ? ", shaken" : ""),
            .vertices = std::move(file.vertices),
            .texture_width = look.width,
            .texture_height = look.height,
            .wrap = look.wrap,
            .perspective = file.perspective,
            .cull_back = file.cull_back,
            .depth = look.depth,
            .light = look.light};
}

/// Corners on centres, slopes of simple ratios: sides run through samples, and samples lie on texels' borders.
[[nodiscard]] DeterminedScene ties(bool perspective) {
    DeterminedScene scene{.name = perspective ? "ties in perspective" : "ties",
                          .texture_width = 48,
                          .texture_height = 48,
                          .perspective = perspective};
    Dice dice(kSeed);
    for (int n = 0; n < 150; ++n)
        for (int k = 0; k < 3; ++k) {
            const auto centre = [&](int from, int size) {
                return static_cast<float>(from + dice.whole(-9, size + 9)) + .5F;
            };
            const float x = centre(kLeft, kWidth), y = centre(kTop, kHeight);
            scene.vertices.push_back({x, y, 0, static_cast<float>(dice.whole(1, 3)),
                                      static_cast<float>(dice.whole(-96, 96)) / 48,
                                      static_cast<float>(dice.whole(-96, 96)) / 48});
        }
    return scene;
}

/// @param paint  draw() or draw_exactly().
[[nodiscard]] std::uint64_t hash_of(const DeterminedScene& scene, const auto& paint) {
    const std::vector<std::uint32_t> texels = texels_of(scene);
    const ChannelTable table = light();
    Picture picture;
    const RasterTexels with_apron({texels.data(), scene.texture_width, scene.texture_height, scene.wrap});
    paint(picture.target(), with_apron.texture(),
          RasterJob{.vertices = scene.vertices,
                    .u_texels = scene.texture_width,
                    .v_texels = scene.texture_height,
                    .perspective = scene.perspective,
                    .cull_back = scene.cull_back,
                    .depth = scene.depth,
                    .light = scene.light ? &table : nullptr});
    return picture.hash();
}

}  // namespace
}  // namespace texelscope::determined_scenes_detail

namespace texelscope {

using namespace determined_scenes_detail;

std::vector<DeterminedScene> determined_scenes() {
    std::vector<DeterminedScene> all{ties(false), ties(true)};
    for (std::size_t n = 0; n < kLooks.size(); ++n)
        for (const bool shaken : {false, true}) all.push_back(scene_of(workloads()[n], kLooks[n], shaken));
    return all;
}

std::uint64_t hash_of_fast(const DeterminedScene& scene, const RasterSettings& settings) {
    return hash_of(scene, [&](const RasterTarget& target, const RasterTexture& texture, const RasterJob& job) {
        RasterCounters counters;
        draw(target, texture, job, settings, counters);
    });
}

std::uint64_t hash_of_exact(const DeterminedScene& scene) { return hash_of(scene, draw_exactly); }

void turn_corners(DeterminedScene& scene) {
    for (auto at = scene.vertices.begin(); at != scene.vertices.end(); at += 3) std::rotate(at, at + 1, at + 3);
}

}  // namespace texelscope
