// What the strip shows of sampling in one dimension: one row of a shape, and how much of it is done.
#pragma once

#include <optional>
#include <vector>

#include "app/views/view.h"

namespace texelscope::canvas {

struct StripRow {
    std::vector<Sample> samples;  ///< in the order of the loop
    std::size_t done = 0;
    int y = 0;
    double left = 0, right = 0;      ///< the shape on the screen [px]
    double u_left = 0, u_right = 0;  ///< there [texels]
    int low = 0, high = 0;           ///< indices in view, half-open
};

/// The texel that a sample takes, before wrapping; kept within a million.
[[nodiscard]] int index_of(const Sample& s);

/// The cursor's row, else the shape's first one; nothing where none is drawn.
[[nodiscard]] std::optional<StripRow> strip_row(const ViewContext& ctx);

}  // namespace texelscope::canvas
