// Which way `fast` takes to each pixel of one shape of a drawing.
#pragma once

#include "core/fast/who_decided.h"
#include "core/method/drawing.h"

namespace texelscope {

/// Of nothing where the shape is no triangle, or is not drawn.
[[nodiscard]] Decisions decisions_of(const Drawing& drawing, int shape);

}  // namespace texelscope
