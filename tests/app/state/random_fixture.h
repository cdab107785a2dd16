// A small document of random triangles.
#pragma once

#include <memory>

#include "app/state/store.h"
#include "core/image/palette.h"
#include "core/image/patterns.h"

namespace texelscope {

/// Twelve triangles of two textures, the first of eight colours, over 64 x 48 pixels.
inline std::shared_ptr<const Document> random_document() {
    auto document = std::make_shared<Document>();
    document->id = "random.json";
    Scene& scene = document->scene;
    scene.framebuffer = {64, 48, 0, 0, {}};
    Texture first{.name = "first", .texels = make_pattern(Pattern::uv, 16, 16, 1)};
    scene.textures.push_back(std::make_shared<const Texture>(with_palette(std::move(first), 8)));
    Texture second{.name = "second", .texels = make_pattern(Pattern::address, 16, 16, 1)};
    scene.textures.push_back(std::make_shared<const Texture>(std::move(second)));
    scene.random = RandomTriangles{12, 24, 5};
    place_random(scene);
    return document;
}

}  // namespace texelscope
