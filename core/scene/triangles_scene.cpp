#include "core/scene/triangles_scene.h"

#include <memory>
#include <utility>

namespace texelscope {

Image default_texels(const TrianglesFile& file) {
    return make_pattern(Pattern::address, file.texture_width, file.texture_height, address_mark(0));
}

Scene scene_of(const TrianglesFile& file, Image texels) {
    Scene scene;
    scene.framebuffer.width = file.width, scene.framebuffer.height = file.height;
    scene.depth = file.depth ? Depth::less : Depth::off;
    scene.cull = file.cull_back ? Cull::back : Cull::none;
    const auto texture = std::make_shared<Texture>();
    texture->texels = std::move(texels);
    const auto u_texels = static_cast<float>(texture->width()), v_texels = static_cast<float>(texture->height());
    scene.textures.push_back(texture);
    scene.polygons.resize(file.vertices.size() / 3);
    for (std::size_t n = 0; n < file.vertices.size(); ++n) {
        Vertex vertex = file.vertices[n];
        vertex.u *= u_texels, vertex.v *= v_texels;
        if (!file.perspective) vertex.w = 1;
        scene.polygons[n / 3].vertices.push_back(vertex);
    }
    return scene;
}

}  // namespace texelscope
