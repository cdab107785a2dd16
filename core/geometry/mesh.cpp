#include "core/geometry/mesh.h"

#include <cstddef>
#include <glm/geometric.hpp>

namespace texelscope {
namespace {

const glm::dvec3& position(std::span<const glm::dvec3> vertices, const FaceCorner& corner) {
    return vertices[static_cast<std::size_t>(corner.vertex)];
}

}  // namespace

glm::dvec3 area_vector(std::span<const glm::dvec3> vertices, const MeshFace& face) {
    glm::dvec3 sum(0);
    if (face.empty()) return sum;
    const glm::dvec3 first = position(vertices, face[0]);  // sides as seen from a corner: small numbers round less
    for (std::size_t i = 2; i < face.size(); ++i)
        sum += glm::cross(position(vertices, face[i - 1]) - first, position(vertices, face[i]) - first);
    return sum;
}

glm::dvec3 middle(std::span<const glm::dvec3> vertices, const MeshFace& face) {
    glm::dvec3 sum(0);
    for (const FaceCorner& corner : face) sum += position(vertices, corner);
    return face.empty() ? sum : sum / static_cast<double>(face.size());
}

}  // namespace texelscope
