#include "app/state/derived.h"

namespace texelscope {
namespace {

void apply(const MeshEdit& edit, Scene& scene) {
    if (edit.mesh < 0 || edit.mesh >= static_cast<int>(scene.meshes.size())) return;
    MeshPlacement& mesh = scene.meshes[static_cast<std::size_t>(edit.mesh)];
    mesh.rotate = edit.rotate, mesh.rotate2 = edit.rotate2, mesh.ratio = edit.ratio;
}

void apply(const VertexEdit& edit, Scene& scene) {
    if (edit.polygon < 0 || edit.polygon >= static_cast<int>(scene.polygons.size())) return;
    Polygon& polygon = scene.polygons[static_cast<std::size_t>(edit.polygon)];
    const bool own = polygon.mesh < 0;  // a mesh's polygons change their places
    if (own && edit.vertex >= 0 && edit.vertex < static_cast<int>(polygon.vertices.size()))
        polygon.vertices[static_cast<std::size_t>(edit.vertex)] = edit.value;
}

}  // namespace

Scene edited_scene(const Document& document, const Work& work, std::vector<PlacedFace>* faces) {
    Scene scene = document.scene;
    for (const MeshEdit& edit : work.meshes) apply(edit, scene);
    if (work.focal > 0) scene.camera.focal = work.focal;
    if (work.size_twice) scene.size_twice = *work.size_twice;
    if (!scene.meshes.empty() && (faces != nullptr || !work.meshes.empty() || work.focal > 0 || work.size_twice)) {
        std::vector<PlacedFace> placed = place_meshes(scene);
        if (faces != nullptr) *faces = std::move(placed);
    }
    if (scene.random && work.random) {
        scene.random = work.random;
        if (work.random->distance > 0)
            scene.framebuffer.origin_x += 1 << work.random->distance,
                scene.framebuffer.origin_y += 1 << work.random->distance;
        place_random(scene);
    }
    for (const VertexEdit& edit : work.edits) apply(edit, scene);
    if (work.frame != 0) show_frame(scene, work.frame);
    if (work.texture && !scene.textures.empty()) scene.textures.front() = work.texture;
    return scene;
}

const Vertex* vertex_of(const Scene& scene, const Handle& handle) {
    if (handle.polygon < 0 || handle.polygon >= static_cast<int>(scene.polygons.size())) return nullptr;
    const auto& vertices = scene.polygons[static_cast<std::size_t>(handle.polygon)].vertices;
    if (handle.vertex < 0 || handle.vertex >= static_cast<int>(vertices.size())) return nullptr;
    return &vertices[static_cast<std::size_t>(handle.vertex)];
}

glm::vec2 position_of(const Scene& scene, const Handle& handle) {
    const Vertex* vertex = vertex_of(scene, handle);
    if (vertex == nullptr) return {0, 0};
    return handle.texture ? glm::vec2(vertex->u, vertex->v) : glm::vec2(vertex->x, vertex->y);
}

}  // namespace texelscope
