#include "core/geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/triangulate.h"

namespace texelscope::polygon_test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Every `step`-th corner of a regular polygon.
std::vector<Vertex> regular(int corners, int step = 1) {
    std::vector<Vertex> ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * i * step / corners;
        ring.push_back(
            {.x = static_cast<float>(50 + 40 * std::cos(angle)), .y = static_cast<float>(50 + 40 * std::sin(angle))});
    }
    return ring;
}

TEST(Polygon, FanHasTheAreaOfThePolygon) {
    for (int corners = 3; corners < 20; ++corners) {
        const std::vector<Vertex> ring = regular(corners);
        double sum = 0;
        for (int i = 0; i < fan_size(ring.size()); ++i) sum += doubled_area(fan_triangle(ring, i));
        EXPECT_NEAR(sum, doubled_area(ring), 1e-9);
        EXPECT_EQ(fan_size(ring.size()), corners - 2);
    }
}

TEST(Polygon, FanStartsAtTheFirstCornerAndUsesEveryOther) {
    const std::vector<Vertex> ring = regular(6);
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(fan_triangle(ring, i),
                  (Triangle{ring[0], ring[static_cast<std::size_t>(i) + 1], ring[static_cast<std::size_t>(i) + 2]}));
}

TEST(Polygon, AreaIsPositiveClockwiseOnTheScreen) {
    EXPECT_EQ(doubled_area(std::vector<Vertex>{{.x = 0, .y = 0}, {.x = 4, .y = 0}, {.x = 0, .y = 3}}), 12);
    EXPECT_EQ(doubled_area(std::vector<Vertex>{{.x = 0, .y = 0}, {.x = 0, .y = 3}, {.x = 4, .y = 0}}), -12);
}

TEST(Polygon, RegularOnesAreConvexInEveryRotationAndWinding) {
    for (int corners = 3; corners < 40; ++corners) {
        std::vector<Vertex> ring = regular(corners);
        for (int i = 0; i < corners; ++i) {
            std::rotate(ring.begin(), ring.begin() + 1, ring.end());
            EXPECT_TRUE(is_convex(ring)) << corners << " corners";
            std::reverse(ring.begin(), ring.end());
            EXPECT_TRUE(is_convex(ring)) << corners << " corners, reversed";
        }
    }
}

TEST(Polygon, StarsAndDentsAreNotConvex) {
    for (const int corners : {5, 7, 9, 11})
        EXPECT_FALSE(is_convex(regular(corners, 2))) << corners;  // goes round twice, turning one way
    const std::vector<Vertex> dent{{.x = 0, .y = 0}, {.x = 9, .y = 0}, {.x = 1, .y = 1}, {.x = 0, .y = 9}};
    EXPECT_FALSE(is_convex(dent));
    const std::vector<Vertex> bow_tie{{.x = 0, .y = 0}, {.x = 9, .y = 9}, {.x = 9, .y = 0}, {.x = 0, .y = 9}};
    EXPECT_FALSE(is_convex(bow_tie));
}

TEST(Polygon, RepeatedAndStraightCornersAreConvex) {
    const std::vector<Vertex> ring{{.x = 0, .y = 0}, {.x = 0, .y = 0}, {.x = 4, .y = 0},
                                   {.x = 9, .y = 0}, {.x = 9, .y = 9}, {.x = 0, .y = 9}};
    EXPECT_TRUE(is_convex(ring));
}

TEST(Polygon, EveryNumberThatIsNotFiniteIsAFault) {
    for (const float bad : {kNan, kInfinity, -kInfinity})
        for (float Vertex::*member : {&Vertex::x, &Vertex::y, &Vertex::z, &Vertex::w, &Vertex::u, &Vertex::v}) {
            Polygon polygon{.vertices = regular(5)};
            EXPECT_TRUE(is_drawable(polygon));
            EXPECT_EQ(polygon_fault(polygon), "");
            polygon.vertices[3].*member = bad;
            EXPECT_FALSE(is_drawable(polygon));
            EXPECT_NE(polygon_fault(polygon).find("vertex 3"), std::string::npos);
        }
}

TEST(Polygon, WMustBeAboveZeroAndLightFinite) {
    for (const float w : {0.0F, -0.0F, -1.0F}) {
        Polygon polygon{.vertices = regular(3)};
        polygon.vertices[1].w = w;
        EXPECT_FALSE(is_drawable(polygon));
        EXPECT_EQ(polygon_fault(polygon), "w of its vertex 1 is not above 0");
    }
    EXPECT_FALSE(is_drawable({.vertices = regular(3), .light = kNan}));
    EXPECT_FALSE(is_drawable({.vertices = {}}));
}

}  // namespace
}  // namespace texelscope::polygon_test
