#include "app/state/lockstep.h"

#include <gtest/gtest.h>

#include "tests/app/state/sampling_fixture.h"

namespace texelscope {
namespace {

[[nodiscard]] Lockstep lockstep(DrawnScene& drawn, std::string_view step) {
    return make_lockstep(*drawn.drawing, *drawn.steps, parse_path(step).value());
}

struct Written {
    int forward = 0, backward = 0;
};
[[nodiscard]] Written so_far(const Lockstep& l) {
    Written sum;
    for (std::size_t n = 0; n < l.cells.size(); ++n)
        sum.forward += l.cells.data()[n].writes > 0, sum.backward += l.cells.data()[n].drawn;
    return sum;
}

TEST(Lockstep, ForwardAtOneAndAHalfLeaves5120Of9216PixelsEmpty) {
    DrawnScene drawn(turned_scene(64, 64, 0, 1.5), "forward");
    const Lockstep l = lockstep(drawn, "t0");
    EXPECT_EQ(l.inside, 9216);
    EXPECT_EQ(l.holes, 5120);
    EXPECT_NEAR(100.0 * static_cast<double>(l.holes) / static_cast<double>(l.inside), 55.6, .05);
    EXPECT_EQ(l.again, 0);
    EXPECT_EQ(l.outside, 0);
}

TEST(Lockstep, ForwardAt30DegreesLeaves552PixelsEmptyAndWrites512MoreThanOnce) {
    DrawnScene drawn(turned_scene(64, 64, 30, 1), "forward");
    const Lockstep l = lockstep(drawn, "t0");
    EXPECT_EQ(l.inside, 4096);
    EXPECT_EQ(l.holes, 552);
    EXPECT_NEAR(100.0 * static_cast<double>(l.holes) / static_cast<double>(l.inside), 13.5, .05);
    EXPECT_EQ(l.again, 512);
}

TEST(Lockstep, BackwardDrawsEachPixelOfTheShapeOnce) {
    for (const double degrees : {0.0, 30.0, 45.0, 77.0}) {
        DrawnScene drawn(turned_scene(64, 64, degrees, 1), "backward-affine");
        const Lockstep l = lockstep(drawn, "t0");
        EXPECT_GT(l.inside, 4000) << degrees;
        EXPECT_EQ(l.backward_again, 0) << degrees;
        EXPECT_EQ(so_far(l).backward, l.inside) << degrees;
    }
}

TEST(Lockstep, FiguresAreTheSameWhicheverWayDrives) {
    DrawnScene forward(turned_scene(32, 32, 20, 1.2), "forward"),
        backward(turned_scene(32, 32, 20, 1.2), "backward-projective");
    const Lockstep a = lockstep(forward, "t0"), b = lockstep(backward, "t0");
    EXPECT_EQ(a.inside, b.inside);
    EXPECT_EQ(a.holes, b.holes);
    EXPECT_EQ(a.again, b.again);
    EXPECT_EQ(so_far(a).forward, so_far(b).forward);
}

TEST(Lockstep, BothWaysHaveDoneAsManyRowsAndColumns) {
    DrawnScene drawn(turned_scene(64, 64, 0, 1.5), "forward");
    const Lockstep none = lockstep(drawn, "t0/s1"), rows = lockstep(drawn, "t0/s2/v8"),
                   part = lockstep(drawn, "t0/s2/v8/u9");
    EXPECT_FALSE(none.begun);
    EXPECT_EQ(so_far(none).forward + so_far(none).backward, 0);
    EXPECT_EQ(rows.rows, 9);
    EXPECT_EQ(so_far(rows).forward, 9 * 64);
    EXPECT_EQ(so_far(rows).backward, 9 * 96);
    EXPECT_EQ(so_far(part).forward, 8 * 64 + 10);
    EXPECT_EQ(so_far(part).backward, 8 * 96 + 10);
    EXPECT_EQ(part.forward_rows, 64);
    EXPECT_EQ(part.backward_rows, 96);
    EXPECT_TRUE(lockstep(drawn, "t0/s2").done);
}

TEST(Lockstep, TheShorterLoopIsDoneWhileTheLongerGoesOn) {
    DrawnScene drawn(turned_scene(64, 64, 0, 1.5), "backward-affine");
    const Lockstep l = lockstep(drawn, "t0/s2/y92");
    EXPECT_EQ(so_far(l).forward, 4096);
    EXPECT_EQ(so_far(l).backward, 81 * 96);
    EXPECT_FALSE(l.done);
}

TEST(Lockstep, HolesAreThePixelsThatItCounts) {
    DrawnScene drawn(turned_scene(64, 64, 30, 1), "forward");
    const Grid<std::uint8_t> holes = holes_of(*drawn.drawing, 0);
    EXPECT_EQ(std::count(holes.data(), holes.data() + holes.size(), 1), lockstep(drawn, "t0").holes);
}

TEST(Lockstep, OfOtherMethodsThereIsNone) {
    DrawnScene drawn(turned_scene(16, 16, 0, 1), "two-pass");
    EXPECT_TRUE(lockstep(drawn, "t0").rect.empty());
}

}  // namespace
}  // namespace texelscope
