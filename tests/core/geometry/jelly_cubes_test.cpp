#include "core/geometry/jelly_cubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <random>
#include <string>
#include <tuple>

#include "core/geometry/camera.h"

namespace texelscope {
namespace {

constexpr double kHalves[] = {0.3, 0.55, 0.6, 0.72, 0.8, 0.9, 1, 1.05, 1.3, 1.6, 2};

struct Pose {
    glm::dvec3 big{0}, small{0};
    [[nodiscard]] JellyCubes cubes(double half) const { return jelly_cubes(1, half, rotation(big), rotation(small)); }
};

/// Any two rotations, and those that put corners, edges and faces of one cube on planes of the other.
std::vector<Pose> poses() {
    std::vector<Pose> poses{{},
                            {{30, 20, 10}, {30, 20, 10}},
                            {{0, 0, 0}, {0, 0, 45}},
                            {{45, 0, 0}, {0, 45, 0}},
                            {{0, 0, 0}, {90, 180, 270}},
                            {{0, 0, 0}, {30, 0, 0}},
                            {{10, 0, 0}, {10, 33, 0}}};
    std::mt19937 random(1);
    const auto angle = [&] { return static_cast<double>(random()) * 8e-8; };
    for (int i = 0; i < 40; ++i) {
        Pose pose;
        for (int axis = 0; axis < 3; ++axis) pose.big[axis] = angle(), pose.small[axis] = angle();
        poses.push_back(pose);
    }
    return poses;
}

glm::dvec3 area_of(const ClipRing& ring) {
    glm::dvec3 sum(0);
    const auto at = [&](std::size_t i) { return glm::dvec3(ring[i].position); };
    for (std::size_t i = 2; i < ring.size(); ++i) sum += glm::cross(at(i - 1) - at(0), at(i) - at(0)) / 2.0;
    return sum;
}

bool is_in(const glm::dvec3& point, const glm::dmat3& turn, double half, double slack = 0) {
    const glm::dvec3 p = glm::transpose(turn) * point;
    return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) <= half + slack;
}

void for_each(const std::function<void(const Pose&, double, const JellyCubes&)>& check) {
    const std::vector<Pose> all = poses();
    for (std::size_t n = 0; n < all.size(); ++n) {
        for (const double half : kHalves) {
            SCOPED_TRACE("pose " + std::to_string(n) + ", small half-size " + std::to_string(half));
            check(all[n], half, all[n].cubes(half));
        }
    }
}

TEST(JellyCubes, PiecesOfAFaceAddUpToIt) {
    for_each([](const Pose&, double half, const JellyCubes& cubes) {
        std::map<std::pair<int, int>, double> sums;
        for (const JellyPiece& piece : cubes.pieces) {
            EXPECT_GE(piece.ring.size(), 3u);
            sums[{piece.cube, piece.face}] += glm::length(area_of(piece.ring));
        }
        ASSERT_EQ(sums.size(), 12u);
        for (const auto& [face, sum] : sums) EXPECT_NEAR(sum, 4 * (face.first == 0 ? 1 : half * half), 1e-8);
    });
}

TEST(JellyCubes, PiecesLieWhereTheySay) {
    for_each([](const Pose& pose, double half, const JellyCubes& cubes) {
        for (const JellyPiece& piece : cubes.pieces) {
            const bool is_big = piece.cube == 0;
            const glm::dmat3 turn = rotation(is_big ? pose.small : pose.big);
            const double other = is_big ? half : 1;
            glm::dvec3 sum(0);
            for (const ClipVertex& vertex : piece.ring) {
                sum += glm::dvec3(vertex.position);
                if (piece.inside) {
                    EXPECT_TRUE(is_in(vertex.position, turn, other, 1e-8));
                }
            }
            const bool has_area = glm::length(area_of(piece.ring)) > 1e-8;
            if (!piece.inside && has_area) {
                EXPECT_FALSE(is_in(sum / static_cast<double>(piece.ring.size()), turn, other, -1e-8));
            }
            EXPECT_EQ(piece.plane >= 0, !piece.inside);
        }
    });
}

TEST(JellyCubes, WhatTheyHaveInCommonIsWatertight) {
    using Point = std::tuple<double, double, double>;
    for_each([](const Pose&, double, const JellyCubes& cubes) {
        std::map<std::pair<Point, Point>, int> sides;
        glm::dvec3 area(0);
        const auto key = [](const glm::dvec4& p) { return Point(p.x, p.y, p.z); };
        for (const JellyPiece& piece : cubes.pieces) {
            if (!piece.inside) continue;
            area += area_of(piece.ring);
            for (std::size_t i = 0; i < piece.ring.size(); ++i) {
                const Point p = key(piece.ring[i].position);
                const Point q = key(piece.ring[(i + 1) % piece.ring.size()].position);
                if (p != q) ++sides[{p, q}];
            }
        }
        EXPECT_NEAR(glm::length(area), 0, 1e-8);
        for (const auto& [side, times] : sides) {
            const auto back = sides.find({side.second, side.first});
            EXPECT_EQ(back == sides.end() ? 0 : back->second, times);
        }
    });
}

/// Points in the small cube, each in the big one or not: the error of the share is that of a binomial, and 4.5 sigma
/// are passed once in 150,000 times.
TEST(JellyCubes, CommonVolumeIsThatOfRandomPoints) {
    std::mt19937 random(2);
    const std::vector<Pose> all = poses();
    constexpr int kPoints = 40'000;
    for (std::size_t n = 0; n < all.size(); n += 3) {
        for (const double half : kHalves) {
            const glm::dmat3 big = rotation(all[n].big), small = rotation(all[n].small);
            int hits = 0;
            for (int i = 0; i < kPoints; ++i) {
                glm::dvec3 p;
                for (int axis = 0; axis < 3; ++axis)
                    p[axis] = (static_cast<double>(random()) / 2147483648.0 - 1) * half;
                hits += is_in(small * p, big, 1) ? 1 : 0;
            }
            const double whole = 8 * half * half * half, share = common_volume(all[n].cubes(half)) / whole;
            const double sigma = std::sqrt(std::max(share * (1 - share), 0.0) / kPoints);
            EXPECT_NEAR(static_cast<double>(hits) / kPoints, share, 4.5 * sigma + 1e-9)
                << "pose " << n << ", half " << half;
            EXPECT_LE(share, 1 + 1e-9);
        }
    }
}

bool has_outside(const JellyCubes& cubes, int cube) {
    for (const JellyPiece& piece : cubes.pieces)
        if (piece.cube == cube && !piece.inside && glm::length(area_of(piece.ring)) > 1e-12) return true;
    return false;
}

/// A whole side of the small cube outside, by one plane of the big one.
bool has_side_outside(const JellyCubes& cubes) {
    for (const auto& stages : cubes.cuts[1]) {
        const std::vector<double>& d = stages[0].distances;
        for (std::size_t i = 0; i < d.size(); ++i)
            if (d[i] < 0 && d[(i + 1) % d.size()] < 0) return true;
    }
    return false;
}

TEST(JellyCubes, CornersPokeOutFromOneOverRootThree) {
    const double limit = 1 / std::sqrt(3.0);
    // The diagonal of the small cube turned onto an axis of the big one: first into the plane xz, then along x.
    const glm::dvec3 on_axis(0, glm::degrees(std::atan(1 / std::sqrt(2.0))), 45);
    const glm::dvec3 corner = rotation(on_axis) * glm::dvec3(1, 1, 1);
    ASSERT_NEAR(std::max({corner.x, corner.y, corner.z}), std::sqrt(3.0), 1e-12);
    EXPECT_FALSE(has_outside(Pose{{}, on_axis}.cubes(limit * 0.9999), 1));
    EXPECT_TRUE(has_outside(Pose{{}, on_axis}.cubes(limit * 1.0001), 1));
    for (const Pose& pose : poses()) EXPECT_FALSE(has_outside(pose.cubes(limit * 0.9999), 1));
}

TEST(JellyCubes, WholeSidesPokeOutFromOneOverRootTwo) {
    const double limit = 1 / std::sqrt(2.0);
    const Pose on_edge{{0, 0, 0}, {0, 0, 45}};
    EXPECT_FALSE(has_side_outside(on_edge.cubes(limit * 0.9999)));
    EXPECT_TRUE(has_side_outside(on_edge.cubes(limit * 1.0001)));
    for (const Pose& pose : poses()) EXPECT_FALSE(has_side_outside(pose.cubes(limit * 0.9999)));
}

TEST(JellyCubes, RolesSwapWhereTheSizesCross) {
    for (const Pose& pose : poses()) {
        for (const double half : kHalves) {
            const JellyCubes one = jelly_cubes(1, half, rotation(pose.big), rotation(pose.small));
            const JellyCubes other = jelly_cubes(half, 1, rotation(pose.small), rotation(pose.big));
            EXPECT_NEAR(common_volume(one), common_volume(other), 1e-8);
        }
        // Below the least ratio only the small cube can be wholly inside; beyond its inverse only the big one.
        EXPECT_FALSE(has_outside(pose.cubes(0.5), 1));
        EXPECT_FALSE(has_outside(pose.cubes(2), 0));
        EXPECT_TRUE(has_outside(pose.cubes(0.5), 0));
        EXPECT_TRUE(has_outside(pose.cubes(2), 1));
    }
}

TEST(JellyCubes, EqualCubesCountOnce) {
    for (const glm::dvec3& degrees : {glm::dvec3(0), glm::dvec3(20, 30, 40)}) {
        const JellyCubes cubes = jelly_cubes(1, 1, rotation(degrees), rotation(degrees));
        EXPECT_NEAR(common_volume(cubes), 8, 1e-9);
        for (const JellyPiece& piece : cubes.pieces) EXPECT_EQ(piece.inside, piece.cube == 0);
    }
}

TEST(JellyCubes, TexturesFollowTheCuts) {
    for_each([](const Pose&, double half, const JellyCubes& cubes) {
        for (const JellyPiece& piece : cubes.pieces) {
            const double texture = 4 * (piece.cube == 0 ? 1 : half * half);  // the area of the whole texture
            double area = 0;
            for (std::size_t i = 0; i < piece.ring.size(); ++i) {
                const glm::dvec2 &p = piece.ring[i].uv, &q = piece.ring[(i + 1) % piece.ring.size()].uv;
                area += (p.x * q.y - q.x * p.y) / 2;
            }
            EXPECT_NEAR(area * texture, glm::length(area_of(piece.ring)), 1e-8);
        }
    });
}

}  // namespace
}  // namespace texelscope
