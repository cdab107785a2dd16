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

constexpr float kSixteenth = 16;                ///< every number format holds corners on whole sixteenths of a pixel
constexpr float kSteepest = 16;                 ///< w of the farthest corners
constexpr float kThin = 1.0F / 64, kThick = 3;  ///< slivers are so wide [px]
constexpr int kWalls = 40;                      ///< of so many triangles one is a wall
constexpr float kWall = .75F;                   ///< a wall's square, in parts of the framebuffer's lesser side

[[nodiscard]] float onto_grid(float a) { return std::floor(a * kSixteenth) / kSixteenth; }

/// Three places in a square.
std::array<glm::vec2, 3> corners_in(Dice& dice, glm::vec2 middle, float size) {
    std::array<glm::vec2, 3> corners;
    for (glm::vec2& corner : corners) {
        const float x = dice.within(-size / 2, size / 2), y = dice.within(-size / 2, size / 2);
        corner = {onto_grid(middle.x + x), onto_grid(middle.y + y)};
    }
    return corners;
}

/// From side to side of the square, and a third corner just off the middle of that line.
std::array<glm::vec2, 3> sliver_in(Dice& dice, glm::vec2 middle, float size) {
    const float skew = dice.within(-size / 2, size / 2), share = dice.within(.25F, .75F),
                width = dice.within(0, 1) * dice.within(0, 1) * (kThick - kThin) + kThin;
    const bool level = dice.fraction() < .5F;
    const glm::vec2 half = level ? glm::vec2(size / 2, skew) : glm::vec2(skew, size / 2);
    const glm::vec2 from = middle - half, to = middle + half;
    const glm::vec2 aside = level ? glm::vec2(0, width) : glm::vec2(width, 0);
    return {from, to, from + (to - from) * share + aside};
}

Polygon polygon_of(const Scene& scene, int number, const std::array<glm::vec2, 3>& corners) {
    const Rect frame = scene.framebuffer.rect();
    Polygon polygon;
    polygon.texture = scene.textures.empty() ? 0 : number % static_cast<int>(scene.textures.size());
    polygon.random = true;
    // The whole texture, whatever the triangle's shape: full (u, v) per vertex, as the source has it.
    const float width = scene.textures.empty() ? 64.0F : static_cast<float>(scene.textures[polygon.texture]->width()),
                height = scene.textures.empty() ? 64.0F : static_cast<float>(scene.textures[polygon.texture]->height());
    const std::array<glm::vec2, 3> on_texture{{{0, 0}, {width, 0}, {width / 2, height}}};
    for (std::size_t n = 0; n < 3; ++n) {
        Vertex v;
        v.x = corners[n].x + static_cast<float>(frame.x0), v.y = corners[n].y + static_cast<float>(frame.y0);
        v.u = on_texture[n].x, v.v = on_texture[n].y;
        polygon.vertices.push_back(v);
    }
    return polygon;
}

/// Where a square of `size` lies wholly in the framebuffer, from its top left.
glm::vec2 place_in_frame(Dice& dice, const Scene& scene, float size) {
    const auto place = [&](int extent) {
        const float whole = static_cast<float>(extent), margin = std::min(size / 2, whole / 2);
        return dice.within(margin, whole - margin);
    };
    const float x = place(scene.framebuffer.width), y = place(scene.framebuffer.height);
    return {x, y};
}

Polygon triangle(Dice& dice, const Scene& scene, int number) {
    const RandomTriangles& random = *scene.random;
    const glm::vec2 middle = place_in_frame(dice, scene, random.size);
    if (random.kind == RandomKind::slivers) return polygon_of(scene, number, sliver_in(dice, middle, random.size));
    Polygon polygon = polygon_of(scene, number, corners_in(dice, middle, random.size));
    if (random.kind == RandomKind::steep)
        for (Vertex& vertex : polygon.vertices) vertex.w = onto_grid(dice.within(1, kSteepest));
    return polygon;
}

void turn_over(Polygon& polygon) {
    std::swap(polygon.vertices[1].x, polygon.vertices[2].x), std::swap(polygon.vertices[1].y, polygon.vertices[2].y);
}

/// One of a scene with depth: the background, a wall before it, what is seen before the walls, or waste.
Polygon triangle_in_depth(Dice& dice, const Scene& scene, int number) {
    const RandomTriangles& random = *scene.random;
    const auto width = static_cast<float>(scene.framebuffer.width),
               height = static_cast<float>(scene.framebuffer.height);
    const auto put = [&](glm::vec2 middle, float size, float near, float far) {
        Polygon polygon = polygon_of(scene, number, corners_in(dice, middle, size));
        if (doubled_area(polygon.vertices) < 0) turn_over(polygon);
        const float z = dice.within(near, far);
        for (Vertex& vertex : polygon.vertices) vertex.z = z;
        return polygon;
    };
    if (number < 2) {  // behind all that is seen, over the whole framebuffer
        const glm::vec2 right{width, 0}, bottom{0, height};
        Polygon back = polygon_of(scene, number,
                                  {number == 0 ? glm::vec2(0) : right, number == 0 ? right : right + bottom, bottom});
        for (Vertex& vertex : back.vertices) vertex.z = .45F;
        return back;
    }
    if (number < random.count / kWalls) {
        const float size = kWall * std::min(width, height);
        return put(place_in_frame(dice, scene, size), size, .3F, .4F);
    }
    const float size = random.size, fate = dice.fraction() * 100;
    const auto waste = static_cast<float>(random.waste);
    const glm::vec2 middle = place_in_frame(dice, scene, size);
    if (fate >= waste) return put(middle, size, .05F, .25F);
    const float kind = fate / waste;
    if (kind < .25F) return put(middle, size, .5F, .9F);  // behind the walls
    if (kind < .5F) {
        Polygon polygon = put(middle, size, .05F, .9F);
        turn_over(polygon);
        return polygon;
    }
    if (kind < .75F) return put(middle + glm::vec2(width + size, 0), size, .05F, .9F);  // off the screen
    Polygon polygon = put(middle, size, .05F, .9F);
    if (kind < .85F) {  // without area
        polygon.vertices[2].x = polygon.vertices[1].x, polygon.vertices[2].y = polygon.vertices[1].y;
    } else {  // between samples
        const float x = std::floor(polygon.vertices[0].x), y = std::floor(polygon.vertices[0].y);
        polygon.vertices[0].x = x - .25F, polygon.vertices[0].y = y - .25F;
        polygon.vertices[1].x = x + .25F, polygon.vertices[1].y = y - .25F;
        polygon.vertices[2].x = x, polygon.vertices[2].y = y + .25F;
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
    const bool deep = scene.depth == Depth::less;
    for (int n = 0; n < count; ++n)
        polygons.push_back(deep ? triangle_in_depth(dice, scene, n) : triangle(dice, scene, n));
}

}  // namespace texelscope
