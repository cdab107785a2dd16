// The chosen numbers against exact ones: the same method over the same samples, run a second time.
#include <algorithm>
#include <cmath>
#include <map>

#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

using Written = std::map<std::pair<Integer, Integer>, Sample>;  ///< by y, then x

[[nodiscard]] Written written(const Drawing& drawing, int shape, const Rect& rect) {
    Written found;
    each_sample(drawing, shape, shape + 1, {rect, 1}, [&](int, const Sample& s) {
        if (s.fate == Fate::written) found.insert_or_assign({s.y, s.x}, s);
    });
    return found;
}

/// The errors of all samples that either run writes.
[[nodiscard]] std::vector<RowError::At> pixel_errors(const Drawing& drawing, int shape, const Rect& rect) {
    DrawSettings exact = drawing.settings();
    exact.format = NumberFormat::exact;
    const Written is = written(drawing, shape, rect);
    Written meant = written(Drawing(drawing.scene(), exact), shape, rect);
    std::vector<RowError::At> all;
    for (const auto& [place, s] : is) {
        const auto same = meant.find(place);
        if (same == meant.end()) {
            all.push_back({.x = s.x, .other = true});
            continue;
        }
        const Sample& m = same->second;
        all.push_back({s.x, s.u - m.u, s.v - m.v, s.column != m.column || s.row != m.row});
        meant.erase(same);
    }
    for (const auto& [place, m] : meant) all.push_back({.x = m.x, .other = true});
    return all;
}

[[nodiscard]] int count_others(const std::vector<RowError::At>& all) {
    return static_cast<int>(std::count_if(all.begin(), all.end(), [](const RowError::At& a) { return a.other; }));
}

}  // namespace

const RowError& Derived::row_error() const {
    auto& found = cache_->of_step.row_error;
    if (found) return *found;
    found.emplace();
    const auto y = row();
    if (!y || shape() < 0) return *found;
    const Rect frame = scene().framebuffer.rect();
    const int line = static_cast<int>(std::clamp<Integer>(*y, frame.y0, frame.y1 - 1));
    found->pixels = pixel_errors(drawing(), shape(), {frame.x0, line, frame.x1, line + 1});
    std::stable_sort(found->pixels.begin(), found->pixels.end(),
                     [](const RowError::At& a, const RowError::At& b) { return a.x < b.x; });
    found->others = count_others(found->pixels);
    return *found;
}

std::optional<ShapeError> Derived::shape_error() const {
    const int n = shape();
    if (n < 0) return std::nullopt;
    auto& found = cache_->of_drawing.error;
    if (found && found->first == n) return found->second;
    found.emplace(n, std::nullopt);
    const Rect reach = drawing().reach(n);
    if (reach.empty() || Integer{reach.width()} * reach.height() > kMaxCompared) return std::nullopt;
    const std::vector<RowError::At> all = pixel_errors(drawing(), n, scene().framebuffer.rect());
    ShapeError sum{.pixels = static_cast<int>(all.size()), .others = count_others(all)};
    for (const RowError::At& a : all) {
        const double most = std::max(std::abs(a.u), std::abs(a.v));
        if (std::isfinite(most)) sum.most = std::max(sum.most, most);
    }
    return found->second = sum;
}

}  // namespace texelscope
