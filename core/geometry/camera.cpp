#include "core/geometry/camera.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/base/assert.h"

namespace texelscope {
namespace {

/// p' = p cos + q sin, q' = q cos - p sin in the plane of axes p and q.
glm::dmat3 plane_rotation(int p, int q, double degrees) {
    const double angle = glm::radians(degrees), c = std::cos(angle), s = std::sin(angle);
    glm::dmat3 matrix(1);  // matrix[column][row]
    matrix[p][p] = c, matrix[q][p] = s;
    matrix[p][q] = -s, matrix[q][q] = c;
    return matrix;
}

glm::dmat3 axis_rotation(int axis, double degrees) {
    TEXELSCOPE_ASSERT(axis >= 0 && axis <= 2);
    return axis == 0   ? plane_rotation(1, 2, degrees)
           : axis == 1 ? plane_rotation(0, 2, degrees)
                       : plane_rotation(0, 1, degrees);
}

}  // namespace

glm::dmat3 rotation(const glm::dvec3& degrees) {
    return axis_rotation(0, degrees.x) * axis_rotation(1, degrees.y) * axis_rotation(2, degrees.z);
}

glm::dvec3 angles_of(const glm::dmat3& matrix) {
    const auto at = [&](int row, int column) { return matrix[column][row]; };
    constexpr double kUpright = 1e-9;  // the cosine of y below which x and z are one
    const double cosine = std::hypot(at(0, 0), at(0, 1));
    const double y = std::atan2(at(0, 2), cosine);
    const bool locked = cosine < kUpright;
    const double x = locked ? 0 : std::atan2(at(1, 2), at(2, 2));
    const double z = locked ? std::atan2(-at(1, 0), at(1, 1)) : std::atan2(at(0, 1), at(0, 0));
    return glm::degrees(glm::dvec3(x, y, z));
}

glm::dmat3 turned(const glm::dmat3& matrix, int axis, double degrees) {
    const glm::dmat3 product = axis_rotation(axis, degrees) * matrix;
    const glm::dvec3 x = glm::normalize(product[0]);
    const glm::dvec3 y = glm::normalize(product[1] - x * glm::dot(x, product[1]));
    return {x, y, glm::cross(x, y)};
}

glm::dvec4 to_clip(const Viewpoint& view, const glm::dvec3& point) {
    return {point.x * view.focal, -point.y * view.focal, point.z - view.near, point.z};
}

ClipStage clip_near(const Viewpoint& view, std::span<const ClipVertex> ring) {
    ClipStage stage = clip(ring, {0, 0, 1, 0});
    for (ClipVertex& vertex : stage.inside)
        if (vertex.is_cut()) vertex.position.z = 0, vertex.position.w = view.near;
    return stage;
}

glm::dvec2 place_on_screen(const Viewpoint& view, const glm::dvec4& position) {
    TEXELSCOPE_ASSERT(position.w > 0);
    return {view.middle_x + position.x / position.w, view.middle_y + position.y / position.w};
}

Vertex to_screen(const Viewpoint& view, const glm::dvec4& position) {
    const glm::dvec2 place = place_on_screen(view, position);
    return {.x = static_cast<float>(place.x),
            .y = static_cast<float>(place.y),
            .z = static_cast<float>(std::clamp(position.z / position.w, 0.0, 1.0)),
            .w = static_cast<float>(position.w)};
}

}  // namespace texelscope
