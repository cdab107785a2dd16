// Who decided each texel: what the fast rasterizer tells somebody who wants to see it, at the places where it leaves
// its cheap arithmetic. Nothing is told, and nothing computed, unless somebody asks.
#pragma once

#include <cstdint>

#include "core/fast/canvas.h"

namespace texelscope {

enum class DecidedBy : std::uint8_t {
    certificate,  ///< the cheap value and its bound: the texel's border lies outside
    in_double,    ///< double, with its own bound
    wide,         ///< whole numbers of 128 bits
    exact,        ///< whole numbers of any size
};

/// Of one drawing, a triangle or a few.
struct RasterWatch {
    std::uint8_t* deciders = nullptr;  ///< a DecidedBy for each pixel, as the target's pixels lie; set to 0 beforehand
    /// Of the last triangle that was set up: bound of what int32 steps along a row may be off [texels]. Of triangles in
    /// perspective this is not the bound: each row has its own there.
    double u_doubt = 0, v_doubt = 0;
    /// Double could not tell some texel, so that from there on values were moved by half of the gap between a border
    /// and any sample not on it: ties are then decided without being asked about.
    bool by_gap = false;
};

/// The target's pixel (x, y) was decided again.
inline void watch(const Canvas& canvas, int x, int y, DecidedBy by) {
    const RasterWatch* const told = canvas.settings->watch;
    if (told != nullptr) told->deciders[y * canvas.target.pitch + x] = static_cast<std::uint8_t>(by);
}

}  // namespace texelscope
