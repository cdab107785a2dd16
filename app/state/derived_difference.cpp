// Where the pictures of two methods differ, and why.
#include <algorithm>
#include <cmath>
#include <map>

#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

/// The sample that is seen in the end, with the polygon it belongs to.
struct Seen {
    Sample sample;
    int polygon = -1;  ///< -1: nothing is written
};

[[nodiscard]] Grid<Seen> seen(const Drawing& drawing, const Window& window) {
    const auto cells = [&](int length) { return (length + window.stride - 1) / window.stride; };
    Grid<Seen> all(cells(window.rect.width()), cells(window.rect.height()));
    each_sample(drawing, 0, drawing.shape_count(), window, [&](int shape, const Sample& s) {
        if (s.fate != Fate::written) return;
        all.at((static_cast<int>(s.x) - window.rect.x0) / window.stride,
               (static_cast<int>(s.y) - window.rect.y0) / window.stride) = {s, drawing.polygon_of(shape)};
    });
    return all;
}

/// How far apart (u, v) are over one polygon: the same everywhere, or not.
struct Spread {
    glm::dvec2 low{INFINITY}, high{-INFINITY};
    void add(const DifferenceCell& cell) {
        low = {std::min(low.x, cell.u), std::min(low.y, cell.v)};
        high = {std::max(high.x, cell.u), std::max(high.y, cell.v)};
    }
    [[nodiscard]] bool constant() const { return high.x - low.x < kRounding && high.y - low.y < kRounding; }
};

[[nodiscard]] Cause cause_of(const Seen& a, const Seen& b, const DifferenceCell& cell, const Spread& spread) {
    if (a.polygon != b.polygon) return Cause::coverage;
    if (a.sample.column == b.sample.column && a.sample.row == b.sample.row) return Cause::same;
    if (std::abs(cell.u) < kRounding && std::abs(cell.v) < kRounding) return Cause::rounding;
    return spread.constant() ? Cause::offset : Cause::warp;
}

}  // namespace

const Difference& Derived::difference(const Window& wanted, const Method& other) const {
    const Window window{intersection(wanted.rect, scene().framebuffer.rect()), std::max(1, wanted.stride)};
    auto& difference = cache_->of_drawing.difference;
    if (difference && difference->window == window && difference->other == &other) return *difference;
    DrawSettings settings = drawing().settings();
    settings.method = &other, settings.quirks = quirks_of(other, other.variants.back().id);
    const Grid<Seen> own = seen(drawing(), window), others = seen(Drawing(scene(), settings), window);
    difference = {window, &other, {own.width(), own.height()}, {}};
    std::map<int, Spread> spreads;
    for (std::size_t n = 0; n < own.size(); ++n) {
        const Seen &a = own.data()[n], &b = others.data()[n];
        DifferenceCell& cell = difference->cells.data()[n];
        cell.own = a.sample.colour, cell.others = b.sample.colour;
        if (a.polygon < 0 || a.polygon != b.polygon) continue;
        cell.u = a.sample.u - b.sample.u, cell.v = a.sample.v - b.sample.v;
        spreads[a.polygon].add(cell);
    }
    for (std::size_t n = 0; n < own.size(); ++n) {
        const Seen &a = own.data()[n], &b = others.data()[n];
        DifferenceCell& cell = difference->cells.data()[n];
        if (a.polygon >= 0 || b.polygon >= 0) cell.cause = cause_of(a, b, cell, spreads[a.polygon]);
        ++difference->count[static_cast<std::size_t>(cell.cause)];
    }
    return *difference;
}

}  // namespace texelscope
