// How long each method takes for one scene, and how much of it is set-up: what S3's demonstration counted.
#pragma once

#include <functional>
#include <vector>

#include "core/method/drawing.h"

namespace texelscope {

/// What a Pentium of 100 MHz needed for a textured pixel (S3): 10 cycles of 10 ns [s].
inline constexpr double kPixelSeconds1995 = 100e-9;

/// One method's run.
struct Lap {
    const Method* method = nullptr;
    Integer triangles = 0;  ///< shapes drawn; polygons for a method that takes them whole
    Integer pixels = 0;     ///< samples written, those written again counted again
    double seconds = 0;     ///< for the whole scene: the least of the rounds
    double set_up = 0;      ///< of these, what the same shapes take when no pixel of them is on the screen [s]
};

/// Draws the scene with one method as often as fits into `seconds`, at least once, and keeps the fastest round.
/// Timings differ from run to run: show them, never decide by them.
[[nodiscard]] Lap lap(const Scene& scene, const DrawSettings& settings, double seconds);

}  // namespace texelscope
