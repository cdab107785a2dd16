// The canvas' picture at the cursor's step, lanes of the timeline, and the samples of the current row.
#include <algorithm>

#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

[[nodiscard]] glm::ivec2 cell_of(const Window& window, const Sample& s) {
    return {(static_cast<int>(s.x) - window.rect.x0) / window.stride,
            (static_cast<int>(s.y) - window.rect.y0) / window.stride};
}

[[nodiscard]] CanvasPicture blank(const Window& window, Rgb clear) {
    const auto cells = [&](int length) { return (length + window.stride - 1) / window.stride; };
    CanvasCell cell;
    cell.now = cell.later = clear;
    return {window, Grid<CanvasCell>(cells(window.rect.width()), cells(window.rect.height()), cell), 0};
}

[[nodiscard]] std::uint8_t one_more(std::uint8_t count) {
    return count < 255 ? static_cast<std::uint8_t>(count + 1) : count;
}

[[nodiscard]] bool same(const Window& a, const Window& b) { return a.rect == b.rect && a.stride == b.stride; }

/// Whether the sample is the cursor's own and its unit is not finished: it has not reached the framebuffer yet.
[[nodiscard]] bool unfinished(const Cursor& cursor, const Visit& visit, int shape, const Sample& s) {
    const Path& step = cursor.step;
    if (!step.at_expression() || step.index_of('x') != s.x || step.index_of('y') != s.y) return false;
    return step.parts[0].index == shape &&
           step.parts.back().index + 1 < static_cast<Integer>(visit.unit().expressions.size());
}

}  // namespace

const Image& Derived::final_picture() const {
    auto& picture = cache_->of_drawing.final_picture;
    if (!picture) picture = render(drawing());
    return *picture;
}

const CanvasPicture& Derived::canvas(const Window& wanted) const {
    const Window window{intersection(wanted.rect, scene().framebuffer.rect()), std::max(1, wanted.stride)};
    auto& canvas = cache_->of_step.canvas;
    if (canvas && same(canvas->window, window)) return *canvas;
    auto& whole = cache_->of_drawing.whole;
    if (!whole || !same(whole->window, window)) {
        whole = blank(window, scene().framebuffer.clear);
        each_sample(drawing(), 0, drawing().shape_count(), window, [&](int, const Sample& s) {
            if (s.fate != Fate::written) return;
            const glm::ivec2 at = cell_of(window, s);
            CanvasCell& cell = whole->cells.at(at.x, at.y);
            cell.later = s.colour;
            cell.writes_in_all = one_more(cell.writes_in_all);
        });
    }
    canvas = *whole;
    const int current = shape();
    if (current >= 0) {
        each_sample(drawing(), current, current + 1, window, [&](int, const Sample& s) {
            const glm::ivec2 at = cell_of(window, s);
            canvas->cells.at(at.x, at.y).will_be_visited = true;
            canvas->cells.at(at.x, at.y).fate = s.fate;
            canvas->cells.at(at.x, at.y).note = s.note;
        });
        const Cursor& cursor = cache_->state.cursor;
        each_sample_until(drawing(), cursor.step, window, [&](int n, const Sample& s) {
            if (unfinished(cursor, visit(), n, s)) return;
            const glm::ivec2 at = cell_of(window, s);
            CanvasCell& cell = canvas->cells.at(at.x, at.y);
            if (n == current) cell.visited = true;
            if (s.fate != Fate::written) return;
            cell.now = s.colour;
            cell.writes = one_more(cell.writes);
        });
    }
    canvas->version = ++cache_->version;
    return *canvas;
}

const LineCounts& Derived::line_counts() const {
    auto& counts = cache_->of_step.counts;
    if (!counts) {
        // Counted over the whole frame where that is cheap; a large shape's are counted up to its current row only.
        counts = shape() < 0
                     ? LineCounts{}
                     : method().until(drawing().settings().format, drawing().job(shape()),
                                      {scene().framebuffer.rect(), 1}, cache_->state.cursor.step, [](const Sample&) {});
    }
    return *counts;
}

const std::vector<Sample>& Derived::row_samples() const {
    auto& samples = cache_->of_step.row;
    if (samples) return *samples;
    samples.emplace();
    const auto y = row();
    if (!y || shape() < 0) return *samples;
    const Rect frame = scene().framebuffer.rect();
    const int line = static_cast<int>(std::clamp<Integer>(*y, frame.y0, frame.y1 - 1));
    each_sample(drawing(), shape(), shape() + 1, {{frame.x0, line, frame.x1, line + 1}, 1},
                [&](int, const Sample& s) { samples->push_back(s); });
    return *samples;
}

}  // namespace texelscope
