// Triangles within a block of 8 x 8 samples: those inside are packed, so that vectors of texels are full.
#if defined(TEXELSCOPE_SMALL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_SMALL_INL
#undef TEXELSCOPE_SMALL_INL
#else
#define TEXELSCOPE_SMALL_INL
#endif

#include "core/fast/cover-inl.h"
#include "core/fast/depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

constexpr int kSmallBits = 3, kSmall = 1 << kSmallBits;  ///< samples from one side of the block to the other

/// The numbers of the bits that are set, in order. Returns how many.
HWY_INLINE int pack(uint64_t bits, uint32_t* numbers) {
    int count = 0;
#if HWY_TARGET <= HWY_AVX3
    const hn::CappedTag<uint32_t, 16> p;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    for (int first = 0; first < kSmall * kSmall; first += kLanes) {
        const uint32_t some = static_cast<uint32_t>(bits >> first) & ((1U << kLanes) - 1);
        const uint8_t bytes[8] = {static_cast<uint8_t>(some), static_cast<uint8_t>(some >> 8)};
        const auto packed = hn::Compress(lanes_from(p, static_cast<uint32_t>(first)), hn::LoadMaskBits(p, bytes));
        hn::StoreU(packed, p, numbers + count);
        count += std::popcount(some);
    }
#else  // without such an instruction
    for (; bits != 0; bits &= bits - 1) numbers[count++] = static_cast<uint32_t>(std::countr_zero(bits));
#endif
    return count;
}

/// The samples of `inside` that pass the depth test; it is left nearer.
HWY_INLINE uint64_t pass_depth_in_block(const Batch& b, int t, uint64_t inside, Again& again, const Canvas& canvas) {
    const hn::CappedTag<uint32_t, kSmall> p;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    uint64_t nearer = 0;
    const int row0 = b.row0.at[t], column0 = b.column0.at[t];
    for (int y = row0, shift = 0; y < b.row1.at[t]; ++y) {
        const DepthRow<decltype(p)> depth(b, t, y);
        for (int x = 0; x < kSmall; x += kLanes, shift += kLanes) {
            const uint8_t bits[8] = {static_cast<uint8_t>((inside >> shift) & ((1U << kLanes) - 1))};
            const auto passed = pass_depth(depth, column0 + x, y, hn::LoadMaskBits(p, bits), again, canvas);
            nearer |= uint64_t{bits_of(p, passed)} << shift;
        }
    }
    return nearer;
}

/// False: nothing was drawn, too much is in doubt.
template <Addressing kAddressing, bool kDepth>
HWY_NOINLINE bool draw_small(const Batch& b, int t, const Canvas& canvas) {
    const hn::CappedTag<uint32_t, 16> p;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    uint64_t inside = 0;
    if (!cover<kSmallBits>(b, t, inside)) return false;
    const int column = b.column0.at[t], row = b.row0.at[t];
    if (column + kSmall > canvas.target.width)
        inside &= 0x0101'0101'0101'0101U * ((1U << (canvas.target.width - column)) - 1);
    if (row + kSmall > canvas.target.height) inside &= (uint64_t{1} << (kSmall * (canvas.target.height - row))) - 1;
    if (inside == 0) return true;
    canvas.counters->samples += static_cast<uint64_t>(std::popcount(inside));
    Again again(canvas, b, t, false);
    const bool late = kDepth && !canvas.settings->skip(RasterSkip::early_z);
    uint64_t shown = inside;
    if (kDepth && !late) {
        shown = pass_depth_in_block(b, t, inside, again, canvas);
        if (shown != inside) again.note_spared();
        if (shown == 0) return true;
    }
    const Texels<decltype(p), kAddressing> texels(canvas, b, t, certain_of(b, t));
    alignas(64) uint32_t numbers[kSmall * kSmall + kLanes];
    const int count = pack(shown, numbers);
    uint32_t* const pixels = canvas.target.pixels + row * canvas.target.pitch + column;
    [[maybe_unused]] uint32_t block[kSmall * kSmall];
    uint32_t* const out = late ? block : pixels;
    const auto pitch = static_cast<uint32_t>(late ? kSmall : canvas.target.pitch);
    for (int n = 0; n < count; n += kLanes) {
        // What lies beyond the last sample is once more the first of these, which is not mended yet.
        const auto number = hn::IfThenElse(hn::FirstN(p, static_cast<size_t>(count - n)), hn::Load(p, numbers + n),
                                           hn::Set(p, numbers[n]));
        const auto x = hn::And(number, hn::Set(p, kSmall - 1U)), y = hn::ShiftRight<kSmallBits>(number);
        const auto u = units_at(p, b.u, t, x, y), v = units_at(p, b.v, t, x, y);
        scatter_looked_up(p, texels.texels, texels.place(u, v), hn::Add(hn::Mul(y, hn::Set(p, pitch)), x), out);
        uint32_t unsure = bits_of(p, texels.unsure(u, v));
        if (unsure == 0 || !canvas.settings->certain) continue;
        if (count - n < kLanes) unsure &= (1U << (count - n)) - 1;
        for (; unsure != 0; unsure &= unsure - 1) {
            const uint32_t which = numbers[n + std::countr_zero(unsure)], right = which % kSmall, down = which / kSmall;
            out[down * pitch + right] = again.texel(column + static_cast<int>(right), row + static_cast<int>(down));
        }
    }
    if (late)
        for (uint64_t m = pass_depth_in_block(b, t, inside, again, canvas); m != 0; m &= m - 1) {
            const auto which = static_cast<uint32_t>(std::countr_zero(m));
            pixels[which / kSmall * canvas.target.pitch + which % kSmall] = block[which];
        }
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
