// Which of its ways the fast rasterizer takes to each pixel's texel: for people to see, by asking the rasterizer itself
// while it draws.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/rect.h"
#include "core/fast/raster.h"
#include "core/image/image.h"

namespace texelscope {

enum class Decision : std::uint8_t {
    none,         ///< the triangle does not own the pixel
    certificate,  ///< value and bound: no border of texels is that near
    tie,          ///< u or v is a whole number: moved by half the gap that all other samples keep from the borders
    in_double,    ///< decided again in double
    wide,         ///< in whole numbers of 128 bits
    exact,        ///< in whole numbers of any size
};
inline constexpr std::size_t kDecisions = 6;

/// Of one triangle.
struct Decisions {
    Rect frame;
    Grid<Decision> pixels;  ///< top left at the frame's
    std::array<std::uint64_t, kDecisions> count{};
    /// Bounds of what the cheap values of u and v may be off, over the triangle [texels]; 0 where it has none: it is
    /// refused, drawn exactly from the beginning, or in perspective, where each row has its own.
    double u_bound = 0, v_bound = 0;
    bool slow = false;  ///< double does not hold the corners' differences: whole numbers decided from the beginning

    [[nodiscard]] std::uint64_t of(Decision d) const { return count[static_cast<std::size_t>(d)]; }
};

/// @param texture  its size and wrap mode; texels are not looked at, u and v count in them.
[[nodiscard]] Decisions who_decided(std::span<const Vertex, 3> corners, const RasterTexture& texture,
                                    const Rect& frame);

}  // namespace texelscope
