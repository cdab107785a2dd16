#include "core/geometry/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

namespace texelscope {
namespace {

using Points = std::vector<glm::dvec3>;

constexpr double kTurn = glm::two_pi<double>();

/// (x, y, z) with each sign of each coordinate that is not 0, and with the coordinates moved round if `cyclic`.
void add_signed(Points& points, const glm::dvec3& point, bool cyclic) {
    for (int round = 0; round < (cyclic ? 3 : 1); ++round) {
        for (int signs = 0; signs < 8; ++signs) {
            glm::dvec3 p = round == 0   ? point
                           : round == 1 ? glm::dvec3(point.z, point.x, point.y)
                                        : glm::dvec3(point.y, point.z, point.x);
            bool once = true;
            for (int axis = 0; axis < 3; ++axis) {
                if ((signs >> axis & 1) == 0) continue;
                once = once && p[axis] != 0;
                p[axis] = -p[axis];
            }
            if (once) points.push_back(p);
        }
    }
}

/// The corners of an icosahedron, which are the middles of a dodecahedron's faces.
Points twelve() {
    Points points;
    add_signed(points, {0, 1, glm::golden_ratio<double>()}, true);
    return points;
}

/// The corners of a dodecahedron, which are the middles of an icosahedron's faces.
Points twenty() {
    Points points;
    add_signed(points, {1, 1, 1}, false);
    add_signed(points, {0, glm::golden_ratio<double>(), 1 / glm::golden_ratio<double>()}, true);
    return points;
}

/// The ring of the corners that lie farthest along `normal`, clockwise as seen from outside; the first is at the top,
/// or the left one of two.
MeshFace farthest(const Points& corners, const glm::dvec3& normal) {
    const glm::dvec3 out = glm::normalize(normal);
    const bool lies = std::fabs(out.y) > 1 - 1e-9;
    const glm::dvec3 top = lies ? glm::dvec3(0, 0, out.y) : glm::dvec3(0, 1, 0);
    const glm::dvec3 up = glm::normalize(top - out * glm::dot(out, top)), right = glm::cross(out, up);
    double most = 0;
    for (const glm::dvec3& corner : corners) most = std::max(most, glm::dot(corner, out));
    std::vector<std::pair<double, int>> ring;  // angle from the top, corner
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (glm::dot(corners[i], out) > most - 1e-6)
            ring.emplace_back(std::atan2(glm::dot(corners[i], right), glm::dot(corners[i], up)), i);
    const double half_step = kTurn / 2 / static_cast<double>(ring.size());
    for (auto& [angle, corner] : ring)
        if (angle < -half_step - 1e-6) angle += kTurn;
    std::sort(ring.begin(), ring.end());
    MeshFace face;
    for (const auto& [angle, corner] : ring)
        face.push_back({corner, polygon_uv(static_cast<int>(face.size()), static_cast<int>(ring.size()))});
    return face;
}

Mesh solid(Points corners, const Points& normals) {
    Mesh mesh;
    for (const glm::dvec3& normal : normals) mesh.faces.push_back(farthest(corners, normal));
    mesh.vertices = std::move(corners);
    return mesh;
}

Points at_distance_1(Points points) {
    for (glm::dvec3& point : points) point = glm::normalize(point);
    return points;
}

}  // namespace

glm::dvec2 polygon_uv(int i, int corners) {
    constexpr std::array<glm::dvec2, 4> kSquare{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    if (corners == 4) return kSquare[static_cast<std::size_t>(i)];
    const double angle = kTurn * i / corners;
    return {0.5 + 0.5 * std::sin(angle), 0.5 - 0.5 * std::cos(angle)};
}

Mesh cube() {
    Points corners;
    add_signed(corners, {1, 1, 1}, false);
    return solid(std::move(corners), {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
}

Mesh dodecahedron() { return solid(at_distance_1(twenty()), twelve()); }

Mesh icosahedron() { return solid(at_distance_1(twelve()), twenty()); }

Mesh torus() {
    Mesh mesh;
    for (int j = 0; j < kTorusRings; ++j) {
        const double turn = kTurn * j / kTorusRings;
        for (int i = 0; i < kTorusRing; ++i) {
            const double angle = kTurn * i / kTorusRing, x = 1.5 + 0.5 * std::cos(angle);
            mesh.vertices.emplace_back(x * std::cos(turn), 0.5 * std::sin(angle), -x * std::sin(turn));
        }
    }
    for (int i = 0; i < kTorusRing; ++i) {
        for (int j = 0; j < kTorusRings; ++j) {
            const int next_i = (i + 1) % kTorusRing, ring = j * kTorusRing;
            const int next_ring = (j + 1) % kTorusRings * kTorusRing;
            // The source's a, b, c, d, the other way round: clockwise as seen from outside.
            mesh.faces.push_back(
                {{next_i + ring, {0, 1}}, {i + ring, {0, 0}}, {i + next_ring, {1, 0}}, {next_i + next_ring, {1, 1}}});
        }
    }
    return mesh;
}

}  // namespace texelscope
