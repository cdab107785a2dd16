// Affine triangles by blocks (blocks-inl.h): u and v of a block start in double and step in fractions of a texel,
// modulo a patch.
#if defined(TEXELSCOPE_AFFINE_BLOCKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_AFFINE_BLOCKS_INL
#undef TEXELSCOPE_AFFINE_BLOCKS_INL
#else
#define TEXELSCOPE_AFFINE_BLOCKS_INL
#endif

#include <bit>

#include "core/fast/blocks-inl.h"

#if HWY_TARGET <= HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// A patch is 2^32 parts.
constexpr double kPartsInTexel = 0x1p32 / kPatch;
/// What follows the texel's bits, modulo a patch.
constexpr uint32_t kInTexel = ~0U >> kPatchBits;

/// What makes texels of affine blocks certain, of one triangle or of eight. They are counted in units of
/// Canvas::addressing, and modulo a patch in parts of 2^32, which are finer: what rounding to whole ones loses is
/// hardly ever in doubt.
template <class D>
struct BlockCertainty {
    hn::Vec<D> bias;    ///< Certainty::bias [units]
    hn::Vec<D> least;   ///< Certainty::least [parts of 2^32 of a texel]
    hn::Vec<D> tested;  ///< if one of these bits is set, the texel is certain

    /// @param unsure    bound of what double has lost [units]
    /// @param half_gap  as Certainty has it [units]
    /// @param parts     in a unit
    HWY_INLINE BlockCertainty(D d, hn::Vec<D> unsure, hn::Vec<D> half_gap, double parts) {
        // What is rounded to whole parts: a block's least, how far its first sample is from there, that by its lowest
        // bit, too, and three steps each to the right and down.
        const auto in_unit = hn::Set(d, parts);
        const Certainty<D> c(d, hn::MulAdd(unsure, in_unit, hn::Set(d, 6.0)), hn::Mul(half_gap, in_unit),
                             hn::Set(d, kPartsInTexel), hn::Set(d, double{kPatch}));
        bias = hn::Mul(c.bias, hn::Set(d, 1 / parts)), least = c.least;
        // The certificate asks for no more than that, rounded up to a power of two: for nothing but the lowest bit
        // where it is 0.
        const auto none = hn::Eq(least, hn::Zero(d));
        const auto asked = hn::IfThenElse(none, hn::Set(d, 1.0), hn::Mul(least, hn::Set(d, 1.0 / kPatch)));
        const auto doubtful = power_of_two(d, hn::Add(exponent_of(d, asked), hn::Set(d, 1.0)));
        tested = hn::IfThenElse(none, hn::Set(d, 1.0), hn::Sub(hn::Set(d, kInTexel + 1.0), doubtful));
    }
};

/// u or v over the blocks of eight affine triangles, computed side by side.
struct BlockAxisEight {
    Eight to_least;                   ///< from a block's first sample to where none is at less [units]
    Eight first;                      ///< there, in the box' first block, and the bias [units]
    EightInt right, down, to_sample;  ///< the steps, and back to the block's first sample [parts]
    EightInt least_rest, tested;      ///< BlockCertainty's

    HWY_INLINE void set_up(const CoordinateEight& u, double texel, double parts) {
        const Real d;
        const V x = hn::Load(d, u.plane.x.at), y = hn::Load(d, u.plane.y.at), in_unit = hn::Set(d, parts);
        const V zero = hn::Zero(d);
        // A quarter of a texel less: the doubts of both.
        const V least =
            hn::MulSub(hn::Add(hn::Min(x, zero), hn::Min(y, zero)), hn::Set(d, kBlock - 1.0), hn::Set(d, texel / 4));
        const BlockCertainty<Real> certainty(d, hn::Load(d, u.unsure.at), zero, parts);
        hn::Store(least, d, to_least.at);
        hn::Store(hn::Add(hn::Load(d, u.plane.at.at), hn::Add(certainty.bias, least)), d, first.at);
        store_fraction(hn::Mul(x, in_unit), right.at), store_fraction(hn::Mul(y, in_unit), down.at);
        store_fraction(hn::Mul(hn::Neg(least), in_unit), to_sample.at);
        store_fraction(certainty.least, least_rest.at), store_fraction(certainty.tested, tested.at);
    }
};

/// u or v of one of them.
struct BlockAxis {
    int shift;     ///< of units to texels
    double parts;  ///< in a unit
    double first;  ///< as BlockAxisEight has it
    uint32_t least_rest;
    Samples lanes;  ///< of each sample from there [parts]; the lowest bit is set
    Samples tested;

