// Any bytes are triangles or an error of one line; what was read can be written again to the same bytes, and drawn:
// within the picture, the same with all instructions, as many samples as the exact triangle owns.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/fast/raster.h"
#include "core/measure/workloads.h"
#include "core/scene/triangles_file.h"

namespace {

using namespace texelscope;

constexpr int kMaxSide = 20, kPitch = kMaxSide + 4;  ///< of the picture [px]: what hostile numbers cost is bounded
constexpr std::size_t kMaxTriangles = 12;
constexpr std::uint32_t kClear = 0xFFFFFFFF;

void demand(bool law) {
    if (!law) std::abort();
}

struct Drawn {
    std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(std::size_t{kPitch} * kMaxSide, kClear);
    RasterCounters counters;
};

Drawn drawn(const TrianglesFile& file, SimdLevel level) {
    // Texels that are their own addresses, as many as the file's texture has up to what a picture shows.
    const int width = std::min(file.texture_width, 32), height = std::min(file.texture_height, 32);
    std::vector<std::uint32_t> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t n = 0; n < texels.size(); ++n) texels[n] = static_cast<std::uint32_t>(n);
    const RasterJob job{.vertices = file.vertices,
                        .u_texels = width,
                        .v_texels = height,
                        .perspective = file.perspective,
                        .cull_back = file.cull_back};
    Drawn drawn;
    draw({drawn.pixels.data(), kPitch, file.width, file.height}, {texels.data(), width, height}, job, {.level = level},
         drawn.counters);
    for (int y = 0; y < kMaxSide; ++y)
        for (int x = 0; x < kPitch; ++x) {
            const std::uint32_t pixel = drawn.pixels[static_cast<std::size_t>(y * kPitch + x)];
            demand(pixel == kClear || (pixel < texels.size() && x < file.width && y < file.height));
        }
    return drawn;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    Result<TrianglesFile> file = parse_triangles(bytes, "fuzz");
    if (!file) {
        demand(file.error().where == "fuzz" && !file.error().what.empty());
        demand(file.error().what.find('\n') == std::string::npos);
        return 0;
    }
    demand(print_triangles(*file) == bytes);
    file->width = std::min(file->width, kMaxSide), file->height = std::min(file->height, kMaxSide);
    file->vertices.resize(std::min(file->vertices.size(), 3 * kMaxTriangles));
    file->depth = false;
    const Drawn best = drawn(*file, SimdLevel::best);
    demand(best.counters.samples == covered_samples(*file));
    for (const SimdLevelInfo& level : kSimdLevels)
        if (is_supported(level.level)) demand(drawn(*file, level.level).pixels == best.pixels);
    return 0;
}
