// The rasterizer of the user interface: coloured, textured triangles over a picture, with no display and no GPU.
// The definition, which paint_test.cpp spells out pixel by pixel:
//   Position  snapped to 1/256 px, halves up. A triangle with a corner that is not finite or lies beyond
//             kPaintGuard draws nothing.
//   Coverage  core/conventions.h: pixel centres, the top-left rule, either winding. Integer edge functions.
//   Values    u, v [texel] and the colour are planes through the first corner, whose gradients are rounded to
//             2^-40 of a unit for 1/256 px; all later arithmetic is in integers, so every machine gives the same bytes.
//   Texel     the nearest one, those outside clamped to the border. Source colour = round(texel * colour / 255).
//   Blending  over: round((source * alpha + target * (255 - alpha)) / 255).
#pragma once

#include <cstdint>
#include <span>

#include "core/base/rect.h"
#include "core/image/image.h"
#include "core/image/rgba.h"

namespace texelscope {

inline constexpr float kPaintGuard = 1048576.0F;  ///< largest |x|, |y| that is drawn [px]: edges then fit 64 bits

struct PaintVertex {
    float x = 0, y = 0;      ///< [px]
    float u = 0, v = 0;      ///< 0 to 1 across the texture; NaN counts as 0
    std::uint32_t rgba = 0;  ///< red in the lowest byte, alpha in the highest
};

/// At most one of the two pointers is set; each points to width * height texels, row-major from the top left.
/// With neither, or with no texels, every texel is opaque white.
struct PaintTexture {
    int width = 0, height = 0;            ///< [texel]
    const std::uint8_t* alpha = nullptr;  ///< white of this alpha: a font
    const Rgba* rgba = nullptr;
};

/// Draws each three of `indices` as a triangle, in order, where `clip` allows it. A triangle with an index outside
/// `vertices` draws nothing, and so does an incomplete one at the end.
void paint(Grid<Rgba>& target, std::span<const PaintVertex> vertices, std::span<const std::uint16_t> indices,
           const PaintTexture& texture, const Rect& clip);
void paint(Image& target, std::span<const PaintVertex> vertices, std::span<const std::uint16_t> indices,
           const PaintTexture& texture, const Rect& clip);

}  // namespace texelscope
