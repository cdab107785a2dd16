// What later triangles cover is left to them: the picture is as if all had been drawn.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/fast/last_covers.h"
#include "tests/core/fast/raster_pictures.h"

namespace texelscope::raster_pictures {
namespace {

/// A target whose last tiles are not whole ones, or are.
struct Frame {
    int width = 150, height = 107, x0 = 0, y0 = 0;

    [[nodiscard]] int pitch() const { return width + 9; }
    template <class Draw>
    [[nodiscard]] std::vector<std::uint32_t> picture(Draw&& draw) const {
        std::vector<std::uint32_t> pixels(static_cast<std::size_t>(pitch()) * static_cast<std::size_t>(height), kClear);
        draw(RasterTarget{pixels.data(), pitch(), width, height, x0, y0});
        return pixels;
    }
    [[nodiscard]] std::vector<std::uint32_t> drawn(const RasterTexture& texture, const RasterJob& job,
                                                   RasterCounters& counters, const RasterSettings& settings) const {
        return picture([&](const RasterTarget& target) { draw(target, texture, job, settings, counters); });
    }
};

/// So large that it covers tiles, and where borders of tiles are on its sides or just beside them now and then.
[[nodiscard]] std::array<Vertex, 3> large_triangle(laws::Dice& dice, const Frame& frame) {
    std::array<Vertex, 3> corners;
    const int kind = dice.whole(0, 3);
    for (Vertex& c : corners) {
        c.x = dice.within(-.6 * frame.width, 1.6 * frame.width),
        c.y = dice.within(-.8 * frame.height, 1.8 * frame.height);
        if (kind == 1) c.x = std::floor(c.x) + .5F, c.y = std::floor(c.y) + .5F;
        if (kind == 2) c.x = std::floor(c.x / 16) * 16 + .5F, c.y = std::floor(c.y / 16) * 16 + .5F;
        c.u = dice.within(-3, 3), c.v = dice.within(-3, 3), c.w = dice.within(1, 4);
        if (kind == 3) c.u = c.x / 64, c.v = c.y / 16, c.w = 1;
        c.x += static_cast<float>(frame.x0), c.y += static_cast<float>(frame.y0);
    }
    if (dice.often(.3)) corners[1].y = corners[0].y;
    return corners;
}

/// Large ones, and among them some that cover nothing: small ones, such without area, and such that are refused.
[[nodiscard]] std::vector<Vertex> layers(laws::Dice& dice, const Frame& frame, int count, bool refused) {
    std::vector<Vertex> vertices;
    for (int n = 0; n < count; ++n) {
        auto corners = large_triangle(dice, frame);
        const auto towards_first = [&](float share) {
            for (std::size_t k = 1; k < 3; ++k) {
                corners[k].x = corners[0].x + share * (corners[k].x - corners[0].x);
                corners[k].y = corners[0].y + share * (corners[k].y - corners[0].y);
            }
        };
        if (n % 4 == 1) towards_first(.08F);
        if (n % 9 == 2) corners[2].x = corners[1].x, corners[2].y = corners[1].y;
        if (refused && n % 7 == 3) corners[1].u = NAN;
        if (refused && n % 11 == 4) corners[2].w = -1;
        if (n % 13 == 5) corners[0].x = 1e-30F, corners[1].y = -3e-38F;  // double does not hold all differences
        vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    return vertices;
}

[[nodiscard]] std::vector<Frame> frames() {
    return {{}, {.width = 160, .height = 112}, {.width = 131, .height = 90, .x0 = -57, .y0 = 1001}};
}

TEST(Overdraw, IsAsDecided) {
    laws::Dice dice(15);
    const Addresses& texels = textures()[0];
    for (const Frame& frame : frames())
        for (const bool perspective : {false, true}) {
            const std::vector<Vertex> vertices = layers(dice, frame, 40, false);
            RasterJob job = job_of(vertices, texels.texture);
            job.perspective = perspective;
            RasterCounters counters;
            EXPECT_EQ(frame.drawn(texels.with_apron.texture(), job, counters, {}),
                      frame.picture([&](const RasterTarget& t) { draw_exactly(t, texels.texture, job); }));
            EXPECT_GT(counters.of(RasterSkip::overdrawn), 3U);
        }
}

TEST(Overdraw, IsAsWithoutIt) {
    laws::Dice dice(16);
    std::uint64_t left_out = 0, all = 0;
    for (int n = 0; n < 60; ++n)
        for (const Frame& frame : frames()) {
            const Addresses& texels = textures()[static_cast<std::size_t>(n % 3)];
            const RasterTexture texture = n % 2 == 0 ? texels.texture : texels.with_apron.texture();
            const std::vector<Vertex> vertices = layers(dice, frame, 40, true);
            RasterJob job = job_of(vertices, texture);
            job.perspective = n % 4 < 2, job.cull_back = n % 3 == 0;
            RasterCounters whole;
            const auto expected = frame.drawn(texture, job, whole, {.skips = kDrawAll});
            EXPECT_EQ(whole.of(RasterSkip::overdrawn), 0U);
            all += whole.samples;
            for (const SimdLevelInfo& level : kSimdLevels) {
                if (!is_supported(level.level)) continue;
                for (const int threads : {1, 3}) {
                    RasterCounters counters;
                    ASSERT_EQ(frame.drawn(texture, job, counters, {.level = level.level, .threads = threads}), expected)
                        << n << ", " << level.id << ", " << threads << " threads";
                    if (threads > 1 || level.level != SimdLevel::sse4) continue;
                    left_out += whole.samples - counters.samples;
                    EXPECT_LE(counters.refused, whole.refused);
                }
            }
        }
    EXPECT_GT(left_out, all / 4);
}

/// A target wider than the tiles that are looked at together, and drawn in one by one last.
TEST(Overdraw, OfWideTargets) {
    laws::Dice dice(17);
    const Frame frame{.width = LastCovers::kMost * LastCovers::kWidth * 4 + 40, .height = 60};
    const Addresses& texels = textures()[0];
    std::vector<Vertex> vertices;
    const auto add = [&](float x0, float y0, float x1, float y1) {
        const float u = dice.within(0, 1), v = dice.within(0, 1);
        const auto at = [&](float x, float y) { return Vertex{x, y, 0, 1, u + x / 50, v + y / 20}; };
        // A half of it covers the box.
        vertices.insert(vertices.end(), {at(x0, y0), at(2 * x1 - x0, y0), at(x0, 2 * y1 - y0)});
    };
    add(-10, -10, 2200, 70), add(-10, -10, 2200, 70);
    for (int n = 0; n < 60; ++n) {
        const auto x = static_cast<float>(16 * dice.whole(0, 130)), y = static_cast<float>(16 * dice.whole(0, 3));
        add(x, y, x + 16, y + 16);
    }
    add(1500, -10, 2200, 20);
    const RasterJob job = job_of(vertices, texels.texture);
    for (const RasterTexture& texture : {texels.texture, texels.with_apron.texture()})
        for (const SimdLevelInfo& level : kSimdLevels) {
            if (!is_supported(level.level)) continue;
            RasterCounters with, without;
            EXPECT_EQ(frame.drawn(texture, job, with, {.level = level.level}),
                      frame.drawn(texture, job, without, {.skips = kDrawAll}))
                << level.id;
            EXPECT_LT(with.samples, without.samples) << level.id;
        }
}

TEST(Overdraw, IsNotLookedForWhereTrianglesAreSmallOrFew) {
    const auto skipped = [](float size, int count) {
        laws::Dice dice(18);
        const Frame frame{};
        std::vector<Vertex> vertices;
        for (int n = 0; n < count; ++n) {
            const float x = dice.within(0, 150 - size), y = dice.within(0, 107 - size);
            for (const auto& [right, down] : {std::pair{0.F, 0.F}, {size, 0.F}, {0.F, size}})
                vertices.push_back({x + right, y + down, 0, 1, right, down});
        }
        RasterCounters counters;
        const RasterTexture& texture = textures()[0].texture;
        (void)frame.drawn(texture, job_of(vertices, texture), counters, {});
        return counters.of(RasterSkip::overdrawn);
    };
    EXPECT_GT(skipped(90, 50), 10U);
    EXPECT_EQ(skipped(40, 100), 0U) << "small";
    EXPECT_EQ(skipped(90, 2), 0U) << "few";
}

}  // namespace
}  // namespace texelscope::raster_pictures
