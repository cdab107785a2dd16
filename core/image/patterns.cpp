#include "core/image/patterns.h"

namespace texelscope {
namespace {

constexpr int kSquare = 8;  // [texels]
constexpr Rgb kDark{48, 56, 72}, kLight{232, 228, 216};

/// 0 for the first of `count` steps, 255 for the last.
std::uint8_t ramp(int step, int count) { return static_cast<std::uint8_t>(count > 1 ? step * 255 / (count - 1) : 0); }

Rgb texel(Pattern pattern, int column, int row, const Image& image, std::uint8_t mark) {
    switch (pattern) {
        case Pattern::address:
            return {static_cast<std::uint8_t>(column & 255), static_cast<std::uint8_t>(row & 255), mark};
        case Pattern::checker: return (column / kSquare + row / kSquare) % 2 == 0 ? kLight : kDark;
        case Pattern::uv: return {ramp(column, image.width()), ramp(row, image.height()), 0};
        case Pattern::solid: break;
    }
    return kSolid;
}

}  // namespace

Image make_pattern(Pattern pattern, int width, int height, std::uint8_t mark) {
    Image image(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) image.at(column, row) = texel(pattern, column, row, image, mark);
    return image;
}

}  // namespace texelscope
