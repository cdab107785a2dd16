// What can be said about a polygon without drawing it.
#pragma once

#include <span>
#include <string>

#include "core/geometry/vertex.h"

namespace texelscope {

/// All six numbers of the corner are finite.
[[nodiscard]] bool is_finite(const Vertex& vertex) noexcept;
/// They are, and w > 0.
[[nodiscard]] bool is_drawable(const Vertex& vertex) noexcept;

/// Why the polygon draws nothing, or an empty text if it can be drawn: fewer than three corners, a number that is not
/// finite, or w <= 0. Every drawing loop skips a polygon that has a fault.
[[nodiscard]] std::string polygon_fault(const Polygon& polygon);

/// polygon_fault is empty, without making the text.
[[nodiscard]] bool is_drawable(const Polygon& polygon) noexcept;

/// Twice the area on the screen [px^2], positive for a front face (core/conventions.h); rounded as double rounds.
[[nodiscard]] double doubled_area(std::span<const Vertex> corners) noexcept;

/// The ring turns one way only and goes round once. Repeated corners and corners on a straight side are fine, and so
/// is a bend that double cannot tell from straight. Requires finite corners.
[[nodiscard]] bool is_convex(std::span<const Vertex> corners) noexcept;

}  // namespace texelscope
