// The fast rasterizer against the exact triangle, pixel for pixel.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/fast/raster_pictures.h"

namespace texelscope::raster_pictures {
namespace {

TEST(RasterEqualsExact, InEveryPixelOfRandomTriangles) {
    laws::Dice dice(1);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (int n = 0; n < 2400; ++n) {
        const auto corners = random_triangle(dice, n);
        RasterJob job = job_of(corners, texels.texture);
        job.perspective = n % 2 == 0, job.cull_back = n % 7 == 0;
        expect_exact(texels, job, counters, std::to_string(n) + ": " + text_of(corners));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.samples, 1000000U);
    EXPECT_GT(counters.crossings, 0U);
    EXPECT_GT(counters.in_double, 0U);
    EXPECT_GT(counters.in_whole, 0U);
}

TEST(RasterEqualsExact, WithTexturesOfAnySizeAndWrap) {
    laws::Dice dice(2);
    RasterCounters counters;
    for (int n = 0; n < 3000; ++n) {
        const auto corners = random_triangle(dice, n);
        const Addresses& texels = textures()[static_cast<std::size_t>(dice.whole(1, 5))];
        RasterJob job = job_of(corners, texels.texture);
        job.perspective = n % 2 == 0;
        if (n % 3 == 0) job.u_texels = job.v_texels = dice.whole(1, 40);
        expect_exact(texels, job, counters, std::to_string(n) + ": " + text_of(corners));
        if (HasFatalFailure()) return;
    }
}

/// Corners on a line of centres but for what float32 loses: their order's sense, which float32 does not tell, decides
/// whether these are drawn.
TEST(RasterEqualsExact, WhereFloat32DoesNotTellTheFront) {
    laws::Dice dice(16);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (int n = 0; n < 4000; ++n) {
        const auto right = static_cast<float>(dice.whole(-9, 9)), down = static_cast<float>(dice.whole(-3, 3));
        const float x = static_cast<float>(dice.whole(50, 280)) + .5F, y = static_cast<float>(dice.whole(0, 51)) + .5F;
        std::array<Vertex, 3> corners{};
        for (int k = 0; k < 3; ++k) {
            const float t = k < 2 ? static_cast<float>(dice.whole(-30, 30)) : dice.within(-40, 40);
            corners[static_cast<std::size_t>(k)] = {x + t * right, y + t * down, 0, 1, .5F, t / 30};
        }
        RasterJob job = job_of(corners, texels.texture);
        job.cull_back = true;
        expect_exact(texels, job, counters, std::to_string(n) + ": " + text_of(corners));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.samples, 10000U);
}

/// Double rounds the corners' differences: the area's sign is not known before the exact triangle is made.
TEST(RasterEqualsExact, WhereDoubleDoesNotTellTheFront) {
    const Addresses& texels = textures()[0];
    for (const auto& [x, y] : {std::pair{0x1p-60F, 0.0F}, {0.0F, -0x1p-60F}, {-0x1p-60F, 0.0F}, {0.0F, 0x1p-60F}}) {
        RasterCounters counters;
        const std::array<Vertex, 3> corners{{{x, y, 0, 1, 0, 0}, {40, 40, 0, 1, 1, 0}, {20, 20, 0, 1, 0, 1}}};
        RasterJob job = job_of(corners, texels.texture);
        job.cull_back = true;
        expect_exact(texels, job, counters, text_of(corners));
        if (HasFatalFailure()) return;
        EXPECT_EQ(counters.samples > 0, x > 0 || y < 0) << "of the two that show their front";
    }
}

/// From an origin below 0 float32 does not hold where a corner is: one next to a centre is not beyond it.
TEST(RasterEqualsExact, NextToACentreFarFromTheOrigin) {
    laws::Dice dice(17);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (int n = 0; n < 400; ++n) {
        const Origin origin{-dice.whole(10, 300), -dice.whole(10, 50)};
        const float past = .5F + static_cast<float>(dice.whole(1, 3)) * 0x1p-24F, before = 1 - past;
        const float x = n % 2 == 0 ? past : before;
        std::array<Vertex, 3> corners{
            {{x, .1F, 0, 1, 0, 0}, {x, .9F, 0, 1, 1, 0}, {n % 2 == 0 ? .2F : .8F, .5F, 0, 1, 0, 1}}};
        if (n % 4 < 2)
            for (Vertex& c : corners) std::swap(c.x, c.y);
        const RasterJob job = job_of(corners, texels.texture);
        expect_exact(texels, job, counters, std::to_string(n), origin);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.samples, 400U);
}

TEST(RasterEqualsExact, FarFromTheOrigin) {
    laws::Dice dice(4);
    RasterCounters counters;
    for (int n = 0; n < 1500; ++n) {
        const int far = 1 << dice.whole(3, 27);
        const Origin origin{dice.often(.5) ? far : -far, dice.whole(-5000, 5000)};
        auto corners = random_triangle(dice, n);
        for (Vertex& c : corners) c.x += static_cast<float>(origin.x), c.y += static_cast<float>(origin.y);
        const Addresses& texels = textures()[static_cast<std::size_t>(n % 6)];
        RasterJob job = job_of(corners, texels.texture);
        job.perspective = n % 2 == 0;
        expect_exact(texels, job, counters, std::to_string(n) + ": " + text_of(corners), origin);
        if (HasFatalFailure()) return;
    }
}

TEST(RasterEqualsExact, WhereManyTrianglesAreDrawnAtOnce) {
    laws::Dice dice(5);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (const int count : {1, 2, 7, 8, 9, 31, 500})
        for (const bool perspective : {false, true}) {
            std::vector<Vertex> vertices;
            for (int n = 0; n < count; ++n) {
                const auto corners = random_triangle(dice, n);
                vertices.insert(vertices.end(), corners.begin(), corners.end());
            }
            RasterJob job = job_of(vertices, texels.texture);
            job.perspective = perspective;
            expect_exact(texels, job, counters, std::to_string(count));
            if (HasFatalFailure()) return;
        }
}

}  // namespace
}  // namespace texelscope::raster_pictures
