// From the world to the screen, in double: rotations, projection, and the cut at the near plane.
// Source: S1, as published (rotation, projection).
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "core/geometry/clip.h"
#include "core/geometry/vertex.h"

namespace texelscope {

/// First in the plane xy by degrees.z (x' = x cos a + y sin a, y' = y cos a - x sin a), then xz by degrees.y, then yz
/// by degrees.x, each alike. Requires finite angles.
[[nodiscard]] glm::dmat3 rotation(const glm::dvec3& degrees);

/// The angles that rotation() makes `matrix` of: x and z in [-180, 180], y in [-90, 90]. Where y is -90 or 90, so that
/// x and z turn about the same axis, x is 0. Requires a rotation.
[[nodiscard]] glm::dvec3 angles_of(const glm::dmat3& matrix);

/// `matrix`, then a turn about one of the world's axes [0, 2] in the sense of rotation(). The result is orthonormal
/// again to 2e-15, however many turns came before.
[[nodiscard]] glm::dmat3 turned(const glm::dmat3& matrix, int axis, double degrees);

/// Where the picture is, and from where it is seen.
struct Viewpoint {
    double middle_x = 0, middle_y = 0;  ///< the screen position of the view axis [px]
    double focal = 1;                   ///< the eye's distance from the screen [px]
    double near = 1;                    ///< the least z that is seen, above 0
};

/// Clip space: (x focal, -y focal, z - near, z). Divided by w = z: the screen position from the middle, and the depth
/// 1 - near / z, which is 0 at the near plane, 1 at infinity, and affine over the screen.
[[nodiscard]] glm::dvec4 to_clip(const Viewpoint& view, const glm::dvec3& point);

/// The ring's part with z >= near, in clip space. A cut has exactly z = 0 and w = near, so that no w is 0 or less.
[[nodiscard]] ClipStage clip_near(const Viewpoint& view, std::span<const ClipVertex> ring);

/// The place on the screen [px]. Requires position.w > 0.
[[nodiscard]] glm::dvec2 place_on_screen(const Viewpoint& view, const glm::dvec4& position);

/// The corner on the screen, rounded to float32; u and v are left 0. Requires position.w > 0.
[[nodiscard]] Vertex to_screen(const Viewpoint& view, const glm::dvec4& position);

}  // namespace texelscope
