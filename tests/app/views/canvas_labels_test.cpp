#include "app/views/canvas_labels.h"

#include <random>

#include <gtest/gtest.h>

namespace texelscope::canvas {
namespace {

constexpr ui::Area kBounds{10, 20, 300, 200};

TEST(CanvasLabels, NoneOverlapsAnotherOrLeavesTheBounds) {
    std::mt19937 random(7);
    const auto number = [&](int low, int high) {
        return static_cast<float>(low + static_cast<int>(random() % static_cast<unsigned>(high - low)));
    };
    LabelPlaces places(kBounds);
    std::vector<ui::Area> placed;
    for (int n = 0; n < 200; ++n) {
        const glm::vec2 anchor{number(-50, 400), number(-50, 300)}, size{number(10, 90), number(10, 30)};
        const auto place = places.place(anchor, size, {number(-9, 9), number(-9, 9)}, 8);
        if (!place) continue;
        EXPECT_TRUE(kBounds.covers(*place));
        for (const ui::Area& other : placed) EXPECT_TRUE(ui::intersection(*place, other).empty());
        placed.push_back(*place);
    }
    EXPECT_GT(placed.size(), 10U);
}

TEST(CanvasLabels, TheWantedDirectionIsTakenWhereItIsFree) {
    LabelPlaces places(kBounds);
    const auto right = places.place({100, 100}, {40, 20}, {1, 0}, 10);
    ASSERT_TRUE(right);
    EXPECT_EQ(right->x, 110);
    EXPECT_EQ(right->centre().y, 100);
}

TEST(CanvasLabels, BlockedGroundIsAvoided) {
    LabelPlaces places(kBounds);
    places.block({105, 80, 60, 40});
    const auto place = places.place({100, 100}, {40, 20}, {1, 0}, 10);
    ASSERT_TRUE(place);
    EXPECT_TRUE(ui::intersection(*place, {105, 80, 60, 40}).empty());
}

TEST(CanvasLabels, NothingIsPlacedWhereAllIsFull) {
    LabelPlaces places(kBounds);
    places.block(kBounds);
    EXPECT_FALSE(places.place({100, 100}, {10, 10}, {0, 1}, 4));
    EXPECT_FALSE(LabelPlaces(kBounds).place({100, 100}, {400, 10}, {0, 1}, 4));
}

}  // namespace
}  // namespace texelscope::canvas
