#include "core/measure/families.h"

#include <algorithm>
#include <array>

#include "core/geometry/snap.h"
#include "core/measure/family_makers.h"

namespace texelscope {
namespace {

constexpr int kSnapBits = 8;

constexpr std::array kFamilies{
    Family{"random", "corners anywhere on the screen", family::random},
    Family{"grid-aligned", "corners and texels on whole, half, quarter and sixteenth parts", family::on_a_grid},
    Family{"on-centres", "corners on samples", family::on_centres},
    Family{"through-centres", "a side runs through samples", family::through_centres},
    Family{"near-ties", "corners on samples, at whole texels, then up to 3 floats off", family::near_ties},
    Family{"ratios", "corners on samples, slopes n/12 to n/48 texels a pixel: texels begin on samples", family::ratios,
           4},
    Family{"blits", "rectangles over the frame, 1:1 and simple ratios", family::blit},
    Family{"denormal", "a denormal coordinate decides a tie", family::denormal},
    Family{"opened-lines", "a line through samples, opened by 1e-7 to 1e-1 px", family::opened_lines},
    Family{"slivers", "16 to 4,000 px long, 1e-3 to 4 px wide", family::thin},
    Family{"tiny", "1e-6 to 2 px large, most of them at a sample", family::tiny},
    Family{"nearly-in-line", "corners in line but for 2 floats, up to 2^18 px out", family::nearly_in_line},
    Family{"without-area", "corners in line or in one place: nothing is drawn", family::without_area},
    Family{"truncation", "u and v between -3 and 2", family::truncated},
    Family{"not-finite", "NaN and infinities: nothing is drawn", family::not_finite},
    Family{"huge", "coordinates of 1e6 to 3e38 px", family::huge},
    Family{"long-legs", "sides of 181 to 4,096 px: 32-bit edge functions overflow", family::long_legs},
    Family{"offset", "3 to 9 px large, 2^8 to 2^12 px from the origin along one axis", family::offset},
    Family{"far-offset", "3 to 9 px large, 2^8 to 2^20 px from the origin, the frame there, too", family::far_offset},
    Family{"long-rows", "rows of 64 to 3,840 px, up to 2 texels a pixel", family::long_rows, 8},
    Family{"big-indices", "u and v from 2^20 to 2^41 texels out, 1,024 texels wide", family::big_indices},
    Family{"any-texture", "textures of 1 to 100 texels each way", family::any_texture},
    Family{"small-textures", "textures of 1, 2, 4 and 8 texels each way", family::small_textures},
    Family{"minified", "up to thousands of texels a pixel", family::minified},
    Family{"magnified", "1e-6 to 1 texel over the triangle, round a whole one", family::magnified},
    Family{"level-texture", "u, or u and v, the same at all corners", family::level_texture},
    Family{"borders", "corners up to 1e-9 px from the screen's borders", family::borders},
    Family{"class-limits", "coordinates at 2^-8, 2^-6, 2^13 and 2^21 px", family::class_limits},
    Family{"orders", "one triangle in the six orders of its corners", family::orders, 6},
    Family{"layers", "over most of a frame, over each other: tiles are left to later ones", family::layers, 4},
    Family{"fans", "closed: triangles round a point", family::fan, 12},
    Family{"grids", "closed: a shaken grid, cells of 3 to 5 px", family::grid, 80},
    Family{"fine-grids", "closed: a shaken grid, cells of 0.7 to 2 px", family::fine_grid, 800},
    Family{"steep", "w from 1e-3 to 1e3", family::steep, 1, true},
    Family{"extreme-depths", "w from 1e-45 to 3e38", family::extreme_depths, 1, true},
    Family{"equal-depths", "the same w, not 1, at all corners", family::equal_depths, 1, true},
    Family{"nearly-equal-depths", "w apart by 1e-6 to 0.1 of itself, or by one float", family::nearly_equal_depths, 1,
           true},
    Family{"whole-depths", "corners on samples, at whole texels, w from 1 to 4", family::whole_depths, 1, true},
};

}  // namespace

std::span<const Family> families() { return kFamilies; }

const Family* find_family(std::string_view name) {
    const auto at = std::find_if(kFamilies.begin(), kFamilies.end(), [=](const Family& f) { return f.name == name; });
    return at == kFamilies.end() ? nullptr : &*at;
}

HardShape in_mode(HardShape shape, StressMode mode) {
    for (Vertex& v : shape.vertices) {
        if (mode.snapped) v.x = snap(v.x, kSnapBits), v.y = snap(v.y, kSnapBits);
        if (!mode.perspective) v.w = 1;
    }
    return shape;
}

std::uint64_t seed_of(std::uint64_t seed, const Family& family, int n) {
    std::uint64_t mixed = seed;
    const auto mix = [&](std::uint64_t more) {  // splitmix64
        mixed += more + 0x9E3779B97F4A7C15;
        mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
        mixed ^= mixed >> 31;
    };
    for (const char letter : family.name) mix(static_cast<unsigned char>(letter));
    mix(static_cast<std::uint64_t>(n));
    return mixed;
}

}  // namespace texelscope
