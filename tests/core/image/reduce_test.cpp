#include "core/image/reduce.h"

#include <gtest/gtest.h>

#include <random>

namespace texelscope {
namespace {

TEST(Reduce, AFlatPictureStaysFlat) {
    for (const int width : {1, 2, 3, 8}) {
        for (const int height : {1, 2, 5}) {
            const Image small = reduced_by_2(Image(width, height, {7, 255, 0}));
            EXPECT_EQ(small, Image((width + 1) / 2, (height + 1) / 2, {7, 255, 0}));
        }
    }
}

TEST(Reduce, ASampleIsSpreadByWeights1331) {
    Image image(8, 8);
    image.at(3, 4) = {255, 0, 64};  // right of its pixel's centre by a quarter, and above it
    const Image small = reduced_by_2(image);
    EXPECT_EQ(small.at(1, 2), (Rgb{36, 0, 9}));  // 3 * 3 of 64
    EXPECT_EQ(small.at(2, 2), (Rgb{12, 0, 3}));
    EXPECT_EQ(small.at(1, 1), (Rgb{12, 0, 3}));
    EXPECT_EQ(small.at(2, 1), (Rgb{4, 0, 1}));
    EXPECT_EQ(small.at(3, 2), Rgb{});
    EXPECT_EQ(small.at(0, 2), Rgb{});
}

TEST(Reduce, MirroringCommutes) {
    std::mt19937 random(1);
    Image image(10, 6), mirrored(10, 6);
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 10; ++x) {
            image.at(x, y) = {static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                              static_cast<std::uint8_t>(random())};
            mirrored.at(9 - x, 5 - y) = image.at(x, y);
        }
    }
    const Image small = reduced_by_2(image), other = reduced_by_2(mirrored);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) EXPECT_EQ(small.at(x, y), other.at(4 - x, 2 - y));
    }
}

}  // namespace
}  // namespace texelscope
