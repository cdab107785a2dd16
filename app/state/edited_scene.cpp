#include "app/state/derived.h"

namespace texelscope {

Scene edited_scene(const Document& document, const Work& work) {
    Scene scene = document.scene;
    for (const VertexEdit& edit : work.edits) {
        if (edit.polygon < 0 || edit.polygon >= static_cast<int>(scene.polygons.size())) continue;
        auto& vertices = scene.polygons[static_cast<std::size_t>(edit.polygon)].vertices;
        if (edit.vertex < 0 || edit.vertex >= static_cast<int>(vertices.size())) continue;
        vertices[static_cast<std::size_t>(edit.vertex)] = edit.value;
    }
    if (work.texture && !scene.textures.empty()) scene.textures.front() = work.texture;
    return scene;
}

glm::vec2 position_of(const Scene& scene, const Handle& handle) {
    if (handle.polygon < 0 || handle.polygon >= static_cast<int>(scene.polygons.size())) return {0, 0};
    const auto& vertices = scene.polygons[static_cast<std::size_t>(handle.polygon)].vertices;
    if (handle.vertex < 0 || handle.vertex >= static_cast<int>(vertices.size())) return {0, 0};
    const Vertex& vertex = vertices[static_cast<std::size_t>(handle.vertex)];
    return handle.texture ? glm::vec2(vertex.u, vertex.v) : glm::vec2(vertex.x, vertex.y);
}

}  // namespace texelscope
