// What the fast rasterizer asks where double is in doubt.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/exact/triangle.h"
#include "core/fast/canvas.h"
#include "core/fast/wide_triangle.h"

namespace texelscope {

/// The first pixel of row `row` at or right of the line through a and b: ceil(x(row + 1/2) - 1/2), by 128-bit division.
/// Requires that double holds all coordinates, and the row, as multiples of one unit (setup-inl.h), and a.y != b.y. All
/// absolute.
[[nodiscard]] int first_pixel(const Vertex& a, const Vertex& b, int row);

/// The place in the texture of a texel before wrapping.
[[nodiscard]] std::uint32_t place_of(const RasterTexture& texture, const TexelIndex& texel);

/// One triangle, decided in whole numbers: of 128 bits if they do, of any size if not. They are made only if somebody
/// asks.
class Decider {
public:
    Decider(const Canvas& canvas, int triangle) : canvas_(&canvas), triangle_(triangle) {}

    /// The texel's place in the texture, and z, of the pixel (x, y) of the target.
    [[nodiscard]] std::uint32_t texel(int x, int y);
    [[nodiscard]] float depth(int x, int y);
    [[nodiscard]] const ExactTriangle& exact();
    /// Where ties are so many that deciding each of them would cost more than the triangle.
    [[nodiscard]] WideTriangle::Gaps gaps();

private:
    [[nodiscard]] std::array<Vertex, 3> corners() const;
    [[nodiscard]] const std::optional<WideTriangle>& wide();

    const Canvas* canvas_;
    int triangle_;
    bool looked_ = false;  ///< whether `wide_` can be made
    std::optional<WideTriangle> wide_;
    std::optional<ExactTriangle> exact_;
};

}  // namespace texelscope
