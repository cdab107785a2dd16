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
    EightInt step, down;  ///< x and y rounded, modulo 2^32
    EightInt shift;       ///< units in a texel are 2^shift; not where the size is no power of two and repeats
};

/// Everything about eight triangles, computed side by side.
struct Batch {
    EightInt index;  ///< which triangle
    EightInt good;   ///< finite, w > 0 where that matters
    EightInt row0, row_mid, row1, column0, column1;
    Eight long_x, long_y, long_slope;          ///< the side from top to bottom: x = long_x + (y - long_y) slope
    Eight top_slope, low_x, low_y, low_slope;  ///< the two others; the upper begins where the long one does
    CoordinateEight u, v;
    Eight cross_doubt;   ///< of a crossing [px]; 0: all crossings are told apart by the bias
    EightInt long_left;  ///< the long side is the left one
    EightInt widest;     ///< no row has more samples
    EightInt front;      ///< seen from the front
    EightInt tiny;       ///< lies in a block of 4 x 4 samples from (column0, row0)
    std::array<EightFloat, 3> side_x, side_y, side_one, side_least;  ///< E over the block; inside: E >= least
    EightFloat side_doubt;
    EightInt flat;                   ///< equal w at all corners: affine
    PlaneEight one, u_over, v_over;  ///< 1/w, u/w, v/w over the box [units]
    Eight u_far, v_far;              ///< bound of what double has lost of u and v [units]
    PlaneEight z;
    Eight z_unsure;  ///< bound of what double has lost of z

