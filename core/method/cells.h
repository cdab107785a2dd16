// Grids that have a cell for each sample of a window.
#pragma once

#include "core/image/image.h"
#include "core/method/method.h"
#include "core/trace/trace.h"

namespace texelscope {

template <class Cell>
[[nodiscard]] Grid<Cell> cells_of(const Window& window) {
    const auto count = [&](int pixels) { return (pixels + window.stride - 1) / window.stride; };
    return {count(window.rect.width()), count(window.rect.height())};
}

/// The cell of a sample in the window.
template <class Cell>
[[nodiscard]] Cell& cell_of(Grid<Cell>& cells, const Window& window, const Sample& s) {
    return cells.at((static_cast<int>(s.x) - window.rect.x0) / window.stride,
                    (static_cast<int>(s.y) - window.rect.y0) / window.stride);
}

}  // namespace texelscope
