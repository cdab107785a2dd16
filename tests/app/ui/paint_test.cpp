#include "app/ui/paint.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace texelscope::ui {
namespace {

TEST(Dashes, KeepTheirPlaceWhileTheFarEndMoves) {
    const glm::vec2 from{10, 20};
    const std::array near{from, from + glm::vec2(60, 0)}, far{from, from + glm::vec2(333.3F, 0)};
    const auto a = dashes(near, edge_pattern(1)), b = dashes(far, edge_pattern(1));
    ASSERT_GT(a.size(), 2U);
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
        EXPECT_NEAR(glm::distance(a[i].from, b[i].from), 0, 1e-3);
        EXPECT_NEAR(glm::distance(a[i].to, b[i].to), 0, 1e-3);
    }
}

TEST(Dashes, StrokesAndGapsHaveTheirLengths) {
    const std::array line{glm::vec2(0, 0), glm::vec2(300, 400)};
    const auto strokes = dashes(line, edge_pattern(1));
    for (std::size_t i = 0; i + 1 < strokes.size(); ++i) {
        EXPECT_NEAR(glm::distance(strokes[i].from, strokes[i].to), 9, 1e-3);
        EXPECT_NEAR(glm::distance(strokes[i].to, strokes[i + 1].from), 5, 1e-3);
    }
}

TEST(Dashes, GoOnRoundACorner) {
    const std::array path{glm::vec2(0, 0), glm::vec2(4, 0), glm::vec2(4, 100)};
    const auto strokes = dashes(path, edge_pattern(1));
    ASSERT_GE(strokes.size(), 3U);
    EXPECT_NEAR(glm::distance(strokes[0].from, strokes[0].to) + glm::distance(strokes[1].from, strokes[1].to), 9, 1e-4);
    EXPECT_NEAR(strokes[2].from.y, 10, 1e-4);
}

TEST(Dashes, EndOnAnyInput) {
    const std::array far{glm::vec2(0, 0), glm::vec2(1e30F, 0)}, nothing{glm::vec2(1, 1), glm::vec2(1, 1)};
    const std::array bad{glm::vec2(0, 0), glm::vec2(NAN, 0)};
    EXPECT_EQ(dashes(far, edge_pattern(2)).size(), 1U);
    EXPECT_TRUE(dashes(nothing, edge_pattern(2)).empty());
    EXPECT_TRUE(dashes(bad, edge_pattern(2)).empty());
}

/// Corners on a circle, so the polygon is convex.
std::vector<glm::vec2> random_convex(std::mt19937& random, bool turned) {
    std::uniform_real_distribution<float> place(50, 600), radius(5, 200), turn(0, 1);
    const glm::vec2 centre{place(random), place(random)};
    const float r = radius(random);
    std::vector<glm::vec2> out;
    const int n = 3 + static_cast<int>(random() % 5);
    for (int i = 0; i < n; ++i) {
        const float a = 6.2831853F * (static_cast<float>(i) + 0.8F * turn(random)) / static_cast<float>(n);
        out.push_back(centre + r * glm::vec2(std::cos(a), turned ? -std::sin(a) : std::sin(a)));
    }
    return out;
}

bool inside(std::span<const glm::vec2> convex, glm::vec2 p, float slack) {
    bool left = true, right = true;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const glm::vec2 a = convex[i], side = convex[(i + 1) % convex.size()] - a;
        const float distance = (side.x * (p.y - a.y) - side.y * (p.x - a.x)) / glm::length(side);
        left = left && distance >= -slack;
        right = right && distance <= slack;
    }
    return left || right;
}

TEST(Hatch, LinesStayInsideThePolygon) {
    std::mt19937 random(7);
    for (int i = 0; i < 300; ++i) {
        const auto polygon = random_convex(random, i % 2 == 1);
        for (int s = 0; s < 5; ++s)
            for (const Segment& line : hatch(polygon, section_degrees(s), 6, {16, 56})) {
                EXPECT_TRUE(inside(polygon, line.from, 0.02F));
                EXPECT_TRUE(inside(polygon, line.to, 0.02F));
            }
    }
}

TEST(Hatch, LinesKeepTheirPlaceWhileThePolygonMoves) {
    const std::array<glm::vec2, 4> square{glm::vec2(0, 0), {100, 0}, {100, 100}, {0, 100}};
    for (const float shift : {0.0F, 3.7F, 50.0F}) {
        auto moved = square;
        for (glm::vec2& p : moved) p += glm::vec2(shift);
        for (const Segment& line : hatch(moved, 0, 9, {16, 5})) {
            const float phase = (line.from.y - 5) / 9;
            EXPECT_NEAR(phase, std::round(phase), 1e-3);
        }
    }
}

TEST(Hatch, DegeneratePolygonsHaveNone) {
    const std::array flat{glm::vec2(0, 0), glm::vec2(10, 0), glm::vec2(20, 0)};
    const std::array two{glm::vec2(0, 0), glm::vec2(10, 0)};
    EXPECT_TRUE(hatch(flat, 45, 9, {0, 0}).empty());
    EXPECT_TRUE(hatch(two, 45, 9, {0, 0}).empty());
    EXPECT_TRUE(hatch(flat, 45, 0, {0, 0}).empty());
}

TEST(HalfPlane, KeepsTheSideBelowTheOffset) {
    const std::array<glm::vec2, 4> square{glm::vec2(0, 0), {10, 0}, {10, 10}, {0, 10}};
    for (const glm::vec2 p : clipped_to_half_plane(square, {1, 0}, 4)) EXPECT_LE(p.x, 4.0001F);
    EXPECT_EQ(clipped_to_half_plane(square, {1, 0}, 20).size(), 4U);
    EXPECT_TRUE(clipped_to_half_plane(square, {1, 0}, -1).empty());
}

}  // namespace
}  // namespace texelscope::ui
