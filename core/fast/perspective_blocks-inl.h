// Triangles in perspective by blocks (blocks-inl.h). With u = N / D and a whole texel a near it, u - a = (N - a D) / D:
// in double at each block's middle, and in float32 from there, where a few texels are left.
#if defined(TEXELSCOPE_PERSPECTIVE_BLOCKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_PERSPECTIVE_BLOCKS_INL
#undef TEXELSCOPE_PERSPECTIVE_BLOCKS_INL
#else
#define TEXELSCOPE_PERSPECTIVE_BLOCKS_INL
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/fast/blocks-inl.h"

#if HWY_TARGET <= HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

using BlockFloat = hn::Rebind<float, Block>;
using SampleFloats = hn::Vec<BlockFloat>;

/// A triangle's blocks in perspective. u and v are counted in parts of a texel from a whole one near the window's
/// middle, and stand in the lowest bits of a float32: 1.5 2^23 is added to them.
class PerspectiveBlocks {
    static constexpr int kPartBits = 16;
    static constexpr double kParts = 1 << kPartBits;
    static constexpr float kWhole = 0x1.8p23F;
    /// No sample of a block is farther from that texel; of one whose texels are loaded one by one [texels].
    static constexpr double kNear = 27, kFar = 60;
    /// Bounds of the error of these [parts].
    static constexpr uint32_t kNearDoubt = 2, kFarDoubt = 8;
    // In float32, with D within a quarter of D in the middle, so that D there is at most 4/3 of D at a sample. In half
    // ulps of u, no more than R, seen from D at the sample: the numerator loses 4/3 R for the middle and, in a window's
    // right half, as much for the step to there; 3 times what the sample adds to it; and R for the sum. D loses twice
    // 4/3, 3 times 1/3 and 1 of itself, its inverse 2. What a sample adds is u's change, at most a patch or 2 R, and
    // R/3 as D changes; no corner adds more than 5/3 of it. Together less than 12.1 R + 40, or 22.1 R. The sum that
    // rounds to whole parts loses half of one. What double has lost is less than 1/16: serves().
    static constexpr double kUlpFloat = 0x1p-24 * kParts, kRounded = .5 + .0625;
    static_assert((12.1 * kNear + 40) * kUlpFloat + kRounded < kNearDoubt &&
                  22.1 * kFar * kUlpFloat + kRounded < kFarDoubt);
    // What follows a texel's bits is certain if one of these is set: no less than twice the doubt.
    static constexpr uint32_t kNearTested = (1U << kPartBits) - 2 * kNearDoubt,
                              kFarTested = (1U << kPartBits) - 2 * kFarDoubt;
    /// What float32 loses of where a block is least and most is far less, the bias included [parts].
    static constexpr double kMargin = 16;
    /// Adding it rounds parts to whole texels.
    static constexpr double kWholeTexels = 1.5 * (1 << 23) * kParts;
    static constexpr float kMiddle = (kBlock - 1) / 2.0F;  ///< from a block's first sample [px]
    /// Set in any float32 near kWhole.
    static constexpr uint32_t kAlways = 1U << 30;

public:
    static constexpr bool kPerspective = true;
    /// What the blocks of a window show.
    struct Found : Window {
        alignas(64) float one[kBlocks], u[kBlocks], v[kBlocks];  ///< D and N - a D in the middle
        /// Added to a quotient, so that it is kWhole where the patch begins.
        alignas(64) float u_patch[kBlocks], v_patch[kBlocks];
        alignas(64) uint32_t texel[kBlocks];  ///< the patch' first
        SampleFloats u_lanes, v_lanes;        ///< from the middle to each sample
        uint32_t u_from, v_from;              ///< the texels a
        uint32_t far;                         ///< bit n: the patch of block n does not hold all of its texels
        uint32_t beyond;                      ///< bit n: float32 cannot tell them, either
    };

