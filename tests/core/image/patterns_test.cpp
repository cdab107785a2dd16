#include "core/image/patterns.h"

#include <gtest/gtest.h>

#include <set>

namespace texelscope {
namespace {

TEST(Patterns, AddressTellsColumnRowAndMark) {
    const Image image = make_pattern(Pattern::address, 300, 270, 7);
    for (int row = 0; row < 270; ++row)
        for (int column = 0; column < 300; ++column)
            ASSERT_EQ(image.at(column, row),
                      (Rgb{static_cast<std::uint8_t>(column % 256), static_cast<std::uint8_t>(row % 256), 7}));
}

TEST(Patterns, MarksOf256TexturesDiffer) {
    std::set<int> marks;
    for (int i = 0; i < 256; ++i) marks.insert(address_mark(i));
    EXPECT_EQ(marks.size(), 256u);
    EXPECT_EQ(address_mark(0), 1);
}

TEST(Patterns, CheckerSquaresAreEightTexels) {
    const Image image = make_pattern(Pattern::checker, 40, 24, 0);
    for (int row = 0; row < 24; ++row)
        for (int column = 0; column + 8 < 40; ++column) {
            ASSERT_NE(image.at(column, row), image.at(column + 8, row));
            ASSERT_EQ(image.at(column, row), image.at(column / 8 * 8, row));
        }
}

TEST(Patterns, UvRunsFromNothingToFull) {
    for (const int size : {2, 3, 17, 256, 1000}) {
        const Image image = make_pattern(Pattern::uv, size, size, 0);
        EXPECT_EQ(image.at(0, 0), (Rgb{0, 0, 0}));
        EXPECT_EQ(image.at(size - 1, size - 1), (Rgb{255, 255, 0}));
        for (int i = 1; i < size; ++i) ASSERT_LE(image.at(i - 1, 0).r, image.at(i, 0).r);
    }
}

TEST(Patterns, SolidIsOneColour) {
    const Image image = make_pattern(Pattern::solid, 5, 3, 9);
    for (std::size_t i = 0; i < image.size(); ++i) EXPECT_EQ(image.data()[i], kSolid);
}

TEST(Patterns, HaveTheSizeAskedFor) {
    for (const Pattern pattern : {Pattern::address, Pattern::checker, Pattern::uv, Pattern::solid}) {
        const Image image = make_pattern(pattern, 1, 3, 0);
        EXPECT_EQ(image.width(), 1);
        EXPECT_EQ(image.height(), 3);
    }
}

}  // namespace
}  // namespace texelscope
