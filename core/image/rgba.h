// A colour with its coverage.
#pragma once

#include <cstdint>

namespace texelscope {

/// Straight (not premultiplied) alpha: 0 shows what is behind, 255 hides it.
struct Rgba {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    friend constexpr bool operator==(const Rgba&, const Rgba&) = default;
};

}  // namespace texelscope
