// The point whose weights are shown, on the canvas and beside it.
#pragma once

#include <array>
#include <optional>

#include "app/views/view.h"

namespace texelscope {

/// A sample of the current shape with its weights, as its own step has them.
struct WeightedPoint {
    glm::ivec2 pixel{0};
    std::array<std::optional<double>, 3> e;  ///< of the corners; those behind the first that rejects are not computed
    bool inside = false;                     ///< all three are known, and none is negative

    [[nodiscard]] double sum() const { return e[0].value_or(0) + e[1].value_or(0) + e[2].value_or(0); }
};
/// The pixel under the mouse, else the pinned one, else the step's; only the step's while a pixel is asked for.
/// Nothing where the method does not come to it.
[[nodiscard]] std::optional<WeightedPoint> weighted_point(const ViewContext& context);
/// Side A, B or C as 0, 1, 2: the one across from corner n, whose style its weight has.
[[nodiscard]] constexpr int side_across(int corner) { return (corner + 1) % 3; }

}  // namespace texelscope
