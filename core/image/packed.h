// Pixels of 32 bits, red in the lowest byte and opaque: what core/fast draws with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/image/image.h"

namespace texelscope {

[[nodiscard]] constexpr std::uint32_t packed(const Rgb& c) noexcept {
    return c.r | std::uint32_t{c.g} << 8 | std::uint32_t{c.b} << 16 | 0xFF000000U;
}
[[nodiscard]] constexpr Rgb unpacked(std::uint32_t pixel) noexcept {
    const auto byte = [=](unsigned shift) { return static_cast<std::uint8_t>(pixel >> shift & 255U); };
    return {byte(0), byte(8), byte(16)};
}

/// @param pitch  from one row to the next [px], at least the width.
[[nodiscard]] inline std::vector<std::uint32_t> packed(const Image& image, int pitch) {
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(pitch) * static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            pixels[static_cast<std::size_t>(std::ptrdiff_t{y} * pitch + x)] = packed(image.at(x, y));
    return pixels;
}

/// @param pitch  from one row of `pixels` to the next [px].
[[nodiscard]] inline Image unpacked(const std::uint32_t* pixels, std::ptrdiff_t pitch, int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = unpacked(pixels[y * pitch + x]);
    return image;
}

}  // namespace texelscope
