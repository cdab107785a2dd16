// What a texel index outside the texture means.
#pragma once

#include <algorithm>
#include <cstdint>

namespace texelscope {

enum class Wrap : std::uint8_t {
    repeat,  ///< Euclidean modulo, any size
    mask,    ///< index & (size - 1): what the sources do; equals repeat for powers of two
    clamp,   ///< the nearest texel inside
};

/// index - size * floor(index / size), in [0, size). Requires size >= 1.
[[nodiscard]] constexpr std::int64_t euclidean_modulo(std::int64_t index, std::int64_t size) noexcept {
    if ((size & (size - 1)) == 0) return index & (size - 1);  // a division costs as much as the rest of a pixel
    const std::int64_t rest = index % size;
    return rest < 0 ? rest + size : rest;
}

/// The texel index inside [0, size). Requires size >= 1. 64 bits: u may lie far outside the texture.
[[nodiscard]] constexpr int wrap_index(std::int64_t index, int size, Wrap wrap) noexcept {
    switch (wrap) {
        case Wrap::mask: return static_cast<int>(index & (size - 1));
        case Wrap::clamp: return static_cast<int>(std::clamp<std::int64_t>(index, 0, size - 1));
        case Wrap::repeat: break;
    }
    return static_cast<int>(euclidean_modulo(index, size));
}

}  // namespace texelscope
