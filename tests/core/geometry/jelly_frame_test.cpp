#include "core/geometry/jelly_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/geometry/camera.h"
#include "core/geometry/jelly_cubes.h"

namespace texelscope {
namespace {

struct Turns {
    glm::dmat3 big{1}, small{1};
};

Turns random_turns(std::mt19937& random) {
    const auto angle = [&] { return static_cast<double>(random()) * 8e-8; };
    const auto turn = [&] { return rotation({angle(), angle(), angle()}); };
    return {turn(), turn()};
}

/// The greatest coordinate of a corner, and of an edge's nearer end, over many rotations.
TEST(JellyFrame, CornersReachTheirLimitWhereTheyPointAlongAnAxis) {
    std::mt19937 random(1);
    double corner_reach = 0, edge_reach = 0;
    for (int n = 0; n < 200'000; ++n) {
        const Turns turns = random_turns(random);
        const auto corners = jelly_corners(1, turns.big, turns.small, 1);
        for (std::size_t c = 0; c < corners.size(); ++c) {
            corner_reach = std::max(corner_reach, corners[c].reach);
            for (const std::size_t bit : {1U, 2U, 4U})
                for (int axis = 0; axis < 3; ++axis)
                    for (const double side : {1.0, -1.0})
                        edge_reach = std::max(
                            edge_reach, std::min(side * corners[c].turned[axis], side * corners[c ^ bit].turned[axis]));
        }
    }
    EXPECT_LE(corner_reach * kCornersOut, 1 + 1e-12);
    EXPECT_GT(corner_reach * kCornersOut, 0.999);
    EXPECT_LE(edge_reach * kEdgesOut, 1 + 1e-12);
    EXPECT_GT(edge_reach * kEdgesOut, 0.99);
}

/// A corner lies beyond 1 in the other's frame exactly where a piece outside has it.
TEST(JellyFrame, AgreesWithTheGeneralCut) {
    std::mt19937 random(2);
    for (int n = 0; n < 300; ++n) {
        const Turns turns = random_turns(random);
        const double half = 0.5 + static_cast<double>(random()) * 2e-10;
        const bool size_twice = n % 3 == 0;
        const JellyCubes cubes = jelly_cubes(1, half, turns.big, turns.small, size_twice);
        const int guest = half > 1 ? 0 : 1;  // the quirk is about the smaller one
        for (int cube = 0; cube < 2; ++cube) {
            const bool twice = size_twice && cube == guest;
            for (const JellyCorner& corner : jelly_corners(half, turns.big, turns.small, cube, twice)) {
                if (std::fabs(corner.reach - 1) < 1e-6) continue;
                bool outside = false;
                for (const JellyPiece& piece : cubes.pieces) {
                    if (piece.inside || piece.cube != cube) continue;
                    for (const ClipVertex& vertex : piece.ring) {
                        const glm::dvec3 apart = glm::dvec3(vertex.position) - corner.world;
                        outside =
                            outside || std::max({std::fabs(apart.x), std::fabs(apart.y), std::fabs(apart.z)}) < 1e-8;
                    }
                }
                EXPECT_EQ(corner.outside, outside) << "half " << half << ", reach " << corner.reach;
            }
        }
    }
}

/// A corner at 0.7 * sqrt 3 = 1.21 of the big one's half-size; times 0.7 it is at 0.85, and nothing is cut.
TEST(JellyFrame, ScaledTwiceACornerThatSticksOutCountsAsInside) {
    const Turns turns{glm::dmat3(1), rotation({35.264389682754654, 0, 45})};  // its diagonal along y
    double reach = 0, twice = 0;
    for (const JellyCorner& corner : jelly_corners(0.7, turns.big, turns.small, 1))
        reach = std::max(reach, corner.reach);
    for (const JellyCorner& corner : jelly_corners(0.7, turns.big, turns.small, 1, true)) {
        twice = std::max(twice, corner.reach);
        EXPECT_FALSE(corner.outside);
    }
    EXPECT_NEAR(reach, 0.7 * std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(twice, 0.7 * 0.7 * std::sqrt(3.0), 1e-9);
}

TEST(JellyFrame, WeightsGoByTheLengthOnTheOtherSide) {
    const CutWeights w = cut_weights(1.1, 0.7);
    EXPECT_NEAR(w.beyond, 0.1, 1e-12);
    EXPECT_NEAR(w.short_of, 0.3, 1e-12);
    EXPECT_NEAR(w.of_outside, 0.75, 1e-12);
    EXPECT_NEAR(w.of_inside, 0.25, 1e-12);
    EXPECT_NEAR(w.of_outside * 1.1 + w.of_inside * 0.7, 1, 1e-12);
}

}  // namespace
}  // namespace texelscope
