#include "core/geometry/jelly_cubes.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

#include "core/geometry/jelly_frame.h"
#include "core/geometry/solids.h"

namespace texelscope {
namespace {

constexpr double kThickness = 1e-12;  // [half-sizes of the cutting cube]
constexpr double kWeld = 1e-9;        // [half-sizes of the larger cube]

struct TurnedCube {
    double half = 1;
    glm::dmat3 turn{1};

    /// Inside is where 1 - (position . normal) / half >= 0.
    [[nodiscard]] glm::dvec4 plane(int face) const {
        glm::dvec3 normal(0);
        normal[face / 2] = face % 2 == 0 ? 1 : -1;
        return {turn * normal * (-1 / half), 1};
    }
    [[nodiscard]] std::array<glm::dvec4, 6> planes() const {
        return {plane(0), plane(1), plane(2), plane(3), plane(4), plane(5)};
    }
    [[nodiscard]] ClipRing ring(const Mesh& cube, std::size_t face) const {
        ClipRing ring;
        for (const FaceCorner& corner : cube.faces[face]) {
            const glm::dvec3& vertex = cube.vertices[static_cast<std::size_t>(corner.vertex)];
            ring.push_back(clip_vertex({turn * vertex * half, 1}, corner.uv));
        }
        return ring;
    }
};

bool lies_on_plane(const ClipStage& stage) {
    return std::all_of(stage.distances.begin(), stage.distances.end(), [](double d) { return d == 0; });
}

/// Makes one of all corners that are nearly equal.
void weld(std::vector<JellyPiece>& pieces, double distance) {
    std::vector<glm::dvec3> known;
    for (JellyPiece& piece : pieces) {
        for (ClipVertex& vertex : piece.ring) {
            glm::dvec3 place(vertex.position);
            const auto same = std::find_if(known.begin(), known.end(), [&](const glm::dvec3& other) {
                return glm::dot(place - other, place - other) <= distance * distance;
            });
            if (same != known.end())
                place = *same;
            else
                known.push_back(place);
            vertex.position = {place, 1};
        }
    }
}

}  // namespace

JellyCubes jelly_cubes(double big_half, double small_half, const glm::dmat3& big, const glm::dmat3& small,
                       bool size_twice) {
    const std::array<TurnedCube, 2> both{{{big_half, big}, {small_half, small}}};
    const Mesh mesh = cube();
    JellyCubes out;
    for (int c = 0; c < 2; ++c) {
        const auto at = static_cast<std::size_t>(c);
        const bool is_guest = (c == 1) == (small_half <= big_half);
        const double unit = cut_unit(both[at].half, both[1 - at].half, size_twice && is_guest);
        const std::array<glm::dvec4, 6> planes = TurnedCube{unit, both[1 - at].turn}.planes();
        for (int face = 0; face < 6; ++face) {
            auto& stages = out.cuts[at][static_cast<std::size_t>(face)];
            stages = clip(both[at].ring(mesh, static_cast<std::size_t>(face)), planes, kThickness);
            for (std::size_t n = 0; n < stages.size(); ++n) {
                ClipStage& stage = stages[n];
                if (c == 1 && lies_on_plane(stage)) {
                    std::swap(stage.inside, stage.outside);
                    stages.resize(n + 1);
                }
                if (!stages[n].outside.empty())
                    out.pieces.push_back({c, face, false, static_cast<int>(n), stages[n].outside});
            }
            if (!stages.back().inside.empty()) out.pieces.push_back({c, face, true, -1, stages.back().inside});
        }
    }
    weld(out.pieces, kWeld * std::max(big_half, small_half));
    return out;
}

double common_volume(const JellyCubes& cubes) {
    double sum = 0;
    for (const JellyPiece& piece : cubes.pieces) {
        if (!piece.inside) continue;
        const auto at = [&](std::size_t i) { return glm::dvec3(piece.ring[i].position); };
        for (std::size_t i = 2; i < piece.ring.size(); ++i)
            sum += glm::dot(at(0), glm::cross(at(i - 1), at(i)));  // six times a tetrahedron on the middle
    }
    return sum / 6;
}

}  // namespace texelscope
