// Eight triangles set up at once: boxes, sides, planes, and how far double may be off.
#if defined(TEXELSCOPE_SETUP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_SETUP_INL
#undef TEXELSCOPE_SETUP_INL
#else
#define TEXELSCOPE_SETUP_INL
#endif

#include <algorithm>
#include <cmath>

#include "core/fast/canvas.h"
#include "core/fast/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// a = at + x i + y j at pixel (i, j) of the box.
struct PlaneEight {
    Eight at, x, y;
};

/// u or v of eight affine triangles, at the centre of (column0, row0) and from there.
struct CoordinateEight {
    PlaneEight plane;     ///< [units of Canvas::addressing]
    Eight unsure;         ///< bound of what double has lost, over the box [units]
    Eight doubt;          ///< bound of the error of int32 steps along a row from a start in double [units]
    EightInt least;       ///< Certainty::least by it
    EightInt step, down;  ///< x and y rounded, modulo 2^32
    EightInt shift;       ///< units in a texel are 2^shift; not where the size is no power of two and repeats
};

/// How float32 carries u or v along a row in perspective, as far as the corners lie apart.
struct FloatEight {
    EightInt shift;    ///< it counts in 2^shift units
    EightFloat scale;  ///< 2^-shift
    Eight low, high;   ///< the least and the most of the corners [units]
    Eight doubt;       ///< bound of the error [units]
    EightInt least;    ///< Certainty::least by it; all bits where too much is in doubt
};

/// Everything about eight triangles, computed side by side.
struct Batch {
    EightInt index;  ///< which triangle
    EightInt good;   ///< finite, w > 0 where that matters, and double holds the corners' differences
    EightInt row0, row_mid, row1, column0, column1;
    Eight long_x, long_y, long_slope;          ///< the side from top to bottom: x = long_x + (y - long_y) slope
    Eight top_slope, low_x, low_y, low_slope;  ///< the two others; the upper begins where the long one does
    CoordinateEight u, v;
    Eight cross_doubt;     ///< of a crossing [px]; 0: all crossings are told apart by the bias
    EightInt long_left;    ///< the long side is the left one
    EightInt widest;       ///< no row has more samples
    EightInt front;        ///< seen from the front; means nothing unless `good`
    EightInt one_texel;    ///< all corners, so all samples, lie in the same texel
    EightInt tiny, small;  ///< lies in a block of 4 x 4, or 8 x 8, samples from (column0, row0)
    std::array<EightFloat, 3> side_x, side_y, side_one, side_least;  ///< E over the block; inside: E >= least
    EightFloat side_doubt;
    EightInt flat;                   ///< equal w at all corners: affine
    PlaneEight one, u_over, v_over;  ///< 1/w, u/w, v/w over the box [units]
    Eight u_far, v_far;              ///< bound of what double has lost of u and v [units]
    FloatEight u_along, v_along;     ///< where rows are narrow
    PlaneEight z;
    Eight z_unsure;    ///< bound of what double has lost of z
    EightInt level_z;  ///< z is the same all over, and that is made use of
};

/// Whether the coordinate is a multiple of 2^-8 below 2^13.
HWY_INLINE hn::Mask<Real> is_coarse(V c) {
    const Real d;
    const V scaled = hn::Mul(c, hn::Set(d, 256.0));
    return hn::And(hn::Eq(hn::Round(scaled), scaled), hn::Lt(hn::Abs(c), hn::Set(d, 8192.0)));
}

/// Eight triangles on the screen, in pixels of the target.
struct Corners {
    V x0, y0, x1, y1, x2, y2;
    HWY_INLINE Corners(const Eights& f, const RasterTarget& target) {
        const Real d;
        const V left = hn::Set(d, target.x0), top = hn::Set(d, target.y0);
        x0 = hn::Sub(promote(f.x[0]), left), y0 = hn::Sub(promote(f.y[0]), top);
        x1 = hn::Sub(promote(f.x[1]), left), y1 = hn::Sub(promote(f.y[1]), top);
        x2 = hn::Sub(promote(f.x[2]), left), y2 = hn::Sub(promote(f.y[2]), top);
    }
    [[nodiscard]] HWY_INLINE V area() const {
        return difference_of_products(hn::Sub(x1, x0), hn::Sub(y2, y0), hn::Sub(x2, x0), hn::Sub(y1, y0));
    }
    [[nodiscard]] HWY_INLINE hn::Mask<Real> coarse() const {
        return hn::And(hn::And(hn::And(is_coarse(x0), is_coarse(y0)), hn::And(is_coarse(x1), is_coarse(y1))),
                       hn::And(is_coarse(x2), is_coarse(y2)));
    }
};

