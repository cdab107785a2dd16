// What eight triangles in perspective have in common over their blocks (perspective_blocks-inl.h), computed side by
// side.
#if defined(TEXELSCOPE_PERSPECTIVE_PLANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_PERSPECTIVE_PLANES_INL
#undef TEXELSCOPE_PERSPECTIVE_PLANES_INL
#else
#define TEXELSCOPE_PERSPECTIVE_PLANES_INL
#endif

#include "core/fast/blocks-inl.h"

#if HWY_TARGET <= HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

constexpr int kPartBits = 19;
constexpr double kParts = 1 << kPartBits;  ///< in a texel
constexpr int kFarPatch = 16;              ///< texels from one side of a far block's patch to the other

constexpr float kToMiddle = (kBlock - 1) / 2.0F;  ///< from a block's first sample to its middle, either way [px]

/// Float32 is asked where u in a block's middle is no more than kMost, and u times how much D changes in the block,
/// seen from D, no more than kSteep: PerspectiveBlocks bounds its error by them [texels].
constexpr double kMost = 1024, kSteep = 17;

/// A plane as steps of double, and its gradients as float32 has them.
struct StepsEight {
    PlaneEight plane;
    EightFloat x, y, sum, difference;  ///< x + y, x - y

    HWY_INLINE void set(V at, V step_x, V step_y) {
        const Real d;
        const Narrow f;
        hn::Store(at, d, plane.at.at), hn::Store(step_x, d, plane.x.at), hn::Store(step_y, d, plane.y.at);
        hn::Store(hn::DemoteTo(f, step_x), f, x.at), hn::Store(hn::DemoteTo(f, step_y), f, y.at);
        hn::Store(hn::DemoteTo(f, hn::Add(step_x, step_y)), f, sum.at);
        hn::Store(hn::DemoteTo(f, hn::Sub(step_x, step_y)), f, difference.at);
    }
};

/// D, N - a D of u and of v, so scaled that D is no more than 2 over the box. u and v are counted in parts from a whole
/// texel a on.
struct PerspectiveEight {
    StepsEight one, u, v;
    EightInt u_from, v_from;  ///< the texels a
    EightFloat spread;        ///< no sample's D is farther from the one in its block's middle
    EightFloat least_one;     ///< where D in the middle is less, float32 is not enough

    HWY_INLINE void set_up(const Batch& b, const Canvas& canvas) {
        const Real d;
        const V half = hn::Set(d, .5);
        const auto of = [](const Eight& a) HWY_ATTR { return hn::Load(Real{}, a.at); };
        const V column0 = load_int(b.column0), row0 = load_int(b.row0);
        const V width = hn::Sub(load_int(b.column1), column0), height = hn::Sub(load_int(b.row1), row0);
        V at = of(b.one.at), x = of(b.one.x), y = of(b.one.y);
        const V most = hn::MulAdd(hn::Abs(x), width, hn::MulAdd(hn::Abs(y), height, hn::Abs(at)));
        const V scale = power_of_two(d, hn::Neg(exponent_of(d, most)));
        at = hn::Mul(at, scale), x = hn::Mul(x, scale), y = hn::Mul(y, scale);
        one.set(at, x, y);

        // Between the middle corner and the long side: inside of the triangle, or nearly so.
        const V low_y = of(b.low_y);
        const V on_long = hn::MulAdd(hn::Sub(low_y, of(b.long_y)), of(b.long_slope), of(b.long_x));
        const V right = hn::Sub(hn::Mul(hn::Add(of(b.low_x), on_long), half), hn::Add(column0, half)),
                down = hn::Sub(low_y, hn::Add(row0, half));
        const auto there = [&](V from, V step_x, V step_y)
                               HWY_ATTR { return hn::MulAdd(right, step_x, hn::MulAdd(down, step_y, from)); };
        const V inverse = hn::Div(hn::Set(d, 1 / kParts), there(at, x, y));
        const auto axis = [&](const PlaneEight& over, const FloatEight& corners, int bits, StepsEight& out,
                              EightInt& from) HWY_ATTR {
            const Real r;
            const V parts = hn::Set(r, kParts / units_in_texel(bits));
            const V by = hn::Mul(scale, parts);
            const V over_at = hn::Mul(of(over.at), by), over_x = hn::Mul(of(over.x), by),
                    over_y = hn::Mul(of(over.y), by);
            const V texel = hn::Round(hn::Mul(there(over_at, over_x, over_y), inverse));
            const V a = hn::Mul(texel, hn::Set(r, kParts));
            store_fraction(texel, from.at);
            out.set(hn::NegMulAdd(a, at, over_at), hn::NegMulAdd(a, x, over_x), hn::NegMulAdd(a, y, over_y));
            // No sample inside is farther from a than a corner.
            return hn::Max(hn::MulSub(of(corners.high), parts, a), hn::NegMulAdd(of(corners.low), parts, a));
        };
        const V u_reach = axis(b.u_over, b.u_along, canvas.u_bits, u, u_from),
                v_reach = axis(b.v_over, b.v_along, canvas.v_bits, v, v_from);
        // Nor is the middle of a block that has samples inside by more than half of a patch, or float32 is not asked.
        const V reach = hn::MulAdd(hn::Max(u_reach, v_reach), hn::Set(d, 1 / kParts), hn::Set(d, kFarPatch / 2.0));
        const V spread_one = hn::Mul(hn::Add(hn::Abs(x), hn::Abs(y)), hn::Set(d, kToMiddle * 1.001));
        const V steep = hn::Max(hn::Set(d, 2.0), hn::MulAdd(reach, hn::Set(d, 1 / kSteep), hn::Set(d, 1.001)));
        const V enough = hn::IfThenElse(hn::Lt(reach, hn::Set(d, kMost)), hn::Mul(spread_one, steep), hn::Inf(d));
        hn::Store(hn::DemoteTo(Narrow{}, spread_one), Narrow{}, spread.at);
        hn::Store(hn::DemoteTo(Narrow{}, enough), Narrow{}, least_one.at);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();

#endif
#endif
