// The canvas' picture at the cursor's step, lanes of the timeline, and the samples of the current row.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/state/derived_cache.h"
#include "core/method/blend.h"
#include "core/method/cells.h"

namespace texelscope {
namespace {

constexpr std::int64_t kDerivedCanvasMostCounted = 1 << 20;  ///< samples: counting more would hold up the step

/// Whether the sample is the cursor's own and its unit is not finished: it has not reached the framebuffer yet.
[[nodiscard]] bool unfinished(const Cursor& cursor, const Visit& visit, int shape, const Sample& s) {
    const Path& step = cursor.step;
    if (!step.at_expression() || step.parts.size() < 5) return false;
    const auto is_own = [&](const PathPart& part) {  // of pixels, or of texels where these drive
        if (part.letter == 'x' || part.letter == 'y') return part.index == (part.letter == 'x' ? s.x : s.y);
        return static_cast<double>(part.index) == std::floor(part.letter == 'u' ? s.u : s.v);
    };
    if (!is_own(step.parts[2]) || !is_own(step.parts[3])) return false;
    return step.parts[0].index == shape &&
           step.parts.back().index + 1 < static_cast<Integer>(visit.unit().expressions.size());
}

}  // namespace

const Image& Derived::final_picture() const {
    auto& picture = cache_->of_drawing.final_picture;
    if (picture) return *picture;
    const auto start = std::chrono::steady_clock::now();
    picture = render(drawing());
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    cache_->of_drawing.frame_time = taken.count();
    return *picture;
}

double Derived::frame_time() const {
    static_cast<void>(final_picture());
    return cache_->of_drawing.frame_time;
}

const CanvasPicture& Derived::canvas(const Window& wanted) const {
    const Window window{intersection(wanted.rect, scene().framebuffer.rect()), std::max(1, wanted.stride)};
    cache_->in_view = window;
    KeptCanvas& kept = cache_->canvas;
    if (cache_->of_step.canvas && kept.step().window == window) return kept.step();
    const int current = shape();
    static_cast<void>(kept.before(drawing(), current, window));
    kept.begin_step();
    if (current >= 0) {
        const Cursor& cursor = cache_->state.cursor;
        const bool half = drawing().is_half(current);
        // With a depth test a shape's samples follow only from all those before it.
        const int first = scene().depth == Depth::less ? 0 : current;
        LineCounts counts = each_sample_until(drawing(), first, cursor.step, window, [&](int n, const Sample& s) {
            if (n != current || unfinished(cursor, visit(), n, s)) return;
            CanvasCell& cell = kept.step_in(s);
            cell.visited = true;
            if (s.fate != Fate::written) return;
            cell.now = blended(cell.now, s.colour, half);
            cell.written = true;
        });
        if (window == Window{scene().framebuffer.rect(), 1}) cache_->of_step.counts = std::move(counts);
    }
    kept.finish_step(++cache_->version);
    cache_->of_step.canvas = true;
    return kept.step();
}

const CanvasPicture* Derived::whole_frame_in_view() const {
    const Window& window = cache_->in_view;
    if (!(window == Window{scene().framebuffer.rect(), 1})) return nullptr;
    return &cache_->canvas.before(drawing(), shape(), window);
}

std::int64_t Derived::cells_drawn() const { return cache_->canvas.cells_drawn(); }

const Grid<std::uint8_t>& Derived::hits(const Window& window) const {
    auto& hits = cache_->of_drawing.hits;
    if (hits && hits->window == window) return hits->count;
    hits = {window, cells_of<std::uint8_t>(window)};
    each_sample(drawing(), 0, drawing().shape_count(), window, [&](int, const Sample& s) {
        if (s.fate != Fate::written) return;
        std::uint8_t& count = cell_of(hits->count, window, s);
        if (count < 255) ++count;
    });
    return hits->count;
}

const LineCounts& Derived::line_counts() const {
    auto& counts = cache_->of_step.counts;
    if (counts) return *counts;
    counts.emplace();
    if (shape() < 0) return *counts;
    const Rect reach = drawing().reach(shape());
    if (std::int64_t{reach.width()} * reach.height() > kDerivedCanvasMostCounted) return *counts;
    counts = method().until(drawing().settings().format, drawing().job(shape()), {scene().framebuffer.rect(), 1},
                            cache_->state.cursor.step, [](const Sample&) {});
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