/// Whether double holds all differences of the corners as given, of these and samples, and of these and the target's
/// origin: with all sizes below 2^k, all are multiples of 2^(k - 52). Coordinates like 1e-12 beside others of 1000 are
/// not, and what is that far out is left alone, too.
HWY_INLINE hn::Mask<Real> is_fine(const Eights& f, const RasterTarget& target) {
    const Real d;
    const hn::Repartition<uint64_t, Real> bits;
    const double reach = std::max(std::abs(target.x0), std::abs(target.y0)) + std::max(target.width, target.height);
    const V x0 = promote(f.x[0]), y0 = promote(f.y[0]), x1 = promote(f.x[1]), y1 = promote(f.y[1]),
            x2 = promote(f.x[2]), y2 = promote(f.y[2]);
    const V most =
        hn::Max(hn::Max(most_of(hn::Abs(x0), hn::Abs(x1), hn::Abs(x2)), most_of(hn::Abs(y0), hn::Abs(y1), hn::Abs(y2))),
                hn::Set(d, reach));
    // Three times the power of two that is at most `most`: adding it rounds to multiples of 2^(k - 52).
    const V power = hn::BitCast(d, hn::And(hn::BitCast(bits, most), hn::Set(bits, 0xFFFULL << 52)));
    const V rounder = hn::Mul(power, hn::Set(d, 3.0));
    const auto whole = [&](V c) HWY_ATTR { return hn::Eq(hn::Sub(hn::Add(c, rounder), rounder), c); };
    return hn::And(hn::And(hn::And(whole(x0), whole(y0)), hn::And(whole(x1), whole(y1))),
                   hn::And(hn::And(whole(x2), whole(y2)), hn::Lt(most, hn::Set(d, 0x1p30))));
}

HWY_INLINE void order(V& xa, V& ya, V& xb, V& yb) {
    const auto wrong = hn::Gt(ya, yb);
    const V x = xa, y = ya;
    xa = hn::IfThenElse(wrong, xb, xa), ya = hn::IfThenElse(wrong, yb, ya);
    xb = hn::IfThenElse(wrong, x, xb), yb = hn::IfThenElse(wrong, y, yb);
}

/// The first pixel whose centre is at c or later, within [0, limit].
HWY_INLINE V first_centre(V c, double limit) {
    const Real d;
    return hn::Min(hn::Max(hn::Ceil(hn::Sub(c, hn::Set(d, .5))), hn::Zero(d)), hn::Set(d, limit));
}

/// The triangles' shapes and boxes, as planes need them.
struct Shape {
    V bx, by, cx, cy, area;
    V dx, dy;          ///< from the first corner to the centre of the box' first sample
    V most_x, most_y;  ///< no sample of the box is farther from the first corner
    V width;           ///< [px]
    V inverse;         ///< of the area
};

/// Whether a1 - a0 is what double says.
HWY_INLINE hn::Mask<Real> is_exact(V a1, V a0, V difference) {
    return hn::And(hn::Eq(hn::Sub(a1, difference), a0), hn::Eq(hn::Add(difference, a0), a1));
}
/// How much a plane over the box moves for each unit that a value at a corner moves, at most.
HWY_INLINE V lever_of(const Shape& s) {
    const V lever = hn::MulAdd(hn::Add(hn::Abs(s.by), hn::Abs(s.cy)), s.most_x,
                               hn::Mul(hn::Add(hn::Abs(s.bx), hn::Abs(s.cx)), s.most_y));
    return hn::Mul(lever, hn::Abs(s.inverse));
}

