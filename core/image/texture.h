// A texture: an image and the rule for texel indices outside it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/image/patterns.h"
#include "core/image/wrap.h"

namespace texelscope {

/// What a texture was made from, so that a scene can be written back.
struct TextureSource {
    std::string file;                  ///< as the scene spells it, relative to the scene; empty for a pattern
    int frames = 0;                    ///< how many equal frames `file` is a strip of; 0 = it is one picture
    Pattern pattern = Pattern::solid;  ///< where `file` is empty
    int palette = 0;                   ///< the colours asked for [2, 256]; 0 = true colour
    friend bool operator==(const TextureSource&, const TextureSource&) = default;
};

struct Texture {
    std::string name;
    Image texels;
    Wrap wrap = Wrap::repeat;
    std::vector<Rgb> palette;    ///< the colours that `indices` refers to; empty for a true-colour texture
    Grid<std::uint8_t> indices;  ///< palette index of each texel; empty for a true-colour texture
    TextureSource source;

    [[nodiscard]] int width() const { return texels.width(); }
    [[nodiscard]] int height() const { return texels.height(); }
    friend bool operator==(const Texture&, const Texture&) = default;
};

}  // namespace texelscope
