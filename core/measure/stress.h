// Numerical stability: the families of hard input, drawn by every method in every number format and by the fast
// rasterizer, against what is decided exactly.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fast/raster.h"
#include "core/measure/families.h"
#include "core/method/drawing.h"

namespace texelscope {

/// One family in one mode, drawn one way.
struct StressRow {
    const Family* family = nullptr;
    StressMode mode;
    std::string_view method, number;                      ///< `number` is empty for the fast rasterizer
    std::int64_t shapes = 0, triangles = 0, samples = 0;  ///< samples: those that the triangles own
    std::int64_t missing = 0, extra = 0;                  ///< owned and not drawn; drawn and not owned
    std::int64_t twice = 0;               ///< drawn again by the same triangle, or by another one of a closed mesh
    std::int64_t wrong = 0;               ///< with another texel
    std::int64_t meshes = 0, leaky = 0;   ///< closed shapes; those with a sample that is not drawn once
    double worst = 0, p99 = 0, mean = 0;  ///< error of u or v, whichever is greater [texels]; of samples drawn rightly
    double bound = 0;                     ///< greatest of the samples' bounds of error that are finite [texels]
    std::int64_t exceeded = 0;            ///< samples whose error is beyond their bound
    std::int64_t together = 0;            ///< fast: pixels wrong where all triangles are drawn in one call
    std::int64_t not_served = 0;          ///< fast: shapes of a kind that it does not draw
    RasterCounters counters;              ///< fast
    std::string fault;                    ///< the first triangle that fails the run, as hexadecimal floats

    /// `fast` and `exact` must be right, and every method must keep its bounds.
    [[nodiscard]] bool failed() const;
};

/// @param settings  a method and its number format; quirks show what stress catches.
[[nodiscard]] StressRow stress_method(const Family& family, StressMode mode, const DrawSettings& settings,
                                      std::uint64_t seed, int shapes);
/// The fast rasterizer itself, with textures of addresses.
[[nodiscard]] StressRow stress_fast(const Family& family, StressMode mode, std::uint64_t seed, int shapes);

struct StressSettings {
    std::uint64_t seed = 1;
    int count = 1000;                ///< triangles or meshes of a family for `fast`; fewer for methods, see below
    const Family* family = nullptr;  ///< null: all
    std::string_view method;         ///< empty: all that define the same mapping
};
inline constexpr int kMostForMethods = 100, kMostForExactNumbers = 3;  ///< shapes of a family

/// Every row, in order of families, modes, methods.
void stress(const StressSettings& settings, const std::function<void(const StressRow&)>& put);

}  // namespace texelscope
