// What a selection means elsewhere: pixel to texel, texel to pixels, line to pixels, and the writers of a pixel.
#include <algorithm>
#include <map>
#include <set>

#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

constexpr std::size_t kMostLinked =
    20000;  ///< pixels of one selection: more light up nothing that an eye could tell apart

struct PixelFate {
    glm::ivec2 pixel;
    Fate fate;
};

/// The lines that run for samples of each fate, seen at the first sample of that fate.
[[nodiscard]] std::map<Fate, std::set<int>> lines_by_fate(const Derived& derived,
                                                          const std::vector<PixelFate>& samples) {
    std::map<Fate, std::set<int>> lines;
    for (const auto& [pixel, fate] : samples) {
        if (lines.contains(fate)) continue;
        std::set<int>& own = lines[fate];
        const auto path = derived.steps().at_pixel(derived.shape(), pixel.x, pixel.y);
        if (!path) continue;
        const Visit& visit = derived.steps().at(*path);
        for (const std::int32_t n : visit.unit().expressions)
            own.insert(visit.tape.names[static_cast<std::size_t>(n)].line);
    }
    return lines;
}

}  // namespace

std::vector<std::pair<int, Sample>> Derived::writers(glm::ivec2 pixel) const {
    std::vector<std::pair<int, Sample>> found;
    each_sample_until(drawing(), 0, cache_->state.cursor.step, {{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, 1},
                      [&](int n, const Sample& s) {
                          if (s.fate == Fate::written) found.emplace_back(n, s);
                      });
    return found;
}

int Derived::writes_in_all(glm::ivec2 pixel) const {
    int count = 0;
    each_sample(drawing(), 0, drawing().shape_count(), {{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, 1},
                [&](int, const Sample& s) { count += s.fate == Fate::written ? 1 : 0; });
    return count;
}

std::optional<Path> Derived::last_write(glm::ivec2 pixel) const {
    const auto so_far = writers(pixel);
    if (!so_far.empty()) return steps().at_pixel(so_far.back().first, pixel.x, pixel.y);
    const Layer whole = layer_of(drawing(), drawing().shape_count(), {{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, 1});
    const int last = whole.cells().at(0, 0).shape;
    return last < 0 ? std::nullopt : steps().at_pixel(last, pixel.x, pixel.y);
}

Highlight Derived::highlight(const Selection& selection) const {
    Highlight h;
    const int current = shape();
    const auto each_of_shape = [&](auto&& put) {
        if (current < 0) return;
        each_sample(drawing(), current, current + 1, {scene().framebuffer.rect(), 1},
                    [&](int, const Sample& s) { put(s, glm::ivec2(s.x, s.y)); });
    };
    switch (selection.kind) {
        case Selection::Kind::none: break;
        case Selection::Kind::pixel: {
            h.pixels.push_back(selection.at);
            std::optional<Sample> top;
            each_sample(drawing(), std::max(0, current), std::max(0, current) + (current >= 0),
                        {{selection.at.x, selection.at.y, selection.at.x + 1, selection.at.y + 1}, 1},
                        [&](int, const Sample& s) { top = s; });
            if (top && top->fate == Fate::written) h.texels.emplace_back(top->column, top->row);
            if (const auto path =
                    current < 0 ? std::nullopt : steps().at_pixel(current, selection.at.x, selection.at.y))
                h.ticks.push_back(*path);
            break;
        }
        case Selection::Kind::texel:
            h.texels.push_back(selection.at);
            each_of_shape([&](const Sample& s, glm::ivec2 pixel) {
                if (s.fate == Fate::written && s.column == selection.at.x && s.row == selection.at.y &&
                    h.pixels.size() < kMostLinked)
                    h.pixels.push_back(pixel);
            });
            break;
        case Selection::Kind::name:
            h.names.push_back(selection.name);
            for (const Named& named : visit().tape.names) {
                if (named.name.text() == selection.name) h.lines.assign(1, named.line);
            }
            for (std::size_t e = 0; e < visit().unit().expressions.size(); ++e) {
                const auto n = static_cast<std::size_t>(visit().unit().expressions[e]);
                if (visit().tape.names[n].name.text() == selection.name)
                    h.ticks.assign(1, visit().path.child('e', static_cast<Integer>(e)));
            }
            break;
        case Selection::Kind::line: {
            h.lines.push_back(selection.line);
            for (const Named& named : visit().tape.names) {
                if (named.line == selection.line) h.names.push_back(named.name.text());
            }
            std::vector<PixelFate> samples;
            samples.reserve(kMostLinked);
            if (const CanvasPicture* all = whole_frame_in_view(); all != nullptr && current >= 0) {
                const Rect frame = all->window.rect, reach = drawing().reach(current);
                for (int y = reach.y0; y < reach.y1; ++y)
                    for (int x = reach.x0; x < reach.x1 && samples.size() < kMostLinked; ++x)
                        if (const CanvasCell& cell = all->cells.at(x - frame.x0, y - frame.y0); cell.will_be_visited)
                            samples.push_back({{x, y}, cell.fate});
            } else {
                each_of_shape([&](const Sample& s, glm::ivec2 pixel) {
                    if (samples.size() < kMostLinked) samples.push_back({pixel, s.fate});
                });
            }
            const auto lines = lines_by_fate(*this, samples);
            for (const auto& [pixel, fate] : samples)
                if (lines.at(fate).contains(selection.line)) h.pixels.push_back(pixel);
            break;
        }
        case Selection::Kind::colour: {
            const auto& indices = texture().indices;
            for (int y = 0; y < indices.height(); ++y)
                for (int x = 0; x < indices.width(); ++x)
                    if (indices.at(x, y) == selection.colour) h.texels.emplace_back(x, y);
            if (h.texels.empty()) break;
            const Grid<std::int16_t>& shown = palette_use().shown;
            const Rect frame = scene().framebuffer.rect();
            for (int y = 0; y < shown.height(); ++y)
                for (int x = 0; x < shown.width() && h.pixels.size() < kMostLinked; ++x)
                    if (shown.at(x, y) == selection.colour) h.pixels.emplace_back(frame.x0 + x, frame.y0 + y);
            break;
        }
        case Selection::Kind::tick:
            h.ticks.push_back(selection.tick);
            if (const auto x = selection.tick.index_of('x'), y = selection.tick.index_of('y'); x && y)
                h.pixels.emplace_back(*x, *y);
            break;
    }
    return h;
}

}  // namespace texelscope
