#include "core/geometry/clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace texelscope {
namespace {

ClipRing square() {
    return {clip_vertex({-1, -1, 0, 1}, {0, 0}), clip_vertex({1, -1, 0, 1}, {1, 0}), clip_vertex({1, 1, 0, 1}, {1, 1}),
            clip_vertex({-1, 1, 0, 1}, {0, 1})};
}

/// Of a ring in the plane xy.
double area(const ClipRing& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec4 &p = ring[i].position, &q = ring[(i + 1) % ring.size()].position;
        sum += (p.x * q.y - q.x * p.y) / 2;
    }
    return sum;
}

TEST(Clip, CutIsTheAverageWeightedByTheLengthsOnEachSide) {
    // The source's example: outside at 1.1, inside at 0.7, the plane at 1.
    const ClipRing ring{clip_vertex({1.1, 0, 0, 1}, {1.1, 0}), clip_vertex({0.7, 4, 0, 1}, {0.7, 4}),
                        clip_vertex({0.5, 0, 0, 1}, {0.5, 0})};
    const ClipStage stage = clip(ring, {-1, 0, 0, 1});
    ASSERT_EQ(stage.inside.size(), 4u);
    EXPECT_NEAR(stage.distances[0], -0.1, 1e-15);
    EXPECT_NEAR(stage.distances[1], 0.3, 1e-15);
    const ClipVertex& cut = stage.inside[0];
    EXPECT_TRUE(cut.is_cut());
    EXPECT_EQ(std::minmax(cut.from, cut.to), std::minmax(0, 1));
    const double of_inside = cut.from == 1 ? cut.from_share : cut.to_share;
    EXPECT_NEAR(of_inside, 0.25, 1e-15);
    EXPECT_NEAR(cut.from_share + cut.to_share, 1, 1e-15);
    EXPECT_NEAR(cut.position.x, 1, 1e-15);
    EXPECT_NEAR(cut.position.y, 1, 1e-15);
    EXPECT_NEAR(cut.uv.y, 1, 1e-15);
    EXPECT_EQ(stage.inside[1].from, 1);
    EXPECT_FALSE(stage.inside[1].is_cut());
}

TEST(Clip, PartsMakeUpTheWhole) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1.2, 1.2);
    for (int i = 0; i < 5000; ++i) {
        const double a = number(random), b = number(random);
        const ClipStage stage = clip(square(), {a, b, 0, number(random)});
        ASSERT_NEAR(area(stage.inside) + area(stage.outside), 4, 1e-12);
        ASSERT_GE(area(stage.inside), -1e-15);
        ASSERT_GE(area(stage.outside), -1e-15);
        for (const ClipVertex& vertex : stage.inside) ASSERT_GE(glm::dot(stage.plane, vertex.position), -1e-12);
        for (const ClipVertex& vertex : stage.outside) ASSERT_LE(glm::dot(stage.plane, vertex.position), 1e-12);
    }
}

TEST(Clip, EachCornerIsTheAverageOfItsOrigins) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const double a = number(random), b = number(random);
        const ClipStage stage = clip(square(), {a, b, 0, number(random) / 2});
        for (const ClipRing* part : {&stage.inside, &stage.outside}) {
            for (const ClipVertex& v : *part) {
                const ClipVertex& from = stage.ring[static_cast<std::size_t>(v.from)];
                const ClipVertex& to = stage.ring[static_cast<std::size_t>(v.is_cut() ? v.to : v.from)];
                ASSERT_EQ(v.position,
                          v.is_cut() ? from.position * v.from_share + to.position * v.to_share : from.position);
                ASSERT_EQ(v.uv, v.is_cut() ? from.uv * v.from_share + to.uv * v.to_share : from.uv);
            }
        }
    }
}

TEST(Clip, BothWaysAlongASideGiveTheSameBits) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-3, 3);
    int cuts = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto point = [&] { return glm::dvec4(number(random), number(random), number(random), 1); };
        const glm::dvec4 p = point(), q = point(), plane = point();
        const ClipRing here{clip_vertex(p, {0, 0}), clip_vertex(q, {1, 0}), clip_vertex(point(), {1, 1})};
        const ClipRing there{clip_vertex(point(), {0, 0}), clip_vertex(q, {7, 0}), clip_vertex(p, {1, 8})};
        const auto cut = [&](const ClipRing& ring, int a, int b) -> std::vector<glm::dvec4> {
            for (const ClipVertex& v : clip(ring, plane).inside)
                if (v.is_cut() && std::minmax(v.from, v.to) == std::minmax(a, b)) return {v.position};
            return {};
        };
        const auto one = cut(here, 0, 1), other = cut(there, 1, 2);
        ASSERT_EQ(one, other);
        cuts += static_cast<int>(one.size());
    }
    EXPECT_GT(cuts, 1000);
}

TEST(Clip, CornersOnThePlaneBelongToBothParts) {
    const ClipStage diagonal = clip(square(), {1, -1, 0, 0});
    EXPECT_EQ(diagonal.inside.size(), 3u);
    EXPECT_EQ(diagonal.outside.size(), 3u);
    for (const ClipVertex& vertex : diagonal.inside) EXPECT_FALSE(vertex.is_cut());
    const ClipStage touches = clip(square(), {1, 0, 0, 1});  // a side lies on it
    EXPECT_EQ(touches.inside.size(), 4u);
    EXPECT_TRUE(touches.outside.empty());
    const ClipStage beside = clip(square(), {-1, 0, 0, -1});
    EXPECT_TRUE(beside.inside.empty());
    EXPECT_EQ(beside.outside.size(), 4u);
    const ClipStage within = clip(square(), {0, 0, 1, 0});
    EXPECT_EQ(within.inside.size(), 4u);
    EXPECT_TRUE(within.outside.empty());
    EXPECT_EQ(clip(square(), {0, 0, 0, 1e-13}, 1e-12).distances[0], 0);
}

TEST(Clip, PlanesOneAfterTheOther) {
    const std::vector<glm::dvec4> planes{{-1, 0, 0, 0.5}, {1, 0, 0, 0.5}, {0, -1, 0, 0.5}, {0, 1, 0, 0.5}};
    const std::vector<ClipStage> stages = clip(square(), planes);
    ASSERT_EQ(stages.size(), 4u);
    EXPECT_NEAR(area(stages.back().inside), 1, 1e-15);
    double sum = area(stages.back().inside);
    for (const ClipStage& stage : stages) sum += area(stage.outside);
    EXPECT_NEAR(sum, 4, 1e-15);
    EXPECT_EQ(clip(square(), std::vector<glm::dvec4>{{0, 0, 0, -1}, {0, 0, 0, 1}}).size(), 1u);
    EXPECT_TRUE(clip(ClipRing{}, planes[0]).inside.empty());
}

TEST(Clip, WhatIsNotANumberIsNotDrawn) {
    ClipRing ring = square();
    for (ClipVertex& vertex : ring) vertex.position.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(clip(ring, {1, 0, 0, 0}).inside.empty());
}

}  // namespace
}  // namespace texelscope
