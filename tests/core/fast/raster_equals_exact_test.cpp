// The fast rasterizer against the exact triangle, pixel for pixel: each pixel says which texel it was given.
#include "core/fast/raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "core/exact/triangle.h"
#include "tests/core/method/cases.h"

namespace texelscope {
namespace {

constexpr int kWidth = 75, kHeight = 52, kPitch = 80;
constexpr std::uint32_t kClear = 0xFFFFFFFF;

std::string text_of(std::span<const Vertex> corners) {
    std::string text;
    for (const Vertex& c : corners)
        for (const float value : {c.x, c.y, c.z, c.w, c.u, c.v}) {
            std::array<char, 40> digits{};
            std::snprintf(digits.data(), digits.size(), "%aF, ", static_cast<double>(value));
            text += digits.data();
        }
    return text;
}

/// Texels that are their own addresses.
struct Addresses {
    std::vector<std::uint32_t> texels;
    RasterTexture texture;
    Addresses(int width, int height) : texels(static_cast<std::size_t>(width * height)) {
        for (std::size_t n = 0; n < texels.size(); ++n) texels[n] = static_cast<std::uint32_t>(n);
        texture = {texels.data(), width, height};
    }
};

using Pixels = std::vector<std::uint32_t>;

Pixels drawn(const RasterTexture& texture, const RasterJob& job, RasterCounters& counters,
             const RasterSettings& settings = {}) {
    Pixels pixels(std::size_t{kPitch} * kHeight, kClear);
    draw({pixels.data(), kPitch, kWidth, kHeight}, texture, job, settings, counters);
    return pixels;
}

Pixels decided(const RasterTexture& texture, const RasterJob& job) {
    Pixels pixels(std::size_t{kPitch} * kHeight, kClear);
    for (std::size_t n = 0; n < job.vertices.size(); n += 3) {
        std::array<Vertex, 3> corners{job.vertices[n], job.vertices[n + 1], job.vertices[n + 2]};
        if (!job.perspective)
            for (Vertex& c : corners) c.w = 1;
        const ExactTriangle triangle(corners, job.u_texels, job.v_texels);
        if (triangle.winding() == 0 || (job.cull_back && triangle.winding() < 0)) continue;
        for (int y = 0; y < kHeight; ++y) {
            const PixelRange row = triangle.row(y, 0, kWidth);
            for (Integer x = row.x0; x < row.x1; ++x) {
                const TexelIndex texel = triangle.texel(x, y);
                pixels[static_cast<std::size_t>(y * kPitch + x)] =
                    static_cast<std::uint32_t>(wrap_index(texel.v, texture.height, Wrap::repeat) * texture.width +
                                               wrap_index(texel.u, texture.width, Wrap::repeat));
            }
        }
    }
    return pixels;
}

/// In u, v of whole textures; most of them on the screen.
std::vector<Vertex> random_triangle(laws::Dice& dice, int n) {
    auto corners =
        laws::random_corners(dice, static_cast<laws::Family>(n % laws::kFamilies), {0, 0, kWidth, kHeight}, 3);
    if (n % 5 == 0)  // ties: on centres, at whole texels
        for (Vertex& c : corners) {
            c.x = std::floor(c.x) + 0.5F, c.y = std::floor(c.y) + 0.5F;
            c.u = std::floor(c.u) / 8, c.v = std::floor(c.v) / 8, c.w = 1;
        }
    if (n % 9 == 0) {  // a side through centres, but for what float32 loses
        const int right = dice.whole(-20, 20), down = dice.whole(-20, 20);
        for (std::size_t k = 0; k < 2; ++k) {
            const float t = dice.within(-2, 2);
            corners[k].x = 30.5F + t * static_cast<float>(right), corners[k].y = 25.5F + t * static_cast<float>(down);
        }
    }
    if (n % 13 == 0) corners[0].x = dice.within(-1e-30, 1e-30), corners[1].y = dice.within(-1e-40, 1e-40);
    if (n % 17 == 0) corners[2].x *= 1e8F;
    if (n % 19 == 0) corners[1].w *= 1e6F;
    return corners;
}

TEST(RasterEqualsExact, InEveryPixelOfRandomTriangles) {
    laws::Dice dice(1);
    const Addresses addresses(64, 16);
    RasterCounters counters;
    for (int n = 0; n < 6000; ++n) {
        const auto corners = random_triangle(dice, n);
        const RasterJob job{.vertices = corners,
                            .u_texels = addresses.texture.width,
                            .v_texels = addresses.texture.height,
                            .perspective = n % 2 == 0,
                            .cull_back = n % 7 == 0};
        const Pixels expected = decided(addresses.texture, job);
        for (const SimdLevelInfo& level : kSimdLevels) {
            if (!is_supported(level.level)) continue;
            ASSERT_EQ(drawn(addresses.texture, job, counters, {.level = level.level}), expected)
                << level.id << ", " << n << ": " << text_of(corners);
        }
    }
    EXPECT_GT(counters.samples, 1000000U);
    EXPECT_GT(counters.crossings, 0U);
    EXPECT_GT(counters.in_double, 0U);
}

TEST(RasterEqualsExact, WhereManyTrianglesAreDrawnAtOnce) {
    laws::Dice dice(2);
    const Addresses addresses(64, 16);
    RasterCounters counters;
    for (const int count : {1, 2, 7, 8, 9, 31, 500})
        for (const bool perspective : {false, true}) {
            std::vector<Vertex> vertices;
            for (int n = 0; n < count; ++n) {
                const auto corners = random_triangle(dice, n);
                vertices.insert(vertices.end(), corners.begin(), corners.end());
            }
            const RasterJob job{.vertices = vertices,
                                .u_texels = addresses.texture.width,
                                .v_texels = addresses.texture.height,
                                .perspective = perspective};
            ASSERT_EQ(drawn(addresses.texture, job, counters), decided(addresses.texture, job)) << count;
        }
}

}  // namespace
}  // namespace texelscope
