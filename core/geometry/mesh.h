// Solids as corners and faces, and their conventions.
//   World   x right, y up, z away from the viewer; the screen is x = w/2 + x focal / z, y = h/2 - y focal / z.
//   Outside a face's ring is such that the cross product of two sides that follow each other points outwards. Seen from
//           outside it is a front face on the screen (core/conventions.h).
//   Texture (0, 0) is the texture's top left, (1, 1) its bottom right.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace texelscope {

inline constexpr int kMaxMeshFaces = 1'000'000;     ///< of one mesh, and of all meshes of a scene together
inline constexpr int kMaxMeshCorners = 4'000'000;   ///< of the faces of one mesh, and of a scene's together
inline constexpr int kMaxMeshVertices = 1'000'000;  ///< of one mesh
inline constexpr double kMaxCoordinate = 1e9;       ///< of a vertex, either way

struct FaceCorner {
    int vertex = 0;    ///< index into Mesh::vertices
    glm::dvec2 uv{0};  ///< on the texture, 1 = its whole width or height
    friend bool operator==(const FaceCorner&, const FaceCorner&) = default;
};

/// A convex polygon: a ring of three or more corners.
using MeshFace = std::vector<FaceCorner>;

struct Mesh {
    std::vector<glm::dvec3> vertices;
    std::vector<MeshFace> faces;
    friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// Points outwards; its length is twice the face's area. Where the face is not flat, a mean over its ring.
[[nodiscard]] glm::dvec3 area_vector(std::span<const glm::dvec3> vertices, const MeshFace& face);

/// The mean of the face's corners.
[[nodiscard]] glm::dvec3 middle(std::span<const glm::dvec3> vertices, const MeshFace& face);

}  // namespace texelscope
