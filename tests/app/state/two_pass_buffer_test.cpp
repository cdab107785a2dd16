#include "core/method/two_pass_buffer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/app/state/sampling_fixture.h"

namespace texelscope {
namespace {

[[nodiscard]] TwoPassBuffer buffer(double degrees, int height = 64, std::string_view variant = "corrected") {
    const DrawnScene drawn(turned_scene(64, height, degrees, 1), "two-pass", variant);
    return two_pass_buffer(NumberFormat::f64, drawn.drawing->job(0));
}

/// Columns of tmp that hold one of the 64 texels of row `v`.
[[nodiscard]] int columns_in(const TwoPassBuffer& tmp, Integer v) {
    int columns = 0;
    for (Integer x = tmp.x0; x < tmp.x1; ++x) {
        const Integer u = tmp.at(x, v);
        columns += u >= 0 && u < 64;
    }
    return columns;
}

TEST(TwoPassBuffer, ItsWidthIs32Of64At60DegreesAnd16At75AndNoneAt90) {
    EXPECT_NEAR(buffer(0).width, 64, 1e-5);
    EXPECT_NEAR(buffer(60).width, 32, 1e-4);
    EXPECT_NEAR(buffer(75).width, 16.6, .05);
    EXPECT_NEAR(buffer(90).width, 0, 1e-4);
    EXPECT_EQ(buffer(60).texels, 64);
}

TEST(TwoPassBuffer, HoldsAsManyColumnsOfARowAsItSays) {
    for (const double degrees : {0.0, 10.0, 45.0, 60.0, 75.0, -60.0, 120.0}) {
        const TwoPassBuffer tmp = buffer(degrees);
        EXPECT_NEAR(columns_in(tmp, 32), tmp.width, 1) << degrees;
    }
    EXPECT_EQ(columns_in(buffer(60), 32), 32);
}

TEST(TwoPassBuffer, DoesNotDependOnHowHighTheTextureIs) { EXPECT_NEAR(buffer(60, 16).width, 32, 1e-4); }

TEST(TwoPassBuffer, AsPrintedItIsFilledByWritingSoThatMagnifyingLeavesGaps) {
    const DrawnScene drawn(turned_scene(32, 32, 0, 2), "two-pass", "as-printed");
    const TwoPassBuffer tmp = two_pass_buffer(NumberFormat::f64, drawn.drawing->job(0));
    EXPECT_NEAR(tmp.width, 64, 1e-4);
    int filled = 0;
    for (Integer x = tmp.x0; x < tmp.x1; ++x) filled += tmp.at(x, 10) != TwoPassBuffer::kNone;
    EXPECT_EQ(filled, 32);
}

TEST(TwoPassBuffer, EveryTexelOfTheImageComesFromIt) {
    const DrawnScene drawn(turned_scene(64, 64, 33, 1), "two-pass");
    const TwoPassBuffer tmp = two_pass_buffer(NumberFormat::f64, drawn.drawing->job(0));
    int compared = 0;
    each_sample(*drawn.drawing, 0, 1, {drawn.scene->framebuffer.rect(), 1}, [&](int, const Sample& s) {
        if (s.fate != Fate::written) return;
        const auto v = static_cast<Integer>(std::floor(s.v));
        EXPECT_EQ(tmp.at(s.x, v), static_cast<Integer>(std::floor(s.u))) << s.x << ' ' << s.y;
        ++compared;
    });
    EXPECT_GT(compared, 4000);
}

TEST(TwoPassBuffer, OfAFlatShapeIsEmpty) {
    Scene scene = turned_scene(64, 64, 0, 1);
    for (Vertex& v : scene.polygons[0].vertices) v.y = 60;
    const DrawnScene drawn(std::move(scene), "two-pass");
    EXPECT_TRUE(two_pass_buffer(NumberFormat::f64, drawn.drawing->job(0)).empty());
}

}  // namespace
}  // namespace texelscope
