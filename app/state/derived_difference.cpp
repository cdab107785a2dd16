// Where the pictures of two runs differ, and why.
#include <algorithm>
#include <cmath>
#include <map>

#include "app/state/compared_run.h"
#include "app/state/derived_cache.h"
#include "core/method/cells.h"

namespace texelscope {
namespace {

/// The sample that is seen in the end, with the polygon it belongs to.
struct Seen {
    Sample sample;
    int polygon = -1;  ///< -1: nothing is written
};
using Sight = Grid<Seen>;

[[nodiscard]] Sight seen(const Scene& scene, const DrawSettings& settings, const Window& window) {
    const Drawing drawing(scene, settings);
    Sight all = cells_of<Seen>(window);
    each_sample(drawing, 0, drawing.shape_count(), window, [&](int shape, const Sample& s) {
        if (s.fate == Fate::written) cell_of(all, window, s) = {s, drawing.polygon_of(shape)};
    });
    return all;
}

/// The run in numbers that do not round, or hardly.
[[nodiscard]] DrawSettings unrounded(DrawSettings settings, const Window& window) {
    const bool small = Integer{window.rect.width()} * window.rect.height() <= kMaxExact;
    settings.format = small ? NumberFormat::exact : NumberFormat::f64;
    settings.mode = {};
    const auto& quirks = settings.method->quirks;
    const auto narrow =
        std::find_if(quirks.begin(), quirks.end(), [](const QuirkInfo& q) { return q.id == "float32"; });
    if (narrow != quirks.end()) settings.quirks &= ~(QuirkSet{1} << (narrow - quirks.begin()));  // it is a format, too
    return settings;
}

[[nodiscard]] glm::dvec2 apart(const Seen& a, const Seen& b) {
    return {a.sample.u - b.sample.u, a.sample.v - b.sample.v};
}

/// How far apart (u, v) are over one polygon: the same everywhere, or not.
struct Spread {
    glm::dvec2 low{INFINITY}, high{-INFINITY};
    void add(glm::dvec2 distance) {
        low = {std::min(low.x, distance.x), std::min(low.y, distance.y)};
        high = {std::max(high.x, distance.x), std::max(high.y, distance.y)};
    }
    [[nodiscard]] bool constant() const {
        return std::isfinite(low.x) && high.x - low.x < kRounding && high.y - low.y < kRounding;
    }
    [[nodiscard]] bool none() const { return constant() && std::abs(low.x) < kRounding && std::abs(low.y) < kRounding; }
};

/// How far (u, v) go at most within half a pixel across and half a pixel down.
[[nodiscard]] std::map<int, glm::dvec2> half_pixels(const Sight& sight, int stride) {
    std::map<int, std::array<glm::dvec2, 2>> steps;  // to the right, down
    const auto step = [&](const Seen& from, const Seen& to, std::size_t way) {
        if (from.polygon < 0 || from.polygon != to.polygon) return;
        glm::dvec2& most = steps.try_emplace(from.polygon).first->second[way];
        const glm::dvec2 d = apart(to, from);
        most = {std::max(most.x, std::abs(d.x)), std::max(most.y, std::abs(d.y))};
    };
    for (int y = 0; y < sight.height(); ++y)
        for (int x = 0; x < sight.width(); ++x) {
            if (x + 1 < sight.width()) step(sight.at(x, y), sight.at(x + 1, y), 0);
            if (y + 1 < sight.height()) step(sight.at(x, y), sight.at(x, y + 1), 1);
        }
    std::map<int, glm::dvec2> half;
    for (const auto& [polygon, way] : steps) half[polygon] = (way[0] + way[1]) / (2.0 * stride);
    return half;
}

/// What the two runs are like without rounding.
class Meant {
public:
    /// @param here, there  what the two runs are like in their own numbers.
    Meant(const Scene& scene, const DrawSettings& own, const DrawSettings& other, const Window& window,
          const Sight& here, const Sight& there)
        : same_(unrounded(own, window) == unrounded(other, window)) {
        if (same_) return;
        own_ = own == unrounded(own, window) ? here : seen(scene, unrounded(own, window), window);
        other_ = other == unrounded(other, window) ? there : seen(scene, unrounded(other, window), window);
        for (std::size_t n = 0; n < own_.size(); ++n) {
            const Seen &a = own_.data()[n], &b = other_.data()[n];
            if (a.polygon >= 0 && a.polygon == b.polygon) spreads_[a.polygon].add(apart(a, b));
        }
        if (own.method->scatters != other.method->scatters)
            slack_ = half_pixels(own.method->scatters ? other_ : own_, window.stride);
    }