/// The plane through three values given exactly, `unit` times as large; returns the bound of what double loses over the
/// box. In half ulps: a gradient 4 for its numerator, 4 for the area, 1 each for its inverse and two products; a
/// sample's value some 8 more of the terms that it is summed from, and 4 more without fused multiply-adds.
HWY_INLINE V plane(V a0, V a1, V a2, const Shape& s, V unit, PlaneEight& out, int lane) {
    const Real d;
    const V b = hn::Sub(a1, a0), c = hn::Sub(a2, a0), scale = hn::Mul(unit, s.inverse), from = hn::Mul(a0, unit);
    const V x = hn::Mul(difference_of_products(b, s.cy, c, s.by), scale);
    const V y = hn::Mul(difference_of_products(c, s.bx, b, s.cx), scale);
    hn::Store(hn::MulAdd(y, s.dy, hn::MulAdd(x, s.dx, from)), d, out.at.at + lane);
    hn::Store(x, d, out.x.at + lane), hn::Store(y, d, out.y.at + lane);
    V reach = hn::MulAdd(hn::Abs(x), s.most_x, hn::MulAdd(hn::Abs(y), s.most_y, hn::Abs(from)));
    // Values so unlike that double rounds their difference: it is as if a corner's value had moved by half an ulp.
    if (const auto exact = hn::And(is_exact(a1, a0, b), is_exact(a2, a0, c)); !hn::AllTrue(d, exact))
        reach = hn::Add(
            reach, hn::IfThenZeroElse(exact, hn::Mul(hn::Mul(hn::Max(hn::Abs(b), hn::Abs(c)), unit), lever_of(s))));
    return hn::Mul(reach, hn::Set(d, 24 * kUlp));
}

/// Adding it puts whole numbers below 2^52 into the lowest bits of a double.
constexpr double kWholeBits = 0x1p52;

/// Floor(log2(value)) of value >= 2^-1022; for NaN and infinity 1024.
template <class D>
HWY_INLINE hn::Vec<D> exponent_of(D d, hn::Vec<D> value) {
    const hn::Repartition<uint64_t, D> bits;
    const auto exponent = hn::ShiftRight<52>(hn::BitCast(bits, value));
    const auto biased = hn::BitCast(d, hn::Or(exponent, hn::BitCast(bits, hn::Set(d, kWholeBits))));
    return hn::Sub(biased, hn::Set(d, kWholeBits + 1023));
}
/// 2^n for whole n in (-1023, 1024).
template <class D>
HWY_INLINE hn::Vec<D> power_of_two(D d, hn::Vec<D> n) {
    const hn::Repartition<uint64_t, D> bits;
    return hn::BitCast(d, hn::ShiftLeft<52>(hn::BitCast(bits, hn::Add(n, hn::Set(d, kWholeBits + 1023)))));
}
/// How many bits after the texel int32 keeps of u, so that no |u| <= `most` [texels] overflows; at most 24.
HWY_INLINE V bits_for(V most) {
    const Real d;
    const V exponent = exponent_of(d, hn::Add(most, hn::Set(d, 2.0)));
    return hn::Min(hn::Max(hn::Sub(hn::Set(d, 29.0), exponent), hn::Zero(d)), hn::Set(d, 24.0));
}

/// What makes texels certain without a look at each. A value is biased by the bound e of its error, so that it lies
/// within 2e above the true one: the texel is right if what follows the texel's own bits is at least 2e.
template <class D>
struct Certainty {
    hn::Vec<D> bias;   ///< what values must be moved by [units]
    hn::Vec<D> least;  ///< what follows a texel's bits, at the top of 32, must be no less
    hn::Mask<D> fits;  ///< else too much is in doubt for texels to be told by it

    /// @param doubt      e [units]
    /// @param half_gap   half of what lies between a border and any sample not on it, or 0 [units]: where the doubt is
    ///                   less, a value moved by that half is right without a test.
    /// @param texel      [units]
    /// @param per_texel  2^32 / texel, or the texels where their number is no power of two
    HWY_INLINE Certainty(D d, hn::Vec<D> doubt, hn::Vec<D> half_gap, hn::Vec<D> texel, hn::Vec<D> per_texel) {
        const auto one = hn::Set(d, 1.0), eight = hn::Set(d, 8.0);
        fits = hn::Lt(hn::MulAdd(doubt, eight, eight), texel);  // in doubt within an eighth of a texel, at most
        const auto sure = hn::Gt(half_gap, doubt);
        bias = hn::IfThenElse(sure, half_gap, doubt);
        const auto twice = hn::Add(hn::Floor(hn::Add(doubt, doubt)), one);
        least = hn::IfThenElseZero(hn::AndNot(sure, fits), hn::Mul(twice, per_texel));
    }
};

/// So much is in doubt where nothing is known [units].
constexpr double kNoBound = 0x1p40;

