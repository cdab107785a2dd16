// One shape drawn twice in lockstep: by its texture (forward) and by the screen (backward). Which pixels are left
// empty and which are written again follows from the two runs, not from a formula.
#pragma once

#include <cstdint>
#include <string_view>

#include <glm/vec2.hpp>

#include "core/base/rect.h"
#include "core/image/image.h"
#include "core/method/steps.h"

namespace texelscope {

inline constexpr std::string_view kForward = "forward", kBackward = "backward-projective";  ///< ids of methods

/// A pixel under both directions.
struct LockstepCell {
    Rgb forward{}, backward{};       ///< last written so far
    std::uint8_t writes = 0;         ///< by forward so far, up to 255
    std::uint8_t writes_in_all = 0;  ///< by forward in the end, up to 255
    bool drawn = false;              ///< by backward so far
    bool inside = false;             ///< backward draws it in the end: it belongs to the shape
};

struct Lockstep {
    Rect rect;  ///< the framebuffer's pixels that either direction can reach
    Grid<LockstepCell> cells;
    Integer rows = 0;                              ///< of either outer loop that were begun so far
    Integer forward_rows = 0, backward_rows = 0;   ///< all
    bool begun = false, done = false;              ///< the loops, at the cursor's step
    glm::ivec2 forward_last{0}, backward_last{0};  ///< pixels written last so far, once begun
    // In the end [px]:
    Integer inside = 0;          ///< pixels of the shape
    Integer holes = 0;           ///< of these, pixels that forward leaves empty
    Integer again = 0;           ///< pixels that forward writes more than once
    Integer backward_again = 0;  ///< and that backward does
    Integer outside = 0;         ///< pixels that forward writes although they are not the shape's
};

/// @param drawing  by forward or by a backward method; other methods give an empty rect.
/// @param step     the cursor's.
[[nodiscard]] Lockstep make_lockstep(const Drawing& drawing, Steps& steps, const Path& step);

/// Whether the two directions can be compared for the method: it is one of them.
[[nodiscard]] bool has_directions(const Method& method);

/// Of shape `shape`: whether forward leaves a pixel of it empty; top left at the frame's.
[[nodiscard]] Grid<std::uint8_t> holes_of(const Drawing& drawing, int shape);

}  // namespace texelscope
