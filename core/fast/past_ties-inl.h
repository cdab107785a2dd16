// A triangle in perspective by blocks, once some sample ties: half of the gap between a border and any sample not on it
// tells ties. What float32 cannot tell so, either, is collected sample by sample and drawn in double, some at once.
#if defined(TEXELSCOPE_PAST_TIES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_PAST_TIES_INL
#undef TEXELSCOPE_PAST_TIES_INL
#else
#define TEXELSCOPE_PAST_TIES_INL
#endif

#include <bit>

#include "core/fast/perspective_blocks-inl.h"

#if HWY_TARGET <= HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// Samples that float32 cannot tell.
class DoubtfulSamples {
public:
    HWY_INLINE DoubtfulSamples() : count_(0) {}

    /// Returns how many blocks have some.
    /// @param doubtful  a number for each block, bit n of which is sample n
    HWY_INLINE int add(const Window& window, const uint16_t* doubtful, const Canvas& canvas) {
        const Block p;
        const hn::Repartition<uint16_t, Block> masks;
        const auto in_block = hn::Or(place_of_lane(), hn::ShiftLeft<16>(four_of_lane()));
        const uint32_t blocks = bits_of(masks, hn::Ne(hn::Load(masks, doubtful), hn::Zero(masks)));
        for (uint32_t which = blocks; which != 0; which &= which - 1) {
            const int n = std::countr_zero(which), down = n % kHalf / kBlock * kBlock;
            const auto x = static_cast<uint32_t>(window.out[n] - down * canvas.target.pitch);
            const auto first = hn::Set(p, x | static_cast<uint32_t>(window.row + down) << 16);
            _mm512_storeu_si512(places_ + count_,
                                _mm512_maskz_compress_epi32(doubtful[n], hn::Add(first, in_block).raw));
            count_ += std::popcount(doubtful[n]);
        }
        return std::popcount(blocks);
    }
    /// Whether another window's might not fit.
    [[nodiscard]] HWY_INLINE bool full() const { return count_ > kMost; }

    /// Draws them. What double cannot tell, either, is decided exactly.
    HWY_NOINLINE void put(const Batch& b, int t, const CertainPair& certain, Again& again, const Canvas& canvas) {
        using Tag = hn::CappedTag<uint32_t, kReals>;
        const Tag p;
        const Real d;
        const hn::Repartition<uint64_t, Real> bits;
        const Texels<Tag, Addressing::powers> texels(canvas, b, t, certain);
        const auto pitch = hn::Set(p, static_cast<uint32_t>(canvas.target.pitch));
        for (int n = 0; n < count_; n += kReals) {
            const auto place = hn::LoadU(p, places_ + n);
            const auto column = hn::And(place, hn::Set(p, 0xFFFF)), row = hn::ShiftRight<16>(place);
            const auto from = [&](hn::Vec<Tag> at, int first) HWY_ATTR {
                return hn::Sub(hn::PromoteTo(Real{}, hn::BitCast(Index{}, at)), hn::Set(Real{}, first));
            };
            V fine_u = hn::Zero(d), fine_v = fine_u;
            FineRow<true, Block>(b, t, from(column, b.column0.at[t]), from(row, b.row0.at[t]), certain)
                .given(fine_u, fine_v);
            const auto u = hn::TruncateTo(p, hn::BitCast(bits, fine_u)),
                       v = hn::TruncateTo(p, hn::BitCast(bits, fine_v));
            alignas(32) uint32_t found[kReals], at[kReals];
            hn::Store(texels.fetch(u, v), p, found);
            hn::Store(hn::Add(hn::Mul(row, pitch), column), p, at);
            const int some = std::min(count_ - n, kReals);
            for (int k = 0; k < some; ++k) canvas.target.pixels[at[k]] = found[k];
            const auto in = hn::FirstN(p, static_cast<size_t>(some));
            for (uint32_t m = bits_of(p, hn::And(in, texels.unsure(u, v))); m != 0; m &= m - 1) {
                const uint32_t asked = places_[n + std::countr_zero(m)];
                mend_pixel(again, static_cast<int>(asked & 0xFFFF), static_cast<int>(asked >> 16), false, canvas);
            }
        }
        count_ = 0;
    }

private:
    static constexpr int kMost = 512;

    int count_;
    /// Column in the lower half, row in the upper one: a target has at most 2^14. With room for a window more, and for
    /// a vector that is stored whole.
    alignas(64) uint32_t places_[kMost + (kBlocks + 1) * kBlock * kBlock];
};

class PastTies {
public:
    HWY_INLINE PastTies() : known_(false) {}

    /// Another triangle.
    HWY_INLINE void begin() { known_ = mostly_doubtful_ = false; }
    /// Whether the gap is known.
    [[nodiscard]] HWY_INLINE bool known() const { return known_; }

    /// Draws a window of which some texels are unsure without the gap, or may be with it.
    HWY_NOINLINE void put(const Batch& b, int t, const PerspectiveBlocks::Found& found, PerspectiveBlocks& kind,
                          Again& again, const Canvas& canvas) {
        if (!known_) kind.use(b, t, canvas, again.half_gaps());
        // What float32 has drawn is right where it need not be asked any more.
        uint32_t in_double = found.beyond;
        if (!kind.sure()) {
            const uint32_t all = found.parts | found.wholes;
            if (mostly_doubtful_)
                in_double = all;
            else
                mostly_doubtful_ = put_in_float(b, t, found, kind, again, canvas) * 2 > std::popcount(all);
        }
        known_ = true;
        if (in_double != 0) kind.put_in_double(b, t, found, in_double, again, false, canvas);
    }
    /// Draws what was put off.
    HWY_NOINLINE void finish(const Batch& b, int t, const PerspectiveBlocks& kind, Again& again, const Canvas& canvas) {
        samples_.put(b, t, kind.certain_in_double(b, t, again, canvas), again, canvas);
    }

private:
    /// Puts off the samples that are unsure. Returns how many blocks have such.
    HWY_INLINE int put_in_float(const Batch& b, int t, const PerspectiveBlocks::Found& found,
                                const PerspectiveBlocks& kind, Again& again, const Canvas& canvas) {
        const hn::Repartition<uint16_t, Block> masks;
        static_assert(kBlocks == hn::MaxLanes(masks));
        alignas(64) uint16_t doubtful[kBlocks];
        hn::Store(hn::Zero(masks), masks, doubtful);
        const uint32_t near = ~(found.far | found.beyond);
        kind.put_far<true>(found, found.far, canvas, doubtful);
        kind.put<false, true>(found, found.parts & near, canvas, doubtful);
        kind.put<true, true>(found, found.wholes & near, canvas, doubtful);
        const int blocks = samples_.add(found, doubtful, canvas);
        if (samples_.full()) finish(b, t, kind, again, canvas);
        return blocks;
    }

    bool known_, mostly_doubtful_;
    DoubtfulSamples samples_;
};

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();

#endif
#endif
