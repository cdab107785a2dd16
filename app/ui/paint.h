// Shapes that ImDrawList lacks: dashes, hatching, crisp rings, arrows, the marks of the edges, icons.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/ui/geometry.h"
#include "app/ui/theme.h"

namespace texelscope::ui {

struct Segment {
    glm::vec2 from{0}, to{0};
};

/// Lengths of strokes and gaps in turn, beginning with a stroke [px]. Empty is a solid line.
using DashPattern = std::span<const float>;
/// The line of edge A, B or C: solid, dashes, dots.
[[nodiscard]] DashPattern edge_pattern(int edge);

/// The strokes of a line from `path[0]`, from where the pattern's phase counts: moving the far end moves no stroke.
/// Patterns whose period is under half a pixel, and lines of over 10,000 strokes, come out solid.
[[nodiscard]] std::vector<Segment> dashes(std::span<const glm::vec2> path, DashPattern pattern);
void draw_dashed(ImDrawList& list, std::span<const glm::vec2> path, DashPattern pattern, float width, Color color);

/// The part of `s` inside a convex polygon of either winding (Cyrus and Beck 1978); none where they do not meet.
[[nodiscard]] std::optional<Segment> clipped(Segment s, std::span<const glm::vec2> convex);
/// `convex` cut by the half-plane where dot(normal, p) <= offset; the result is convex, empty where nothing is left.
[[nodiscard]] std::vector<glm::vec2> clipped_to_half_plane(std::span<const glm::vec2> convex, glm::vec2 normal,
                                                           float offset);

/// Parallel lines `step` apart in the direction `degrees` (from +x towards +y), one of which passes `origin`.
[[nodiscard]] std::vector<Segment> hatch(std::span<const glm::vec2> convex, float degrees, float step,
                                         glm::vec2 origin);
void draw_hatch(ImDrawList& list, std::span<const glm::vec2> convex, float degrees, float step, glm::vec2 origin,
                float width, Color color);
/// Direction of a section's hatch; `section` counts from 0.
[[nodiscard]] float section_degrees(int section);

/// Convex polygon of either winding, anti-aliased.
void fill_convex(ImDrawList& list, std::span<const glm::vec2> convex, Color color);

void fill(ImDrawList& list, const Area& area, Color color, float radius = 0);
/// A border inside `area`. With no radius four filled rectangles at whole pixels, never blurred.
void frame(ImDrawList& list, const Area& area, Color color, float width = 1, float radius = 0);
/// A `now` ring around a pixel: an outline of `outline_px` inside the ring of `width`, both outside `pixel`.
void pixel_ring(ImDrawList& list, const Area& pixel, Color now, Color outline, float width, float outline_px = 1.5F);

void line(ImDrawList& list, glm::vec2 from, glm::vec2 to, float width, Color color);
void arrow(ImDrawList& list, glm::vec2 from, glm::vec2 to, float width, Color color, float head = 8);
/// Ring with a dot, over a disc of `ground`.
void vertex_ring(ImDrawList& list, glm::vec2 centre, float radius, Color color, Color ground);
/// The mark of edge A (dot), B (square) or C (triangle); `radius` is half its width.
void edge_mark(ImDrawList& list, int edge, glm::vec2 centre, float radius, Color color);
/// A small x: a rejected sample.
void cross(ImDrawList& list, glm::vec2 centre, float radius, float width, Color color);

/// A picture of a command, drawn from shapes.
enum class Icon : std::uint8_t { first, previous, play, pause, next, last, tick, arrow_right, chevron, close };
void draw_icon(ImDrawList& list, Icon icon, const Area& area, Color color);

}  // namespace texelscope::ui
