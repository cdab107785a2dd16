#include "core/scene/random.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/polygon.h"
#include "core/scene/scene.h"

namespace texelscope {
namespace {

/// xorshift32 (G. Marsaglia, "Xorshift RNGs", 2003): the standard's distributions differ between libraries.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : state_(seed * 2654435769U | 1U) {}
    /// In [0, 1), of 24 bits.
    [[nodiscard]] float fraction() {
        state_ ^= state_ << 13, state_ ^= state_ >> 17, state_ ^= state_ << 5;
        return static_cast<float>(state_ >> 8) / 16777216.0F;
    }
    [[nodiscard]] float within(float low, float high) { return low + (high - low) * fraction(); }

private:
    std::uint32_t state_;
};

/// Three places in a square, on whole sixteenths of a pixel so that every number format holds them.
std::array<glm::vec2, 3> corners_in(Dice& dice, glm::vec2 middle, float size) {
    std::array<glm::vec2, 3> corners;
    for (glm::vec2& corner : corners) {
        const float x = dice.within(-size / 2, size / 2), y = dice.within(-size / 2, size / 2);
        corner = {std::floor((middle.x + x) * 16) / 16, std::floor((middle.y + y) * 16) / 16};
    }
    return corners;
}

Polygon triangle(Dice& dice, const Scene& scene, int number) {
    const Rect frame = scene.framebuffer.rect();
    const float size = scene.random->size;
    const auto place = [&](int low, int high) {
        const float margin = std::min(size / 2, static_cast<float>(high - low) / 2);
        return dice.within(static_cast<float>(low) + margin, static_cast<float>(high) - margin);
    };
    const float x = place(frame.x0, frame.x1), y = place(frame.y0, frame.y1);
    Polygon polygon;
    polygon.texture = scene.textures.empty() ? 0 : number % static_cast<int>(scene.textures.size());
    polygon.random = true;
    const auto corners = corners_in(dice, {x, y}, size);
    // The whole texture, whatever the triangle's shape: full (u, v) per vertex, as the source has it.
    const float width = scene.textures.empty() ? 64.0F : static_cast<float>(scene.textures[polygon.texture]->width()),
                height = scene.textures.empty() ? 64.0F : static_cast<float>(scene.textures[polygon.texture]->height());
    const std::array<glm::vec2, 3> on_texture{{{0, 0}, {width, 0}, {width / 2, height}}};
    for (std::size_t n = 0; n < 3; ++n) {
        Vertex v;
        v.x = corners[n].x, v.y = corners[n].y, v.u = on_texture[n].x, v.v = on_texture[n].y;
        polygon.vertices.push_back(v);
    }
    return polygon;
}

}  // namespace

void place_random(Scene& scene) {
    auto& polygons = scene.polygons;
    polygons.erase(std::remove_if(polygons.begin(), polygons.end(), [](const Polygon& p) { return p.random; }),
                   polygons.end());
    if (!scene.random) return;
    Dice dice(scene.random->seed);
    const int count = std::clamp(scene.random->count, 1, kMaxRandomTriangles);
    polygons.reserve(polygons.size() + static_cast<std::size_t>(count));
    for (int n = 0; n < count; ++n) polygons.push_back(triangle(dice, scene, n));
}

}  // namespace texelscope
