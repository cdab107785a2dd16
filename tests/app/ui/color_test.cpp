#include "app/ui/color.h"

#include <gtest/gtest.h>

namespace texelscope::ui {
namespace {

TEST(Color, HexKeepsTheOrderOfChannels) {
    EXPECT_EQ(hex(0x123456) & 0xFFU, 0x12U);
    EXPECT_EQ((hex(0x123456) >> 16U) & 0xFFU, 0x56U);
    EXPECT_EQ(hex(0x123456) >> 24U, 0xFFU);
}

TEST(Color, OverIsTheGroundAtZeroAndTheColorAtOne) {
    EXPECT_EQ(over(hex(0xBFFFD9), 0, hex(0x191C21)), hex(0x191C21));
    EXPECT_EQ(over(hex(0xBFFFD9), 1, hex(0x191C21)), hex(0xBFFFD9));
}

TEST(Color, ContrastIsSymmetricAndReaches21) {
    EXPECT_NEAR(contrast(hex(0x000000), hex(0xFFFFFF)), 21, 1e-9);
    EXPECT_DOUBLE_EQ(contrast(hex(0x9DA6B1), hex(0x191C21)), contrast(hex(0x191C21), hex(0x9DA6B1)));
    EXPECT_DOUBLE_EQ(contrast(hex(0x9DA6B1), hex(0x9DA6B1)), 1);
}

// Pairs 1, 7, 17, 21 and 25 of the data published with Sharma, Wu and Dalal 2005.
TEST(Color, DifferenceAgreesWithThePublishedPairs) {
    struct Pair {
        Lab x, y;
        double expected;
    };
    const Pair pairs[] = {
        {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
        {{50, 0, 0}, {50, -1, 2}, 2.3669},
        {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
        {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0},
        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    };
    for (const Pair& p : pairs) {
        EXPECT_NEAR(difference(p.x, p.y), p.expected, 1e-4);
        EXPECT_NEAR(difference(p.y, p.x), p.expected, 1e-4);
    }
}

TEST(Color, GreysLookAlikeToEverySight) {
    for (const Sight sight : kSights) {
        const Lab lab = seen(hex(0x808080), sight);
        EXPECT_NEAR(lab.a, 0, 0.2);
        EXPECT_NEAR(lab.b, 0, 0.2);
    }
}

}  // namespace
}  // namespace texelscope::ui
