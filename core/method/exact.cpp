#include "core/method/exact.h"

#include <algorithm>
#include <cmath>

#include "core/method/run.h"
#include "core/method/shortcut.h"

namespace texelscope {
namespace {

[[nodiscard]] std::span<const Vertex, 3> three(const Job& job) { return job.corners.first<3>(); }

/// An index as the definition's floor leaves it, which saturates.
[[nodiscard]] Integer saturated(Integer index) {
    constexpr auto kEnd = static_cast<Integer>(kIntegerLimit);
    return std::clamp(index, -kEnd, kEnd);
}

/// Calls put(x, y, colour of the texel) for each sample of the part that the triangle owns.
void each_texel(const Job& job, const Window& part, auto&& put) {
    const Texture& texture = *job.texture;
    const Rect box = intersection(exact_box(job), part.rect);
    if (box.empty()) return;
    const auto first = [&](int low, int from) {
        return low + (from - low + part.stride - 1) / part.stride * part.stride;
    };
    const ExactTriangle triangle(three(job));
    for (int y = first(part.rect.y0, box.y0); y < box.y1; y += part.stride) {
        const PixelRange row = triangle.row(y, box.x0, box.x1);
        for (int x = first(part.rect.x0, static_cast<int>(row.x0)); x < row.x1; x += part.stride) {
            const TexelIndex texel = triangle.texel(x, y);
            put(x, y,
                texture.texels.at(wrap_index(saturated(texel.u), texture.width(), texture.wrap),
                                  wrap_index(saturated(texel.v), texture.height(), texture.wrap)));
        }
    }
}

[[nodiscard]] const Method& definition() {
    static const Method& method = *find_method(kDefinition);
    return method;
}
[[nodiscard]] Job without_quirks(Job job) {
    job.quirks = 0;
    return job;
}

Fate render(NumberFormat, const Job& job, Image& picture) { return render_exactly(job, picture); }
Fate paint(NumberFormat, const Job& job, const Window& part, int shape, Layer& layer) {
    return paint_exactly(job, part, shape, layer);
}

constexpr Method kMethod = shown_by_definition({.id = "exact", .title = "Exact", .render = render, .paint = paint});
const RegisterMethod kRegistered(kMethod);
constexpr Shortcut kShortcut{&kMethod, kDefinition};
const RegisterShortcut kRegisteredShortcut(kShortcut);

}  // namespace

int winding_of(std::span<const Vertex, 3> corners) {
    const auto &p = corners[0], &q = corners[1], &r = corners[2];
    const double bx = double{q.x} - p.x, by = double{q.y} - p.y, cx = double{r.x} - p.x, cy = double{r.y} - p.y;
    const double one = bx * cy, other = cx * by, area = one - other;
    // Differences and products are within 2^-53 of themselves and none underflows: four roundings a product, one more.
    if (std::abs(area) > 0x1p-50 * (std::abs(one) + std::abs(other))) return area > 0 ? 1 : -1;
    return ExactTriangle(corners).winding();
}

Fate exact_fate(const Job& job) {
    const int winding = winding_of(three(job));
    if (winding == 0) return Fate::zero_area;
    if (job.cull_back && winding < 0) return Fate::culled;
    return exact_box(job).empty() ? Fate::off_screen : Fate::written;
}

Rect exact_box(const Job& job) {
    const auto p = three(job);
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    const auto within = [](double a, int low, int high) {
        return static_cast<int>(std::clamp<double>(std::floor(a), low, high));
    };
    const Rect& frame = job.frame;
    // One less than the frame, then one more: the clamped end is still a whole number of the frame's.
    return {within(left, frame.x0, frame.x1), within(top, frame.y0, frame.y1),
            within(right, frame.x0 - 1, frame.x1 - 1) + 1, within(bottom, frame.y0 - 1, frame.y1 - 1) + 1};
}

std::array<std::uint8_t, 256> exactly_lit(const Job& job) { return run::lit_channels<double>(job); }

Fate render_exactly(const Job& job, Image& picture) {
    const Fate fate = exact_fate(job);
    if (fate != Fate::written) return fate;
    const auto lit = exactly_lit(job);
    each_texel(job, {job.frame, 1}, [&](int x, int y, const Rgb& texel) {
        picture.at(x - job.frame.x0, y - job.frame.y0) = {lit[texel.r], lit[texel.g], lit[texel.b]};
    });
    return fate;
}

Fate paint_exactly(const Job& job, const Window& part, int shape, Layer& layer) {
    const Fate fate = exact_fate(job);
    if (fate != Fate::written) return fate;
    const auto lit = exactly_lit(job);
    auto put = layer.put(shape, job.half, [](const Rgb& colour) { return colour; });
    each_texel(job, part, [&](int x, int y, const Rgb& texel) {
        put(x, y, Painted{{lit[texel.r], lit[texel.g], lit[texel.b]}});
    });
    return fate;
}

Fate samples_by_definition(NumberFormat, const Job& job, const Window& window, const Put& put) {
    return definition().samples(NumberFormat::exact, without_quirks(job), window, put);
}
LineCounts until_by_definition(NumberFormat, const Job& job, const Window& window, const Path& target, const Put& put) {
    return definition().until(NumberFormat::exact, without_quirks(job), window, target, put);
}
Visit visit_by_definition(NumberFormat, const Job& job, const Path& path) {
    return definition().visit(NumberFormat::exact, without_quirks(job), path);
}

}  // namespace texelscope
