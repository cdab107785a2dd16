#include "app/state/kept_canvas.h"

#include <algorithm>
#include <utility>

#include "core/method/cells.h"
#include "core/method/drawing.h"

namespace texelscope {
namespace {

constexpr std::size_t kMostRects = 16;  ///< with more of them it is simpler to draw everything

[[nodiscard]] std::int64_t area_of(const Rect& r) { return std::int64_t{r.width()} * r.height(); }
[[nodiscard]] Rect hull(const Rect& a, const Rect& b) {
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// Adds a rectangle, together with another one where that is no more work.
void add(std::vector<Rect>& rects, const Rect& rect) {
    if (rect.empty()) return;
    for (Rect& other : rects) {
        const Rect both = hull(other, rect);
        if (area_of(both) <= area_of(other) + area_of(rect)) return void(other = both);
    }
    rects.push_back(rect);
}

[[nodiscard]] bool same_frame(const Scene& a, const Scene& b) {
    return a.framebuffer == b.framebuffer && a.depth == b.depth && a.cull == b.cull && a.textures == b.textures;
}

/// Whether a shape, of polygons that differ, is drawn the same.
[[nodiscard]] bool same_shape(const Drawing& a, const Drawing& b, int shape) {
    const Job x = a.job(shape), y = b.job(shape);
    return std::equal(x.corners.begin(), x.corners.end(), y.corners.begin(), y.corners.end()) &&
           x.texture == y.texture && x.light == y.light && x.half == y.half &&
           std::equal(x.unrounded.begin(), x.unrounded.end(), y.unrounded.begin(), y.unrounded.end()) &&
           x.unrounded_light == y.unrounded_light && a.refusal(shape) == b.refusal(shape);
}

/// Pixels in which two drawings may differ; nothing where they have too little in common to say.
[[nodiscard]] std::optional<std::vector<Rect>> changed_between(const Drawing& a, const Drawing& b) {
    const auto &before = a.scene().polygons, &after = b.scene().polygons;
    if (!(a.settings() == b.settings()) || !same_frame(a.scene(), b.scene()) || a.shape_count() != b.shape_count() ||
        before.size() != after.size())
        return std::nullopt;
    std::vector<Rect> rects;
    for (std::size_t n = 0; n < after.size(); ++n) {
        if (before[n] == after[n]) continue;
        if (before[n].vertices.size() != after[n].vertices.size()) return std::nullopt;
        const auto polygon = static_cast<int>(n);
        for (int shape = b.first_shape_of(polygon); shape < b.first_shape_of(polygon + 1); ++shape) {
            if (same_shape(a, b, shape)) continue;
            for (const Drawing* drawing : {&a, &b})
                if (drawing->refusal(shape) == Fate::written) add(rects, drawing->reach(shape));
            if (rects.size() > kMostRects) return std::nullopt;
        }
    }
    return rects;
}

/// What layers and cells over a window become by the samples of a drawing.
struct Part {
    Layer whole;
    Grid<CanvasCell> cells;
    bool ghosts = false;
};

/// @param whole  the end of the drawing over the window, where it is known.
[[nodiscard]] Part drawn(const Drawing& drawing, int shape, const Window& window, const Layer* whole) {
    const Rgb clear = drawing.scene().framebuffer.clear;
    const int first = std::max(0, shape), behind = shape + 1, count = drawing.shape_count();
    Part part;
    Layer so_far(window, clear);
    part.cells = {so_far.cells().width(), so_far.cells().height()};
    const auto visit = [&](const Sample& s) {
        CanvasCell& cell = cell_of(part.cells, window, s);
        cell.will_be_visited = true;
        cell.fate = s.fate, cell.note = s.note;
        part.ghosts = part.ghosts || s.note == Note::ghost;
    };
    const bool known = whole != nullptr;
    if (drawing.scene().depth == Depth::less) {  // a shape's samples follow only from all those before it
        if (!known) part.whole = so_far;
        each_sample(drawing, 0, known ? behind : count, window, [&](int n, const Sample& s) {
            if (n == shape) visit(s);
            if (s.fate != Fate::written) return;
            if (n < first) add_sample(drawing, n, s, so_far);
            if (!known) add_sample(drawing, n, s, part.whole);
        });
    } else {
        so_far = layer_of(drawing, first, window, whole);
        if (!known) part.whole = so_far;
        each_sample(drawing, first, behind, window, [&](int n, const Sample& s) {
            visit(s);
            if (!known && s.fate == Fate::written) add_sample(drawing, n, s, part.whole);
        });
        if (!known) draw_over(drawing, behind, count, part.whole);
    }
    const LayerCell *now = so_far.cells().data(), *later = (known ? *whole : part.whole).cells().data();
    for (CanvasCell* cell = part.cells.data(); cell != part.cells.data() + part.cells.size(); ++cell, ++now, ++later) {
        cell->written = now->shape >= 0, cell->will_be_written = later->shape >= 0;
        cell->now = cell->written ? now->colour : clear;
        cell->later = cell->will_be_written ? later->colour : clear;
    }
    return part;
}

/// Puts a grid into its place in a larger one.
template <class Cell>
void put_at(int x, int y, const Grid<Cell>& part, Grid<Cell>& into) {
    for (int row = 0; row < part.height(); ++row) {
        const Cell* const from = part.data() + std::ptrdiff_t{row} * part.width();
        std::copy(from, from + part.width(), into.data() + std::ptrdiff_t{y + row} * into.width() + x);
    }
}

}  // namespace

void KeptCanvas::change(const Drawing& from, const Drawing& to) {
    const auto rects = changed_between(from, to);
    if (!rects) return forget();
    for (const Rect& rect : *rects) add(changed_, rect);
    if (changed_.size() > kMostRects) forget();
}

const CanvasPicture& KeptCanvas::before(const Drawing& drawing, int shape, const Window& window) {
    const bool same_window = whole_ && before_.window == window;
    if (same_window && shape == shape_) {
        for (const Rect& rect : std::exchange(changed_, {})) draw(drawing, intersection(rect, window.rect));
        return before_;
    }
    const bool known = same_window && changed_.empty();
    Part part = drawn(drawing, shape, window, known ? &*whole_ : nullptr);
    if (!known) whole_ = std::move(part.whole);
    shape_ = shape;
    before_ = {window, std::move(part.cells), 0, part.ghosts};
    changed_.clear();
    stale_ = {{0, 0, before_.cells.width(), before_.cells.height()}};
    cells_drawn_ += static_cast<std::int64_t>(before_.cells.size());
    return before_;
}

/// Draws part of the window again, whole cells.
void KeptCanvas::draw(const Drawing& drawing, const Rect& pixels) {
    if (pixels.empty()) return;
    const Window& window = before_.window;
    const int stride = window.stride, x = (pixels.x0 - window.rect.x0) / stride,
              y = (pixels.y0 - window.rect.y0) / stride;
    const Rect rect{window.rect.x0 + x * stride, window.rect.y0 + y * stride, pixels.x1, pixels.y1};
    const Part part = drawn(drawing, shape_, {rect, stride}, nullptr);
    put_at(x, y, part.cells, before_.cells);
    put_at(x, y, part.whole.cells(), whole_->cells());
    const CanvasCell* const first = before_.cells.data();
    before_.ghosts =
        part.ghosts || (before_.ghosts && std::any_of(first, first + before_.cells.size(),
                                                      [](const CanvasCell& cell) { return cell.note == Note::ghost; }));
    add(stale_, {x, y, x + part.cells.width(), y + part.cells.height()});
    cells_drawn_ += static_cast<std::int64_t>(part.cells.size());
}

void KeptCanvas::begin_step() {
    add(stale_, std::exchange(stepped_, {}));
    const Grid<CanvasCell>& from = before_.cells;
    if (step_.cells.width() != from.width() || step_.cells.height() != from.height()) {
        step_.cells = from;
    } else {
        for (const Rect& r : stale_)
            for (int y = r.y0; y < r.y1; ++y) {
                const CanvasCell* const row = from.data() + std::ptrdiff_t{y} * from.width();
                std::copy(row + r.x0, row + r.x1, &step_.cells.at(r.x0, y));
            }
    }
    stale_.clear();
    step_.window = before_.window, step_.ghosts = before_.ghosts;
}

CanvasCell& KeptCanvas::step_in(const Sample& s) {
    const Window& window = step_.window;
    const int x = (static_cast<int>(s.x) - window.rect.x0) / window.stride,
              y = (static_cast<int>(s.y) - window.rect.y0) / window.stride;
    stepped_ = stepped_.empty() ? Rect{x, y, x + 1, y + 1} : hull(stepped_, {x, y, x + 1, y + 1});
    return step_.cells.at(x, y);
}

}  // namespace texelscope
