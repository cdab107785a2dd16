// The scenes of the front: what makes u and v hard to get right, one thing each.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/rect.h"
#include "core/geometry/vertex.h"

namespace texelscope {

inline constexpr int kFrontTexture = 256;  ///< side of the texture of all scenes; it repeats [texels]

/// All triangles lie inside the frame and face front.
struct FrontScene {
    Rect frame;
    std::vector<Vertex> vertices;  ///< three a triangle; u, v in texels

    [[nodiscard]] std::size_t triangles() const { return vertices.size() / 3; }
    [[nodiscard]] std::span<const Vertex, 3> corners(std::size_t triangle) const {
        return std::span(vertices).subspan(3 * triangle).first<3>();
    }
};

struct FrontSceneInfo {
    std::string_view id, title, summary;
    FrontScene (*make)(std::uint64_t seed);  ///< the same seed gives the same triangles everywhere
};

struct Scene;
/// The triangles that a scene's polygons are cut into, their fronts to us; what has no area, or numbers that cannot be
/// drawn, is left out. At most kMostFrontTriangles of them.
[[nodiscard]] FrontScene front_scene_of(const Scene& scene);
inline constexpr std::size_t kMostFrontTriangles = 240;

/// In the order in which tables and pictures show them.
[[nodiscard]] std::span<const FrontSceneInfo> front_scenes();
/// Null where there is none of that id.
[[nodiscard]] const FrontSceneInfo* find_front_scene(std::string_view id);

}  // namespace texelscope