    HWY_INLINE void set_up(const BlockAxisEight& all, int t, int bits) {
        const Block p;
        const auto of = [&](const EightInt& a) HWY_ATTR { return hn::Set(Block{}, static_cast<uint32_t>(a.at[t])); };
        shift = 32 - bits, parts = parts_of(bits), first = all.first.at[t];
        const auto right = hn::Mul(place_of_lane(), of(all.right)), down = hn::Mul(four_of_lane(), of(all.down));
        lanes = hn::Or(hn::Add(hn::Add(right, down), of(all.to_sample)), hn::Set(p, 1));
        least_rest = static_cast<uint32_t>(all.least_rest.at[t]), tested = of(all.tested);
    }
    /// Once ties are known: BlockCertainty's half of the gap.
    HWY_INLINE void use(const CoordinateEight& u, const BlockAxisEight& all, int t, double half_gap) {
        const One d;
        const BlockCertainty<One> certainty(d, hn::Set(d, u.unsure.at[t]), hn::Set(d, half_gap), parts);
        const auto whole = [](hn::Vec<One> a) HWY_ATTR { return static_cast<uint32_t>(hn::GetLane(a)); };
        first = u.plane.at.at[t] + (hn::GetLane(certainty.bias) + all.to_least.at[t]);
        least_rest = whole(certainty.least), tested = hn::Set(Block{}, whole(certainty.tested));
    }
    /// Samples of a block that are in doubt.
    [[nodiscard]] HWY_INLINE uint32_t unsure(uint32_t block) const {
        const Block p;
        const auto rest = hn::ShiftLeft<kPatchBits>(hn::Add(hn::Set(p, block), lanes));
        return bits_of(p, hn::Lt(rest, hn::Set(p, least_rest)));
    }
    [[nodiscard]] HWY_INLINE bool sure() const { return least_rest == 0; }

    static HWY_INLINE double parts_of(int bits) { return static_cast<double>(int64_t{1} << (bits - kPatchBits)); }
};

/// Eight affine triangles over their blocks.
struct AffineEight {
    BlockAxisEight u, v;

    HWY_INLINE void set_up(const Batch& b, const Canvas& canvas) {
        const auto axis = [](const CoordinateEight& from, int bits, BlockAxisEight& out)
                              HWY_ATTR { out.set_up(from, units_in_texel(bits), BlockAxis::parts_of(bits)); };
        axis(b.u, canvas.u_bits, u), axis(b.v, canvas.v_bits, v);
    }
};

/// An affine triangle's blocks.
class AffineBlocks {
public:
    using Eights = AffineEight;
    /// What the blocks of a window show.
    struct Found : Window {
        alignas(64) uint32_t u[kBlocks], v[kBlocks];    ///< from the patch to where they are least [parts]
        alignas(64) uint32_t texel[kBlocks];            ///< the patch' first
        static constexpr uint32_t far = 0, beyond = 0;  ///< all patches hold their texels: serves()
    };

    /// Of which triangles the patch of any block holds all of its texels. They spread over what u and v change from one
    /// corner of it to the opposite one, and twice the doubt at each of these two: Certainty lets the doubt be no more
    /// than an eighth of a texel.
    [[nodiscard]] static HWY_INLINE hn::Mask<Real> serves(const Batch& b, const Canvas& canvas) {
        const auto fits = [&](const CoordinateEight& u, int bits) HWY_ATTR {
            const Real d;
            if (bits <= kPatchBits) return hn::FirstN(d, 0);
            const double texel = units_in_texel(bits);
            const V spread = hn::Add(hn::Abs(hn::Load(d, u.plane.x.at)), hn::Abs(hn::Load(d, u.plane.y.at)));
            // In double parts are whole up to 2^51: 24 half ulps of 2^45 are 2^-3.
            return hn::And(hn::Lt(hn::Load(d, u.unsure.at), hn::Set(d, .125 * texel / kPartsInTexel)),
                           hn::Le(spread, hn::Set(d, (kPatch - 1.5) * texel / (kBlock - 1))));
        };
        return hn::And(fits(b.u, canvas.u_bits), fits(b.v, canvas.v_bits));
    }
    HWY_INLINE void set_up(int t, const Canvas& canvas, const AffineEight& all) {
        all_ = &all, u_.set_up(all.u, t, canvas.u_bits), v_.set_up(all.v, t, canvas.v_bits);
    }
    HWY_INLINE void use(const Batch& b, int t, const Canvas& /*canvas*/, const HalfGaps& gaps) {
        u_.use(b.u, all_->u, t, gaps.u), v_.use(b.v, all_->v, t, gaps.v);
    }
    /// Whether no sample needs a test.
    [[nodiscard]] HWY_INLINE bool sure() const { return u_.sure() && v_.sure(); }

