// How a shape lies on the screen compared with its texture: where, turned by how much, how large. What the tuning of
// lessons changes. The shape is the picture of its texels under a similarity: (x, y) = centre + scale R (uv - middle).
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/geometry/vertex.h"

namespace texelscope {

struct Pose {
    glm::dvec2 centre{0};  ///< mean of the corners [px]
    double degrees = 0;    ///< clockwise on the screen, (-180, 180]
    double scale = 1;      ///< pixels a texel, at least 1e-3
    friend bool operator==(const Pose&, const Pose&) = default;
};

/// Turn and scale are those of the first side. A shape that no similarity makes has a pose, too.
[[nodiscard]] Pose pose_of(std::span<const Vertex> corners);
/// The corners on the screen in that pose [px], one for each of `corners`.
[[nodiscard]] std::vector<glm::vec2> posed(std::span<const Vertex> corners, const Pose& pose);

}  // namespace texelscope
