#include "app/views/canvas_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "core/conventions.h"

namespace texelscope::canvas {
namespace {

constexpr std::array<double, 21> kLevels{1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 30, 32, 40, 48, 64, 80, 96, 112, 128};
constexpr double kNotch = 1.19;  ///< of the wheel; the levels lie about this far apart
constexpr double kFurthestOut = 1.0 / 64;
constexpr int kKeptWhole = 128 * 128;   ///< framebuffers of at most so many pixels are asked for whole
constexpr double kCanvasMapSteps = 16;  ///< of a dragged corner, to a pixel

/// The nearest zoom that keeps pixels crisp.
[[nodiscard]] double crisp(double zoom) {
    if (zoom < 1) return 1 / std::round(1 / std::max(zoom, kFurthestOut));
    const auto nearer = [zoom](double a, double b) {
        return std::abs(std::log(a / zoom)) < std::abs(std::log(b / zoom));
    };
    return *std::min_element(kLevels.begin(), kLevels.end(), nearer);
}

[[nodiscard]] glm::dvec2 middle(const ui::Area& area) { return {area.x + area.w / 2, area.y + area.h / 2}; }

[[nodiscard]] int bounded(double value, int low, int high) {
    return static_cast<int>(std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

}  // namespace

glm::ivec2 CanvasMap::pixel_at(glm::vec2 window) const {
    const glm::dvec2 p = glm::floor(to_scene(window));
    return {bounded(p.x, -(1 << 30), 1 << 30), bounded(p.y, -(1 << 30), 1 << 30)};
}

ui::Area CanvasMap::place_of(const Rect& pixels) const {
    const glm::vec2 a = glm::round(to_window({pixels.x0, pixels.y0})),
                    b = glm::round(to_window({pixels.x1, pixels.y1}));
    return {a.x, a.y, b.x - a.x, b.y - a.y};
}

double fit_zoom(const ui::Area& area, const Framebuffer& frame) {
    const double zoom = std::min(double{area.w} / std::max(1, frame.width), double{area.h} / std::max(1, frame.height));
    if (zoom >= 1) return std::floor(zoom);
    return 1 / std::ceil(1 / std::max(zoom, 1e-4));
}

CanvasMap make_map(const ui::Area& area, const Framebuffer& frame, const Look& look) {
    const bool fit = !(look.zoom > 0);
    CanvasMap map{.area = area, .zoom = fit ? fit_zoom(area, frame) : crisp(double{look.zoom})};
    map.origin = {frame.origin_x, frame.origin_y};
    const glm::dvec2 half = glm::dvec2(frame.width, frame.height) / 2.0;
    const glm::dvec2 centre = fit ? half : glm::dvec2(look.centre) - glm::dvec2(map.origin);
    map.at = glm::floor(middle(area) - centre * map.zoom + 0.5);
    return map;
}

Look zoomed(const Look& look, const CanvasMap& map, const Framebuffer& frame, glm::vec2 mouse, float notches) {
    Look next = look;
    const double least = std::max(kFurthestOut / 16, std::min(fit_zoom(map.area, frame) / 4, 1.0));
    const double before = look.zoom > 0 ? double{look.zoom} : map.zoom;
    double zoom = std::clamp(before * std::pow(kNotch, double{notches}), least, kLevels.back());
    // A whole notch always shows, however far apart the levels are here.
    for (int n = 0; n < 8 && std::abs(notches) >= 1 && crisp(zoom) == map.zoom; ++n)
        zoom = std::clamp(zoom * std::pow(kNotch, notches > 0 ? 1.0 : -1.0), least, kLevels.back());
    next.zoom = static_cast<float>(zoom);
    const glm::dvec2 fixed = map.to_scene(mouse);
    next.centre = glm::vec2(fixed + (middle(map.area) - glm::dvec2(mouse)) / crisp(zoom));
    return next;
}

Look panned(const Look& look, const CanvasMap& map, glm::vec2 by) {
    Look next = look;
    if (!(next.zoom > 0)) next.zoom = static_cast<float>(map.zoom);
    next.centre = glm::vec2(map.to_scene(glm::vec2(middle(map.area)) - by));
    return next;
}

Rect pixels_in_view(const CanvasMap& map, const Framebuffer& frame) {
    const glm::dvec2 a = glm::floor(map.to_scene({map.area.x, map.area.y}));
    const glm::dvec2 b = glm::ceil(map.to_scene({map.area.right(), map.area.bottom()}));
    const Rect all = frame.rect();
    return {bounded(a.x, all.x0, all.x1), bounded(a.y, all.y0, all.y1), bounded(b.x, all.x0, all.x1),
            bounded(b.y, all.y0, all.y1)};
}

Window window_in_view(const CanvasMap& map, const Framebuffer& frame) {
    const int stride = map.zoom >= 1 ? 1 : static_cast<int>(std::ceil(1 / map.zoom - 1e-6));
    if (stride == 1 && frame.width * frame.height <= kKeptWhole) return {frame.rect(), 1};
    Rect rect = pixels_in_view(map, frame);
    // On the stride's own grid, so that panning shows the same samples.
    rect.x0 -= (rect.x0 - frame.origin_x) % stride;
    rect.y0 -= (rect.y0 - frame.origin_y) % stride;
    return {rect, stride};
}

int label_step(double zoom, float least) {
    int step = 1;
    while (step < (1 << 28) && step * zoom < double{least}) step *= 2;
    return step;
}

std::int64_t address_of(const Framebuffer& frame, glm::ivec2 pixel) {
    return std::int64_t{pixel.y - frame.origin_y} * frame.width + (pixel.x - frame.origin_x);
}

glm::vec2 dragged_to(const CanvasMap& map, glm::vec2 mouse, bool to_centres) {
    const glm::vec2 kept =
        glm::clamp(mouse, glm::vec2(map.area.x, map.area.y), glm::vec2(map.area.right(), map.area.bottom()));
    const glm::dvec2 p = map.to_scene(kept);
    if (to_centres) return glm::floor(p) + kSample;
    return glm::floor(p * kCanvasMapSteps + 0.5) / kCanvasMapSteps;
}

}  // namespace texelscope::canvas