    /// Whether what double loses is nothing beside float32's losses. Where rows need no division, they are faster.
    [[nodiscard]] static HWY_INLINE bool serves(const Batch& b, int t, const Canvas& canvas) {
        if (b.one.x.at[t] == 0 && canvas.settings->skip(RasterSkip::level_w)) return false;
        const auto fits = [](double far, int bits) HWY_ATTR {
            return bits > kPatchBits && far * 4 * kParts < .0625 * static_cast<double>(int64_t{1} << (32 - bits));
        };
        return fits(b.u_far.at[t], canvas.u_bits) && fits(b.v_far.at[t], canvas.v_bits);
    }
    HWY_INLINE void set_up(const Batch& b, int t, const Canvas& canvas) {
        const One d;
        const double width = b.column1.at[t] - b.column0.at[t], height = b.row1.at[t] - b.row0.at[t];
        const double most =
            std::abs(b.one.at.at[t]) + std::abs(b.one.x.at[t]) * width + std::abs(b.one.y.at[t]) * height;
        const double scale = hn::GetLane(power_of_two(d, hn::Neg(exponent_of(d, hn::Set(d, most)))));
        const auto plane = [&](const PlaneEight& p, double by, Plane& out) HWY_ATTR {
            const double x = p.x.at[t] * by, y = p.y.at[t] * by;
            out = {{p.at.at[t] * by, x, y, x + y, x - y, 0, 0, 0}};
        };
        const auto parts = [](int bits) HWY_ATTR { return kParts / static_cast<double>(int64_t{1} << (32 - bits)); };
        plane(b.one, scale, one_);
        plane(b.u_over, scale * parts(canvas.u_bits), u_), plane(b.v_over, scale * parts(canvas.v_bits), v_);
        rounded(hn::Load(Real{}, one_.at), one_rounded_);
        one_lanes_ = lanes_of(one_rounded_);
        one_spread_ = static_cast<float>((std::abs(one_.at[1]) + std::abs(one_.at[2])) * kMiddle);
        right_most_ = width - 1;
        u_always_ = v_always_ = 0, far_told_ = true;
    }
    HWY_INLINE void use(const Batch& /*b*/, int /*t*/, const Canvas& canvas, const HalfGaps& gaps) {
        // Half of the gap in parts.
        const auto parts = [](double gap, int bits)
                               HWY_ATTR { return gap * kParts / static_cast<double>(int64_t{1} << (32 - bits)); };
        const double u = parts(gaps.u, canvas.u_bits), v = parts(gaps.v, canvas.v_bits);
        gaps_ = gaps, u_always_ = u > kNearDoubt ? kAlways : 0, v_always_ = v > kNearDoubt ? kAlways : 0;
        far_told_ = u > kFarDoubt && v > kFarDoubt;
    }
    /// Whether no sample needs a test.
    [[nodiscard]] HWY_INLINE bool sure() const { return (u_always_ & v_always_) != 0; }

