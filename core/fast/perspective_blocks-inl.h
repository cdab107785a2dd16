// Triangles in perspective by blocks (blocks-inl.h). u = N / D is found in double at each block's middle. In float32 it
// goes on from there: u + (n - u d) / (D + d), with n and d what N and D change by. A few texels are left.
#if defined(TEXELSCOPE_PERSPECTIVE_BLOCKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_PERSPECTIVE_BLOCKS_INL
#undef TEXELSCOPE_PERSPECTIVE_BLOCKS_INL
#else
#define TEXELSCOPE_PERSPECTIVE_BLOCKS_INL
#endif

#include <bit>

#include "core/fast/perspective_planes-inl.h"

#if HWY_TARGET <= HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

using BlockFloat = hn::Rebind<float, Block>;
using SampleFloats = hn::Vec<BlockFloat>;

/// A triangle's blocks in perspective. u and v are counted in parts of a texel from a whole one, a, in the middle of
/// the triangle; at a sample from its block's patch on, where they stand in the lowest bits of a float32: 2^23 is
/// added.
class PerspectiveBlocks {
    static constexpr float kWhole = 0x1p23F;
    /// Bound of the error of u and v at a sample [parts].
    static constexpr uint32_t kDoubt = 8;
    // Let no sample add more than G to u in the middle, which is half of a patch; D lie within S of D in the middle, M,
    // and S be no more than M / 2. In half ulps: M loses 1, d 3 S, their sum 1: 6 of the sum at most; its inverse 2.1.
    // The numerator loses 4 times what it is, which is no more than G D, and 7 u S for u's own rounding, d's and n's: n
    // is the numerator and u d. Together less than 12.2 G + 7 u S / (M - S). The patch' corner and the sum are rounded
    // to whole parts; what double has lost is less than 1/16: serves().
    static constexpr double kUlpFloat = 0x1p-24 * kParts, kRounded = 1.0625;
    static_assert(kFarPatch <= kTexelApron);
    static_assert((12.2 * kFarPatch / 2 + 7 * kSteep) * kUlpFloat + kRounded < kDoubt);
    /// What follows a texel's bits is certain if one of these is set: no less than twice the doubt.
    static constexpr uint32_t kTested = (1U << kPartBits) - 2 * kDoubt;
    /// What float32 loses of where a block is least and most: three roundings of u, and a few parts of the rest. The
    /// bias is included.
    static constexpr double kMargin = 3 * kMost * kUlpFloat + 64;
    /// Adding it rounds parts to whole texels.
    static constexpr double kWholeTexels = 1.5 * (1 << 23) * kParts;
    /// Set in any float32 near kWhole.
    static constexpr uint32_t kAlways = 1U << 30;

public:
    using Eights = PerspectiveEight;
    /// What the blocks of a window show.
    struct Found : Window {
        alignas(64) float one[kBlocks], u[kBlocks], v[kBlocks];  ///< D, u and v in the middle
        alignas(64) float u_patch[kBlocks], v_patch[kBlocks];    ///< the same from the patch on, kWhole and doubt added
        alignas(64) uint32_t texel[kBlocks];                     ///< the patch' first
        uint32_t far;     ///< bit n: the patch of block n does not hold all of its texels
        uint32_t beyond;  ///< bit n: float32 cannot tell them, either
    };