/// The most that float32 loses of u or v along a row in perspective, before it is rounded to whole units.
/// @param relative  no value is farther from the middle's [units]
/// @param kappa     D of the middle over any other D is no more than it
template <class D>
HWY_INLINE hn::Vec<D> lost_by_float(D d, hn::Vec<D> relative, hn::Vec<D> kappa) {
    // d, and i d where multiplication and addition are not fused, lose 2^-24 (kappa - 1) each, seen from 1 + i d; n,
    // that sum, the quotient and the last product 2^-24: 2 kappa + 2, and some for what is lost of these losses.
    return hn::Mul(hn::Mul(relative, hn::Set(d, 0x1p-24)), hn::MulAdd(kappa, hn::Set(d, 2.0), hn::Set(d, 6.0)));
}

/// How float32 carries u or v along a row in perspective, from the middle.
template <class D>
struct FloatBound {
    hn::Vec<D> shift, scale;  ///< it counts in 2^shift units; 2^-shift
    hn::Vec<D> doubt;         ///< the most that a value may be wrong [units]

    /// @param far  bound of what double has lost [units]
    HWY_INLINE FloatBound(D d, hn::Vec<D> relative, hn::Vec<D> kappa, hn::Vec<D> far) {
        shift = hn::Max(hn::Sub(exponent_of(d, relative), hn::Set(d, 20.0)), hn::Zero(d));
        const auto fits = hn::Lt(shift, hn::Set(d, 24.0));
        shift = hn::IfThenElseZero(fits, shift);
        scale = power_of_two(d, hn::Neg(shift));
        // One rounding to whole 2^shift units, and some to whole ones.
        const auto rounding = hn::MulAdd(power_of_two(d, shift), hn::Set(d, .6), hn::Set(d, 3.0));
        const auto all = hn::Add(hn::Add(lost_by_float(d, relative, kappa), rounding), far);
        doubt = hn::IfThenElse(fits, all, hn::Set(d, kNoBound));
    }
};

/// The units in which u or v of some triangles is counted.
struct Units {
    V unit;              ///< in one unit of u
    V texel, per_texel;  ///< as Certainty has them
};
/// Stores the shift that makes texels of units, too.
HWY_INLINE Units units_of(V a0, V a1, V a2, const Canvas& canvas, bool is_u, EightInt& shift, int lane) {
    const Real d;
    const double texels = is_u ? canvas.texture.width : canvas.texture.height;
    if (canvas.addressing != Addressing::clamped) {
        store_int(hn::Set(d, 32 - (is_u ? canvas.u_bits : canvas.v_bits)), shift.at + lane);
        return {hn::Set(d, is_u ? canvas.u_unit : canvas.v_unit), hn::Set(d, 0x1p32 / texels), hn::Set(d, texels)};
    }
    const V size = hn::Set(d, is_u ? canvas.job->u_texels : canvas.job->v_texels);
    const V bits = bits_for(hn::Mul(most_of(hn::Abs(a0), hn::Abs(a1), hn::Abs(a2)), size));
    store_int(bits, shift.at + lane);
    const V texel = power_of_two(d, bits);
    return {hn::Mul(texel, size), texel, power_of_two(d, hn::Sub(hn::Set(d, 32.0), bits))};
}

/// Where z, w, u and v are finite, those that nobody asks for, too: a triangle with a number that is not draws nothing.
HWY_INLINE hn::Mask<Real> has_finite_values(const Eights& f) {
    const Floats zero = hn::Zero(Narrow{});
    const auto nothing_of = [&](const Floats(&a)[3]) HWY_ATTR {  // or NaN
        return hn::MulAdd(a[0], zero, hn::MulAdd(a[1], zero, hn::Mul(a[2], zero)));
    };
    const Floats nothing =
        hn::Add(hn::Add(nothing_of(f.z), nothing_of(f.w)), hn::Add(nothing_of(f.u), nothing_of(f.v)));
    return hn::Eq(promote(nothing), hn::Zero(Real{}));
}

