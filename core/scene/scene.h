// What is drawn: a framebuffer, textures and polygons. The file format is `core/scene/json.h`'s.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/rect.h"
#include "core/geometry/vertex.h"
#include "core/image/texture.h"

namespace texelscope {

enum class Depth : std::uint8_t { off, less };
enum class Cull : std::uint8_t { none, back };

struct Framebuffer {
    int width = 64, height = 48;     ///< [px], 1 to kMaxSize
    int origin_x = 0, origin_y = 0;  ///< the absolute pixel at the picture's top left
    Rgb clear{};

    [[nodiscard]] Rect rect() const { return {origin_x, origin_y, origin_x + width, origin_y + height}; }
    friend bool operator==(const Framebuffer&, const Framebuffer&) = default;
};

struct Scene {
    Framebuffer framebuffer;
    Depth depth = Depth::off;
    Cull cull = Cull::none;
    std::vector<std::shared_ptr<const Texture>> textures;  ///< shared: a scene is copied on every edit
    std::vector<Polygon> polygons;
};

}  // namespace texelscope
