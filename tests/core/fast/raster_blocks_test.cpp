// Triangles that are drawn by blocks of samples, large ones and small ones, against the exact triangle.
#include <gtest/gtest.h>

#include <functional>

#include "tests/core/fast/raster_pictures.h"

namespace texelscope::raster_pictures {
namespace {

/// A triangle as blocks are for: its texture laid over the screen, turned, about `density` texels a pixel. Ties:
/// samples on borders of texels, or as near as float32 rounds thirds, and on sides.
std::array<Vertex, 3> laid_triangle(laws::Dice& dice, const RasterTexture& texture, float density, bool ties) {
    const float angle = dice.within(0, 6.3F);
    float along = density * std::cos(angle), across = density * std::sin(angle);
    const float part = dice.often(.7) ? 4 : 3;
    if (ties)
        along = static_cast<float>(dice.whole(-8, 8)) / part, across = static_cast<float>(dice.whole(-4, 4)) / part;
    const float middle_x = dice.within(-20, kWidth + 20), middle_y = dice.within(-10, kHeight + 10);
    const float size = dice.often(.5) ? 20 : 200, from = dice.often(.5) ? 3000 : 0;
    std::array<Vertex, 3> corners{};
    for (Vertex& c : corners) {
        c = {middle_x + dice.within(-size, size), middle_y + dice.within(-size, size), 0, 1};
        if (ties) c.x = std::floor(2 * c.x) / 2, c.y = std::floor(2 * c.y) / 2;
        c.u = (along * c.x - across * c.y + from) / static_cast<float>(texture.width);
        c.v = (across * c.x + along * c.y - from) / static_cast<float>(texture.height);
    }
    return corners;
}

/// Textures that repeat, small ones within a triangle and large ones.
const std::array<Addresses, 5>& repeating_textures() {
    static const std::array<Addresses, 5> all{{{256, 256, Wrap::repeat},
                                               {16, 16, Wrap::mask},
                                               {64, 16, Wrap::repeat},
                                               {16, 512, Wrap::mask},
                                               {8, 8, Wrap::repeat}}};
    return all;
}

/// Scenes of such triangles, which `made` makes for a texture.
void expect_exact_by_blocks(unsigned seed, bool perspective,
                            const std::function<std::array<Vertex, 3>(laws::Dice&, const RasterTexture&)>& made) {
    laws::Dice dice(seed);
    RasterCounters counters;
    for (int n = 0; n < 1500; ++n) {
        const Addresses& texels = repeating_textures()[static_cast<std::size_t>(n % 5)];
        std::vector<Vertex> vertices;
        for (int k = dice.whole(1, 10); k-- > 0;) {
            const auto corners = made(dice, texels.texture);
            vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
        RasterJob job = job_of(vertices, texels.texture);
        job.perspective = perspective, job.cull_back = n % 7 == 0;
        expect_exact(texels, job, counters, std::to_string(n));
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_TRUE(!is_supported(SimdLevel::avx512) || counters.by_blocks > 2000U) << counters.by_blocks;
    EXPECT_GT(counters.in_double, 1000U);
}

/// From magnified to somewhat more than a texel a pixel.
TEST(RasterEqualsExact, ByBlocks) {
    expect_exact_by_blocks(11, false, [](laws::Dice& dice, const RasterTexture& texture) {
        const float density = dice.within(.05F, 1.9F);
        return laid_triangle(dice, texture, density, dice.often(.3));
    });
}

/// Some blocks' texels lie within a patch, others not, and others are too far apart or too steep for float32; w is
/// equal at two or three corners, too.
TEST(RasterEqualsExact, ByBlocksInPerspective) {
    expect_exact_by_blocks(12, true, [](laws::Dice& dice, const RasterTexture& texture) {
        const bool ties = dice.often(.3);
        const float density = dice.often(.8) ? dice.within(.05F, 1.9F) : dice.within(1, 8),
                    steep = dice.often(.7) ? 4 : std::exp2(dice.within(2, 10));
        auto corners = laid_triangle(dice, texture, density, ties);
        for (Vertex& c : corners) c.w = ties ? static_cast<float>(1 << dice.whole(0, 2)) : dice.within(1, steep);
        if (dice.often(.2)) corners[1].w = corners[0].w, corners[1].y = corners[0].y;
        if (ties && dice.often(.3))
            for (Vertex& c : corners) c.u *= 4, c.v *= 4;
        if (!ties && dice.often(.7)) bring_to_border(dice, texture, corners);
        if (dice.often(.2)) {  // a corner on a centre, so near to a border that double does not tell its side
            Vertex& c = corners[0];
            c.x = std::floor(c.x) + .5F, c.y = std::floor(c.y) + .5F, c.u = dice.often(.5) ? -1e-20F : 1e-20F;
        }
        return corners;
    });
}

/// Sizes and pitches up to 2^15 and more: in rows, AVX2 counts texels in 16 bits where that is enough. Some textures go
/// by thousands of times in a row.
TEST(RasterEqualsExact, InPerspectiveWithLargeTextures) {
    static const std::array<Addresses, 6> all{{{1 << 14, 2, Wrap::repeat},
                                               {2, 1 << 15, Wrap::mask},
                                               {1 << 15, 1, Wrap::repeat},
                                               {1, 1 << 16, Wrap::repeat},
                                               {64, 16, Wrap::repeat, (1 << 15) - 1},
                                               {64, 16, Wrap::mask, 1 << 15}}};
    laws::Dice dice(21);
    RasterCounters counters;
    for (int n = 0; n < 600; ++n) {
        const Addresses& texels = all[static_cast<std::size_t>(n % 6)];
        const float density = dice.often(.5) ? dice.within(.05F, 3) : std::exp2(dice.within(2, 22));
        auto corners = laid_triangle(dice, texels.texture, density, false);
        for (Vertex& c : corners) c.w = dice.within(1, dice.often(.8) ? 4 : 1000);
        if (density < 3) bring_to_border(dice, texels.texture, corners);
        RasterJob job = job_of(corners, texels.texture);
        job.perspective = true;
        expect_exact(texels, job, counters, std::to_string(n));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.samples, 1000000U);
    EXPECT_GT(counters.in_double, 1000U);
}

/// Up to 8 px wide, near (x, y).
std::array<Vertex, 3> small_triangle(laws::Dice& dice, int n, float x, float y) {
    const float size = dice.often(.3) ? 4 : 7.9F;
    x += dice.within(-5, 5), y += dice.within(-5, 5);
    const float grid = n % 3 == 0 ? 2 : 256, density = dice.within(.2F, 3), level = dice.within(0, .9F);
    std::array<Vertex, 3> corners{};
    for (Vertex& c : corners) {
        c = {x + dice.within(0, size), y + dice.within(0, size), n % 2 == 0 ? level : dice.within(0, .9F), 1};
        if (n % 4 != 0) c.x = std::round(c.x * grid) / grid, c.y = std::round(c.y * grid) / grid;
        c.u = density * c.x / 64 + dice.within(-.02F, .02F), c.v = density * c.y / 16 + dice.within(-.02F, .02F);
        if (n % 7 == 0) c.u = std::floor(c.u * 64) / 64, c.v = std::floor(c.v * 16) / 16;
    }
    if (n % 5 == 0) {  // a side through centres, but for what float32 loses
        const auto right = static_cast<float>(dice.whole(-3, 3)), down = static_cast<float>(dice.whole(-3, 3));
        for (std::size_t k = 0; k < 2; ++k) {
            const float t = k == 0 ? dice.within(-1.3F, 0) : dice.within(0, 1.3F);
            corners[k].x = std::floor(x) + 4.5F + t * right, corners[k].y = std::floor(y) + 4.5F + t * down;
        }
    }
    return corners;
}

TEST(RasterEqualsExact, InEveryPixelOfSmallTriangles) {
    laws::Dice dice(14);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (int n = 0; n < 1500; ++n) {
        std::vector<Vertex> vertices;
        const float x = dice.within(-4, kWidth + 2), y = dice.within(-4, kHeight + 2);  // its ends, too
        for (int k = 0; k < 9; ++k) {
            auto corners = small_triangle(dice, n + 8 * k, x, y);
            if (n % 2 == 0) bring_to_border(dice, texels.texture, corners);
            vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = n % 3 != 0, job.cull_back = n % 4 == 0;
        const std::string what = std::to_string(n);
        expect_exact(texels, job, counters, what);
        if (HasFatalFailure()) return;
        const std::uint32_t late = ~(1U << static_cast<unsigned>(RasterSkip::early_z));
        expect_same(drawn(texels.texture, job, counters, {.skips = late}), decided(texels.texture, job),
                    "late: " + what);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.samples, 100000U);
    EXPECT_GT(counters.in_double, 100U);
    EXPECT_GT(counters.of(RasterSkip::early_z), 100U);
}

}  // namespace
}  // namespace texelscope::raster_pictures
