// What shapes leave in a window of the picture: each cell's colour, and whose sample came last. They are taken from the
// last to the first, and where one stands no other is drawn; in their order where a depth test or blending needs that.
#pragma once

#include <cstdint>
#include <vector>

#include "core/image/image.h"
#include "core/method/blend.h"
#include "core/number/real.h"
#include "core/trace/fate.h"
#include "core/trace/trace.h"

namespace texelscope {

class Drawing;

struct LayerCell {
    Rgb colour{};
    std::int32_t shape = -1;  ///< whose sample it is; -1 where none was written
    friend bool operator==(const LayerCell&, const LayerCell&) = default;
};

class Layer {
public:
    Layer() = default;
    /// @param clear  what stands where nothing is written, for half-transparent shapes.
    explicit Layer(const Window& window, Rgb clear = {});

    [[nodiscard]] const Window& window() const { return window_; }
    /// A cell for each sample of the window.
    [[nodiscard]] const Grid<LayerCell>& cells() const { return cells_; }
    [[nodiscard]] Grid<LayerCell>& cells() { return cells_; }

    /// What a method puts its samples into: those of a later shape stay.
    [[nodiscard]] auto put(std::int32_t shape, bool half, auto&& colour_of) {
        return [cells = cells_.data(), column = column_.data(), row = row_.data(), rect = window_.rect, shape, half,
                clear = clear_, colour_of](Integer x, Integer y, const auto& pixel) {
            if (pixel.fate != Fate::written || !rect.contains(x, y)) return;
            const std::int32_t c = column[x - rect.x0], r = row[y - rect.y0];
            if (c < 0 || r < 0) return;
            LayerCell& cell = cells[r + c];
            if (cell.shape > shape) return;
            const Rgb colour = colour_of(pixel.texel);
            cell = {half ? blended(cell.shape < 0 ? clear : cell.colour, colour, true) : colour, shape};
        };
    }

private:
    Window window_;
    Rgb clear_;
    Grid<LayerCell> cells_;
    std::vector<std::int32_t> column_, row_;  ///< of each pixel of the window: its cell, or -1 between samples
};

/// What shapes [0, last) leave in the window.
/// @param more  the same window with more shapes, which saves drawing what these left there; or null.
[[nodiscard]] Layer layer_of(const Drawing& drawing, int last, const Window& window, const Layer* more = nullptr);

/// Draws shapes [first, last) over what shapes [0, first) left in the layer. Not for a scene with a depth test.
void draw_over(const Drawing& drawing, int first, int last, Layer& layer);

}  // namespace texelscope
