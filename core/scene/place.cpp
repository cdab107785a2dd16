#include "core/scene/place.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "core/geometry/polygon.h"
#include "core/geometry/solids.h"

namespace texelscope {
namespace {

/// Each corner of each piece becomes a vertex: those that are one have the same bits, and so are drawn as one.
Mesh mesh_of(const JellyCubes& cubes) {
    Mesh mesh;
    for (const JellyPiece& piece : cubes.pieces) {
        MeshFace face;
        for (const ClipVertex& vertex : piece.ring) {
            face.push_back({static_cast<int>(mesh.vertices.size()), vertex.uv});
            mesh.vertices.emplace_back(vertex.position);
        }
        mesh.faces.push_back(std::move(face));
    }
    return mesh;
}

Mesh mesh_of(Shape3d shape) {
    switch (shape) {
        case Shape3d::dodecahedron: return dodecahedron();
        case Shape3d::icosahedron: return icosahedron();
        case Shape3d::torus: return torus();
        default: return cube();
    }
}

bool is_finite(const MeshPlacement& mesh) {
    for (const glm::vec3& v : {mesh.rotate, mesh.rotate2, mesh.move})
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(v[axis])) return false;
    return std::isfinite(mesh.scale) && std::isfinite(mesh.ratio) && mesh.ratio > 0 &&
           std::isfinite(mesh.light.value_or(1));
}

class Placer {
public:
    explicit Placer(Scene& scene) : scene_(scene), view_(view_of(scene)) {}

    void place(std::size_t index) {
        const MeshPlacement& placement = scene_.meshes[index];
        if (!is_finite(placement)) return;
        if (placement.shape == Shape3d::obj) {
            if (placement.model) place_mesh(index, *placement.model, rotation(placement.rotate), {});
        } else if (placement.shape == Shape3d::jelly_cubes) {
            const JellyCubes jelly = jelly_cubes_of(placement, scene_.size_twice);
            place_mesh(index, mesh_of(jelly), glm::dmat3(1), jelly.pieces);
        } else {
            place_mesh(index, mesh_of(placement.shape), rotation(placement.rotate), {});
        }
    }

    std::vector<PlacedFace> finish() && {
        if (scene_.depth == Depth::off)
            std::stable_sort(made_.begin(), made_.end(), [this](const Made& a, const Made& b) {
                return faces_[a.face].depth > faces_[b.face].depth;
            });
        for (Made& made : made_) {
            faces_[made.face].polygon = static_cast<int>(scene_.polygons.size());
            scene_.polygons.push_back(std::move(made.polygon));
        }
        return std::move(faces_);
    }

private:
    struct Made {
        Polygon polygon;
        std::size_t face = 0;  ///< index into faces_
    };

    /// @param pieces  what the faces are, if they are those of jelly cubes.
    void place_mesh(std::size_t index, const Mesh& mesh, const glm::dmat3& turn, std::span<const JellyPiece> pieces) {
        const MeshPlacement& placement = scene_.meshes[index];
        std::vector<glm::dvec3> vertices;
        vertices.reserve(mesh.vertices.size());
        for (const glm::dvec3& vertex : mesh.vertices)
            vertices.push_back(turn * (vertex * double{placement.scale}) + glm::dvec3(placement.move));
        const auto& textures = placement.textures;
        for (std::size_t n = 0; n < mesh.faces.size() && faces_.size() < kMaxMeshPolygons; ++n) {
            const std::size_t in_turn = pieces.empty() ? n : static_cast<std::size_t>(pieces[n].cube);
            place_face(index, n, vertices, mesh.faces[n], textures.empty() ? -1 : textures[in_turn % textures.size()]);
        }
    }

