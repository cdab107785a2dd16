#include "core/image/load.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <random>
#include <string>

#include "core/base/file.h"
#include "core/image/patterns.h"

namespace texelscope {
namespace {

std::vector<std::uint8_t> png_of(int width, int height) {
    return *encode_png(make_pattern(Pattern::address, width, height, 3));
}

/// Overwrites the size that the header of a PNG tells.
std::vector<std::uint8_t> resized(std::vector<std::uint8_t> png, std::uint32_t width, std::uint32_t height) {
    for (int i = 0; i < 4; ++i) {
        png[static_cast<std::size_t>(16 + i)] = static_cast<std::uint8_t>(width >> (24 - 8 * i) & 255);
        png[static_cast<std::size_t>(20 + i)] = static_cast<std::uint8_t>(height >> (24 - 8 * i) & 255);
    }
    return png;
}

TEST(LoadImage, PngRoundTripKeepsEveryPixel) {
    for (const int width : {1, 2, 63, 300})
        for (const int height : {1, 5, 270})
            EXPECT_EQ(*decode_image(png_of(width, height), "a.png"), make_pattern(Pattern::address, width, height, 3));
}

TEST(LoadImage, AlphaIsDropped) {
    const std::string header("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x20\x28", 18);  // TGA, 1 x 1, 32 bits
    const std::string tga = header + std::string("\x0a\x14\x1e\x00", 4);
    EXPECT_EQ(decode_image(bytes_of(tga), "a.tga")->at(0, 0), (Rgb{30, 20, 10}));
}

TEST(LoadImage, TruncatedOrDamagedFileIsAnErrorOrAnImage) {
    const std::vector<std::uint8_t> png = png_of(40, 30);
    for (std::size_t size = 0; size < png.size(); ++size) {
        const Result<Image> image = decode_image({png.data(), size}, "cut.png");
        if (!image) {
            EXPECT_EQ(image.error().where, "cut.png");
        }
    }
    std::mt19937 random(1);
    for (int i = 0; i < 500; ++i) {
        std::vector<std::uint8_t> damaged = png;
        for (int k = 0; k < 4; ++k) damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
        const Result<Image> image = decode_image(damaged, "damaged.png");
        if (image) {
            EXPECT_LE(image->width(), kMaxSize);
        }
    }
}

TEST(LoadImage, SizesOutOfBoundsAreErrors) {
    const std::vector<std::uint8_t> png = png_of(4, 4);
    for (const auto& size : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
             {16385, 1}, {1, 16385}, {0, 4}, {0x7fffffff, 0x7fffffff}, {0xffffffff, 4}, {16384, 16384}, {8192, 8192}}) {
        const Result<Image> image = decode_image(resized(png, size.first, size.second), "big.png");
        ASSERT_FALSE(image) << size.first << " x " << size.second;
        EXPECT_EQ(image.error().text().find('\n'), std::string::npos);
    }
}

TEST(LoadImage, TextIsNotAnImage) {
    EXPECT_NE(decode_image(bytes_of("hello, this is a text"), "a.txt").error().text().find("a.txt: is not an image"),
              std::string::npos);
    EXPECT_FALSE(decode_image({}, "empty"));
}

TEST(LoadImage, ReadsAFileAndNamesTheOneItCannot) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("texelscope-load-test-" + std::to_string(::getpid()) + ".png");
    ASSERT_FALSE(write_file_atomically(path, png_of(3, 3)));
    EXPECT_EQ(*load_image(path), make_pattern(Pattern::address, 3, 3, 3));
    std::filesystem::remove(path);
    EXPECT_EQ(load_image(path).error().where, path.string());
    EXPECT_FALSE(load_image("/dev/zero"));
    EXPECT_FALSE(load_image("/"));
}

TEST(EncodePng, EmptyImageIsAnError) { EXPECT_FALSE(encode_png(Image{})); }

}  // namespace
}  // namespace texelscope
