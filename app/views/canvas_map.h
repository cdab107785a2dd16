// Where scene pixels lie on the canvas: zoom, panning, the part in view, and the rulers' steps. Pure arithmetic.
#pragma once

#include <glm/vec2.hpp>

#include "app/state/state.h"
#include "app/ui/geometry.h"
#include "core/trace/trace.h"

namespace texelscope::canvas {

/// Scene pixels in the window. Pixel borders lie on whole window pixels wherever a pixel is at least one wide.
struct CanvasMap {
    ui::Area area;         ///< where pixels may show
    double zoom = 1;       ///< window pixels per scene pixel: a whole number, or one over a whole number
    glm::ivec2 origin{0};  ///< the framebuffer's first pixel
    glm::dvec2 at{0};      ///< the window place of that pixel's top left corner, whole

    [[nodiscard]] glm::vec2 to_window(glm::dvec2 scene) const { return at + (scene - glm::dvec2(origin)) * zoom; }
    [[nodiscard]] glm::dvec2 to_scene(glm::vec2 window) const {
        return glm::dvec2(origin) + (glm::dvec2(window) - at) / zoom;
    }
    [[nodiscard]] glm::ivec2 pixel_at(glm::vec2 window) const;
    [[nodiscard]] ui::Area place_of(const Rect& pixels) const;
    [[nodiscard]] ui::Area place_of(glm::ivec2 pixel) const {
        return place_of(Rect{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1});
    }
};

/// The greatest zoom at which the whole framebuffer fits into `area`.
[[nodiscard]] double fit_zoom(const ui::Area& area, const Framebuffer& frame);
[[nodiscard]] CanvasMap make_map(const ui::Area& area, const Framebuffer& frame, const Look& look);

/// `look` zoomed by wheel `notches` so that the scene point under `mouse` stays there.
[[nodiscard]] Look zoomed(const Look& look, const CanvasMap& map, const Framebuffer& frame, glm::vec2 mouse,
                          float notches);
/// `look` with the scene moved by `by` window pixels.
[[nodiscard]] Look panned(const Look& look, const CanvasMap& map, glm::vec2 by);

/// The framebuffer's pixels that are in view; empty where none is.
[[nodiscard]] Rect pixels_in_view(const CanvasMap& map, const Framebuffer& frame);
/// What to ask Derived::canvas for. Small framebuffers are asked for whole, so that panning computes nothing.
[[nodiscard]] Window window_in_view(const CanvasMap& map, const Framebuffer& frame);

/// The least power of two, in scene pixels, that is at least `least` window pixels wide.
[[nodiscard]] int label_step(double zoom, float least);

/// Where a pixel stands in the framebuffer's array, counted in pixels: row after row from the top left.
[[nodiscard]] std::int64_t address_of(const Framebuffer& frame, glm::ivec2 pixel);

/// Where a dragged corner goes: to multiples of 1/16, or to the middle of a pixel, and not out of view.
[[nodiscard]] glm::vec2 dragged_to(const CanvasMap& map, glm::vec2 mouse, bool to_centres);

}  // namespace texelscope::canvas
