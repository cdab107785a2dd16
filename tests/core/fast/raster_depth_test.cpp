// Depth and what tiles of depths hide, against the exact triangle.
#include <gtest/gtest.h>

#include "tests/core/fast/raster_pictures.h"

namespace texelscope::raster_pictures {
namespace {

TEST(RasterEqualsExact, WithDepthAndLight) {
    laws::Dice dice(3);
    ChannelTable light{};
    for (std::uint32_t n = 0; n < light.size(); ++n) light[n] = n * 7 / 10;
    RasterCounters counters;
    for (int n = 0; n < 600; ++n) {
        std::vector<Vertex> vertices;
        for (int k = dice.whole(1, 12); k-- > 0;) {
            auto corners = random_triangle(dice, dice.whole(0, 1000));
            if (dice.often(.3))  // level, and equal to others
                for (Vertex& c : corners) c.z = .5F;
            if (dice.often(.3))  // near halves between floats
                for (Vertex& c : corners) c.z = .5F + static_cast<float>(dice.whole(0, 7)) * 0x1p-24F;
            vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
        const Addresses& texels = textures()[static_cast<std::size_t>(n % 6)];
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = n % 4 != 0, job.perspective = n % 2 == 0, job.cull_back = n % 5 == 0;
        if (n % 3 == 0) job.light = &light;
        expect_exact(texels, job, counters, std::to_string(n));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.of(RasterSkip::hidden), 0U);
}

/// Wide slopes through and behind each other: what a tile of them hides is as near as it is said to be.
TEST(RasterEqualsExact, WhereTilesHideWideTriangles) {
    laws::Dice dice(15);
    RasterCounters counters;
    for (int n = 0; n < 300; ++n) {
        const Addresses& texels = textures()[static_cast<std::size_t>(n % 6)];
        const Origin origin{n % 3 == 0 ? dice.whole(-3000, 3000) : 0, n % 3 == 0 ? dice.whole(-3000, 3000) : 0};
        std::vector<Vertex> vertices;
        for (int k = 0; k < 14; ++k) {
            const float z = dice.within(.1F, .9F), slope = k % 3 == 0 ? 0 : dice.within(0, .1F);
            for (int corner = 0; corner < 3; ++corner)
                vertices.push_back({dice.within(-250, kWidth + 250) + static_cast<float>(origin.x),
                                    dice.within(-200, kHeight + 200) + static_cast<float>(origin.y),
                                    z + slope * dice.within(-1, 1), 1, dice.within(-2, 2), dice.within(-2, 2)});
        }
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = true;
        expect_exact(texels, job, counters, std::to_string(n), origin);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.of(RasterSkip::hidden_tile), 1000U);
    EXPECT_GT(counters.of(RasterSkip::early_z), 1000U);
}

/// One row of a steep triangle, nearer by an ulp than what stands there: its tile's other rows lie far outside of it.
TEST(RasterEqualsExact, WhereADepthIsAsNearAsItsTile) {
    const Addresses& texels = textures()[0];
    struct Case {
        float before;
        std::array<Vertex, 3> corners;
    };
    const std::array<Case, 2> cases{{{0x1.e1ad54p-15F,
                                      {{{0x1.8ad0f2p+7F, 0x1.f00012p+3F, -0x1.3f2fd4p-2F, 1, 0, 0},
                                        {0x1.1d3f16p+7F, 0x1.effff6p+3F, 0x1.6316b6p-3F, 1, 1, 0},
                                        {0x1.f738e4p+7F, 0x1.effff6p+3F, 0x1.627b6ep-3F, 1, 0, 1}}}},
                                     {-0x1.136452p-18F,
                                      {{{0x1.6342dap+7F, 0x1.f00038p+3F, -0x1.e8782ap-3F, 1, 0, 0},
                                        {0x1.da14ecp+6F, 0x1.efff9p+3F, 0x1.e8b60ap-2F, 1, 1, 0},
                                        {0x1.dbd8e6p+7F, 0x1.efff9p+3F, 0x1.e868dcp-2F, 1, 0, 1}}}}}};
    for (const Case& c : cases) {
        std::vector<Vertex> vertices{
            {-400, -400, c.before, 1, 0, 0}, {2000, -400, c.before, 1, 1, 0}, {-400, 2000, c.before, 1, 0, 1}};
        vertices.insert(vertices.end(), c.corners.begin(), c.corners.end());
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = true;
        RasterCounters counters;
        expect_exact(texels, job, counters, text_of(c.corners));
        if (HasFatalFailure()) return;
    }
}

void add_square(std::vector<Vertex>& to, float x, float y, float size, float z) {
    const auto corner = [&](float right, float down) {
        return Vertex{x + right * size, y + down * size, z, 1, right / 4, down / 4};
    };
    for (const Vertex& c : {corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 0), corner(1, 1), corner(0, 1)})
        to.push_back(c);
}

/// Three of the four tiles that a small square meets are covered by something nearer: what lies in the fourth is seen.
TEST(RasterSkips, HideNothingThatOneOfFourTilesShows) {
    const Addresses& texels = textures()[0];
    for (int open = 0; open < 4; ++open) {
        std::vector<Vertex> vertices;
        const auto tile = [&](int n, float inset, float size, float z) {
            add_square(vertices, static_cast<float>(16 + 16 * (n % 2)) + inset,
                       static_cast<float>(16 * (n / 2)) + inset, size, z);
        };
        for (int round = 0; round < 16; ++round)  // until it is asked again how far each tile's depths are
            for (int n = 0; n < 4; ++n) {
                if (n != open) tile(n, 0, 16, .3F - .01F * static_cast<float>(round));
                tile(n, 2, 4, n == open ? .1F : .7F);
            }
        for (int round = 0; round < 8; ++round) add_square(vertices, 24, 8, 16, .5F);
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = true;
        RasterCounters counters;
        const Picture is = drawn(texels.texture, job, counters);
        EXPECT_EQ(is, decided(texels.texture, job)) << "tile " << open;
        EXPECT_GE(counters.of(RasterSkip::hidden), 30U);
    }
}

}  // namespace
}  // namespace texelscope::raster_pictures
