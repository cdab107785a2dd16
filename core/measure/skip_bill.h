// What a scene's skips save: how many triangles each of them drops, whether the picture is the same without it, and how
// long drawing takes with and without it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/fast/raster.h"
#include "core/fast/raster_texels.h"
#include "core/measure/race.h"
#include "core/scene/scene.h"

namespace texelscope {

inline constexpr std::uint32_t kAllSkips = (1U << kRasterSkips.size()) - 1;
/// All skips but one.
[[nodiscard]] constexpr std::uint32_t without(RasterSkip skip) {
    return kAllSkips & ~(1U << static_cast<unsigned>(skip));
}

/// A scene's triangles as the fast rasterizer takes them, opaque, and every texel in its own colour whatever the light.
class SkipScene {
public:
    explicit SkipScene(const Scene& scene);

    void clear();
    /// Draws all of them over what is there; returns what was counted.
    RasterCounters draw(std::uint32_t skips);
    /// As the last draw() left them; rows lie width() + a gap apart.
    [[nodiscard]] const std::vector<std::uint32_t>& pixels() const { return pixels_; }
    [[nodiscard]] std::size_t triangles() const { return vertices_.size() / 3; }

private:
    /// Neighbours of one texture.
    struct Part {
        int texture = 0;
        std::size_t first = 0, count = 0;  ///< of vertices_
    };

    Framebuffer frame_;
    bool depth_, cull_;
    std::vector<RasterTexels> textures_;
    std::vector<Part> parts_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> pixels_;
    std::vector<float> nearest_;
};

/// What is counted with some of the skips.
struct SkipCount {
    RasterCounters counters;    ///< with the skips asked for
    RasterCounters all;         ///< with all of them
    std::uint64_t differs = 0;  ///< pixels that are not as with all of them
};
[[nodiscard]] SkipCount count_skips(const Scene& scene, std::uint32_t skips);

/// How long one drawing takes: the least of the rounds.
struct SkipTime {
    std::uint32_t skips = kAllSkips;
    double seconds = 0;
};

/// Times a scene with all skips, without each of them, with none and as asked for, in turn, so that a machine's moods
/// meet all of them. In steps of one drawing each.
class SkipRun {
public:
    using Clock = LapRun::Clock;

    SkipRun(const Scene& scene, std::uint32_t skips, Clock clock = LapRun::monotonic_seconds);
    /// Draws for about `seconds`. @return whether all rounds are over.
    bool advance(double seconds);
    /// As far as it is known: none before the first round is over.
    [[nodiscard]] const std::vector<SkipTime>& times() const { return times_; }
    [[nodiscard]] double share() const;  ///< of the rounds [0, 1]

private:
    SkipScene scene_;
    Clock clock_;
    std::vector<SkipTime> best_, times_;
    std::size_t next_ = 0;
    int round_ = 0;  ///< 0 warms up and is not counted
};

}  // namespace texelscope
