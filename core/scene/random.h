// Random triangles all over the framebuffer: the demonstration of S3 (A. LaMothe, Dr. Dobb's Journal, July 1998), which
// drew them at 640 x 480 in 256 colours.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace texelscope {

struct Scene;

inline constexpr int kMaxRandomTriangles = 100'000;

/// What makes them hard.
enum class RandomKind : std::uint8_t {
    plain,    ///< nothing
    steep,    ///< corners 1 to 16 times as far as the nearest
    slivers,  ///< as long as their squares allow, 1/64 to 3 px wide
};
/// As a scene spells them, in the order of RandomKind.
inline constexpr std::array<std::string_view, 3> kRandomKinds{"plain", "steep", "slivers"};

inline constexpr int kMaxDistance = 19;  ///< float32 still holds sixteenths of a pixel there
inline constexpr int kMaxWaste = 95;     ///< [percent]

struct RandomTriangles {
    int count = 100;         ///< [1, kMaxRandomTriangles]
    float size = 60;         ///< of the square that holds a triangle [px], (0, kMaxSize]
    std::uint32_t seed = 1;  ///< the same number gives the same triangles everywhere
    RandomKind kind = RandomKind::plain;
    /// The framebuffer and these triangles lie 2^distance px further right and down; 0: where the scene has it.
    /// A person's: in a file the framebuffer has an `origin`.
    int distance = 0;
    /// Of scenes with depth: how many show nothing [percent], being hidden, turned away, off the screen, between
    /// samples or without area.
    int waste = 0;
    friend bool operator==(const RandomTriangles&, const RandomTriangles&) = default;
};

/// Replaces all polygons of the scene that were made by `scene.random`. They come after its own, take its textures in
/// turn, and lie wholly in the framebuffer where their size lets them.
void place_random(Scene& scene);

}  // namespace texelscope
