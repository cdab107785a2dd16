// Textures made by a rule, so that a scene needs no files and a texel tells where it came from.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/image/image.h"

namespace texelscope {

enum class Pattern : std::uint8_t {
    address,  ///< r = column & 255, g = row & 255, b = the mark
    checker,  ///< dark and light squares of 8 x 8 texels
    uv,       ///< red grows from 0 to 255 along the columns, green along the rows
    solid,    ///< one mid-grey
};

inline constexpr Rgb kSolid{128, 128, 128};

/// As a scene spells them, in the order of Pattern.
inline constexpr std::array<std::string_view, 4> kPatternNames{"address", "checker", "uv", "solid"};

/// Requires width, height >= 1.
/// @param mark  the blue of `address`: tells the textures of a scene apart.
[[nodiscard]] Image make_pattern(Pattern pattern, int width, int height, std::uint8_t mark);

/// The mark of the texture at `index` in its scene: 1, 2, ...; texel (0, 0) so differs from a black background.
[[nodiscard]] constexpr std::uint8_t address_mark(int index) { return static_cast<std::uint8_t>((index + 1) & 255); }

}  // namespace texelscope
