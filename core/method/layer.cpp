#include "core/method/layer.h"

#include <algorithm>

#include "core/method/blend.h"
#include "core/method/cells.h"
#include "core/method/drawing.h"
#include "core/method/fast_picture.h"

namespace texelscope {
namespace {

constexpr int kTile = 32;  ///< cells each way

/// The cells of a layer in squares, and which of these have cells that no shape from `first` on has written so far.
class Tiles {
public:
    Tiles(const Layer& layer, int first)
        : layer_(layer), first_(first), open_(in_tiles(layer.cells().width()), in_tiles(layer.cells().height())) {
        for (int y = 0; y < open_.height(); ++y)
            for (int x = 0; x < open_.width(); ++x) look_at(x, y);
    }
    [[nodiscard]] bool any_open() const { return open_count_ > 0; }

    /// Calls draw(part of the window) for each run of open squares, side by side, that `pixels` meets.
    void each_open(const Rect& pixels, auto&& draw) {
        const Window& window = layer_.window();
        const int side = kTile * window.stride;
        const Rect met = intersection(pixels, window.rect);
        if (met.empty()) return;
        const int last = (met.x1 - 1 - window.rect.x0) / side;
        for (int y = (met.y0 - window.rect.y0) / side; y <= (met.y1 - 1 - window.rect.y0) / side; ++y) {
            for (int x = (met.x0 - window.rect.x0) / side; x <= last; ++x) {
                const int first = x;
                while (x <= last && open_.at(x, y) != 0) ++x;
                if (x == first) continue;
                const int x0 = window.rect.x0 + first * side, y0 = window.rect.y0 + y * side;
                draw(Window{intersection({x0, y0, x0 + (x - first) * side, y0 + side}, window.rect), window.stride});
                for (int n = first; n < x; ++n) look_at(n, y);
            }
        }
    }

private:
    [[nodiscard]] static int in_tiles(int cells) { return (cells + kTile - 1) / kTile; }
    void look_at(int x, int y) {
        const Grid<LayerCell>& cells = layer_.cells();
        const int last_row = std::min((y + 1) * kTile, cells.height());
        const int first = x * kTile, count = std::min(kTile, cells.width() - first);
        bool open = false;
        for (int row = y * kTile; row < last_row && !open; ++row) {
            const LayerCell* const from = &cells.at(first, row);
            open = std::any_of(from, from + count, [&](const LayerCell& cell) { return cell.shape < first_; });
        }
        open_count_ += static_cast<int>(open) - open_.at(x, y);
        open_.at(x, y) = open ? 1 : 0;
    }

    const Layer& layer_;
    int first_;
    Grid<std::uint8_t> open_;
    int open_count_ = 0;
};

void paint(const Drawing& drawing, int shape, const Window& part, Layer& layer) {
    const DrawSettings& settings = drawing.settings();
    const Job job = drawing.job(shape);
    if (draws_the_same_as_fast(settings, job))
        (void)paint_fast(settings, job, part, shape, layer);
    else
        settings.method->paint(settings.format, job, part, shape, layer);
}

void draw_in_order(const Drawing& drawing, int first, int last, Layer& layer) {
    for (int n = first; n < last; ++n)
        if (drawing.refusal(n) == Fate::written && drawing.touches(n, layer.window().rect))
            paint(drawing, n, layer.window(), layer);
}

/// The same from the last to the first: where one stands no other is drawn.
void draw_from_last(const Drawing& drawing, int first, int last, Layer& layer) {
    if (first >= last) return;
    Tiles tiles(layer, first);
    const bool may_stray = drawing.settings().method->may_stray(drawing.settings().quirks);
    for (int n = last - 1; n >= first && tiles.any_open(); --n) {
        if (drawing.refusal(n) != Fate::written) continue;
        if (may_stray)
            paint(drawing, n, layer.window(), layer);  // it may put samples anywhere
        else
            tiles.each_open(drawing.reach(n), [&](const Window& part) { paint(drawing, n, part, layer); });
    }
}

}  // namespace

Layer::Layer(const Window& window, Rgb clear) : window_(window), clear_(clear) {
    const auto cells_of = [&](int pixels, std::int32_t scale, std::vector<std::int32_t>& cells) {
        cells.assign(static_cast<std::size_t>(pixels), -1);
        std::int32_t count = 0;
        for (int n = 0; n < pixels; n += window.stride) cells[static_cast<std::size_t>(n)] = count++ * scale;
        return count;
    };
    const int columns = cells_of(window.rect.width(), 1, column_);
    cells_ = {columns, cells_of(window.rect.height(), columns, row_)};
}

void add_sample(const Drawing& drawing, int shape, const Sample& s, Layer& layer) {
    LayerCell& cell = cell_of(layer.cells(), layer.window(), s);
    const Rgb before = cell.shape < 0 ? drawing.scene().framebuffer.clear : cell.colour;
    cell = {blended(before, s.colour, drawing.is_half(shape)), shape};
}

void draw_over(const Drawing& drawing, int first, int last, Layer& layer) {
    TEXELSCOPE_ASSERT(drawing.scene().depth == Depth::off);
    drawing.has_half() ? draw_in_order(drawing, first, last, layer) : draw_from_last(drawing, first, last, layer);
}

Layer layer_of(const Drawing& drawing, int last, const Window& window, const Layer* more) {
    Layer layer(window, drawing.scene().framebuffer.clear);
    if (last <= 0) return layer;
    if (drawing.scene().depth == Depth::less) {
        each_sample(drawing, 0, last, window, [&](int shape, const Sample& s) {
            if (s.fate == Fate::written) add_sample(drawing, shape, s, layer);
        });
        return layer;
    }
    if (more == nullptr || drawing.has_half()) return draw_over(drawing, 0, last, layer), layer;
    // What no later shape wrote stands there already; a later one's cells are drawn again.
    constexpr std::int32_t kBlank = 1 << 30;
    LayerCell* const first = layer.cells().data();
    std::transform(more->cells().data(), more->cells().data() + more->cells().size(), first,
                   [&](const LayerCell& cell) {
                       if (cell.shape >= last) return LayerCell{};
                       return cell.shape < 0 ? LayerCell{{}, kBlank} : cell;
                   });
    draw_over(drawing, 0, last, layer);
    for (LayerCell* cell = first; cell != first + layer.cells().size(); ++cell)
        if (cell->shape == kBlank) cell->shape = -1;
    return layer;
}

}  // namespace texelscope