    /// Of the triangles in the lanes from `lane` on.
    [[nodiscard]] HWY_INLINE bool any_flat(int lane) const {
        const Index d;
        return !hn::AllFalse(d, hn::Ne(hn::Load(d, flat.at + lane), hn::Zero(d)));
    }
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
    HWY_INLINE Corners(const float* base, hn::Vec<Index> index, const RasterTarget& target) {
        const Real d;
        const V left = hn::Set(d, target.x0), top = hn::Set(d, target.y0);
        x0 = hn::Sub(field(base, index, 0), left), y0 = hn::Sub(field(base, index, 1), top);
        x1 = hn::Sub(field(base, index, 6), left), y1 = hn::Sub(field(base, index, 7), top);
        x2 = hn::Sub(field(base, index, 12), left), y2 = hn::Sub(field(base, index, 13), top);
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
HWY_INLINE hn::Mask<Real> is_fine(const float* base, hn::Vec<Index> index, const RasterTarget& target) {
    const Real d;
    const hn::Repartition<uint64_t, Real> bits;
    const double reach = std::max(std::abs(target.x0), std::abs(target.y0)) + std::max(target.width, target.height);
    const V x0 = field(base, index, 0), y0 = field(base, index, 1), x1 = field(base, index, 6),
            y1 = field(base, index, 7), x2 = field(base, index, 12), y2 = field(base, index, 13);
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
};

/// Whether a1 - a0 is what double says.
HWY_INLINE hn::Mask<Real> is_exact(V a1, V a0, V difference) {
    return hn::And(hn::Eq(hn::Sub(a1, difference), a0), hn::Eq(hn::Add(difference, a0), a1));
}
/// How much a plane over the box moves for each unit that a value at a corner moves, at most.
HWY_INLINE V lever_of(const Shape& s) {
    const V lever = hn::MulAdd(hn::Add(hn::Abs(s.by), hn::Abs(s.cy)), s.most_x,
                               hn::Mul(hn::Add(hn::Abs(s.bx), hn::Abs(s.cx)), s.most_y));
    return hn::Div(lever, hn::Abs(s.area));
}

/// The plane through three values given exactly, `unit` times as large; returns the bound of what double loses over the
/// box. In half ulps: a gradient 4 for its numerator, 4 for the area, 1 each for the quotient by it and the product; a
/// sample's value some 8 more of the terms that it is summed from, and 4 more without fused multiply-adds.
HWY_INLINE V plane(V a0, V a1, V a2, const Shape& s, V unit, PlaneEight& out, int lane) {
    const Real d;
    const V b = hn::Sub(a1, a0), c = hn::Sub(a2, a0), scale = hn::Div(unit, s.area), from = hn::Mul(a0, unit);
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

/// How many bits after the texel int32 keeps of u, so that no |u| <= `most` [texels] overflows; at most 24.
HWY_INLINE V bits_for(V most) {
    const Real d;
    const hn::Repartition<uint64_t, Real> bits;
    const auto exponent = hn::ShiftRight<52>(hn::BitCast(bits, hn::Add(most, hn::Set(d, 2.0))));
    const V biased =
        hn::Sub(hn::BitCast(d, hn::Or(exponent, hn::BitCast(bits, hn::Set(d, kWholeBits)))), hn::Set(d, kWholeBits));
    return hn::Min(hn::Max(hn::Sub(hn::Set(d, 29 + 1023), biased), hn::Zero(d)), hn::Set(d, 24.0));
}
/// 2^n for whole n in [0, 64).
HWY_INLINE V power_of_two(V n) {
    const Real d;
    const hn::Repartition<uint64_t, Real> bits;
    return hn::BitCast(d, hn::ShiftLeft<52>(hn::BitCast(bits, hn::Add(n, hn::Set(d, kWholeBits + 1023)))));
}

/// Units in one unit of u, and the shift that makes texels of them.
HWY_INLINE V unit_of(V a0, V a1, V a2, const Canvas& canvas, bool is_u, EightInt& shift, int lane) {
    const Real d;
    if (canvas.addressing != Addressing::clamped) {
        store_int(hn::Set(d, 32 - (is_u ? canvas.u_bits : canvas.v_bits)), shift, lane);
        return hn::Set(d, is_u ? canvas.u_unit : canvas.v_unit);
    }
    const V texels = hn::Set(d, is_u ? canvas.job->u_texels : canvas.job->v_texels);
    const V bits = bits_for(hn::Mul(most_of(hn::Abs(a0), hn::Abs(a1), hn::Abs(a2)), texels));
    store_int(bits, shift, lane);
    return hn::Mul(power_of_two(bits), texels);
}

/// 0, or NaN where one of them is not finite.
HWY_INLINE V nothing_of(V a0, V a1, V a2) {
    const V zero = hn::Zero(Real{});
    return hn::MulAdd(a0, zero, hn::MulAdd(a1, zero, hn::Mul(a2, zero)));
}

/// Returns nothing_of() the corners' values.
HWY_INLINE V coordinate(const float* base, hn::Vec<Index> index, int offset, const Shape& s, const Canvas& canvas,
                        CoordinateEight& out, int lane) {
    const Real d;
    const V a0 = field(base, index, offset), a1 = field(base, index, offset + 6), a2 = field(base, index, offset + 12);
    const V unit = unit_of(a0, a1, a2, canvas, offset == 4, out.shift, lane);
    // 24 half ulps of 2^50 are 2.7: from there on double does not hold whole units, and the slow path has to.
    const V lost = plane(a0, a1, a2, s, unit, out.plane, lane);
    const V unsure = hn::IfThenElse(hn::Lt(lost, hn::Set(d, 2.0)), lost, hn::Set(d, 0x1p40));
    hn::Store(unsure, d, out.unsure.at + lane);
    // A start is rounded to whole units, and each step by up to half of one.
    hn::Store(hn::Add(unsure, hn::MulAdd(s.width, hn::Set(d, .5), hn::Set(d, 4.0))), d, out.doubt.at + lane);
    store_fraction(hn::Load(d, out.plane.x.at + lane), out.step, lane);
    store_fraction(hn::Load(d, out.plane.y.at + lane), out.down, lane);
    return nothing_of(a0, a1, a2);
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
    const V b = hn::Sub(a1, a0), c = hn::Sub(a2, a0), scale = hn::Div(hn::Set(d, 1.0), s.area);
    const V x = hn::Mul(difference_of_products(b, s.cy, c, s.by), scale),
            y = hn::Mul(difference_of_products(c, s.bx, b, s.cx), scale);
    hn::Store(hn::MulAdd(y, s.dy, hn::MulAdd(x, s.dx, a0)), d, out.at.at + lane);
    hn::Store(x, d, out.x.at + lane), hn::Store(y, d, out.y.at + lane);
    // The values come with 3 half ulps of the largest, their differences with 8 of it; over the area that grows as the
    // sides do.
    const V largest = most_of(hn::Abs(a0), hn::Abs(a1), hn::Abs(a2)), grown = hn::Mul(largest, lever_of(s));
    const V reach = hn::MulAdd(hn::Abs(x), s.most_x, hn::MulAdd(hn::Abs(y), s.most_y, largest));
    return hn::Mul(hn::Add(grown, reach), hn::Set(d, 10 * kUlp));
}

/// Returns where u, v and w are finite, and w is positive.
HWY_INLINE hn::Mask<Real> set_up_perspective(const float* base, hn::Vec<Index> index, const Shape& s,
                                             const Canvas& canvas, Batch& batch, int lane) {
    const Real d;
    const V w0 = field(base, index, 3), w1 = field(base, index, 9), w2 = field(base, index, 15), one = hn::Set(d, 1.0);
    const auto flat = hn::And(hn::Eq(w0, w1), hn::Eq(w0, w2));
    store_int(hn::IfThenElseZero(flat, one), batch.flat, lane);
    const V i0 = hn::Div(one, w0), i1 = hn::Div(one, w1), i2 = hn::Div(one, w2), least = least_of(i0, i1, i2);
    const V one_error = rounded_plane(i0, i1, i2, s, batch.one, lane);
    V nothing = hn::Zero(d);
    const auto over = [&](int offset, EightInt& shift, PlaneEight& out, Eight& far) HWY_ATTR {
        const Real r;
        V a0 = field(base, index, offset), a1 = field(base, index, offset + 6), a2 = field(base, index, offset + 12);
        nothing = hn::Add(nothing, nothing_of(a0, a1, a2));
        const V unit = unit_of(a0, a1, a2, canvas, offset == 4, shift, lane);
        a0 = hn::Mul(a0, unit), a1 = hn::Mul(a1, unit), a2 = hn::Mul(a2, unit);
        const V error = rounded_plane(hn::Mul(a0, i0), hn::Mul(a1, i1), hn::Mul(a2, i2), s, out, lane);
        const V largest = most_of(hn::Abs(a0), hn::Abs(a1), hn::Abs(a2));
        // (N + eN) / (D + eD) - N / D, with |N / D| no more than the largest u and D no less than the least 1/w; and a
        // few roundings of quotients. Twice that.
        const V lost = hn::Div(hn::MulAdd(largest, one_error, error), hn::Sub(least, one_error));
        const V bound = hn::MulAdd(largest, hn::Set(r, 32 * kUlp), hn::Mul(hn::Abs(lost), hn::Set(r, 2.0)));
        const auto good = hn::And(hn::Gt(least, hn::Add(one_error, one_error)), hn::Lt(largest, hn::Set(r, 0x1p50)));
        hn::Store(hn::IfThenElse(good, bound, hn::Set(r, 0x1p40)), r, far.at + lane);
    };
    over(4, batch.u.shift, batch.u_over, batch.u_far);
    over(5, batch.v.shift, batch.v_over, batch.v_far);
    nothing = hn::Add(nothing, nothing_of(w0, w1, w2));
    return hn::And(hn::Gt(least_of(w0, w1, w2), hn::Zero(d)), hn::Eq(nothing, hn::Zero(d)));
}

HWY_INLINE void set_up_tiny(const Corners& p, const Shape& s, V c0, V r0, hn::Mask<Real> coarse, Batch& batch,
                            int lane) {
    const Real d;
    const V sign = hn::IfThenElse(hn::Lt(s.area, hn::Zero(d)), hn::Set(d, -1.0), hn::Set(d, 1.0));
    const V sx = hn::Add(c0, hn::Set(d, .5)), sy = hn::Add(r0, hn::Set(d, .5));
    set_side(p.x1, p.y1, p.x2, p.y2, sx, sy, sign, coarse, batch, 0, lane);
    set_side(p.x2, p.y2, p.x0, p.y0, sx, sy, sign, coarse, batch, 1, lane);
    set_side(p.x0, p.y0, p.x1, p.y1, sx, sy, sign, coarse, batch, 2, lane);
    hn::Store(hn::DemoteTo(Narrow{}, hn::IfThenZeroElse(coarse, hn::Set(d, 0x1p-15))), Narrow{},
              batch.side_doubt.at + lane);
}

/// The sides from top to bottom.
HWY_INLINE void set_up_sides(Corners p, V area, const Canvas& canvas, Batch& batch, int lane) {
    const Real d;
    order(p.x0, p.y0, p.x1, p.y1), order(p.x1, p.y1, p.x2, p.y2), order(p.x0, p.y0, p.x1, p.y1);
    store_int(first_centre(p.y1, canvas.target.height), batch.row_mid, lane);
    store_int(hn::Min(hn::Add(hn::Div(hn::Abs(area), hn::Sub(p.y2, p.y0)), hn::Set(d, 1.25)), hn::Set(d, 32768.0)),
              batch.widest, lane);
    store_int(hn::IfThenElse(hn::Gt(p.area(), hn::Zero(d)), hn::Set(d, 1.0), hn::Zero(d)), batch.long_left, lane);
    hn::Store(p.x0, d, batch.long_x.at + lane), hn::Store(p.y0, d, batch.long_y.at + lane);
    hn::Store(hn::Div(hn::Sub(p.x2, p.x0), hn::Sub(p.y2, p.y0)), d, batch.long_slope.at + lane);
    hn::Store(hn::Div(hn::Sub(p.x1, p.x0), hn::Sub(p.y1, p.y0)), d, batch.top_slope.at + lane);
    hn::Store(p.x1, d, batch.low_x.at + lane), hn::Store(p.y1, d, batch.low_y.at + lane);
    hn::Store(hn::Div(hn::Sub(p.x2, p.x1), hn::Sub(p.y2, p.y1)), d, batch.low_slope.at + lane);
}

/// Sets up the triangles whose indices stand in `batch`; those beyond `count` repeat one of them.
HWY_NOINLINE void set_up(Batch& batch, const Canvas& canvas) {
    const Real d;
    const auto* const base = reinterpret_cast<const float*>(canvas.job->vertices.data());
    const double u = 16 * kUlp;
    for (int lane = 0; lane < kBatch; lane += kReals) {
        const auto index = hn::Mul(hn::Load(Index{}, batch.index.at + lane), hn::Set(Index{}, 18));
        const Corners p(base, index, canvas.target);
        const auto coarse = p.coarse();
        const V low_x = least_of(p.x0, p.x1, p.x2), high_x = most_of(p.x0, p.x1, p.x2);
        const V low_y = least_of(p.y0, p.y1, p.y2), high_y = most_of(p.y0, p.y1, p.y2);
        const V c0 = first_centre(low_x, canvas.target.width), c1 = first_centre(high_x, canvas.target.width);
        const V r0 = first_centre(low_y, canvas.target.height), r1 = first_centre(high_y, canvas.target.height);
        const V widest = hn::Max(hn::Abs(low_x), hn::Abs(high_x));
        hn::Store(
            hn::IfThenZeroElse(coarse, hn::MulAdd(widest, hn::Set(d, u), hn::Set(d, u * (canvas.target.width + 2)))), d,
            batch.cross_doubt.at + lane);
        store_int(c0, batch.column0, lane), store_int(c1, batch.column1, lane);
        store_int(r0, batch.row0, lane), store_int(r1, batch.row1, lane);

        const V half = hn::Set(d, .5);
        Shape s{hn::Sub(p.x1, p.x0),
                hn::Sub(p.y1, p.y0),
                hn::Sub(p.x2, p.x0),
                hn::Sub(p.y2, p.y0),
                p.area(),
                hn::Sub(hn::Add(c0, half), p.x0),
                hn::Sub(hn::Add(r0, half), p.y0),
                half,
                half,
                hn::Sub(c1, c0)};
        s.most_x = hn::Max(hn::Abs(s.dx), hn::Abs(hn::Add(s.dx, s.width)));
        s.most_y = hn::Max(hn::Abs(s.dy), hn::Abs(hn::Add(s.dy, hn::Sub(r1, r0))));
        store_int(hn::IfThenElseZero(hn::Gt(s.area, hn::Zero(d)), hn::Set(d, 1.0)), batch.front, lane);
        V nothing = hn::Zero(d);
        auto good = hn::Eq(half, half);
        if (canvas.job->perspective) good = set_up_perspective(base, index, s, canvas, batch, lane);
        if (!canvas.job->perspective || batch.any_flat(lane))
            nothing = hn::Add(coordinate(base, index, 4, s, canvas, batch.u, lane),
                              coordinate(base, index, 5, s, canvas, batch.v, lane));
        if (canvas.job->depth) {
            const V z0 = field(base, index, 2), z1 = field(base, index, 8), z2 = field(base, index, 14);
            const V unsure = plane(z0, z1, z2, s, hn::Set(d, 1.0), batch.z, lane);
            // At least half a denormal, the least that differs; and nothing where z is the same all over.
            nothing = hn::Add(nothing, nothing_of(z0, z1, z2));
            const auto level = hn::And(hn::Eq(z0, z1), hn::Eq(z0, z2));
            hn::Store(hn::IfThenZeroElse(level, hn::Max(unsure, hn::Set(d, 0x1p-149))), d, batch.z_unsure.at + lane);
        } else {
            const auto is_small = [&](V extent, V samples) HWY_ATTR {
                return hn::And(hn::Le(samples, hn::Set(Real{}, 4.0)), hn::Lt(extent, hn::Set(Real{}, 8.0)));
            };
            const auto tiny =
                hn::And(is_small(hn::Sub(high_x, low_x), s.width), is_small(hn::Sub(high_y, low_y), hn::Sub(r1, r0)));
            store_int(hn::IfThenElseZero(tiny, hn::Set(d, 1.0)), batch.tiny, lane);
            if (!hn::AllFalse(d, tiny)) set_up_tiny(p, s, c0, r0, coarse, batch, lane);
        }
        good = hn::And(good, hn::Eq(nothing, hn::Zero(d)));
        store_int(hn::IfThenElseZero(good, hn::Set(d, 1.0)), batch.good, lane);
        set_up_sides(p, s.area, canvas, batch, lane);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
