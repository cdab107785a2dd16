// Random triangles all over the framebuffer: the demonstration of S3 (A. LaMothe, Dr. Dobb's Journal, July 1998), which
// drew them at 640 x 480 in 256 colours.
#pragma once

#include <cstdint>

namespace texelscope {

struct Scene;

inline constexpr int kMaxRandomTriangles = 100'000;

struct RandomTriangles {
    int count = 100;         ///< [1, kMaxRandomTriangles]
    float size = 60;         ///< of the square that holds a triangle [px], (0, kMaxSize]
    std::uint32_t seed = 1;  ///< the same number gives the same triangles everywhere
    friend bool operator==(const RandomTriangles&, const RandomTriangles&) = default;
};

/// Replaces all polygons of the scene that were made by `scene.random`. They come after its own, take its textures in
/// turn, and lie wholly in the framebuffer where their size lets them.
void place_random(Scene& scene);

}  // namespace texelscope
