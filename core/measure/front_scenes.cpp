#include "core/measure/front_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include <glm/glm.hpp>

#include "core/geometry/polygon.h"
#include "core/scene/scene.h"

namespace texelscope {
namespace {

constexpr int kSide = 256, kFar = 1 << 16;
constexpr int kReach = 256;  ///< beyond the frame: what lies farther out is no longer a scene of this kind [px]
constexpr int kCount = 240;
constexpr float kMost = 224;  ///< the largest triangles [px]
constexpr float kTexels = kFrontTexture;
constexpr float kFarGrid = 128;  ///< a float32 at kFar is a multiple of 1 / 128 px

/// As core/measure/workloads.cpp: the standard's engines give the same numbers everywhere, its distributions do not.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    [[nodiscard]] float within(float low, float high) {
        return low + (high - low) * (static_cast<float>(engine_() >> 40U) / 16777216.0F);
    }
    /// Of all sizes alike: as often between 1 and 2 as between 10 and 20.
    [[nodiscard]] float any_size(float low, float high) {
        const double share = double{within(0, 1)};
        return static_cast<float>(double{low} * std::exp2(share * std::log2(double{high} / low)));
    }
    [[nodiscard]] glm::vec2 inside(float side) {
        const float x = within(0, side);
        return {x, within(0, side)};
    }

private:
    std::mt19937_64 engine_;
};

void add(FrontScene& scene, std::array<Vertex, 3> corners) {
    const auto& [p, q, r] = corners;
    const double area = (double{q.x} - p.x) * (double{r.y} - p.y) - (double{r.x} - p.x) * (double{q.y} - p.y);
    if (area == 0) return;
    if (area < 0) std::swap(corners[1], corners[2]);
    scene.vertices.insert(scene.vertices.end(), corners.begin(), corners.end());
}
[[nodiscard]] float onto_grid(float a) { return std::round(a * kFarGrid) / kFarGrid; }

/// Triangles of `low` to `high` px with any part of the texture, `repeats` of it at most. The small ones have slopes of
/// some 50 texels a pixel.
[[nodiscard]] FrontScene triangles(std::uint64_t seed, float low, float high, float repeats, int offset = 0) {
    Dice dice(seed);
    FrontScene scene{.frame = {offset, offset, offset + kSide, offset + kSide}};
    for (int n = 0; n < kCount; ++n) {
        const float size = dice.any_size(low, high);
        const glm::vec2 at = dice.inside(kSide - size);
        std::array<Vertex, 3> corners;
        for (Vertex& corner : corners) {
            const glm::vec2 place = at + dice.inside(size), uv = dice.inside(repeats * kTexels);
            corner.x = onto_grid(place.x) + static_cast<float>(offset);
            corner.y = onto_grid(place.y) + static_cast<float>(offset);
            corner.u = uv.x, corner.v = uv.y;
        }
        add(scene, corners);
    }
    return scene;
}
[[nodiscard]] FrontScene near(std::uint64_t seed) { return triangles(seed, 3, kMost, 1); }
[[nodiscard]] FrontScene far(std::uint64_t seed) { return triangles(seed, 3, kMost, 1, kFar); }
[[nodiscard]] FrontScene minified(std::uint64_t seed) { return triangles(seed, 3, kMost, 64); }

/// Corners from 1 to 16 times as far away as the nearest.
[[nodiscard]] FrontScene steep(std::uint64_t seed) {
    Dice dice(seed + 1);
    FrontScene scene = triangles(seed, 24, kMost, 1);
    for (Vertex& corner : scene.vertices) corner.w = dice.any_size(1, 16);
    return scene;
}

/// 100 to 200 px long and 0.001 to 3 px wide.
[[nodiscard]] FrontScene slivers(std::uint64_t seed) {
    Dice dice(seed);
    FrontScene scene{.frame = {0, 0, kSide, kSide}};
    while (scene.triangles() < kCount) {
        const glm::vec2 from = dice.inside(kSide), to = dice.inside(kSide);
        const float length = glm::distance(from, to);
        if (length < 100 || length > 200) continue;
        const glm::vec2 way = (to - from) / length, across{-way.y, way.x};
        const glm::vec2 apex = glm::clamp(glm::mix(from, to, dice.within(.2F, .8F)) + across * dice.any_size(.001F, 3),
                                          0.0F, float{kSide});
        std::array<Vertex, 3> corners;
        for (std::size_t n = 0; n < 3; ++n) {
            const glm::vec2 place = n == 0 ? from : n == 1 ? to : apex, uv = dice.inside(kTexels);
            corners[n] = {.x = place.x, .y = place.y, .u = uv.x, .v = uv.y};
        }
        add(scene, corners);
    }
    return scene;
}

constexpr std::array<FrontSceneInfo, 5> kScenes{{
    {"near", "Near the origin", "Triangles of 3 to 224 px near the origin, u and v of 0 to 256 texels", near},
    {"far", "65,536 px from the origin", "The same triangles 2^16 px further right and down", far},
    {"steep", "Steep perspective", "Triangles of 24 to 224 px, corners 1 to 16 times as far as the nearest", steep},
    {"slivers", "Slivers", "Triangles 100 to 200 px long and 0.001 to 3 px wide", slivers},
    {"minified", "Minified", "As near, with up to 64 repeats of the texture", minified},
}};

}  // namespace

FrontScene front_scene_of(const Scene& scene) {
    FrontScene front{.frame = scene.framebuffer.rect()};
    for (const Polygon& polygon : scene.polygons) {
        const std::vector<Vertex>& corners = polygon.vertices;
        const Rect reach{front.frame.x0 - kReach, front.frame.y0 - kReach, front.frame.x1 + kReach,
                         front.frame.y1 + kReach};
        const auto fine = [&](const Vertex& v) {
            return is_drawable(v) && v.x >= static_cast<float>(reach.x0) && v.x <= static_cast<float>(reach.x1) &&
                   v.y >= static_cast<float>(reach.y0) && v.y <= static_cast<float>(reach.y1);
        };
        if (!std::all_of(corners.begin(), corners.end(), fine)) continue;
        for (std::size_t k = 2; k < corners.size() && front.triangles() < kMostFrontTriangles; ++k)
            add(front, {corners[0], corners[k - 1], corners[k]});
    }
    return front;
}

std::span<const FrontSceneInfo> front_scenes() { return kScenes; }

const FrontSceneInfo* find_front_scene(std::string_view id) {
    const auto* const found =
        std::find_if(kScenes.begin(), kScenes.end(), [&](const FrontSceneInfo& s) { return s.id == id; });
    return found != kScenes.end() ? found : nullptr;
}

}  // namespace texelscope