/// Returns where int32 can tell the texels.
HWY_INLINE hn::Mask<Real> coordinate(const Floats (&a)[3], bool is_u, const Shape& s, const Canvas& canvas,
                                     CoordinateEight& out, int lane) {
    const Real d;
    const V a0 = promote(a[0]), a1 = promote(a[1]), a2 = promote(a[2]);
    const Units units = units_of(a0, a1, a2, canvas, is_u, out.shift, lane);
    // 24 half ulps of 2^50 are 2.7: from there on double does not hold whole units, and the slow path has to.
    const V lost = plane(a0, a1, a2, s, units.unit, out.plane, lane);
    const V unsure = hn::IfThenElse(hn::Lt(lost, hn::Set(d, 2.0)), lost, hn::Set(d, 0x1p40));
    hn::Store(unsure, d, out.unsure.at + lane);
    // A start is cut to whole units, and each step rounded by up to half of one; those down are 7 at most, in
    // draw_small().
    const V doubt = hn::Add(unsure, hn::MulAdd(s.width, hn::Set(d, .5), hn::Set(d, 4.0)));
    hn::Store(doubt, d, out.doubt.at + lane);
    const Certainty<Real> certainty(d, doubt, hn::Zero(d), units.texel, units.per_texel);
    store_fraction(certainty.least, out.least.at + lane);
    store_fraction(hn::Load(d, out.plane.x.at + lane), out.step.at + lane);
    store_fraction(hn::Load(d, out.plane.y.at + lane), out.down.at + lane);
    return certainty.fits;
}

/// E of the side from a to b over the block of samples from (sx, sy): positive inside.
HWY_INLINE void set_side(V ax, V ay, V bx, V by, V sx, V sy, V sign, hn::Mask<Real> coarse, Batch& batch, size_t n,
                         int lane) {
    const Real d;
    const Narrow f;
    const V right = hn::Mul(hn::Sub(ay, by), sign), down = hn::Mul(hn::Sub(bx, ax), sign), zero = hn::Zero(d);
    const V one = difference_of_products(down, hn::Sub(sy, ay), right, hn::Sub(ax, sx));
    const auto owns = hn::Or(hn::Gt(right, zero), hn::And(hn::Eq(right, zero), hn::Gt(down, zero)));
    const V least = hn::IfThenElse(hn::And(coarse, hn::Not(owns)), hn::Set(d, 0x1p-16), zero);
    hn::Store(hn::DemoteTo(f, right), f, batch.side_x[n].at + lane);
    hn::Store(hn::DemoteTo(f, down), f, batch.side_y[n].at + lane);
    hn::Store(hn::DemoteTo(f, one), f, batch.side_one[n].at + lane);
    hn::Store(hn::DemoteTo(f, least), f, batch.side_least[n].at + lane);
}

/// A plane through values that double has rounded; returns the bound of its error over the box.
HWY_INLINE V rounded_plane(V a0, V a1, V a2, const Shape& s, PlaneEight& out, int lane) {
    const Real d;
    const V b = hn::Sub(a1, a0), c = hn::Sub(a2, a0), scale = s.inverse;
    const V x = hn::Mul(difference_of_products(b, s.cy, c, s.by), scale),
            y = hn::Mul(difference_of_products(c, s.bx, b, s.cx), scale);
    hn::Store(hn::MulAdd(y, s.dy, hn::MulAdd(x, s.dx, a0)), d, out.at.at + lane);
    hn::Store(x, d, out.x.at + lane), hn::Store(y, d, out.y.at + lane);
    // In half ulps: values come with 3 of the largest, so their differences with 8 of it, which grows over the area as
    // the sides do. A gradient has 4 for its numerator, 4 for the area, 1 each for its inverse and the product: 10; the
    // sum at a sample some 8 of all its terms, without fused multiply-adds, and the first value's own 3.
    const V largest = most_of(hn::Abs(a0), hn::Abs(a1), hn::Abs(a2)), grown = hn::Mul(largest, lever_of(s));
    const V reach = hn::MulAdd(hn::Abs(x), s.most_x, hn::MulAdd(hn::Abs(y), s.most_y, largest));
    return hn::MulAdd(grown, hn::Set(d, 8 * kUlp), hn::Mul(reach, hn::Set(d, 20 * kUlp)));
}

