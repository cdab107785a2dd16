#include "core/geometry/snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace texelscope {
namespace {

TEST(Snap, GivesAMultipleAndIsIdempotentAndNear) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> coordinate(-20000, 20000);
    for (int i = 0; i < 20000; ++i) {
        const float x = coordinate(random);
        const int bits = static_cast<int>(random() % 13);
        const float snapped_x = snap(x, bits);
        const double steps = std::ldexp(double{snapped_x}, bits);
        ASSERT_EQ(steps, std::floor(steps)) << x << " at " << bits << " bits";
        ASSERT_EQ(snap(snapped_x, bits), snapped_x);
        ASSERT_LE(std::fabs(double{x} - snapped_x), std::ldexp(0.5, -bits));
    }
}

TEST(Snap, TiesGoToEven) {
    EXPECT_EQ(snap(0.5F, 0), 0.0F);
    EXPECT_EQ(snap(1.5F, 0), 2.0F);
    EXPECT_EQ(snap(2.5F, 0), 2.0F);
    EXPECT_EQ(snap(-0.5F, 0), 0.0F);
    EXPECT_EQ(snap(0x1p-9F, 8), 0.0F);
    EXPECT_EQ(snap(3 * 0x1p-9F, 8), 0x1p-7F);
}

TEST(Snap, FineGridsAndExtremeNumbersChangeNothing) {
    for (const float x : {0.1F, -3.3F, std::numeric_limits<float>::max(), std::numeric_limits<float>::infinity()})
        EXPECT_EQ(snap(x, kMaxSnapBits), x);
    EXPECT_TRUE(std::isnan(snap(std::numeric_limits<float>::quiet_NaN(), 8)));
}

TEST(Snap, PolygonKeepsAllButXAndY) {
    const Vertex v{.x = 1.3F, .y = 2.6F, .z = 0.3F, .w = 1.7F, .u = 0.1F, .v = 0.9F};
    const Polygon polygon = snapped({.vertices = {v, v, v}, .texture = 2, .light = 0.3F}, 0);
    const Vertex expected{.x = 1, .y = 3, .z = 0.3F, .w = 1.7F, .u = 0.1F, .v = 0.9F};
    EXPECT_EQ(polygon, (Polygon{.vertices = {expected, expected, expected}, .texture = 2, .light = 0.3F}));
}

TEST(Snap, NothingOfASolidsCornersIsKeptBeside) {
    Polygon polygon{.vertices = {{.x = 1.3F}, {.x = 2.6F}, {.x = 3.5F}}};
    polygon.unrounded.corners = {{1.3, 0}, {2.6, 0}, {3.5, 0}};
    EXPECT_TRUE(snapped(polygon, 0).unrounded.corners.empty());
}

}  // namespace
}  // namespace texelscope
