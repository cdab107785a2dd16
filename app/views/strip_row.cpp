#include "app/views/strip_row.h"

#include <algorithm>
#include <cmath>

#include "app/views/canvas_texture.h"

namespace texelscope::canvas {
namespace {

constexpr int kMostTexels = 64;
constexpr double kFarthest = 1 << 20;

}  // namespace

int index_of(const Sample& s) { return static_cast<int>(std::floor(std::clamp(s.u, -kFarthest, kFarthest))); }

std::optional<StripRow> strip_row(const ViewContext& ctx) {
    const Derived& derived = ctx.derived;
    const int shape = derived.shape();
    const Drawing& drawing = derived.drawing();
    const Rect frame = drawing.scene().framebuffer.rect();
    std::optional<Integer> y = derived.row();
    if (!y) {
        each_sample(drawing, shape, shape + 1, {drawing.reach(shape), 1}, [&](int, const Sample& s) {
            if (!y && s.fate == Fate::written) y = s.y;
        });
    }
    if (!y || *y < frame.y0 || *y >= frame.y1) return std::nullopt;
    StripRow row;
    row.y = static_cast<int>(*y);
    const Window window{{frame.x0, row.y, frame.x1, row.y + 1}, 1};
    each_sample(drawing, shape, shape + 1, window, [&](int, const Sample& s) {
        if (s.fate == Fate::written && std::isfinite(s.u)) row.samples.push_back(s);
    });
    if (row.samples.empty()) return std::nullopt;
    each_sample_until(drawing, shape, ctx.state.cursor.step, window,
                      [&](int n, const Sample&) { row.done += n == shape; });
    row.done = std::min(row.done, row.samples.size());
    // A pixel under work takes no texel before its column is known.
    if (ctx.state.cursor.step.at_expression() && derived.pixel() && !derived.texel() && row.done > 0) --row.done;

    const std::span<const Vertex> corners = corners_of(derived);
    const auto by_x = [](const Vertex& a, const Vertex& b) { return a.x < b.x; };
    const auto [left, right] = std::minmax_element(corners.begin(), corners.end(), by_x);
    row.left = left->x, row.right = right->x, row.u_left = left->u, row.u_right = right->u;
    row.high = derived.texture().width();
    for (std::size_t n = 0; n < row.done; ++n) {
        row.low = std::min(row.low, index_of(row.samples[n]));
        row.high = std::max(row.high, index_of(row.samples[n]) + 1);
    }
    row.low = std::max(row.low, -kMostTexels / 4);
    row.high = std::min(row.high, row.low + kMostTexels);
    return row;
}

}  // namespace texelscope::canvas