    /// Of which triangles what double loses is nothing beside float32's losses. Where rows need no division, they are
    /// faster.
    [[nodiscard]] static HWY_INLINE hn::Mask<Real> serves(const Batch& b, const Canvas& canvas) {
        const auto fits = [](const Eight& far, int bits) HWY_ATTR {
            const double most = bits > kPatchBits ? units_in_texel(bits) / kParts / 64 : 0;
            return hn::Lt(hn::Load(Real{}, far.at), hn::Set(Real{}, most));
        };
        const auto all = hn::And(fits(b.u_far, canvas.u_bits), fits(b.v_far, canvas.v_bits));
        if (!canvas.settings->skip(RasterSkip::level_w)) return all;
        return hn::And(all, hn::Ne(hn::Load(Real{}, b.one.x.at), hn::Zero(Real{})));
    }
    HWY_INLINE void set_up(int t, const Canvas& /*canvas*/, const PerspectiveEight& all) {
        all_ = &all, t_ = t;
        one_lanes_ = lanes_of(all.one), u_lanes_ = lanes_of(all.u), v_lanes_ = lanes_of(all.v);
        u_tested_ = v_tested_ = kTested;
    }
    HWY_INLINE void use(const Batch& /*b*/, int /*t*/, const Canvas& canvas, const HalfGaps& gaps) {
        // Half of the gap in parts.
        const double u = gaps.u * kParts / units_in_texel(canvas.u_bits),
                     v = gaps.v * kParts / units_in_texel(canvas.v_bits);
        gaps_ = gaps;
        u_tested_ = kTested | (u > kDoubt ? kAlways : 0), v_tested_ = kTested | (v > kDoubt ? kAlways : 0);
    }
    /// Whether no sample needs a test.
    [[nodiscard]] HWY_INLINE bool sure() const { return (u_tested_ & v_tested_ & kAlways) != 0; }

