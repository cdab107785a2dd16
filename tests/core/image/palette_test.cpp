#include "core/image/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

namespace texelscope {
namespace {

Image noise(int width, int height, unsigned seed, int levels = 256) {
    std::mt19937 random(seed);
    Image image(width, height);
    const auto channel = [&] { return static_cast<std::uint8_t>(random() % static_cast<unsigned>(levels)); };
    for (std::size_t i = 0; i < image.size(); ++i) {
        const std::uint8_t r = channel(), g = channel(), b = channel();
        image.data()[i] = {r, g, b};
    }
    return image;
}

Image painted(const Paletted& paletted) {
    Image image(paletted.indices.width(), paletted.indices.height());
    for (std::size_t i = 0; i < image.size(); ++i) image.data()[i] = paletted.palette[paletted.indices.data()[i]];
    return image;
}

TEST(Palette, HasAtMostTheColoursAskedFor) {
    for (const int colours : {1, 2, 3, 16, 255, 256}) {
        const Paletted paletted = reduce_to_palette(noise(40, 30, 1), colours);
        EXPECT_LE(paletted.palette.size(), static_cast<std::size_t>(colours));
        for (std::size_t i = 0; i < paletted.indices.size(); ++i)
            ASSERT_LT(paletted.indices.data()[i], paletted.palette.size());
    }
}

TEST(Palette, ReducingTwiceChangesNothing) {
    for (const int colours : {1, 2, 7, 64, 256}) {
        const Paletted once = reduce_to_palette(noise(64, 64, 2), colours);
        const Paletted twice = reduce_to_palette(painted(once), colours);
        EXPECT_EQ(painted(twice), painted(once));
        EXPECT_EQ(twice.palette, once.palette);
        EXPECT_EQ(twice.indices, once.indices);
    }
}

TEST(Palette, KeepsAnImageOfFewColours) {
    const Image image = noise(50, 50, 3, 6);  // 216 colours
    EXPECT_EQ(painted(reduce_to_palette(image, 256)), image);
}

TEST(Palette, LargeAndSmallImagesOfTheSameColoursAgree) {
    const Image small = make_pattern(Pattern::address, 256, 64, 5);
    Image large(256, 64 * 64);  // beyond the size at which the colours are counted in a table
    for (int row = 0; row < large.height(); ++row)
        for (int column = 0; column < 256; ++column) large.at(column, row) = small.at(column, row % 64);
    EXPECT_EQ(reduce_to_palette(large, 64).palette, reduce_to_palette(small, 64).palette);
}

TEST(Palette, ColoursStayNear) {
    const Image image = make_pattern(Pattern::uv, 256, 256, 0);
    const Image reduced = painted(reduce_to_palette(image, 256));
    for (std::size_t i = 0; i < image.size(); ++i) {
        ASSERT_LE(std::abs(image.data()[i].r - reduced.data()[i].r), 16);
        ASSERT_LE(std::abs(image.data()[i].g - reduced.data()[i].g), 16);
    }
}

TEST(Palette, TextureTexelsAreThePaletteOfTheIndices) {
    Texture texture;
    texture.name = "t";
    texture.texels = noise(9, 7, 4);
    const Texture reduced = with_palette(texture, 16);
    EXPECT_EQ(reduced.source.palette, 16);
    EXPECT_EQ(reduced.name, "t");
    EXPECT_EQ(painted({reduced.palette, reduced.indices}), reduced.texels);
    EXPECT_EQ(with_palette(reduced, 16), reduced);
}

}  // namespace
}  // namespace texelscope