/// Returns where w is positive; `flat` is where it is the same at all corners.
HWY_INLINE hn::Mask<Real> set_up_perspective(const Eights& f, const Shape& s, const Canvas& canvas,
                                             hn::Mask<Real>& flat, Batch& batch, int lane) {
    const Real d;
    const V w0 = promote(f.w[0]), w1 = promote(f.w[1]), w2 = promote(f.w[2]), one = hn::Set(d, 1.0);
    flat = hn::And(hn::Eq(w0, w1), hn::Eq(w0, w2));
    store_int(hn::IfThenElseZero(flat, one), batch.flat.at + lane);
    const V i0 = hn::Div(one, w0), i1 = hn::Div(one, w1), i2 = hn::Div(one, w2), least = least_of(i0, i1, i2);
    const V kappa = hn::Div(most_of(i0, i1, i2), least);
    const V one_error = rounded_plane(i0, i1, i2, s, batch.one, lane);
    const auto over = [&](const Floats(&a)[3], bool is_u, EightInt& shift, PlaneEight& out, Eight& far,
                          FloatEight& along) HWY_ATTR {
        const Real r;
        V a0 = promote(a[0]), a1 = promote(a[1]), a2 = promote(a[2]);
        const Units units = units_of(a0, a1, a2, canvas, is_u, shift, lane);
        a0 = hn::Mul(a0, units.unit), a1 = hn::Mul(a1, units.unit), a2 = hn::Mul(a2, units.unit);
        const V error = rounded_plane(hn::Mul(a0, i0), hn::Mul(a1, i1), hn::Mul(a2, i2), s, out, lane);
        const V largest = most_of(hn::Abs(a0), hn::Abs(a1), hn::Abs(a2));
        // (N + eN) / (D + eD) - N / D, with |N / D| no more than the largest u and D no less than the least 1/w; and a
        // few roundings of quotients. Twice that.
        const V lost = hn::Div(hn::MulAdd(largest, one_error, error), hn::Sub(least, one_error));
        const V bound = hn::MulAdd(largest, hn::Set(r, 32 * kUlp), hn::Mul(hn::Abs(lost), hn::Set(r, 2.0)));
        const auto good = hn::And(hn::Gt(least, hn::Add(one_error, one_error)), hn::Lt(largest, hn::Set(r, 0x1p50)));
        const V lost_far = hn::IfThenElse(good, bound, hn::Set(r, 0x1p40));
        hn::Store(lost_far, r, far.at + lane);
        const V low = least_of(a0, a1, a2), high = most_of(a0, a1, a2);
        hn::Store(low, r, along.low.at + lane), hn::Store(high, r, along.high.at + lane);
        const FloatBound<Real> along_rows(r, hn::Sub(high, low), kappa, lost_far);
        const Certainty<Real> certainty(r, along_rows.doubt, hn::Zero(r), units.texel, units.per_texel);
        store_int(along_rows.shift, along.shift.at + lane);
        hn::Store(hn::DemoteTo(Narrow{}, along_rows.scale), Narrow{}, along.scale.at + lane);
        hn::Store(along_rows.doubt, r, along.doubt.at + lane);
        store_fraction(hn::IfThenElse(certainty.fits, certainty.least, hn::Set(r, 0x1p32 - 1)), along.least.at + lane);
    };
    over(f.u, true, batch.u.shift, batch.u_over, batch.u_far, batch.u_along);
    over(f.v, false, batch.v.shift, batch.v_over, batch.v_far, batch.v_along);
    return hn::Gt(least_of(w0, w1, w2), hn::Zero(d));
}

/// Elsewhere than on the coarse grid, what float32 loses of a side's value: half an ulp of one below 2^8 in it and in
/// each sum that makes it, 2^-17 each, 2^-22 for each of 7 samples in either direction, and 2^-19 for each of two
/// products that are not fused; less than half of 2^-14. (A triangle outside the target may be far from the block: its
/// values then are too large to be in doubt.)
HWY_INLINE void set_up_small(const Corners& p, const Shape& s, V c0, V r0, hn::Mask<Real> coarse, Batch& batch,
                             int lane) {
    const Real d;
    const V sign = hn::IfThenElse(hn::Lt(s.area, hn::Zero(d)), hn::Set(d, -1.0), hn::Set(d, 1.0));
    const V sx = hn::Add(c0, hn::Set(d, .5)), sy = hn::Add(r0, hn::Set(d, .5));
    set_side(p.x1, p.y1, p.x2, p.y2, sx, sy, sign, coarse, batch, 0, lane);
    set_side(p.x2, p.y2, p.x0, p.y0, sx, sy, sign, coarse, batch, 1, lane);
    set_side(p.x0, p.y0, p.x1, p.y1, sx, sy, sign, coarse, batch, 2, lane);
    hn::Store(hn::DemoteTo(Narrow{}, hn::IfThenZeroElse(coarse, hn::Set(d, 0x1p-14))), Narrow{},
              batch.side_doubt.at + lane);
}

