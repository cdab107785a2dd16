#include "core/method/layer.h"

#include <algorithm>

#include "core/method/blend.h"
#include "core/method/drawing.h"

namespace texelscope {
namespace {

constexpr int kTile = 32;  ///< cells each way

/// The cells of a layer in squares, and which of these have cells that no shape has written so far.
class Tiles {
public:
    explicit Tiles(const Layer& layer)
        : layer_(layer), open_(in_tiles(layer.cells().width()), in_tiles(layer.cells().height())) {
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
            open = std::any_of(from, from + count, [](const LayerCell& cell) { return cell.shape < 0; });
        }
        open_count_ += static_cast<int>(open) - open_.at(x, y);
        open_.at(x, y) = open ? 1 : 0;
    }

    const Layer& layer_;
    Grid<std::uint8_t> open_;
    int open_count_ = 0;
};

/// Shapes in their order, as a depth test needs them.
void draw_by_depth(const Drawing& drawing, int last, Layer& layer) {
    const Window& window = layer.window();
    const Rgb clear = drawing.scene().framebuffer.clear;
    each_sample(drawing, 0, last, window, [&](int shape, const Sample& s) {
        if (s.fate != Fate::written) return;
        LayerCell& cell = layer.cells().at((static_cast<int>(s.x) - window.rect.x0) / window.stride,
                                           (static_cast<int>(s.y) - window.rect.y0) / window.stride);
        cell = {blended(cell.shape < 0 ? clear : cell.colour, s.colour, drawing.is_half(shape)), shape};
    });
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

void draw_over(const Drawing& drawing, int first, int last, Layer& layer) {
    TEXELSCOPE_ASSERT(drawing.scene().depth == Depth::off);
    const DrawSettings& settings = drawing.settings();
    for (int n = first; n < last; ++n)
        if (drawing.refusal(n) == Fate::written && drawing.touches(n, layer.window().rect))
            settings.method->paint(settings.format, drawing.job(n), layer.window(), n, layer);
}

Layer layer_of(const Drawing& drawing, int last, const Window& window, const Layer* more) {
    Layer layer(window, drawing.scene().framebuffer.clear);
    if (last <= 0) return layer;
    if (drawing.scene().depth == Depth::less) return draw_by_depth(drawing, last, layer), layer;
    if (drawing.has_half()) return draw_over(drawing, 0, last, layer), layer;
    // What no later shape wrote stands there already; a later one's cells are drawn again.
    constexpr std::int32_t kBlank = 1 << 30;
    if (more != nullptr) {
        std::transform(more->cells().data(), more->cells().data() + more->cells().size(), layer.cells().data(),
                       [&](const LayerCell& cell) {
                           if (cell.shape >= last) return LayerCell{};
                           return cell.shape < 0 ? LayerCell{{}, kBlank} : cell;
                       });
    }
    Tiles tiles(layer);
    const Method& method = *drawing.settings().method;
    for (int n = last - 1; n >= 0 && tiles.any_open(); --n) {
        if (drawing.refusal(n) != Fate::written) continue;
        const Job job = drawing.job(n);
        if (method.may_stray(job.quirks)) {
            method.paint(drawing.settings().format, job, window, n, layer);  // it may have put samples anywhere
            continue;
        }
        tiles.each_open(drawing.reach(n),
                        [&](const Window& part) { method.paint(drawing.settings().format, job, part, n, layer); });
    }
    if (more == nullptr) return layer;
    for (LayerCell* cell = layer.cells().data(); cell != layer.cells().data() + layer.cells().size(); ++cell)
        if (cell->shape == kBlank) cell->shape = -1;
    return layer;
}

}  // namespace texelscope
