// What a sample leaves in the framebuffer: its colour, or of a half-transparent polygon its half and half of what
// stood there. Shifted first, so that no sum needs a ninth bit, as on machines of 1995.
// Source: S2 (jelly cubes).
#pragma once

#include <cstdint>

#include "core/image/image.h"

namespace texelscope {

/// (a >> 1) + (b >> 1), at most 254: below the mean by a half where one of them is odd, by 1 where both are.
[[nodiscard]] constexpr std::uint8_t half_of_each(std::uint8_t a, std::uint8_t b) noexcept {
    return static_cast<std::uint8_t>((a >> 1) + (b >> 1));
}

/// The pixel after the sample.
[[nodiscard]] constexpr Rgb blended(const Rgb& before, const Rgb& sample, bool half) noexcept {
    if (!half) return sample;
    return {half_of_each(before.r, sample.r), half_of_each(before.g, sample.g), half_of_each(before.b, sample.b)};
}

}  // namespace texelscope