/// The sides from top to bottom.
HWY_INLINE void set_up_sides(Corners p, V area, const Canvas& canvas, Batch& batch, int lane) {
    const Real d;
    order(p.x0, p.y0, p.x1, p.y1), order(p.x1, p.y1, p.x2, p.y2), order(p.x0, p.y0, p.x1, p.y1);
    store_int(first_centre(p.y1, canvas.target.height), batch.row_mid.at + lane);
    store_int(hn::Min(hn::Add(hn::Div(hn::Abs(area), hn::Sub(p.y2, p.y0)), hn::Set(d, 1.25)), hn::Set(d, 32768.0)),
              batch.widest.at + lane);
    store_int(hn::IfThenElse(hn::Gt(p.area(), hn::Zero(d)), hn::Set(d, 1.0), hn::Zero(d)), batch.long_left.at + lane);
    hn::Store(p.x0, d, batch.long_x.at + lane), hn::Store(p.y0, d, batch.long_y.at + lane);
    hn::Store(hn::Div(hn::Sub(p.x2, p.x0), hn::Sub(p.y2, p.y0)), d, batch.long_slope.at + lane);
    hn::Store(hn::Div(hn::Sub(p.x1, p.x0), hn::Sub(p.y1, p.y0)), d, batch.top_slope.at + lane);
    hn::Store(p.x1, d, batch.low_x.at + lane), hn::Store(p.y1, d, batch.low_y.at + lane);
    hn::Store(hn::Div(hn::Sub(p.x2, p.x1), hn::Sub(p.y2, p.y1)), d, batch.low_slope.at + lane);
}

/// Where all corners lie in the same texel: u and v of a sample are between the corners', in perspective, too.
HWY_INLINE hn::Mask<Real> in_one_texel(const Eights& f, const Canvas& canvas) {
    const Real d;
    const auto same = [&](const Floats(&a)[3], int texels) HWY_ATTR {
        const V size = hn::Set(Real{}, texels);  // the products are exact
        const V a0 = hn::Floor(hn::Mul(promote(a[0]), size)), a1 = hn::Floor(hn::Mul(promote(a[1]), size)),
                a2 = hn::Floor(hn::Mul(promote(a[2]), size));
        return hn::And(hn::And(hn::Eq(a0, a1), hn::Eq(a0, a2)), hn::Lt(hn::Abs(a0), hn::Set(Real{}, 0x1p50)));
    };
    if (!canvas.settings->skip(RasterSkip::one_texel)) return hn::FirstN(d, 0);
    return hn::And(same(f.u, canvas.job->u_texels), same(f.v, canvas.job->v_texels));
}

/// The corners' box, and the samples in it [px].
struct Box {
    V low_x, high_x, low_y, high_y;
    V c0, c1, r0, r1;
};
HWY_INLINE Box set_up_box(const Corners& p, hn::Mask<Real> coarse, const Canvas& canvas, Batch& batch, int lane) {
    const Real d;
    const double u = 16 * kUlp;
    Box box{least_of(p.x0, p.x1, p.x2), most_of(p.x0, p.x1, p.x2), least_of(p.y0, p.y1, p.y2),
            most_of(p.y0, p.y1, p.y2)};
    box.c0 = first_centre(box.low_x, canvas.target.width), box.c1 = first_centre(box.high_x, canvas.target.width);
    box.r0 = first_centre(box.low_y, canvas.target.height), box.r1 = first_centre(box.high_y, canvas.target.height);
    const V widest = hn::Max(hn::Abs(box.low_x), hn::Abs(box.high_x));
    const V doubt = hn::MulAdd(widest, hn::Set(d, u), hn::Set(d, u * (canvas.target.width + 2)));
    hn::Store(hn::IfThenZeroElse(coarse, doubt), d, batch.cross_doubt.at + lane);
    store_int(box.c0, batch.column0.at + lane), store_int(box.c1, batch.column1.at + lane);
    store_int(box.r0, batch.row0.at + lane), store_int(box.r1, batch.row1.at + lane);
    return box;
}

