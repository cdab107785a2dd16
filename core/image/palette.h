// Reduction of an image to few colours.
// Source: Heckbert 1982, "Color image quantization for frame buffer display" (median cut).
#pragma once

#include <cstdint>
#include <vector>

#include "core/image/texture.h"

namespace texelscope {

struct Paletted {
    std::vector<Rgb> palette;    ///< ascending by r, g, b, no two equal
    Grid<std::uint8_t> indices;  ///< the palette entry of each pixel
};

/// The image in at most `colours` colours [1, 256]. Deterministic; an image that has no more colours than that keeps
/// them all, so a second reduction changes nothing.
[[nodiscard]] Paletted reduce_to_palette(const Image& image, int colours);

/// The texture with palette, indices, and texels = palette[index].
[[nodiscard]] Texture with_palette(Texture texture, int colours);

}  // namespace texelscope
