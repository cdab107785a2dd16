// Convex polygons cut by planes; each corner of a result knows where it came from.
// Source: Sutherland and Hodgman 1974, "Reentrant polygon clipping".
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace texelscope {

/// A corner of a ring: an original one, or a cut on the side between two corners of the ring that was cut.
struct ClipVertex {
    glm::dvec4 position{0, 0, 0, 1};  ///< homogeneous
    glm::dvec2 uv{0};
    int from = -1;          ///< of the cut ring: the corner that this one is, or one end of the side it lies on
    int to = -1;            ///< the other end of that side; -1 for a corner that is no cut
    double from_share = 1;  ///< weight of `from` in the average; 1 for a corner that is no cut
    double to_share = 0;    ///< weight of `to`

    [[nodiscard]] bool is_cut() const { return to >= 0; }
};

using ClipRing = std::vector<ClipVertex>;

/// A corner whose origin is not yet known.
[[nodiscard]] inline ClipVertex clip_vertex(const glm::dvec4& position, const glm::dvec2& uv) {
    return {.position = position, .uv = uv};
}

/// One cut by one plane. `inside` and `outside` are the two parts; either may be empty. Corners on the plane belong to
/// both parts; a ring that lies wholly on the plane is all inside.
struct ClipStage {
    ClipRing ring;                  ///< what was cut
    glm::dvec4 plane{0};            ///< inside is dot(plane, position) >= 0
    std::vector<double> distances;  ///< that product for each corner of `ring`; 0 where within the thickness
    ClipRing inside, outside;
};

/// Cuts a convex ring. A cut is the average of its side's ends, weighted by the lengths on each side: with ends at
/// distances 3 and -1 the weights are 1/4 and 3/4. Its position has the same bits whichever end comes first, so that
/// faces that share a side stay watertight.
/// @param thickness  corners that are so near to the plane count as on it. Requires >= 0.
/// A distance that is not a number counts as outside, and so no part of the ring that needs it is drawn.
[[nodiscard]] ClipStage clip(std::span<const ClipVertex> ring, const glm::dvec4& plane, double thickness = 0);

/// Cuts by plane after plane: the inside of each cut is the ring of the next. Stops early where nothing is left.
/// The parts outside, and the inside of the last, are disjoint and make up the ring.
[[nodiscard]] std::vector<ClipStage> clip(std::span<const ClipVertex> ring, std::span<const glm::dvec4> planes,
                                          double thickness = 0);

}  // namespace texelscope
