// What a rung of the front draws of a scene, and which of its pixels are wrong.
#pragma once

#include <cstdint>
#include <string>

#include "core/image/image.h"
#include "core/measure/rungs.h"

namespace texelscope {

enum class PixelVerdict : std::uint8_t {
    empty,    ///< drawn neither by the rung nor by the definition
    right,    ///< the texel of the definition
    wrong,    ///< another texel
    missing,  ///< drawn by the definition only
    extra,    ///< drawn by the rung only
};

/// The picture in the end: what later triangles cover is not looked at.
struct RungPicture {
    Rect frame;
    Grid<PixelVerdict> pixels;  ///< top left at the frame's
    Integer right = 0, wrong = 0, missing = 0, extra = 0;
    std::size_t triangles = 0;  ///< of the scene's, that the rung draws
};
[[nodiscard]] RungPicture rung_picture(const FrontScene& scene, const Rung& rung);

}  // namespace texelscope
