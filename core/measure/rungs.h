// What the front compares: every method in every number format, and a ladder of implementations beside them. All do the
// same: for each triangle of a list they find the samples that it owns, and write the texel of each.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/fast/raster.h"
#include "core/fast/raster_texels.h"
#include "core/measure/bounds.h"
#include "core/measure/front_scenes.h"
#include "core/method/method.h"

namespace texelscope {

/// What draws a rung, and so what its time may be compared with.
enum class RungKind : std::uint8_t {
    method,  ///< a method's plain loop: all samples of the box tested or rows solved, one after the other; RGB
    kernel,  ///< core/measure/rung_kernels.h, the same way
    exact,   ///< core/exact/triangle.h, rows solved; RGB
    fast,    ///< core/fast/raster.h: SIMD, the whole list in one call; 32 bits a pixel
};
[[nodiscard]] std::string_view id_of(RungKind kind);

struct Rung {
    std::string id;     ///< "edge-equations:f32:based": what a method is asked for, or a name
    std::string label;  ///< a few words for tables and pictures
    RungKind kind = RungKind::method;
    bounds::Bound bound = nullptr;  ///< on |Δu| and |Δv| over a triangle; null where none is published
    std::size_t most = 0;           ///< triangles that it draws at most, as it is slow; 0 = all

    NumberFormat format = NumberFormat::f64;  ///< what u and v are computed in, nearly enough for a kernel

    const Method* method = nullptr;  ///< of kind method, with its quirks
    QuirkSet quirks = 0;
    Fate (*render)(const Job&, Image&) = nullptr;                      ///< of kind kernel
    Fate (*samples)(const Job&, const Window&, const Put&) = nullptr;  ///< of kind kernel
};

/// The ladder first, then methods by id, each in every number format.
[[nodiscard]] const std::vector<Rung>& rungs();
/// Null where there is none of that id.
[[nodiscard]] const Rung* find_rung(std::string_view id);

/// A scene with what rungs draw into and from. The texture's texels are all of different colours.
class RungStage {
public:
    explicit RungStage(FrontScene scene);

    [[nodiscard]] const FrontScene& scene() const { return scene_; }
    /// How many of the scene's triangles the rung draws.
    [[nodiscard]] std::size_t count(const Rung& rung) const;
    /// Draws them all: what is timed.
    void draw(const Rung& rung);
    /// The rung's written samples of one triangle, its column and row those of the texel after wrapping. u and v are
    /// NaN for rungs that decide on texels alone.
    void each_sample(const Rung& rung, std::size_t triangle, const Put& put);

private:
    [[nodiscard]] Job job(std::size_t triangle) const;
    void draw_exact(std::size_t triangle);
    void draw_fast(std::span<const Vertex> vertices);
    void samples_of_pixels(std::size_t triangle, const Put& put);

    FrontScene scene_;
    Texture texture_;
    Image picture_;
    bool perspective_ = false;
    RasterTexels texels_;                ///< fast's texture
    std::vector<std::uint32_t> pixels_;  ///< and target
};

}  // namespace texelscope