    HWY_INLINE void go_to(const Batch& /*b*/, int /*t*/, const Doubles& right, const Doubles& down) {
        const V middle = hn::Set(Real{}, kToMiddle);
        right_ = {hn::Add(right.low, middle), hn::Add(right.high, middle)};
        const Doubles y{hn::Add(down.low, middle), hn::Add(down.high, middle)};
        const auto at_strips = [&](const StepsEight& steps) HWY_ATTR {
            const Real d;
            const V at = hn::Set(d, steps.plane.at.at[t_]), step = hn::Set(d, steps.plane.y.at[t_]);
            return Doubles{hn::MulAdd(y.low, step, at), hn::MulAdd(y.high, step, at)};
        };
        one_at_ = at_strips(all_->one), u_at_ = at_strips(all_->u), v_at_ = at_strips(all_->v);
    }
    HWY_INLINE void find(const Batch& /*b*/, int /*t*/, const Canvas& canvas, bool both, Found& found) {
        found.far = found.beyond = 0;
        const uint32_t some = found.parts | found.wholes;
        find_half(canvas, right_, some & 0xFFFF, 0, found);
        if (both) find_half(canvas, moved(right_, kHalfWidth), some >> kHalf, kHalf, found);
        right_ = moved(right_, kWindowWidth);
    }
    /// Draws the blocks whose bits are set and whose texels fit a patch. False: some of their texels are unsure; where
    /// `doubtful` is given, it is told which samples are, a number for each block.
    template <bool kWholeBlock, bool kCertain>
    HWY_INLINE bool put(const Found& found, uint32_t which, const Canvas& canvas, uint16_t* doubtful = nullptr) const {
        const Block p;
        const uint32_t* const texels = canvas.texture.texels;
        const std::ptrdiff_t pitch = canvas.target.pitch, texture_pitch = canvas.texture.pitch;
        uint32_t* const line = canvas.target.pixels + found.row * pitch;
        const auto one_lanes = one_lanes_, u_lanes = u_lanes_, v_lanes = v_lanes_;
        const auto u_tested = hn::Set(p, u_tested_), v_tested = hn::Set(p, v_tested_);
        __mmask16 unsure = 0;
        for (; which != 0; which &= which - 1) {
            const int n = std::countr_zero(which);
            Samples u, v;
            at(found, n, one_lanes, u_lanes, v_lanes, u, v);
            const __m512i place =
                _mm512_ternarylogic_epi32(hn::Set(p, kPatch - 1).raw, hn::ShiftRight<kPartBits>(u).raw,
                                          hn::ShiftRight<kPartBits - kPatchBits>(v).raw, 0xCA);
            const __mmask16 lower = _mm512_test_epi32_mask(v.raw, _mm512_set1_epi32(4 << kPartBits));
            const auto texel = look_up_patch(texels + found.texel[n], texture_pitch, Samples{place}, lower);
            const __mmask16 inside = store_block<kWholeBlock>(texel, found.inside[n], line + found.out[n], pitch);
            if constexpr (kCertain) note(in_doubt(inside, u, u_tested, v, v_tested), n, unsure, doubtful);
        }
        return unsure == 0;
    }
    /// The same for blocks whose texels lie farther apart.
    template <bool kCertain>
    HWY_INLINE bool put_far(const Found& found, uint32_t which, const Canvas& canvas,
                            uint16_t* doubtful = nullptr) const {
        const Block p;
        const std::ptrdiff_t pitch = canvas.target.pitch;
        uint32_t* const line = canvas.target.pixels + found.row * pitch;
        const auto one_lanes = one_lanes_, u_lanes = u_lanes_, v_lanes = v_lanes_;
        const auto u_tested = hn::Set(p, u_tested_), v_tested = hn::Set(p, v_tested_);
        const auto in_patch = hn::Set(p, kFarPatch - 1U),
                   texture_pitch = hn::Set(p, static_cast<uint32_t>(canvas.texture.pitch));
        __mmask16 unsure = 0;
        for (; which != 0; which &= which - 1) {
            const int n = std::countr_zero(which);
            Samples u, v;
            at(found, n, one_lanes, u_lanes, v_lanes, u, v);
            const auto column = hn::And(hn::ShiftRight<kPartBits>(u), in_patch),
                       line_of = hn::And(hn::ShiftRight<kPartBits>(v), in_patch);
            const auto texel =
                look_up(p, canvas.texture.texels + found.texel[n], hn::Add(hn::Mul(line_of, texture_pitch), column));
            const __mmask16 inside = store_block<false>(texel, found.inside[n], line + found.out[n], pitch);
            if constexpr (kCertain) note(in_doubt(inside, u, u_tested, v, v_tested), n, unsure, doubtful);
        }
        return unsure == 0;
    }
    /// The same in double, for blocks that float32 cannot tell; mends unsure texels, and returns as mend() does.
    HWY_NOINLINE bool put_in_double(const Batch& b, int t, const Found& found, uint32_t which, Again& again,
                                    bool only_double, const Canvas& canvas) const {
        const Block p;
        const Real d;
        alignas(64) static constexpr double kRight[] = {0, 2, 0, 2, 0, 2, 0, 2}, kDown[] = {0, 0, 1, 1, 2, 2, 3, 3};
        const CertainPair certain = certain_in_double(b, t, again, canvas);
        const Texels<Block, Addressing::powers> texels(canvas, b, t, certain);
        const bool sure = certain.sure();
        const std::ptrdiff_t pitch = canvas.target.pitch;
        uint32_t* const line = canvas.target.pixels + found.row * pitch;
        for (; which != 0; which &= which - 1) {
            const int n = std::countr_zero(which), down = n % kHalf / kBlock * kBlock;
            const auto x = static_cast<int>(found.out[n] - down * pitch);
            const V at_x = hn::Set(d, x - b.column0.at[t]), at_y = hn::Set(d, found.row + down - b.row0.at[t]);
            Samples u = hn::Zero(p), v = u;
            FineRow<true, Block>(b, t, hn::Add(at_x, hn::Load(d, kRight)), hn::Add(at_y, hn::Load(d, kDown)), certain)
                .next(u, v);
            const __mmask16 inside =
                store_block<false>(texels.fetch(u, v), found.inside[n], line + found.out[n], pitch);
            if (sure) continue;
            for (uint32_t m = inside & bits_of(p, texels.unsure(u, v)); m != 0; m &= m - 1) {
                const int sample = std::countr_zero(m);
                if (!mend_pixel(again, x + sample % kBlock, found.row + down + sample / kBlock, only_double, canvas))
                    return false;
            }
        }
        return true;
    }
    /// What makes texels certain in double.
    [[nodiscard]] HWY_INLINE CertainPair certain_in_double(const Batch& b, int t, const Again& again,
                                                           const Canvas& canvas) const {
        return fine_certain_of(b, t, again, gaps_, canvas);
    }
    /// Bit n: sample n of a block is in doubt.
    [[nodiscard]] HWY_INLINE uint32_t unsure(const Found& found, int n) const {
        Samples u, v;
        at(found, n, one_lanes_, u_lanes_, v_lanes_, u, v);
        return uint32_t{in_doubt(0xFFFF, u, hn::Set(Block{}, u_tested_), v, hn::Set(Block{}, v_tested_))};
    }

private:
    static HWY_INLINE void note(__mmask16 in_block, int n, __mmask16& unsure, uint16_t* doubtful) {
        unsure = _kor_mask16(unsure, in_block);
        if (doubtful != nullptr) _store_mask16(reinterpret_cast<__mmask16*>(doubtful + n), in_block);
    }
    /// What a plane adds at each sample of a block.
    [[nodiscard]] HWY_INLINE SampleFloats lanes_of(const StepsEight& steps) const {
        const BlockFloat f;
        alignas(64) static constexpr float kRight[16] = {-1.5, -.5, .5, 1.5, -1.5, -.5, .5, 1.5,
                                                         -1.5, -.5, .5, 1.5, -1.5, -.5, .5, 1.5};
        alignas(64) static constexpr float kDown[16] = {-1.5, -1.5, -1.5, -1.5, -.5, -.5, -.5, -.5,
                                                        .5,   .5,   .5,   .5,   1.5, 1.5, 1.5, 1.5};
        return hn::MulAdd(hn::Load(f, kDown), hn::Set(f, steps.y.at[t_]),
                          hn::Mul(hn::Load(f, kRight), hn::Set(f, steps.x.at[t_])));
    }
    static HWY_INLINE SampleFloats reciprocal(SampleFloats a) {
        const SampleFloats r{_mm512_rcp14_ps(a.raw)};
        return hn::Mul(r, hn::NegMulAdd(a, r, hn::Set(BlockFloat{}, 2.0F)));
    }
    /// u and v at the samples of block n, from its patch on.
    static HWY_INLINE void at(const Found& found, int n, SampleFloats one_lanes, SampleFloats u_lanes,
                              SampleFloats v_lanes, Samples& u, Samples& v) {
        const BlockFloat f;
        const auto inverse = reciprocal(hn::Add(one_lanes, hn::Set(f, found.one[n])));
        const auto go_on = [&](float middle, SampleFloats lanes, float patch) HWY_ATTR {
            const auto change = hn::NegMulAdd(hn::Set(BlockFloat{}, middle), one_lanes, lanes);
            return hn::BitCast(Block{}, hn::MulAdd(change, inverse, hn::Set(BlockFloat{}, patch)));
        };
        u = go_on(found.u[n], u_lanes, found.u_patch[n]), v = go_on(found.v[n], v_lanes, found.v_patch[n]);
    }
    /// The lanes' larger number, by its size.
    static HWY_INLINE SampleFloats larger(SampleFloats a, SampleFloats c) {
        return SampleFloats{_mm512_range_ps(a.raw, c.raw, 0b1011)};
    }
    static HWY_INLINE SampleFloats demote(const Doubles& a) {
        return hn::Combine(BlockFloat{}, hn::DemoteTo(Narrow{}, a.high), hn::DemoteTo(Narrow{}, a.low));
    }
    static HWY_INLINE Doubles promote(SampleFloats a) {
        const hn::Half<BlockFloat> half;
        return {hn::PromoteTo(Real{}, hn::LowerHalf(half, a)), hn::PromoteTo(Real{}, hn::UpperHalf(half, a))};
    }
    /// u or v of 16 blocks.
    struct Middles {
        SampleFloats at;    ///< in the middle, from a on
        SampleFloats rest;  ///< from the patch to the farthest sample
        Samples texel;      ///< the patch' first
    };
    /// The blocks of a half from `first` on, whose middles lie at these columns; `some` has the bits of those to be
    /// drawn.
    HWY_INLINE void find_half(const Canvas& canvas, const Doubles& right, uint32_t some, int first,
                              Found& found) const {
        const Real d;
        const BlockFloat f;
        const Block p;
        const auto all = [](double a) HWY_ATTR { return hn::Set(BlockFloat{}, static_cast<float>(a)); };
        const auto of = [&](const EightFloat& a) HWY_ATTR { return hn::Set(BlockFloat{}, a.at[t_]); };
        const auto value = [&](const StepsEight& steps, const Doubles& at) HWY_ATTR {
            const V x = hn::Set(Real{}, steps.plane.x.at[t_]);
            return Doubles{hn::MulAdd(right.low, x, at.low), hn::MulAdd(right.high, x, at.high)};
        };
        const Doubles one_at = value(all_->one, one_at_);
        const auto one = demote(one_at);
        const V unit = hn::Set(d, 1.0);
        const Doubles inverse{hn::Div(unit, one_at.low), hn::Div(unit, one_at.high)};
        // Over the least D, rounded up.
        const SampleFloats most_inverse{_mm512_rcp14_ps(hn::Sub(one, of(all_->spread)).raw)};
        const auto per_pixel = hn::Mul(most_inverse, all(kToMiddle * 1.001));
        // The gradient is (gradient of N - u gradient of D) / D. Of x and y the sum of absolute values is the larger of
        // their sum and their difference.
        const auto axis = [&](const StepsEight& steps, const Doubles& at, const EightInt& from, int size,
                              float* middle_out, float* patch_out) HWY_ATTR {
            const Real r;
            const Doubles over = value(steps, at);
            const Doubles exact{hn::Mul(over.low, inverse.low), hn::Mul(over.high, inverse.high)};
            Middles m;
            m.at = demote(exact);
            const auto sum = hn::NegMulAdd(m.at, of(all_->one.sum), of(steps.sum)),
                       difference = hn::NegMulAdd(m.at, of(all_->one.difference), of(steps.difference));
            const auto spread = hn::MulAdd(larger(sum, difference), per_pixel, all(kMargin));
            const SampleFloats texel{_mm512_add_round_ps(hn::Sub(m.at, spread).raw, all(kWholeTexels).raw,
                                                         _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
            const auto begin = hn::Sub(texel, all(kWholeTexels));
            m.rest = hn::Sub(hn::Add(m.at, spread), begin);
            const Doubles patch = promote(begin);
            const V whole = hn::Set(r, double{kWhole} + kDoubt);
            const auto in_patch = demote(
                {hn::Add(hn::Sub(exact.low, patch.low), whole), hn::Add(hn::Sub(exact.high, patch.high), whole)});
            hn::Store(m.at, BlockFloat{}, middle_out + first), hn::Store(in_patch, BlockFloat{}, patch_out + first);
            m.texel =
                hn::And(hn::Add(hn::BitCast(Block{}, texel), hn::Set(Block{}, static_cast<uint32_t>(from.at[t_]))),
                        hn::Set(Block{}, size - 1U));
            return m;
        };
        const Middles u = axis(all_->u, u_at_, all_->u_from, canvas.texture.width, found.u, found.u_patch),
                      v = axis(all_->v, v_at_, all_->v_from, canvas.texture.height, found.v, found.v_patch);
        hn::Store(one, f, found.one + first);
        hn::Store(hn::Add(hn::Mul(v.texel, hn::Set(p, static_cast<uint32_t>(canvas.texture.pitch))), u.texel), p,
                  found.texel + first);
        // Each compared by itself: of NaN and a number the machine says that the number is larger.
        const auto within = [&](double texels) HWY_ATTR {
            const auto most = all(texels * kParts);
            return hn::And(hn::Lt(u.rest, most), hn::Lt(v.rest, most));
        };
        const auto told_of = hn::And(hn::Ge(one, of(all_->least_one)), within(kFarPatch));
        const uint32_t told = bits_of(f, told_of), near = told & bits_of(f, within(kPatch));
        found.far |= (some & told & ~near) << first, found.beyond |= (some & ~told) << first;
    }

    const PerspectiveEight* all_;
    int t_;                                       ///< which of them
    SampleFloats one_lanes_, u_lanes_, v_lanes_;  ///< what they change by from a block's middle to each sample
    uint32_t u_tested_, v_tested_;                ///< kTested, and kAlways where all texels are certain
    HalfGaps gaps_;
    Doubles right_;                 ///< the middles of the next window's left half
    Doubles one_at_, u_at_, v_at_;  ///< the planes at their rows, at column 0 of the box
};

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();

#endif
#endif