    HWY_INLINE void go_to(const Batch& b, int t, int row, const Rows& rows, const Doubles& right, const Doubles& down) {
        const V middle = hn::Set(Real{}, kMiddle);
        right_ = {hn::Add(right.low, middle), hn::Add(right.high, middle)};
        down_ = {hn::Add(down.low, middle), hn::Add(down.high, middle)};
        const int n = (std::min(kRows, b.row1.at[t] - row) - 1) / 2;
        near_x_ = rows.x0.at[n] - b.column0.at[t], last_x_ = rows.x1.at[n] - 1 - b.column0.at[t];
        near_y_ = row + n - b.row0.at[t];
        approach();
    }
    HWY_INLINE void find(const Batch& /*b*/, int /*t*/, const Canvas& canvas, bool both, bool more, Found& found) {
        const BlockFloat f;
        const Plane u = near_u_, v = near_v_;
        found.u_from = u_from_, found.v_from = v_from_;
        PlaneFloat u_rounded, v_rounded;
        rounded(hn::Load(Real{}, u.at), u_rounded), rounded(hn::Load(Real{}, v.at), v_rounded);
        found.u_lanes = lanes_of(u_rounded), found.v_lanes = lanes_of(v_rounded);
        found.far = found.beyond = 0;
        const uint32_t some = found.parts | found.wholes;
        const auto one_at = at_blocks(one_), u_at = at_blocks(u), v_at = at_blocks(v);
        find_half(canvas, u_rounded, v_rounded, one_at, u_at, v_at, some & 0xFFFF, 0, found);
        const auto moved_on = [&](SampleFloats at, const PlaneFloat& plane)
                                  HWY_ATTR { return hn::Add(at, hn::Set(f, plane.at[1] * kHalfWidth)); };
        if (both)
            find_half(canvas, u_rounded, v_rounded, moved_on(one_at, one_rounded_), moved_on(u_at, u_rounded),
                      moved_on(v_at, v_rounded), some >> kHalf, kHalf, found);
        right_ = moved(right_, kWindowWidth), near_x_ += kWindowWidth;
        if (more) approach();
    }
    template <bool kWholeBlock, bool kCertain>
    HWY_INLINE bool put(const Found& found, uint32_t which, const Canvas& canvas) const {
        const Block p;
        const uint32_t* const texels = canvas.texture.texels;
        const std::ptrdiff_t pitch = canvas.target.pitch, texture_pitch = canvas.texture.pitch;
        uint32_t* const line = canvas.target.pixels + found.row * pitch;
        const auto one_lanes = one_lanes_, u_lanes = found.u_lanes, v_lanes = found.v_lanes;
        const auto u_tested = hn::Set(p, u_always_ | kNearTested), v_tested = hn::Set(p, v_always_ | kNearTested);
        __mmask16 unsure = 0;
        for (; which != 0; which &= which - 1) {
            const int n = std::countr_zero(which);
            Samples u, v;
            at(found, n, one_lanes, u_lanes, v_lanes, found.u_patch[n], found.v_patch[n], u, v);
            const __m512i place =
                _mm512_ternarylogic_epi32(hn::Set(p, kPatch - 1).raw, hn::ShiftRight<kPartBits>(u).raw,
                                          hn::ShiftRight<kPartBits - kPatchBits>(v).raw, 0xCA);
            const __mmask16 lower = _mm512_test_epi32_mask(v.raw, _mm512_set1_epi32(4 << kPartBits));
            const auto texel = look_up_patch(texels + found.texel[n], texture_pitch, Samples{place}, lower);
            const __mmask16 inside = store_block<kWholeBlock>(texel, found.inside[n], line + found.out[n], pitch);
            if constexpr (kCertain) unsure = _kor_mask16(unsure, doubtful(inside, u, u_tested, v, v_tested));
        }
        return unsure == 0;
    }
    /// The same for blocks whose texels lie farther apart.
    template <bool kCertain>
    HWY_INLINE bool put_far(const Found& found, uint32_t which, const Canvas& canvas) const {
        const Block p;
        const std::ptrdiff_t pitch = canvas.target.pitch;
        uint32_t* const line = canvas.target.pixels + found.row * pitch;
        const auto u_tested = hn::Set(p, u_always_ | kFarTested), v_tested = hn::Set(p, v_always_ | kFarTested);
        const auto u_from = hn::Set(p, found.u_from - (std::bit_cast<uint32_t>(kWhole) >> kPartBits)),
                   v_from = hn::Set(p, found.v_from - (std::bit_cast<uint32_t>(kWhole) >> kPartBits));
        const auto u_mask = hn::Set(p, canvas.texture.width - 1U), v_mask = hn::Set(p, canvas.texture.height - 1U),
                   texture_pitch = hn::Set(p, static_cast<uint32_t>(canvas.texture.pitch));
        __mmask16 unsure = 0;
        for (; which != 0; which &= which - 1) {
            const int n = std::countr_zero(which);
            Samples u, v;
            at_far(found, n, u, v);
            const auto column = hn::And(hn::Add(hn::ShiftRight<kPartBits>(u), u_from), u_mask),
                       line_of = hn::And(hn::Add(hn::ShiftRight<kPartBits>(v), v_from), v_mask);
            const auto texel = look_up(p, canvas.texture.texels, hn::Add(hn::Mul(line_of, texture_pitch), column));
            const __mmask16 inside = store_block<false>(texel, found.inside[n], line + found.out[n], pitch);
            if constexpr (kCertain) unsure = _kor_mask16(unsure, doubtful(inside, u, u_tested, v, v_tested));
        }
        return unsure == 0;
    }
    /// The same in double, for blocks that float32 cannot tell; mends unsure texels, and returns as mend() does.
    HWY_NOINLINE bool put_beyond(const Batch& b, int t, const Found& found, uint32_t which, Again& again,
                                 bool only_double, const Canvas& canvas) const {
        using Row = hn::CappedTag<uint32_t, kBlock>;
        const Row p;
        const CertainPair certain =
            certain_of(canvas, b, t, 2 * b.u_far.at[t] + kFineCut, 2 * b.v_far.at[t] + kFineCut, gaps_);
        const Texels<Row, Addressing::powers> texels(canvas, b, t, certain);
        const auto pitch = static_cast<uint32_t>(canvas.target.pitch);
        for (; which != 0; which &= which - 1) {
            const int n = std::countr_zero(which);
            const int x = static_cast<int>(found.out[n] % pitch),
                      row = found.row + static_cast<int>(found.out[n] / pitch);
            uint32_t inside = found.inside[n];
            for (int y = row; inside != 0; inside >>= kBlock, ++y) {
                const uint8_t bits = inside & ((1U << kBlock) - 1);
                if (bits == 0) continue;
                auto u = hn::Zero(p), v = u;
                FineRow<true, Row>(b, t, x, y, certain).next(u, v);
                const auto in = hn::LoadMaskBits(p, &bits);
                hn::BlendedStore(texels.fetch(u, v), in, p,
                                 canvas.target.pixels + std::ptrdiff_t{y} * canvas.target.pitch + x);
                if (const auto unsure = hn::And(in, texels.unsure(u, v)); !hn::AllFalse(p, unsure))
                    if (!mend(p, again, x, y, unsure, only_double, canvas)) return false;
            }
        }
        return true;
    }
    /// Bit n: sample n of a block is in doubt.
    [[nodiscard]] HWY_INLINE uint32_t unsure(const Found& found, int n) const {
        const bool far = (found.far >> n & 1) != 0;
        Samples u, v;
        if (far)
            at_far(found, n, u, v);
        else
            at(found, n, one_lanes_, found.u_lanes, found.v_lanes, found.u_patch[n], found.v_patch[n], u, v);
        const auto unsure = [&](Samples at, uint32_t always) HWY_ATTR {
            const auto tested = hn::Set(Block{}, always | (far ? kFarTested : kNearTested));
            return uint32_t{_mm512_testn_epi32_mask(at.raw, tested.raw)};
        };
        return unsure(u, u_always_) | unsure(v, v_always_);
    }

private:
    /// At the first sample of the box, x, y, x + y and x - y.
    struct alignas(64) Plane {
        double at[kBatch];
    };
    struct PlaneFloat {
        alignas(32) float at[kBatch];
    };
    static HWY_INLINE void rounded(V plane, PlaneFloat& out) {
        hn::Store(hn::DemoteTo(Narrow{}, plane), Narrow{}, out.at);
    }
    /// At column x of the strips' row in the middle.
    [[nodiscard]] HWY_INLINE double at_pixel(const Plane& plane, double x) const {
        const One d;
        const auto row = hn::MulAdd(hn::Set(d, near_y_), hn::Set(d, plane.at[2]), hn::Set(d, plane.at[0]));
        return hn::GetLane(hn::MulAdd(hn::Set(d, x), hn::Set(d, plane.at[1]), row));
    }
    /// In the middle of the left half's blocks.
    [[nodiscard]] HWY_INLINE SampleFloats at_blocks(const Plane& plane) const {
        const Real d;
        const V at = hn::Set(d, plane.at[0]), x = hn::Set(d, plane.at[1]), y = hn::Set(d, plane.at[2]);
        const V low = hn::MulAdd(right_.low, x, hn::MulAdd(down_.low, y, at)),
                high = hn::MulAdd(right_.high, x, hn::MulAdd(down_.high, y, at));
        return hn::Combine(BlockFloat{}, hn::DemoteTo(Narrow{}, high), hn::DemoteTo(Narrow{}, low));
    }
    /// The planes of the next window, from whole texels near its middle on: some time before they are needed, as to
    /// divide takes long.
    HWY_INLINE void approach() {
        const double x = std::max(0.0, std::min(std::min(near_x_ + kHalfWidth, (near_x_ + last_x_) / 2), right_most_));
        const double inverse = 1 / kParts / at_pixel(one_, x);
        from_whole(u_, inverse, x, u_from_, near_u_), from_whole(v_, inverse, x, v_from_, near_v_);
    }
    /// The plane from a whole texel near its value in that row on.
    HWY_INLINE void from_whole(const Plane& over, double inverse, double x, uint32_t& texel, Plane& out) const {
        const Real d;
        const double whole = at_pixel(over, x) * inverse + kWholeDouble;
        texel = static_cast<uint32_t>(std::bit_cast<uint64_t>(whole));
        const V a = hn::Set(d, (whole - kWholeDouble) * kParts);
        hn::Store(hn::NegMulAdd(a, hn::Load(d, one_.at), hn::Load(d, over.at)), d, out.at);
    }
    /// What a plane adds at each sample of a block.
    static HWY_INLINE SampleFloats lanes_of(const PlaneFloat& plane) {
        const BlockFloat f;
        alignas(64) static constexpr float kRight[16] = {-1.5, -.5, .5, 1.5, -1.5, -.5, .5, 1.5,
                                                         -1.5, -.5, .5, 1.5, -1.5, -.5, .5, 1.5};
        alignas(64) static constexpr float kDown[16] = {-1.5, -1.5, -1.5, -1.5, -.5, -.5, -.5, -.5,
                                                        .5,   .5,   .5,   .5,   1.5, 1.5, 1.5, 1.5};
        return hn::MulAdd(hn::Load(f, kDown), hn::Set(f, plane.at[2]),
                          hn::Mul(hn::Load(f, kRight), hn::Set(f, plane.at[1])));
    }
    static HWY_INLINE SampleFloats reciprocal(SampleFloats a) {
        const SampleFloats r{_mm512_rcp14_ps(a.raw)};
        return hn::Mul(r, hn::NegMulAdd(a, r, hn::Set(BlockFloat{}, 2.0F)));
    }
    static HWY_INLINE void at(const Found& found, int n, SampleFloats one_lanes, SampleFloats u_lanes,
                              SampleFloats v_lanes, float u_patch, float v_patch, Samples& u, Samples& v) {
        const BlockFloat f;
        const Block p;
        const auto inverse = reciprocal(hn::Add(one_lanes, hn::Set(f, found.one[n])));
        u = hn::BitCast(p, hn::MulAdd(hn::Add(u_lanes, hn::Set(f, found.u[n])), inverse, hn::Set(f, u_patch)));
        v = hn::BitCast(p, hn::MulAdd(hn::Add(v_lanes, hn::Set(f, found.v[n])), inverse, hn::Set(f, v_patch)));
    }
    /// u and v from the whole texels u_from and v_from on.
    HWY_INLINE void at_far(const Found& found, int n, Samples& u, Samples& v) const {
        constexpr float kBiased = kWhole + kFarDoubt;
        at(found, n, one_lanes_, found.u_lanes, found.v_lanes, kBiased, kBiased, u, v);
    }
    /// The lanes' larger number, by its size.
    static HWY_INLINE SampleFloats larger(SampleFloats a, SampleFloats c) {
        return SampleFloats{_mm512_range_ps(a.raw, c.raw, 0b1011)};
    }
    HWY_INLINE void find_half(const Canvas& canvas, const PlaneFloat& u, const PlaneFloat& v, SampleFloats one_at,
                              SampleFloats u_at, SampleFloats v_at, uint32_t some, int first, Found& found) const {
        const BlockFloat f;
        const Block p;
        hn::Store(one_at, f, found.one + first), hn::Store(u_at, f, found.u + first),
            hn::Store(v_at, f, found.v + first);
        const auto all = [](double a) HWY_ATTR { return hn::Set(BlockFloat{}, static_cast<float>(a)); };
        const auto inverse = reciprocal(one_at);
        // 1.5 over the least D, rounded up.
        const SampleFloats most_inverse{_mm512_rcp14_ps(hn::Sub(one_at, all(one_spread_)).raw)};
        const auto per_pixel = hn::Mul(most_inverse, all(kMiddle * 1.001));
        SampleFloats rest, farthest;
        // The gradient is (gradient of N' - u gradient of D) / D. Of x and y the sum of absolute values is the larger
        // of their sum and their difference.
        const auto axis = [&](const PlaneFloat& plane, SampleFloats at, uint32_t from, int size, float* patch,
                              SampleFloats& rest_of, SampleFloats& farthest_of) HWY_ATTR {
            const auto middle = hn::Mul(at, inverse);
            const auto sum = hn::NegMulAdd(middle, all(one_rounded_.at[3]), all(plane.at[3])),
                       difference = hn::NegMulAdd(middle, all(one_rounded_.at[4]), all(plane.at[4]));
            const auto spread = hn::MulAdd(larger(sum, difference), per_pixel, all(kMargin));
            const auto low = hn::Sub(middle, spread), high = hn::Add(middle, spread);
            const SampleFloats texel{
                _mm512_add_round_ps(low.raw, all(kWholeTexels).raw, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
            const auto begin = hn::Sub(texel, all(kWholeTexels));
            hn::Store(hn::Sub(all(kWhole + kNearDoubt), begin), BlockFloat{}, patch + first);
            rest_of = hn::Sub(high, begin), farthest_of = larger(high, low);
            return hn::And(hn::Add(hn::BitCast(Block{}, texel), hn::Set(Block{}, from)), hn::Set(Block{}, size - 1U));
        };
        SampleFloats v_rest, v_farthest;
        const auto column = axis(u, u_at, found.u_from, canvas.texture.width, found.u_patch, rest, farthest),
                   line = axis(v, v_at, found.v_from, canvas.texture.height, found.v_patch, v_rest, v_farthest);
        hn::Store(hn::Add(hn::Mul(line, hn::Set(p, static_cast<uint32_t>(canvas.texture.pitch))), column), p,
                  found.texel + first);
        // Each compared by itself: of NaN and a number the machine says that the number is larger.
        const auto within = [&](double texels) HWY_ATTR {
            const auto most = all(texels * kParts);
            return hn::And(hn::Lt(farthest, most), hn::Lt(v_farthest, most));
        };
        const auto fits = hn::Lt(hn::Max(rest, v_rest), all(kPatch * kParts));
        const uint32_t near = bits_of(f, hn::And(fits, within(kNear))),
                       told = bits_of(f, hn::And(hn::Ge(one_at, all(4 * one_spread_)), within(kFar)));
        (far_told_ ? found.far : found.beyond) |= (some & told & ~near) << first;
        found.beyond |= (some & ~told) << first;
    }

    Plane one_, u_, v_;  ///< D and N over the box; u and v in parts
    PlaneFloat one_rounded_;
    SampleFloats one_lanes_;
    float one_spread_;              ///< no sample's D is farther from its block's
    double right_most_;             ///< the last column of the box
    uint32_t u_always_, v_always_;  ///< kAlways where all texels are certain
    bool far_told_;                 ///< float32 can tell ties of far blocks, too
    HalfGaps gaps_;
    Plane near_u_, near_v_;            ///< N - a D of the next window
    uint32_t u_from_, v_from_;         ///< its texels a
    Doubles right_, down_;             ///< the middles of the next window's left half
    double near_x_, last_x_, near_y_;  ///< of the strips' row in the middle
};

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();

#endif
#endif
