// The least that drawing affine triangles can cost: the loop that fetches and stores the same texels in the same
// order, in pieces as wide as the machine's vectors, as core/fast does for wide rows. Rows and where their texels begin
// are computed before the clock starts; nothing is decided, so that now and then a texel is its neighbour.
//   bare_loop FILE.tri ROUNDS [OUT.png]   affine, no depth, textures of powers of two
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/exact/triangle.h"
#include "core/image/packed.h"
#include "core/scene/triangles_scene.h"
#include "tests/bench/peers/peer.h"

#include "core/fast/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/peers/bare_loop.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/fast/simd-inl.h"

#ifndef TEXELSCOPE_BARE_LOOP_ROW
#define TEXELSCOPE_BARE_LOOP_ROW
namespace texelscope::peer {

/// A row of one triangle; u, v, and how they grow along it, in 2^-32 repeats modulo 2^32.
struct Row {
    std::uint32_t first = 0, count = 0;  ///< pixels of the framebuffer
    std::uint32_t u = 0, v = 0, u_x = 0, v_x = 0;
};
struct Texels {
    const std::uint32_t* first;
    int u_shift, v_shift;  ///< of a fraction to its column, or row
    std::uint32_t pitch;   ///< from one row to the next [texels]
};

}  // namespace texelscope::peer
#endif

HWY_BEFORE_NAMESPACE();
namespace texelscope::peer::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_ATTR void draw_rows(std::span<const Row> rows, const Texels& texels, std::uint32_t* pixels) {
    const hn::ScalableTag<std::uint32_t> p;
    const std::size_t lanes = hn::Lanes(p);
    const auto steps = hn::Iota(p, 0), pitch = hn::Set(p, texels.pitch);
    for (const Row& row : rows) {
        const auto u_x = hn::Set(p, row.u_x), v_x = hn::Set(p, row.v_x);
        const auto u_step = hn::Mul(u_x, hn::Set(p, static_cast<std::uint32_t>(lanes))),
                   v_step = hn::Mul(v_x, hn::Set(p, static_cast<std::uint32_t>(lanes)));
        auto u = hn::Add(hn::Set(p, row.u), hn::Mul(u_x, steps)), v = hn::Add(hn::Set(p, row.v), hn::Mul(v_x, steps));
        std::uint32_t* out = pixels + row.first;
        const auto fetch = [&]() HWY_ATTR {
            const auto row_of_texels = hn::Mul(hn::ShiftRightSame(v, texels.v_shift), pitch);
            return texelscope::HWY_NAMESPACE::look_up(p, texels.first,
                                                      hn::Add(row_of_texels, hn::ShiftRightSame(u, texels.u_shift)));
        };
        std::size_t left = row.count;
        for (; left >= lanes; left -= lanes, out += lanes) {
            hn::StoreU(fetch(), p, out);
            u = hn::Add(u, u_step), v = hn::Add(v, v_step);
        }
        if (left > 0) hn::BlendedStore(fetch(), hn::FirstN(p, left), p, out);
    }
}

}  // namespace texelscope::peer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace texelscope::peer {
namespace {

HWY_EXPORT(draw_rows);

constexpr int kPadding = 16;  ///< beyond each row, as `bench` has it

/// a(x, y) = at + x a_x + y a_y through the corners' values.
struct Plane {
    double at, x, y;
};
[[nodiscard]] Plane plane_of(std::span<const Vertex, 3> p, float Vertex::*value) {
    const double bx = double{p[1].x} - double{p[0].x}, by = double{p[1].y} - double{p[0].y};
    const double cx = double{p[2].x} - double{p[0].x}, cy = double{p[2].y} - double{p[0].y};
    const double b = double{p[1].*value} - double{p[0].*value}, c = double{p[2].*value} - double{p[0].*value};
    const double area = bx * cy - cx * by, x = (b * cy - c * by) / area, y = (bx * c - cx * b) / area;
    return {double{p[0].*value} - x * double{p[0].x} - y * double{p[0].y}, x, y};
}

/// The part of a repeat, in units of 2^-32.
[[nodiscard]] std::uint32_t fraction(double repeats) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>((repeats - std::floor(repeats)) * 0x1p32));
}

[[nodiscard]] std::vector<Row> rows_of(const TrianglesFile& file, int pitch) {
    std::vector<Row> rows;
    for (std::size_t n = 0; n < file.vertices.size(); n += 3) {
        const std::span<const Vertex, 3> corners(&file.vertices[n], 3);
        const ExactTriangle triangle(corners);
        if (triangle.winding() == 0 || (file.cull_back && triangle.winding() < 0)) continue;
        const Plane u = plane_of(corners, &Vertex::u), v = plane_of(corners, &Vertex::v);
        const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        const auto end = static_cast<float>(file.height);
        for (int y = static_cast<int>(std::clamp(low - 1, 0.0F, end)),
                 last = static_cast<int>(std::clamp(high + 2, 0.0F, end));
             y < last; ++y) {
            const PixelRange range = triangle.row(y, 0, file.width);
            if (range.empty()) continue;
            const double x = static_cast<double>(range.x0) + .5, line = y + .5;
            rows.push_back({static_cast<std::uint32_t>(y * pitch + range.x0),
                            static_cast<std::uint32_t>(range.x1 - range.x0), fraction(u.at + u.x * x + u.y * line),
                            fraction(v.at + v.x * x + v.y * line), fraction(u.x), fraction(v.x)});
        }
    }
    return rows;
}

void run(const Call& call) {
    const TrianglesFile& file = call.file;
    const auto is_power = [](int size) { return size > 1 && std::has_single_bit(static_cast<unsigned>(size)); };
    if (file.perspective || file.depth || !is_power(file.texture_width) || !is_power(file.texture_height))
        stop("the bare loop draws affine triangles without depth, textures of powers of two");
    const int pitch = file.width + kPadding;
    const std::vector<Row> rows = rows_of(file, pitch);
    const int texture_pitch = file.texture_width + kPadding;
    const std::vector<std::uint32_t> image = packed(default_texels(file), texture_pitch);
    const int u_bits = std::countr_zero(static_cast<unsigned>(file.texture_width)),
              v_bits = std::countr_zero(static_cast<unsigned>(file.texture_height));
    const Texels texels{image.data(), 32 - u_bits, 32 - v_bits, static_cast<std::uint32_t>(texture_pitch)};
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(pitch) * static_cast<std::size_t>(file.height));
    const auto clear = [&] { std::fill(pixels.begin(), pixels.end(), packed(Rgb{})); };
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());  // once, not within the time
    const auto draw = HWY_DYNAMIC_DISPATCH(draw_rows);
    race(call, "bare-loop", clear, [&] { draw(rows, texels, pixels.data()); });
    if (!call.picture.empty()) write_picture(call, unpacked(pixels.data(), pitch, file.width, file.height));
}

}  // namespace
}  // namespace texelscope::peer

int main(int count, char** words) { texelscope::peer::run(texelscope::peer::read_call(count, words)); }
#endif
