// The same triangles by Allegro 4, the library of the DOS years, whose loops are still compiled C: affine ones by
// POLYTYPE_ATEX, the others by POLYTYPE_PTEX, which divides once in four pixels at least.
//   allegro FILE.tri ROUNDS [OUT.png]   no depth, textures of powers of two; prints as `texelscope bench` does
// It samples at whole coordinates, so corners are moved by half a pixel before the clock starts. It is not exact about
//   which samples lie inside    sides are 16.16 numbers, stepped row by row
//   which texel                 u and v are 16.16 numbers too, or float32 over z
#define ALLEGRO_NO_MAGIC_MAIN
#include <allegro.h>

#include <bit>

#include "core/image/packed.h"
#include "core/scene/triangles_scene.h"
#include "tests/bench/peers/peer.h"

namespace texelscope::peer {
namespace {

constexpr int kPadding = 16;  ///< beyond each row, as `bench` has it

[[nodiscard]] BITMAP* bitmap(int width, int height) {
    BITMAP* const made = create_bitmap_ex(32, width, height);
    if (made == nullptr) stop("Allegro has no memory for a bitmap");
    return made;
}
[[nodiscard]] std::uint32_t* row_of(BITMAP* image, int y) { return reinterpret_cast<std::uint32_t*>(image->line[y]); }

[[nodiscard]] std::vector<V3D_f> corners_of(const TrianglesFile& file) {
    std::vector<V3D_f> corners;
    for (const Vertex& v : file.vertices)
        corners.push_back({v.x - .5F, v.y - .5F, file.perspective ? v.w : 1.0F,
                           v.u * static_cast<float>(file.texture_width), v.v * static_cast<float>(file.texture_height),
                           0});
    return corners;
}

void run(const Call& call) {
    const TrianglesFile& file = call.file;
    const auto is_power = [](int size) { return std::has_single_bit(static_cast<unsigned>(size)); };
    if (file.depth || file.cull_back || !is_power(file.texture_width) || !is_power(file.texture_height))
        stop("allegro draws triangles without depth and culling, textures of powers of two");
    if (install_allegro(SYSTEM_NONE, &errno, nullptr) != 0) stop("Allegro does not start");
    set_color_depth(32);
    BITMAP *const texture = bitmap(file.texture_width, file.texture_height), *const frame = bitmap(
                                                                                 file.width + kPadding, file.height);
    set_clip_rect(frame, 0, 0, file.width - 1, file.height - 1);
    const std::vector<std::uint32_t> texels = packed(default_texels(file), file.texture_width);
    for (int y = 0; y < file.texture_height; ++y)
        std::copy_n(texels.data() + static_cast<std::ptrdiff_t>(y) * file.texture_width, file.texture_width,
                    row_of(texture, y));
    std::vector<V3D_f> corners = corners_of(file);
    const auto clear = [&] {
        for (int y = 0; y < file.height; ++y) std::fill_n(row_of(frame, y), frame->w, packed(Rgb{}));
    };
    race(call, "allegro", clear, [&] {
        const int kind = file.perspective ? POLYTYPE_PTEX : POLYTYPE_ATEX;
        for (std::size_t n = 0; n < corners.size(); n += 3)
            triangle3d_f(frame, kind, texture, &corners[n], &corners[n + 1], &corners[n + 2]);
    });
    if (!call.picture.empty()) write_picture(call, unpacked(row_of(frame, 0), frame->w, file.width, file.height));
}

}  // namespace
}  // namespace texelscope::peer

int main(int count, char** words) { texelscope::peer::run(texelscope::peer::read_call(count, words)); }
