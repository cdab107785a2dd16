// Affine triangles by blocks (blocks-inl.h): u and v of a block start in double and step in fractions of a texel,
// modulo a patch.
#if defined(TEXELSCOPE_AFFINE_BLOCKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_AFFINE_BLOCKS_INL
#undef TEXELSCOPE_AFFINE_BLOCKS_INL
#else
#define TEXELSCOPE_AFFINE_BLOCKS_INL
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/fast/blocks-inl.h"

#if HWY_TARGET <= HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// A patch is 2^32 parts.
constexpr double kPartsInTexel = 0x1p32 / kPatch;
/// What follows the texel's bits, modulo a patch.
constexpr uint32_t kInTexel = ~0U >> kPatchBits;

/// u or v of an affine triangle's blocks. They are counted in units of Canvas::addressing, and modulo a patch in parts
/// of 2^32, which are finer: what rounding to whole ones loses is hardly ever in doubt.
struct BlockAxis {
    int shift;            ///< of units to texels
    double parts;         ///< in a unit
    double to_least;      ///< from a block's first sample to where none is at less [units]
    double bias;          ///< Certain::bias [units]
    uint32_t least_rest;  ///< Certain::least
    Samples lanes;        ///< of each sample from there [parts]; the lowest bit is set
    Samples tested;       ///< if one of these bits is set, the texel is certain

    HWY_INLINE void set_up(const CoordinateEight& u, int t, int bits) {
        const Block p;
        shift = 32 - bits, parts = static_cast<double>(int64_t{1} << (bits - kPatchBits));
        const double x = u.plane.x.at[t], y = u.plane.y.at[t];
        // A quarter of a texel less: the doubts of both.
        to_least =
            (std::min(x, 0.0) + std::min(y, 0.0)) * (kBlock - 1) - static_cast<double>(int64_t{1} << (shift - 2));
        const auto in_parts = [&](double a) HWY_ATTR {
            return hn::Set(p, static_cast<uint32_t>(std::bit_cast<uint64_t>(a * parts + kWholeDouble)));
        };
        const auto right = hn::Mul(place_of_lane(), in_parts(x)), down = hn::Mul(four_of_lane(), in_parts(y));
        lanes = hn::Or(hn::Add(hn::Add(right, down), in_parts(-to_least)), hn::Set(p, 1));
    }
    /// @param unsure    bound of what double has lost [units]
    /// @param half_gap  as Certainty has it [units]
    HWY_INLINE void use(double unsure, double half_gap) {
        const One d;
        // What is rounded to whole parts: a block's least, how far its first sample is from there, that by its lowest
        // bit, too, and three steps each to the right and down.
        const Certainty<One> c(d, hn::Set(d, unsure * parts + 6), hn::Set(d, half_gap * parts),
                               hn::Set(d, kPartsInTexel), hn::Set(d, kPatch));
        bias = hn::GetLane(c.bias) * static_cast<double>(int64_t{1} << shift) * (1 / kPartsInTexel);
        least_rest = static_cast<uint32_t>(hn::GetLane(c.least));
        // The certificate asks for no more than that, rounded up to a power of two: for nothing but the lowest bit
        // where it is 0.
        const uint32_t doubtful = std::bit_ceil(std::max(2U, (least_rest >> kPatchBits) + 1));
        tested = hn::Set(Block{}, least_rest == 0 ? 1 : kInTexel & ~(doubtful - 1));
    }
    /// Samples of a block that are in doubt.
    [[nodiscard]] HWY_INLINE uint32_t unsure(uint32_t block) const {
        const Block p;
        const auto rest = hn::ShiftLeft<kPatchBits>(hn::Add(hn::Set(p, block), lanes));
        return bits_of(p, hn::Lt(rest, hn::Set(p, least_rest)));
    }
    [[nodiscard]] HWY_INLINE bool sure() const { return least_rest == 0; }
};

/// An affine triangle's blocks.
class AffineBlocks {
public:
    static constexpr bool kPerspective = false;
    struct Eights {
        HWY_INLINE void set_up(const Batch& /*b*/, const Canvas& /*canvas*/) {}
    };
    /// What the blocks of a window show.
    struct Found : Window {
        alignas(64) uint32_t u[kBlocks], v[kBlocks];    ///< from the patch to where they are least [parts]
        alignas(64) uint32_t texel[kBlocks];            ///< the patch' first
        static constexpr uint32_t far = 0, beyond = 0;  ///< all patches hold their texels: serves()
    };

    /// Whether the patch of any block of the triangle holds all of its texels. They spread over what u and v change
    /// from one corner of it to the opposite one, and twice the doubt at each of these two: Certainty lets the doubt be
    /// no more than an eighth of a texel.
    [[nodiscard]] static HWY_INLINE bool serves(const Batch& b, int t, const Canvas& canvas) {
        const auto fits = [&](const CoordinateEight& u, int bits) {
            const double spread = (std::abs(u.plane.x.at[t]) + std::abs(u.plane.y.at[t])) * (kBlock - 1);
            // In double parts are whole up to 2^51: 24 half ulps of 2^45 are 2^-3.
            const double texel = static_cast<double>(int64_t{1} << (32 - bits)), parts = kPartsInTexel / texel;
            return bits > kPatchBits && u.unsure.at[t] * parts < .125 && spread <= (kPatch - 1.5) * texel;
        };
        return fits(b.u, canvas.u_bits) && fits(b.v, canvas.v_bits);
    }
    HWY_INLINE void set_up(const Batch& b, int t, const Canvas& canvas, const Eights& /*all*/) {
        u_.set_up(b.u, t, canvas.u_bits), v_.set_up(b.v, t, canvas.v_bits);
        use(b, t, canvas, {});
    }
    HWY_INLINE void use(const Batch& b, int t, const Canvas& /*canvas*/, const HalfGaps& gaps) {
        u_.use(b.u.unsure.at[t], gaps.u), v_.use(b.v.unsure.at[t], gaps.v);
    }
    /// Whether no sample needs a test.
    [[nodiscard]] HWY_INLINE bool sure() const { return u_.sure() && v_.sure(); }

    /// Goes to the strips the blocks of whose first window's left half begin at these pixels of the box.
    HWY_INLINE void go_to(const Batch& b, int t, int /*row*/, const Rows& /*rows*/, const Doubles& right,
                          const Doubles& down) {
        const auto start = [&](const CoordinateEight& u, const BlockAxis& axis, Doubles& at) HWY_ATTR {
            const Real d;
            const V first = hn::Set(d, u.plane.at.at[t] + (axis.bias + axis.to_least)), y = hn::Set(d, u.plane.y.at[t]);
            at = {hn::MulAdd(down.low, y, first), hn::MulAdd(down.high, y, first)};
        };
        right_ = right, start(b.u, u_, u_at_), start(b.v, v_, v_at_);
    }
    /// What the next window's blocks show.
    HWY_INLINE void find(const Batch& b, int t, const Canvas& canvas, bool both, bool /*more*/, Found& found) {
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
            if constexpr (kCertain) unsure = _kor_mask16(unsure, doubtful(inside, u, u_tested, v, v_tested));
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

    BlockAxis u_, v_;
    Doubles right_;        ///< columns of the box where the blocks of the next window's left half begin
    Doubles u_at_, v_at_;  ///< at column 0 of their rows, moved to the least of a block and by the bias [units]
};

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();

#endif
#endif
