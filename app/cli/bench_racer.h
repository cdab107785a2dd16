// What `bench` times: triangles, ready to be drawn again and again in one way.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "app/cli/draw_options.h"
#include "core/base/result.h"
#include "core/image/image.h"
#include "core/scene/triangles_file.h"

namespace texelscope {

inline constexpr std::string_view kFastMethod = "fast";  ///< core/fast/raster.h; other ids are methods()

class BenchRacer {
public:
    BenchRacer() = default;
    BenchRacer(const BenchRacer&) = delete;
    BenchRacer& operator=(const BenchRacer&) = delete;
    virtual ~BenchRacer() = default;
    virtual void clear() = 0;  ///< makes the framebuffer ready for the next draw
    virtual void draw() = 0;   ///< what is timed
    [[nodiscard]] virtual Image picture() const = 0;
    [[nodiscard]] virtual std::uint64_t samples() const = 0;  ///< of one draw, those drawn again counted again
    [[nodiscard]] virtual int threads() const = 0;            ///< that draw
    /// How often each decision was made in one draw, as a JSON object; empty where nobody counts.
    [[nodiscard]] virtual std::string stats() const { return {}; }
};

/// Fails where the options are wrong, or what they name cannot draw these triangles.
/// @param certificates  RasterSettings::certain.
/// @param name          of the triangles, for the error.
Result<std::unique_ptr<BenchRacer>> make_racer(TrianglesFile file, Image texels, const DrawOptions& options,
                                               bool certificates, const std::string& name);

}  // namespace texelscope