/// Sets up the triangles whose indices stand in `batch`; those beyond `count` repeat one of them.
HWY_NOINLINE void set_up(Batch& batch, const Canvas& canvas) {
    const Real d;
    const auto* const base = reinterpret_cast<const float*>(canvas.job->vertices.data());
    for (int lane = 0; lane < kBatch; lane += kReals) {
        const Eights f(Narrow{}, ByIndex{base, batch.index.at + lane});
        const Corners p(f, canvas.target);
        const auto coarse = p.coarse();
        const Box box = set_up_box(p, coarse, canvas, batch, lane);
        const V half = hn::Set(d, .5);
        Shape s{hn::Sub(p.x1, p.x0),
                hn::Sub(p.y1, p.y0),
                hn::Sub(p.x2, p.x0),
                hn::Sub(p.y2, p.y0),
                p.area(),
                hn::Sub(hn::Add(box.c0, half), p.x0),
                hn::Sub(hn::Add(box.r0, half), p.y0),
                half,
                half,
                hn::Sub(box.c1, box.c0),
                hn::Div(hn::Set(d, 1.0), p.area())};
        s.most_x = hn::Max(hn::Abs(s.dx), hn::Abs(hn::Add(s.dx, s.width)));
        s.most_y = hn::Max(hn::Abs(s.dy), hn::Abs(hn::Add(s.dy, hn::Sub(box.r1, box.r0))));
        store_int(hn::IfThenElseZero(hn::Gt(s.area, hn::Zero(d)), hn::Set(d, 1.0)), batch.front.at + lane);
        const auto one_texel = in_one_texel(f, canvas);
        store_int(hn::IfThenElseZero(one_texel, hn::Set(d, 1.0)), batch.one_texel.at + lane);
        const auto affine = [&]() HWY_ATTR {
            return hn::And(coordinate(f.u, true, s, canvas, batch.u, lane),
                           coordinate(f.v, false, s, canvas, batch.v, lane));
        };
        hn::Mask<Real> good;
        if (!canvas.job->perspective) {
            good = affine();
        } else {
            hn::Mask<Real> flat;
            good = set_up_perspective(f, s, canvas, flat, batch, lane);
            if (!hn::AllFalse(d, flat)) good = hn::And(good, hn::Or(affine(), hn::Not(flat)));
        }
        if (canvas.job->depth) {
            const V z0 = promote(f.z[0]), z1 = promote(f.z[1]), z2 = promote(f.z[2]);
            const V unsure = plane(z0, z1, z2, s, hn::Set(d, 1.0), batch.z, lane);
            // At least half a denormal, the least that differs; and nothing where z is the same all over.
            const auto level = hn::And(hn::Eq(z0, z1), hn::Eq(z0, z2));
            hn::Store(hn::IfThenZeroElse(level, hn::Max(unsure, hn::Set(d, 0x1p-149))), d, batch.z_unsure.at + lane);
            const V used = hn::Set(d, canvas.settings->skip(RasterSkip::level_z) ? 1.0 : 0.0);
            store_int(hn::IfThenElseZero(level, used), batch.level_z.at + lane);
        }
        bool has_rows = true;
        if (canvas.addressing == Addressing::powers && !canvas.job->perspective) {
            const V extent = hn::Max(hn::Sub(box.high_x, box.low_x), hn::Sub(box.high_y, box.low_y)),
                    samples = hn::Max(s.width, hn::Sub(box.r1, box.r0));
            const auto small = hn::And(hn::Lt(extent, hn::Set(d, 8.0)), hn::Le(samples, hn::Set(d, 8.0)));
            store_int(hn::IfThenElseZero(small, hn::Set(d, 1.0)), batch.small.at + lane);
            const auto tiny = hn::And(small, hn::Le(samples, hn::Set(d, 4.0)));
            store_int(hn::IfThenElseZero(tiny, hn::Set(d, 1.0)), batch.tiny.at + lane);
            if (!hn::AllFalse(d, small)) set_up_small(p, s, box.c0, box.r0, coarse, batch, lane);
            // Neither draw_tiny() nor draw_small() gives any of these back.
            has_rows = !hn::AllTrue(d, hn::AndNot(one_texel, hn::And(small, coarse)));
        }
        good = hn::And(good, hn::And(has_finite_values(f), is_fine(f, canvas.target)));
        store_int(hn::IfThenElseZero(good, hn::Set(d, 1.0)), batch.good.at + lane);
        if (has_rows) set_up_sides(p, s.area, canvas, batch, lane);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
