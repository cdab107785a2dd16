// What a job may hold and how it may be drawn: numbers that are not finite, threads, skips.
#include <gtest/gtest.h>

#include "tests/core/fast/raster_pictures.h"

namespace texelscope::raster_pictures {
namespace {

TEST(RasterRefuses, WhatIsNotFiniteOrBehindTheEye) {
    laws::Dice dice(8);
    const RasterTexture& texture = textures()[0].texture;
    const auto spoilt = [&](Vertex& c, int which, bool perspective) {
        const float wrong = std::array{NAN, INFINITY, -INFINITY}[static_cast<std::size_t>(dice.whole(0, 2))];
        const std::array<float*, 6> fields{&c.x, &c.y, &c.z, &c.w, &c.u, &c.v};
        *fields[static_cast<std::size_t>(which)] =
            which == 3 && perspective && dice.often(.5) ? -dice.within(0, 1) : wrong;
    };
    for (int n = 0; n < 3000; ++n) {
        auto corners =
            laws::random_corners(dice, static_cast<laws::Family>(n % laws::kFamilies), {0, 0, kWidth, kHeight}, 3);
        RasterJob job = job_of(corners, texture);
        job.perspective = dice.often(.5), job.depth = dice.often(.5), job.cull_back = dice.often(.5);
        spoilt(corners[static_cast<std::size_t>(n % 3)], n % 6, job.perspective);
        RasterCounters counters;
        ASSERT_EQ(drawn(texture, job, counters), Picture{}) << text_of(corners);
    }
}

TEST(RasterThreads, DrawTheSamePicture) {
    laws::Dice dice(7);
    const RasterTexture texture = textures()[0].with_apron.texture();
    std::vector<Vertex> vertices;
    for (int n = 0; n < 400; ++n) {
        const auto corners = random_triangle(dice, n);
        vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    for (const bool depth : {false, true}) {
        RasterJob job = job_of(vertices, texture);
        job.depth = depth, job.perspective = true;
        RasterCounters one;
        const Picture expected = drawn(texture, job, one, {.skips = kDrawAll});
        for (const int threads : {2, 3, 4, 7, kMaxRasterThreads}) {
            RasterCounters counters, all;
            ASSERT_EQ(drawn(texture, job, counters, {.threads = threads}), expected) << threads;
            ASSERT_EQ(drawn(texture, job, all, {.skips = kDrawAll, .threads = threads}), expected) << threads;
            // Tiles hide what they do, and later triangles cover what they do, within a band.
            EXPECT_TRUE(depth || all.samples == one.samples) << threads;
        }
    }
}

/// What is dropped or refused before bands are drawn counts once, whatever the number of threads.
TEST(RasterThreads, LookAtEachTriangleOnce) {
    laws::Dice dice(9);
    const RasterTexture texture = textures()[0].with_apron.texture();
    std::vector<Vertex> vertices;
    for (int n = 0; n < 5000; ++n) {  // more than a thread takes at once
        auto corners = random_triangle(dice, n);
        if (n % 7 == 0) corners[2] = corners[1];
        if (n % 11 == 0) corners[0].y = n % 2 == 0 ? NAN : INFINITY;
        if (n % 13 == 0) corners[1].x = 1e30F, corners[2].y = -1e30F;
        if (n % 17 == 0)
            for (Vertex& c : corners) c.y += 3 * kHeight;
        vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    RasterJob job = job_of(vertices, texture);
    job.cull_back = true;
    RasterCounters one;
    const Picture expected = drawn(texture, job, one, {.skips = kDrawAll});
    EXPECT_GT(one.refused, 100U);
    EXPECT_GT(one.slow, 50U);
    for (const int threads : {2, 3, kMaxRasterThreads}) {
        RasterCounters counters;
        ASSERT_EQ(drawn(texture, job, counters, {.skips = kDrawAll, .threads = threads}), expected) << threads;
        EXPECT_EQ(counters.triangles, 5000U);
        EXPECT_EQ(counters.refused, one.refused) << threads;
        EXPECT_EQ(counters.samples, one.samples) << threads;
        for (const RasterSkip skip :
             {RasterSkip::off_screen, RasterSkip::no_sample, RasterSkip::zero_area, RasterSkip::back_face}) {
            EXPECT_GT(one.of(skip), 10U) << static_cast<int>(skip);
            EXPECT_EQ(counters.of(skip), one.of(skip)) << static_cast<int>(skip) << ", " << threads << " threads";
        }
    }
}

/// Any subset of the skips leaves the picture as it is.
TEST(RasterSkips, ChangeNoPixel) {
    laws::Dice dice(6);
    const Addresses& texels = textures()[0];
    std::uint64_t level = 0, single = 0, floors = 0, flat = 0, deep = 0, tiles = 0, early = 0, over = 0;
    for (int n = 0; n < 40; ++n) {
        std::vector<Vertex> vertices;
        for (int k = 0; k < 60; ++k) {
            auto corners = random_triangle(dice, k);
            if (k % 3 == 0)
                for (Vertex& c : corners) c.w = 2, c.z = .3F;
            if (k % 4 == 0) corners[2] = corners[1];
            if (k % 5 == 0)  // rows of one texel, in a triangle as wide as the picture
                for (Vertex& c : corners) c.x *= 2, c.u = .02F * c.y, c.v = .3F - .01F * c.y;
            if (k % 7 == 0)
                for (Vertex& c : corners) c.u = .3F + 1e-6F * c.u, c.v = .7F;
            if (k % 11 == 0) corners[1].y = corners[0].y, corners[1].w = corners[0].w;  // a floor's
            vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
        const RasterTexture texture = n % 3 == 0 ? texels.texture : texels.with_apron.texture();
        RasterJob job = job_of(vertices, texture);
        job.depth = n % 2 == 0, job.perspective = n % 4 < 2, job.cull_back = true;
        RasterCounters with, without, by_rows;
        const Picture expected = decided(texture, job);
        ASSERT_EQ(drawn(texture, job, with), expected);
        ASSERT_EQ(drawn(texels.texture, job, by_rows), expected);
        for (const RasterSkip skip : {RasterSkip::equal_w, RasterSkip::level_w})
            EXPECT_EQ(with.of(skip), by_rows.of(skip)) << "by blocks and by rows: " << static_cast<int>(skip);
        flat += with.of(RasterSkip::equal_w);
        for (const RasterSkipInfo& skip : kRasterSkips) {
            const std::uint32_t others = ~(1U << static_cast<unsigned>(skip.skip));
            RasterCounters counters;
            ASSERT_EQ(drawn(texture, job, counters, {.skips = others}), expected) << skip.id;
            EXPECT_EQ(counters.of(skip.skip), 0U) << skip.id;
        }
        ASSERT_EQ(drawn(texture, job, without, {.skips = 0}), expected);
        for (const RasterSkip skip : {RasterSkip::off_screen, RasterSkip::zero_area, RasterSkip::back_face})
            EXPECT_GT(with.of(skip), 0U) << static_cast<int>(skip);
        level += with.of(RasterSkip::zero_gradient), single += with.of(RasterSkip::one_texel),
            floors += with.of(RasterSkip::level_w), deep += with.of(RasterSkip::level_z);
        tiles += with.of(RasterSkip::hidden_tile), early += with.of(RasterSkip::early_z);
        over += with.of(RasterSkip::overdrawn);
        EXPECT_TRUE(job.depth || with.of(RasterSkip::level_z) == 0);
    }
    EXPECT_GT(single, 0U);
    EXPECT_GT(floors, 0U);
    EXPECT_GT(flat, 0U);
    EXPECT_GT(deep, 0U);
    EXPECT_GT(tiles, 0U);
    EXPECT_GT(early, 0U);
    EXPECT_GT(over, 0U);
    EXPECT_GT(level, 0U) << "of wide triangles only, without depth";
}

}  // namespace
}  // namespace texelscope::raster_pictures
