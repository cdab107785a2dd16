#include "core/measure/timing.h"

#include <gtest/gtest.h>

namespace texelscope {
namespace {

TEST(Timing, HasTheLeastAndTheMedian) {
    const Timing odd = timing_of({5, 1, 9}), even = timing_of({8, 2, 4, 100}), one = timing_of({3});
    EXPECT_EQ(odd.median_ms, 5);
    EXPECT_EQ(odd.least_ms, 1);
    EXPECT_EQ(even.median_ms, 6);
    EXPECT_EQ(even.least_ms, 2);
    EXPECT_EQ(one.median_ms, 3);
    EXPECT_EQ(one.least_ms, 3);
}

TEST(Timing, IsPrintedWithItsRatesByTheMedian) {
    const TimedWork work{.method = "fast", .name = "big", .threads = 2, .samples = 8'000'000, .triangles = 400};
    EXPECT_EQ(timing_line(work, {.median_ms = 4, .least_ms = 3.5}), "fast,t2,big,4.0000,3.5000,2000.00,0.100");
}

TEST(Timing, OfNothingHasNoRates) {
    EXPECT_EQ(timing_line({.method = "fast", .name = "none"}, {}), "fast,t1,none,0.0000,0.0000,0.00,0.000");
}

}  // namespace
}  // namespace texelscope
