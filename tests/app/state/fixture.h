// Small documents for tests of the state.
#pragma once

#include <memory>

#include "app/state/store.h"
#include "core/image/patterns.h"

namespace texelscope {

/// Two triangles that share a side, as one quad, on 32 x 24 pixels.
inline std::shared_ptr<const Document> quad_document() {
    auto texture = std::make_shared<Texture>();
    texture->name = "t";
    texture->source.pattern = Pattern::address;
    texture->texels = make_pattern(Pattern::address, 16, 16, 1);
    auto document = std::make_shared<Document>();
    document->id = "quad.json";
    document->scene.framebuffer = {32, 24, 0, 0, {}};
    document->scene.textures = {texture};
    document->scene.polygons = {
        {{{4, 3, 0, 1, 0, 0}, {20, 5, 0, 1, 16, 0}, {18, 20, 0, 1, 16, 16}, {5, 17, 0, 1, 0, 16}}, 0, 1}};
    return document;
}

}  // namespace texelscope