    void place_face(std::size_t index, std::size_t n, std::span<const glm::dvec3> vertices, const MeshFace& face,
                    int texture) {
        const MeshPlacement& placement = scene_.meshes[index];
        const glm::dvec3 area = area_vector(vertices, face);
        const double length = glm::length(area);
        PlacedFace placed{
            .mesh = static_cast<int>(index), .face = static_cast<int>(n), .n_z = length > 0 ? area.z / length : 0};
        const double light = placement.light ? double{*placement.light} : 0.5 + 0.49 * std::fabs(placed.n_z);
        placed.light = static_cast<float>(light);
        placed.depth = placement.shape == Shape3d::torus ? vertices[static_cast<std::size_t>(face[0].vertex)].z
                                                         : middle(vertices, face).z;
        if (texture >= 0 && texture < static_cast<int>(scene_.textures.size())) {
            Polygon polygon{.texture = texture,
                            .light = placed.light,
                            .mesh = placed.mesh,
                            .face = placed.face,
                            .half = placement.half};
            polygon.unrounded.light = light;
            project(vertices, face, *scene_.textures[static_cast<std::size_t>(texture)], polygon);
            if (is_drawable(polygon)) {
                placed.doubled_area = doubled_area(polygon.vertices);
                if (scene_.cull == Cull::none || placed.doubled_area > 0)
                    made_.push_back({std::move(polygon), faces_.size()});
            }
        }
        faces_.push_back(placed);
    }

    /// Adds the corners of the face's part beyond the near plane; none where there is no such part.
    void project(std::span<const glm::dvec3> vertices, const MeshFace& face, const Texture& texture,
                 Polygon& polygon) const {
        ClipRing ring;
        for (const FaceCorner& corner : face)
            ring.push_back(clip_vertex(to_clip(view_, vertices[static_cast<std::size_t>(corner.vertex)]), corner.uv));
        const bool whole =
            std::all_of(ring.begin(), ring.end(), [](const ClipVertex& vertex) { return vertex.position.z >= 0; });
        if (!whole) ring = clip_near(view_, ring).inside;
        for (const ClipVertex& vertex : ring) {
            Vertex corner = to_screen(view_, vertex.position);
            corner.u = static_cast<float>(vertex.uv.x * texture.width());
            corner.v = static_cast<float>(vertex.uv.y * texture.height());
            polygon.vertices.push_back(corner);
            polygon.unrounded.corners.push_back(place_on_screen(view_, vertex.position));
        }
    }

    Scene& scene_;
    Viewpoint view_;
    std::vector<PlacedFace> faces_;
    std::vector<Made> made_;
};

}  // namespace

Viewpoint view_of(const Scene& scene) {
    double nearest = 0;
    for (const MeshPlacement& placement : scene.meshes)
        if (placement.move.z > 0 && (nearest == 0 || placement.move.z < nearest)) nearest = placement.move.z;
    if (nearest == 0) nearest = 1;
    const Framebuffer& frame = scene.framebuffer;
    return {.middle_x = frame.width / 2.0,
            .middle_y = frame.height / 2.0,
            .focal = scene.camera.focal > 0 ? double{scene.camera.focal} : frame.width,
            .near = scene.camera.near > 0 ? double{scene.camera.near} : nearest / 16};
}

JellyCubes jelly_cubes_of(const MeshPlacement& placement, bool size_twice) {
    return jelly_cubes(1, placement.ratio, rotation(placement.rotate), rotation(placement.rotate2), size_twice);
}

glm::vec3 turned_angles(const glm::vec3& degrees, int axis, double by) {
    const glm::dvec3 angles = angles_of(turned(rotation(degrees), axis, by));
    glm::vec3 rounded(0);
    for (int n = 0; n < 3; ++n) rounded[n] = static_cast<float>(std::round(angles[n] * 100) / 100);
    return rounded;
}

std::vector<PlacedFace> place_meshes(Scene& scene) {
    const auto is_made = [](const Polygon& polygon) { return polygon.mesh >= 0; };
    scene.polygons.erase(std::remove_if(scene.polygons.begin(), scene.polygons.end(), is_made), scene.polygons.end());
    Placer placer(scene);
    for (std::size_t i = 0; i < scene.meshes.size() && i < kMaxMeshes; ++i) placer.place(i);
    return std::move(placer).finish();
}

}  // namespace texelscope