    /// Goes to the strips the blocks of whose first window's left half begin at these pixels of the box.
    HWY_INLINE void go_to(const Batch& b, int t, const Doubles& right, const Doubles& down) {
        const auto start = [&](const CoordinateEight& u, const BlockAxis& axis, Doubles& at) HWY_ATTR {
            const Real d;
            const V first = hn::Set(d, axis.first), y = hn::Set(d, u.plane.y.at[t]);
            at = {hn::MulAdd(down.low, y, first), hn::MulAdd(down.high, y, first)};
        };
        right_ = right, start(b.u, u_, u_at_), start(b.v, v_, v_at_);
    }
    /// What the next window's blocks show.
    HWY_INLINE void find(const Batch& b, int t, const Canvas& canvas, bool both, Found& found) {
        find_half(b, t, canvas, right_, 0, found);
        if (both) find_half(b, t, canvas, moved(right_, kHalfWidth), kHalf, found);
        right_ = moved(right_, kWindowWidth);
    }
    /// Draws the blocks whose bits are set. False: some of their texels are unsure.
    template <bool kWhole, bool kCertain>
    HWY_INLINE bool put(const Found& found, uint32_t which, const Canvas& canvas) const {
        const Block p;
        const auto u_lanes = u_.lanes, v_lanes = v_.lanes;
        const auto u_tested = u_.tested, v_tested = v_.tested;
        const uint32_t* const texels = canvas.texture.texels;
        const std::ptrdiff_t pitch = canvas.target.pitch, texture_pitch = canvas.texture.pitch;
        uint32_t* const line = canvas.target.pixels + found.row * pitch;
        __mmask16 unsure = 0;
        for (; which != 0; which &= which - 1) {
            const int n = std::countr_zero(which);
            const auto u = hn::Add(u_lanes, hn::Set(p, found.u[n])), v = hn::Add(v_lanes, hn::Set(p, found.v[n]));
            // 8 v + u
            const auto place =
                hn::Or(hn::ShiftRight<32 - kPatchBits>(u),
                       hn::And(hn::ShiftRight<32 - 2 * kPatchBits>(v), hn::Set(p, kPatch * (kPatch - 1))));
            const auto texel =
                look_up_patch(texels + found.texel[n], texture_pitch, place, _mm512_movepi32_mask(v.raw));
            const __mmask16 inside = store_block<kWhole>(texel, found.inside[n], line + found.out[n], pitch);
            if constexpr (kCertain) unsure = _kor_mask16(unsure, in_doubt(inside, u, u_tested, v, v_tested));
        }
        return unsure == 0;
    }
    /// Bit n: sample n of a block is in doubt.
    [[nodiscard]] HWY_INLINE uint32_t unsure(const Found& found, int n) const {
        return u_.unsure(found.u[n]) | v_.unsure(found.v[n]);
    }

private:
    /// u or v of 16 blocks in parts from the patch on; its first texel.
    static HWY_INLINE Samples locate(const CoordinateEight& u, int t, const BlockAxis& axis, const Doubles& at,
                                     const Doubles& right, uint32_t* from_patch) {
        const Real d;
        const V x = hn::Set(d, u.plane.x.at[t]), whole = hn::Set(d, kWholeDouble), parts = hn::Set(d, axis.parts);
        const V low = hn::MulAdd(right.low, x, at.low), high = hn::MulAdd(right.high, x, at.high);
        const auto texel = hn::ShiftRightSame(low_bits_of(hn::Add(low, whole), hn::Add(high, whole)), axis.shift);
        const auto in_parts = low_bits_of(hn::MulAdd(low, parts, whole), hn::MulAdd(high, parts, whole));
        hn::Store(hn::Sub(in_parts, hn::ShiftLeft<32 - kPatchBits>(texel)), Block{}, from_patch);
        return texel;
    }
    HWY_INLINE void find_half(const Batch& b, int t, const Canvas& canvas, const Doubles& right, int first,
                              Found& found) const {
        const Block p;
        const auto u = locate(b.u, t, u_, u_at_, right, found.u + first),
                   v = locate(b.v, t, v_, v_at_, right, found.v + first);
        const auto pitch = hn::Set(p, static_cast<uint32_t>(canvas.texture.pitch));
        hn::Store(hn::Add(hn::Mul(v, pitch), u), p, found.texel + first);
    }

    const AffineEight* all_;
    BlockAxis u_, v_;
    Doubles right_;        ///< columns of the box where the blocks of the next window's left half begin
    Doubles u_at_, v_at_;  ///< at column 0 of their rows, moved to the least of a block and by the bias [units]
};

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();

#endif
#endif
