// A colour ramp for magnitudes: even to the eye, and rising in lightness for every sight and in print.
#pragma once

#include "app/ui/color.h"

namespace texelscope::ui {

/// Viridis. Opaque.
/// @param t  [0, 1], clamped; NaN is 0.
/// Source    S. van der Walt, N. Smith, 2015 (matplotlib); here linear between eleven of its colours.
[[nodiscard]] Color viridis(double t);

}  // namespace texelscope::ui
