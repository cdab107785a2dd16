#include "core/geometry/solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <utility>

namespace texelscope::solids_test {
namespace {

struct Named {
    std::string name;
    Mesh mesh;
    int vertices, faces, corners;  // of the mesh, of the mesh, of a face
    double reach;                  // of a corner from the middle; 0 where it differs
};

std::vector<Named> solids() {
    return {{"cube", cube(), 8, 6, 4, std::sqrt(3.0)},
            {"dodecahedron", dodecahedron(), 20, 12, 5, 1},
            {"icosahedron", icosahedron(), 12, 20, 3, 1},
            {"torus", torus(), 91, 91, 4, 0}};
}

const glm::dvec3& at(const Mesh& mesh, const FaceCorner& corner) {
    return mesh.vertices[static_cast<std::size_t>(corner.vertex)];
}

/// How often each directed side is there.
std::map<std::pair<int, int>, int> sides(const Mesh& mesh) {
    std::map<std::pair<int, int>, int> count;
    for (const MeshFace& face : mesh.faces)
        for (std::size_t i = 0; i < face.size(); ++i) ++count[{face[i].vertex, face[(i + 1) % face.size()].vertex}];
    return count;
}

TEST(Solids, HaveTheirNumberOfCornersAndFaces) {
    for (const Named& solid : solids()) {
        SCOPED_TRACE(solid.name);
        EXPECT_EQ(solid.mesh.vertices.size(), static_cast<std::size_t>(solid.vertices));
        ASSERT_EQ(solid.mesh.faces.size(), static_cast<std::size_t>(solid.faces));
        for (const MeshFace& face : solid.mesh.faces) EXPECT_EQ(face.size(), static_cast<std::size_t>(solid.corners));
        if (solid.reach > 0) {
            for (const glm::dvec3& vertex : solid.mesh.vertices) EXPECT_NEAR(glm::length(vertex), solid.reach, 1e-15);
        }
    }
}

TEST(Solids, AreClosedAndEulersFormulaHolds) {
    for (const Named& solid : solids()) {
        SCOPED_TRACE(solid.name);
        const auto count = sides(solid.mesh);
        for (const auto& [side, times] : count) {
            EXPECT_EQ(times, 1);
            EXPECT_EQ(count.count({side.second, side.first}), 1U) << side.first << " to " << side.second;
        }
        const int edges = static_cast<int>(count.size()) / 2;
        EXPECT_EQ(solid.vertices - edges + solid.faces, solid.name == "torus" ? 0 : 2);
    }
}

TEST(Solids, FacesAreFlatAndPointOutwards) {
    for (const Named& solid : solids()) {
        SCOPED_TRACE(solid.name);
        for (const MeshFace& face : solid.mesh.faces) {
            const glm::dvec3 normal = glm::normalize(area_vector(solid.mesh.vertices, face));
            const glm::dvec3 centre = middle(solid.mesh.vertices, face);
            for (const FaceCorner& corner : face)
                EXPECT_NEAR(glm::dot(at(solid.mesh, corner) - centre, normal), 0, 1e-15);
            const glm::dvec3 from =
                solid.name == "torus" ? glm::normalize(glm::dvec3(centre.x, 0, centre.z)) * 1.5 : glm::dvec3(0);
            EXPECT_GT(glm::dot(normal, glm::normalize(centre - from)), 0.9);
        }
    }
}

TEST(Solids, SidesOfPlatosAreEqual) {
    for (const Named& solid : solids()) {
        if (solid.name == "torus") continue;
        SCOPED_TRACE(solid.name);
        const auto& first = solid.mesh.faces[0];
        const double length = glm::length(at(solid.mesh, first[1]) - at(solid.mesh, first[0]));
        for (const auto& [side, times] : sides(solid.mesh))
            EXPECT_NEAR(glm::length(solid.mesh.vertices[static_cast<std::size_t>(side.first)] -
                                    solid.mesh.vertices[static_cast<std::size_t>(side.second)]),
                        length, 1e-14);
    }
}

/// Lengths on the texture are those on the face times one factor, and a face is not mirrored.
TEST(Solids, TexturesOfPlatosAreNotDistorted) {
    for (const Named& solid : solids()) {
        if (solid.name == "torus") continue;
        SCOPED_TRACE(solid.name);
        for (const MeshFace& face : solid.mesh.faces) {
            const double factor =
                glm::length(face[1].uv - face[0].uv) / glm::length(at(solid.mesh, face[1]) - at(solid.mesh, face[0]));
            double area = 0;
            for (std::size_t i = 0; i < face.size(); ++i) {
                const glm::dvec2 &p = face[i].uv, &q = face[(i + 1) % face.size()].uv;
                area += p.x * q.y - q.x * p.y;
                for (const double c : {p.x, p.y}) EXPECT_TRUE(c >= 0 && c <= 1) << c;
                for (const FaceCorner& other : face)
                    EXPECT_NEAR(glm::length(other.uv - p),
                                factor * glm::length(at(solid.mesh, other) - at(solid.mesh, face[i])), 1e-14);
            }
            EXPECT_GT(area, 0);  // clockwise with v down, as the ring is seen from outside
        }
    }
}

TEST(Solids, CubesFacesLookAlongTheirAxesAndStandUpright) {
    const Mesh mesh = cube();
    for (int n = 0; n < 6; ++n) {
        const MeshFace& face = mesh.faces[static_cast<std::size_t>(n)];
        glm::dvec3 normal(0);
        normal[n / 2] = n % 2 == 0 ? 1 : -1;
        EXPECT_EQ(middle(mesh.vertices, face), normal);
        for (const FaceCorner& corner : face) {
            if (normal.y == 0) {
                EXPECT_EQ(corner.uv.y, at(mesh, corner).y > 0 ? 0 : 1);
            }
        }
    }
    const MeshFace& front = mesh.faces[5];  // seen by the viewer: its left is the texture's
    for (const FaceCorner& corner : front) EXPECT_EQ(corner.uv.x, at(mesh, corner).x < 0 ? 0 : 1);
}

TEST(Solids, TorusIsThePublishedOne) {
    const Mesh mesh = torus();
    for (int j = 0; j < 13; ++j) {
        for (int i = 0; i < 7; ++i) {
            const double a = 2 * 3.14159265358979323846 * i / 7, t = 2 * 3.14159265358979323846 * j / 13;
            const glm::dvec3 p(1.5 + 0.5 * std::cos(a), 0.5 * std::sin(a), 0);
            const glm::dvec3 turned(p.x * std::cos(t) + p.z * std::sin(t), p.y, p.z * std::cos(t) - p.x * std::sin(t));
            EXPECT_NEAR(glm::length(mesh.vertices[static_cast<std::size_t>(i + j * 7)] - turned), 0, 1e-15);
            const std::map<int, glm::dvec2> uvs{{(i + 1) % 7 + j * 7, {0, 1}},
                                                {(i + 1) % 7 + (j + 1) % 13 * 7, {1, 1}},
                                                {i + (j + 1) % 13 * 7, {1, 0}},
                                                {i + j * 7, {0, 0}}};
            const MeshFace& face = mesh.faces[static_cast<std::size_t>(i * 13 + j)];
            for (const FaceCorner& corner : face) EXPECT_EQ(uvs.at(corner.vertex), corner.uv);
        }
    }
}

}  // namespace
}  // namespace texelscope::solids_test
