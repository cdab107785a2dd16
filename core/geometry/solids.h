// The solids of the sources: three of Plato's (S2), and the torus of S1's own program.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "core/geometry/mesh.h"

namespace texelscope {

inline constexpr int kTorusRing = 7, kTorusRings = 13;  ///< corners of a ring of the torus; how many rings

/// Corners at (+-1, +-1, +-1): faces 0 to 5 look along +x, -x, +y, -y, +z, -z. A face shows the whole texture, upright
/// on the four that stand.
[[nodiscard]] Mesh cube();

/// 12 regular pentagons, corners at distance 1 from the middle.
[[nodiscard]] Mesh dodecahedron();

/// 20 regular triangles, corners at distance 1 from the middle.
[[nodiscard]] Mesh icosahedron();

/// 13 x 7 quads, radii 1.5 and 0.5, about the y axis. Face i * 13 + j lies between corners i and i + 1 of rings j and
/// j + 1, and shows the whole texture. Source: S1, as published.
[[nodiscard]] Mesh torus();

/// Where corner `i` of a regular polygon lies on a texture: the whole square for four corners, else on the largest
/// circle, so that nothing is distorted; clockwise from the top, or from the left one of the two corners at the top.
[[nodiscard]] glm::dvec2 polygon_uv(int i, int corners);

}  // namespace texelscope
