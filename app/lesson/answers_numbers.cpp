#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"

namespace texelscope::answers {
namespace {

constexpr int kMostCompared = 1 << 11;  ///< pixels of a shape's box: exact numbers are slow
constexpr double kOnePixel = 0.04;      ///< weights so near are those of the same place, to the eye

using Texels = std::map<std::pair<Integer, Integer>, glm::ivec2>;  ///< by pixel

/// Of a shape with more pixels only the upper rows.
[[nodiscard]] Texels texels_of(const Drawing& drawing, int shape) {
    Texels texels;
    Rect rect = drawing.reach(shape);
    rect.y1 = std::min(rect.y1, rect.y0 + std::max(1, kMostCompared / std::max(1, rect.width())));
    each_sample(drawing, shape, shape + 1, {rect, 1}, [&](int, const Sample& s) {
        if (s.fate == Fate::written) texels.insert_or_assign({s.x, s.y}, glm::ivec2(s.column, s.row));
    });
    return texels;
}

/// The scene as it would stand with its frame's first column at `left`.
[[nodiscard]] Scene moved_to(Scene scene, int left) {
    const int by = left - scene.framebuffer.origin_x;
    scene.framebuffer.origin_x = left;
    for (Polygon& polygon : scene.polygons)
        for (Vertex& vertex : polygon.vertices) vertex.x += static_cast<float>(by);
    return scene;
}

/// Pixels of the shape whose texel is another than in exact numbers.
[[nodiscard]] int flips(const Scene& scene, const DrawSettings& settings, int shape) {
    DrawSettings exact = settings;
    exact.format = NumberFormat::exact;
    const Texels is = texels_of(Drawing(scene, settings), shape), meant = texels_of(Drawing(scene, exact), shape);
    return static_cast<int>(std::count_if(is.begin(), is.end(), [&](const auto& entry) {
        const auto same = meant.find(entry.first);
        return same != meant.end() && same->second != entry.second;
    }));
}

}  // namespace

Accepted double_row(const Asked& asked) {
    const int shape = asked.shape();
    Accepted a{.step = asked.step, .sentence = "No row is drawn twice."};
    if (shape < 0) return a;
    const Drawing drawing(asked.drawing.scene(), with_quirks(asked.drawing, asked.call.quirks));
    std::map<std::pair<Integer, Integer>, int> writes;
    each_sample(drawing, shape, shape + 1, {drawing.scene().framebuffer.rect(), 1}, [&](int, const Sample& s) {
        writes[{s.y, s.x}] += s.fate == Fate::written ? 1 : 0;
    });
    const auto twice = std::find_if(writes.begin(), writes.end(), [](const auto& entry) { return entry.second > 1; });
    if (twice == writes.end()) return a;
    const auto [y, x] = twice->first;
    a.number = static_cast<double>(y);
    a.sentence = fmt::format("The upper half ends with row {}, and the lower one begins with it.", y);
    if (const auto step = pixel_step(asked.steps, shape, x, y)) a.step = step->prefix(3);
    return a;
}

Accepted first_flip(const Asked& asked) {
    constexpr int kNone = 4;
    Accepted a{.options = {kNone}, .step = asked.step, .sentence = "At none of them: all texels are the exact ones."};
    const int shape = asked.shape();
    if (shape < 0) return a;
    const DrawSettings settings = with_quirks(asked.drawing, asked.call.quirks);
    for (int n = 0; n < kNone; ++n) {
        const int left = asked.whole(static_cast<std::size_t>(n));
        const int wrong = flips(moved_to(asked.drawing.scene(), left), settings, shape);
        if (wrong == 0) continue;
        a.options = {n};
        a.sentence =
            fmt::format("From {} px on: {} {} wrong there.", left, wrong, wrong == 1 ? "texel is" : "texels are");
        break;
    }
    return a;
}

Accepted weights_at(const Asked& asked) {
    Accepted a{.step = asked.step, .sentence = "No pixel of the shape has them."};
    const int shape = asked.shape();
    if (shape < 0) return a;
    // Corners that are (1, 0), (0, 1) and (0, 0) on the texture: there u and v are the weights themselves.
    Scene scene = asked.drawing.scene();
    auto& vertices = scene.polygons[static_cast<std::size_t>(asked.drawing.polygon_of(shape))].vertices;
    for (int n = 0; n < 3; ++n) {
        Vertex& vertex = vertices[static_cast<std::size_t>(asked.drawing.vertex_of(shape, n))];
        vertex.u = n == 0 ? 1 : 0, vertex.v = n == 1 ? 1 : 0, vertex.w = 1;
    }
    DrawSettings settings = asked.drawing.settings();
    settings.format = NumberFormat::f64;
    const Drawing weights(scene, settings);
    const std::array<double, 3> wanted{asked.call.numbers[0], asked.call.numbers[1], asked.call.numbers[2]};
    double nearest = 2;
    Sample best;
    const auto off = [&](const Sample& s) {
        return std::max({std::abs(s.u - wanted[0]), std::abs(s.v - wanted[1]), std::abs(1 - s.u - s.v - wanted[2])});
    };
    each_sample(weights, shape, shape + 1, {scene.framebuffer.rect(), 1}, [&](int, const Sample& s) {
        if (s.fate != Fate::written || !(off(s) < nearest)) return;
        nearest = off(s), best = s;
    });
    if (nearest > 1) return a;
    each_sample(weights, shape, shape + 1, {scene.framebuffer.rect(), 1}, [&](int, const Sample& s) {
        if (s.fate == Fate::written && off(s) <= std::max(nearest, kOnePixel)) a.places.emplace_back(s.x, s.y);
    });
    if (const auto step = pixel_step(asked.steps, shape, best.x, best.y)) a.step = *step;
    a.sentence =
        fmt::format("Pixel ({}, {}) comes nearest: ${}$, ${}$, ${}$.", best.x, best.y, equation("e_0", best.u, 2),
                    equation("e_1", best.v, 2), equation("e_2", 1 - best.u - best.v, 2));
    return a;
}

}  // namespace texelscope::answers
