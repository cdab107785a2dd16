// Makes a picture that was drawn at twice its size small again, for smooth edges (S4).
#pragma once

#include "core/image/image.h"

namespace texelscope {

/// Half the size, rounded up. A pixel is the mean of the samples around its centre, each way weighted 1, 3, 3, 1: a
/// triangle as wide as two pixels. Weights outside the picture are left out. Rounded once, halves up.
[[nodiscard]] Image reduced_by_2(const Image& image);

}  // namespace texelscope
