// Triangles within a block of 4 x 4 samples: all of them at once.
#if defined(TEXELSCOPE_TINY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_TINY_INL
#undef TEXELSCOPE_TINY_INL
#else
#define TEXELSCOPE_TINY_INL
#endif

#include "core/fast/cover-inl.h"
#include "core/fast/texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// False: nothing was drawn, too much is in doubt.
template <Addressing kAddressing>
HWY_INLINE bool draw_tiny(const Batch& b, int t, const Canvas& canvas) {
    const hn::CappedTag<uint32_t, 16> p;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    const Texels<decltype(p), kAddressing> texels(canvas, b, t, certain_of(b, t));
    uint64_t all = 0;
    if (!cover<2>(b, t, all)) return false;
    auto inside = static_cast<uint32_t>(all);
    const int column = b.column0.at[t], row = b.row0.at[t];
    if (column + 4 > canvas.target.width) inside &= 0x1111U * ((1U << (canvas.target.width - column)) - 1);
    if (row + 4 > canvas.target.height) inside &= (1U << (4 * (canvas.target.height - row))) - 1;
    if (inside == 0) return true;
    canvas.counters->samples += static_cast<uint64_t>(std::popcount(inside));
    const auto x = hn::And(hn::Iota(p, 0), hn::Set(p, 3U));
    alignas(64) uint32_t found[16];
    uint32_t unsure = 0;
    for (int lane = 0; lane < 16; lane += kLanes) {
        const auto y = hn::ShiftRight<2>(lanes_from(p, static_cast<uint32_t>(lane)));
        const auto u = units_at(p, b.u, t, x, y), v = units_at(p, b.v, t, x, y);
        hn::Store(texels.fetch(u, v), p, found + lane);
        unsure |= bits_of(p, texels.unsure(u, v)) << lane;
    }
    const std::ptrdiff_t pitch = canvas.target.pitch;
    uint32_t* const out = canvas.target.pixels + row * pitch + column;
    if (HWY_TARGET <= HWY_AVX3 || (column + 4 <= canvas.target.width && row + 4 <= canvas.target.height)) {
        const hn::CappedTag<uint32_t, 4> four;
        uint32_t* line = out;
        for (int n = 0; n < 4; ++n, line += pitch) {
            const uint8_t bits[8] = {static_cast<uint8_t>(inside >> (4 * n) & 15)};
            store_some(hn::Load(four, found + 4 * n), hn::LoadMaskBits(four, bits), four, line, line + 4);
        }
    } else {
        // Beyond the target's end are others' rows, or none: a masked store leaves them alone, but not one that writes
        // what stands there again.
        for (uint32_t m = inside; m != 0; m &= m - 1) {
            const int n = std::countr_zero(m);
            out[(n >> 2) * pitch + (n & 3)] = found[n];
        }
    }
    if ((unsure & inside) == 0 || !canvas.settings->certain) return true;
    Again again(canvas, b, t, false);
    for (uint32_t m = unsure & inside; m != 0; m &= m - 1) {
        const int n = std::countr_zero(m), at_x = column + (n & 3), at_y = row + (n >> 2);
        canvas.target.pixels[at_y * pitch + at_x] = again.texel(at_x, at_y);
    }
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
