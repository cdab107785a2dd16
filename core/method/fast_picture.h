// Pictures by the production rasterizer (core/fast/raster.h) in place of a method that draws the same. Its pixels are
// first the addresses of their texels, then looked up: so one table of addresses serves every texture in every light.
#pragma once

#include "core/image/image.h"
#include "core/method/method.h"

namespace texelscope {

class Drawing;
struct DrawSettings;

/// Whether the rasterizer may draw the picture. Only of
/// - exact numbers: the errors of all other formats belong to what they draw;
/// - corrected methods over which a triangle's corners define everything: the samples by the top-left rule, and u and v
///   affine over the screen or in perspective. They draw the same texels as each other (tests/methods/equalities.py).
/// Not for a scene with a depth test, whose z is rounded otherwise than the rasterizer's.
[[nodiscard]] bool draws_the_same_as_fast(const DrawSettings& settings);
/// Whether it may draw this shape, which `refusal` accepts. It must be a triangle, too: other polygons need not be in
/// one plane. And the rasterizer masks only textures of powers of two, and its indices saturate sooner.
[[nodiscard]] bool draws_the_same_as_fast(const DrawSettings& settings, const Job& job);

/// As Method's `render` and `paint`, of a shape that draws_the_same_as_fast.
Fate render_fast(const DrawSettings& settings, const Job& job, Image& picture);
Fate paint_fast(const DrawSettings& settings, const Job& job, const Window& part, int shape, Layer& layer);

/// As draw_into(), of settings that draws_the_same_as_fast: shapes that do in batches, the others by their method.
void draw_fast(const Drawing& drawing, Image& picture);

}  // namespace texelscope
