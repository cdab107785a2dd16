#include "core/image/frames.h"

#include <gtest/gtest.h>

#include "core/image/patterns.h"

namespace texelscope {
namespace {

TEST(Frames, PutTogetherAreTheStrip) {
    for (const auto& [width, height, count] : {std::array{4, 12, 3}, std::array{12, 4, 3}, std::array{8, 8, 4}}) {
        const Image strip = make_pattern(Pattern::address, width, height, 1);
        const auto frames = cut_frames(strip, count);
        ASSERT_TRUE(frames);
        ASSERT_EQ(frames->size(), static_cast<std::size_t>(count));
        const bool sideways = (*frames)[0].height() == height;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const int columns = (*frames)[0].width(), rows = (*frames)[0].height();
                const auto& frame = (*frames)[static_cast<std::size_t>(sideways ? x / columns : y / rows)];
                EXPECT_EQ(frame.at(x % columns, y % rows), strip.at(x, y));
            }
        }
    }
}

TEST(Frames, AreCutWhereTheyComeNearestToSquares) {
    const auto size = [](int width, int height, int count) {
        const auto frames = cut_frames(Image(width, height), count);
        return frames ? std::pair((*frames)[0].width(), (*frames)[0].height()) : std::pair(0, 0);
    };
    EXPECT_EQ(size(32, 320, 10), std::pair(32, 32));
    EXPECT_EQ(size(320, 32, 10), std::pair(32, 32));
    EXPECT_EQ(size(320, 40, 10), std::pair(32, 40));
    EXPECT_EQ(size(33, 30, 10), std::pair(33, 3));  // the only way
    EXPECT_EQ(size(64, 64, 4), std::pair(64, 16));  // either: one below the other
    EXPECT_EQ(size(7, 5, 1), std::pair(7, 5));
}

TEST(Frames, UnequalOnesAreAnError) {
    EXPECT_EQ(cut_frames(Image(33, 31), 10).error().what, "is 33 x 31, expected a side of 10 equal frames");
}

}  // namespace
}  // namespace texelscope