    /// @param polygon  that both runs draw in cell n; -1 where only one of them draws there.
    [[nodiscard]] Cause cause(std::size_t n, int polygon) const {
        if (same_) return Cause::rounding;
        const Seen &a = own_.data()[n], &b = other_.data()[n];
        if (polygon < 0) return a.polygon == b.polygon ? Cause::rounding : Cause::coverage;
        const auto spread = spreads_.find(polygon);
        if (spread == spreads_.end()) return Cause::warp;
        if (spread->second.none()) return Cause::rounding;
        if (a.polygon == polygon && b.polygon == polygon && is_near(apart(a, b), polygon)) return Cause::rounding;
        return spread->second.constant() ? Cause::offset : Cause::warp;
    }

private:
    [[nodiscard]] bool is_near(glm::dvec2 distance, int polygon) const {
        const auto slack = slack_.find(polygon);
        const glm::dvec2 most = (slack == slack_.end() ? glm::dvec2(0) : slack->second) + kRounding;
        return std::abs(distance.x) < most.x && std::abs(distance.y) < most.y;
    }

    bool same_;
    Sight own_, other_;
    std::map<int, Spread> spreads_;
    std::map<int, glm::dvec2> slack_;  ///< by polygon; empty where neither run, or either, is driven by its texture
};

[[nodiscard]] bool same_texel(const Seen& a, const Seen& b) {
    return a.sample.column == b.sample.column && a.sample.row == b.sample.row;
}

}  // namespace

Difference compare(const Drawing& own, const DrawSettings& other, const Window& wanted) {
    const Scene& scene = own.scene();
    const Window window{intersection(wanted.rect, scene.framebuffer.rect()), std::max(1, wanted.stride)};
    const Sight here = seen(scene, own.settings(), window), there = seen(scene, other, window);
    Difference difference{window, other, {here.width(), here.height()}, {}};
    std::optional<Meant> meant;  // costs as much as the two pictures, and more: not where they are the same
    for (std::size_t n = 0; n < here.size(); ++n) {
        const Seen &a = here.data()[n], &b = there.data()[n];
        DifferenceCell& cell = difference.cells.data()[n];
        if (a.polygon >= 0) cell.own = a.sample.colour;
        if (b.polygon >= 0) cell.others = b.sample.colour;
        if (a.polygon >= 0 && a.polygon == b.polygon) cell.u = apart(a, b).x, cell.v = apart(a, b).y;
        const bool both = a.polygon == b.polygon;
        if (!both || (a.polygon >= 0 && !same_texel(a, b))) {
            if (!meant) meant.emplace(scene, own.settings(), other, window, here, there);
            cell.cause = meant->cause(n, both ? a.polygon : -1);
        } else if (a.polygon >= 0) {
            cell.cause = Cause::same;
        }
        ++difference.count[static_cast<std::size_t>(cell.cause)];
    }
    return difference;
}

const Difference& Derived::difference(const Window& wanted) const {
    const Window window{intersection(wanted.rect, scene().framebuffer.rect()), std::max(1, wanted.stride)};
    const DrawSettings other = texelscope::settings_of(cache_->state.look.other, drawing().settings());
    auto& difference = cache_->of_drawing.difference;
    if (!difference || !(difference->window == window) || !(difference->other == other))
        difference = compare(drawing(), other, window);
    return *difference;
}

}  // namespace texelscope
