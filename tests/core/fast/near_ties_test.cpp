// Squares whose samples lie on borders of texels, or near them because float32 rounds the vertices' u and v: blits,
// simple ratios, and 5/48 texels a pixel. int32 and float32 leave many of their texels unsure.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/fast/raster.h"
#include "core/fast/raster_texels.h"
#include "tests/core/fast/draw_exactly.h"

namespace texelscope::near_ties_test {
namespace {

constexpr int kWidth = 420, kHeight = 66, kPitch = 432;

struct Shape {
    int size;        ///< of the square, which may be cut off below [px]
    float slope;     ///< [texels/px] at w = 1
    float from_u;    ///< at the left [texels]
    float right_w;   ///< w at the right; 1 at the left
    float turn = 0;  ///< how much u grows downwards [texels/px]
};

/// Two triangles, their corners on centres of pixels.
std::vector<Vertex> square(const Shape& shape, int u_texels, int v_texels) {
    const auto corner = [&](int right, int down) {
        const auto x = static_cast<float>(shape.size * right), y = static_cast<float>(shape.size * down);
        return Vertex{.x = x + 3.5F,
                      .y = y + 1.5F,
                      .z = .25F + .001F * x,
                      .w = right != 0 ? shape.right_w : 1,
                      .u = (shape.from_u + shape.slope * x + shape.turn * y) / static_cast<float>(u_texels),
                      .v = (7 + shape.slope * y) / static_cast<float>(v_texels)};
    };
    return {corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 0), corner(1, 1), corner(0, 1)};
}

std::vector<Shape> shapes() {
    std::vector<Shape> all;
    for (const int size : {20, 48, 64, 400})
        for (const float slope : {1.0F, 5.0F / 48, 1.0F / 3, 7.0F / 10})
            for (const float from_u : {0.0F, 61.0F})
                for (const float w : {1.0F, 2.0F}) {
                    all.push_back({size, slope, from_u, w});
                    all.push_back({size, slope, from_u, w, 3.0F / 16});
                }
    return all;
}

/// Texels that are their own addresses.
struct Addresses {
    RasterTexels texels;
    RasterTexture texture;
    Addresses(int width, int height, Wrap wrap) {
        std::vector<std::uint32_t> own(static_cast<std::size_t>(width * height));
        for (std::size_t n = 0; n < own.size(); ++n) own[n] = static_cast<std::uint32_t>(n);
        texels = RasterTexels({own.data(), width, height, wrap}), texture = texels.texture();
    }
};

struct Picture {
    std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(std::size_t{kPitch} * kHeight, ~0U);
    std::vector<float> depth = std::vector<float>(std::size_t{kPitch} * kHeight, 1.0F);
    RasterTarget target() { return {pixels.data(), kPitch, kWidth, kHeight, 0, 0, depth.data()}; }
    friend bool operator==(const Picture&, const Picture&) = default;
};

/// Each SIMD level must draw each shape as is decided. Returns all their counters.
RasterCounters expect_exact(const Addresses& image, bool depth) {
    RasterCounters all;
    for (const Shape& shape : shapes()) {
        const auto vertices = square(shape, image.texture.width, image.texture.height);
        const RasterJob job{.vertices = vertices,
                            .u_texels = image.texture.width,
                            .v_texels = image.texture.height,
                            .perspective = shape.right_w != 1,
                            .depth = depth};
        Picture expected;
        draw_exactly(expected.target(), image.texture, job);
        for (const SimdLevelInfo& level : kSimdLevels) {
            if (!is_supported(level.level)) continue;
            RasterCounters counters;
            Picture is;
            draw(is.target(), image.texture, job, {.level = level.level}, counters);
            EXPECT_EQ(is, expected) << level.id << ": " << shape.size << " px, " << shape.slope
                                    << " texels a pixel from " << shape.from_u << ", turn " << shape.turn << ", w "
                                    << shape.right_w;
            EXPECT_EQ(counters.samples, static_cast<std::uint64_t>(shape.size) *
                                            static_cast<std::uint64_t>(std::min(shape.size, kHeight - 1)));
            all += counters;
        }
    }
    return all;
}

TEST(RasterNearTies, AreExactAndCostAFewTexelsInDouble) {
    const RasterCounters counters = expect_exact({256, 256, Wrap::repeat}, false);
    EXPECT_GT(counters.in_double, 0U);
    EXPECT_LT(counters.in_double, counters.samples / 100);
    EXPECT_LT(counters.in_whole, counters.samples / 10000);
}

TEST(RasterNearTies, AreExactWhereTexturesEnd) { expect_exact({256, 64, Wrap::clamp}, false); }

TEST(RasterNearTies, AreExactInTexturesOfAnySize) { expect_exact({100, 48, Wrap::repeat}, false); }

TEST(RasterNearTies, AreExactBehindADepthTest) {
    expect_exact({256, 256, Wrap::repeat}, true);
    expect_exact({100, 48, Wrap::repeat}, true);
}

}  // namespace
}  // namespace texelscope::near_ties_test
