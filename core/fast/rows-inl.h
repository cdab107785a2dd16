// Affine triangles row by row, for each SIMD target. Included by raster.cpp only.
#if defined(TEXELSCOPE_ROWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_ROWS_INL
#undef TEXELSCOPE_ROWS_INL
#else
#define TEXELSCOPE_ROWS_INL
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "core/fast/decide.h"
#include "core/fast/dispatch.h"
#include "core/fast/raster.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kBatch = 8;         ///< triangles set up at once, rows crossed at once
constexpr double kUlp = 0x1p-53;  ///< half a unit in the last place of 1

using Real = hn::CappedTag<double, kBatch>;
using Narrow = hn::Rebind<float, Real>;
using Index = hn::Rebind<int32_t, Real>;
using Pixel = hn::ScalableTag<uint32_t>;
using PixelInt = hn::ScalableTag<int32_t>;
constexpr int kReals = static_cast<int>(hn::MaxLanes(Real{}));
using V = hn::Vec<Real>;

/// Numbers of eight triangles, or of eight rows.
struct alignas(64) Eight {
    double at[kBatch];
};
struct alignas(64) EightFloat {
    float at[kBatch];
};
struct alignas(64) EightInt {
    int32_t at[kBatch];
};

HWY_INLINE V field(const float* base, hn::Vec<Index> index, int offset) {
    return hn::PromoteTo(Real{}, hn::GatherIndex(Narrow{}, base + offset, index));
}

/// a b - c d with at most 1.5 ulp of error, so that its sign is right (Kahan; Jeannerod, Louvet, Muller 2013).
HWY_INLINE V difference_of_products(V a, V b, V c, V d) {
    const V w = hn::Mul(c, d);
    return hn::Add(hn::MulSub(a, b, w), hn::NegMulAdd(c, d, w));
}

/// a = at + x i + y j at pixel (i, j) of the box.
struct PlaneEight {
    Eight at, x, y;
};

/// Everything about eight triangles, computed side by side.
struct Batch {
    EightInt index;  ///< which triangle
    EightInt row0, row_mid, row1, column0, column1;
    Eight long_x, long_y, long_slope;          ///< the side from top to bottom: x = long_x + (y - long_y) slope
    Eight top_slope, low_x, low_y, low_slope;  ///< the two others; the upper begins where the long one does
    Eight u, v, u_x, u_y, v_x, v_y;            ///< at the centre of (column0, row0), and from there [2^-32 repeats]
    Eight u_doubt, v_doubt;                    ///< bound of the error of u over the box [2^-32 repeats]
    Eight cross_doubt;                         ///< of a crossing [px]; 0: all crossings are told apart by the bias
    EightInt long_left;
    EightInt u_step, v_step, u_down, v_down;  ///< u_x and v_x, rounded, modulo 2^32
    EightInt widest;                          ///< no row has more samples
    EightInt tiny;                            ///< lies in a block of 4 x 4 samples from (column0, row0)
    std::array<EightFloat, 3> side_x, side_y, side_one, side_least;  ///< E over the block; inside: E >= least
    EightFloat side_doubt;
    EightInt flat;                   ///< equal w at all corners: affine
    PlaneEight one, u_over, v_over;  ///< 1/w, u/w, v/w over the box [u, v in repeats]
    Eight u_far, v_far;              ///< bound of what double has lost of u and v [2^-32 repeats]
};

struct Canvas {
    RasterTarget target;
    RasterTexture texture;
    const RasterJob* job;
    RasterCounters* counters;
    int u_shift, v_shift, v_up;  ///< of a 2^-32 fraction to its texel, and of a texel row to its first texel
};

/// Whether the coordinate is 0 or from 2^-6 to 2^21.
HWY_INLINE hn::Mask<Real> is_fine(V c) {
    const Real d;
    const V size = hn::Abs(c);
    return hn::Or(hn::Eq(c, hn::Zero(d)), hn::And(hn::Ge(size, hn::Set(d, 0x1p-6)), hn::Lt(size, hn::Set(d, 0x1p21))));
}
/// Whether it is a multiple of 2^-8 below 2^13.
HWY_INLINE hn::Mask<Real> is_coarse(V c) {
    const Real d;
    const V scaled = hn::Mul(c, hn::Set(d, 256.0));
    return hn::And(hn::Eq(hn::Round(scaled), scaled), hn::Lt(hn::Abs(c), hn::Set(d, 8192.0)));
}

HWY_INLINE void order(V& xa, V& ya, V& xb, V& yb) {
    const auto wrong = hn::Gt(ya, yb);
    const V x = xa, y = ya;
    xa = hn::IfThenElse(wrong, xb, xa), ya = hn::IfThenElse(wrong, yb, ya);
    xb = hn::IfThenElse(wrong, x, xb), yb = hn::IfThenElse(wrong, y, yb);
}

HWY_INLINE V first_centre(V c, double limit) {
    const Real d;
    return hn::Min(hn::Max(hn::Ceil(hn::Sub(c, hn::Set(d, .5))), hn::Zero(d)), hn::Set(d, limit));
}

HWY_INLINE void store_int(V value, EightInt& to, int lane) {
    hn::Store(hn::DemoteTo(Index{}, value), Index{}, to.at + lane);
}

/// The low 32 bits of the whole part of |value| < 2^51.
HWY_INLINE void store_fraction(V value, EightInt& to, int lane) {
    const Real d;
    const hn::Repartition<uint64_t, Real> bits;
    const V shifted = hn::Add(value, hn::Set(d, 0x1.8p52));
    const auto low = hn::TruncateTo(hn::Rebind<uint32_t, Real>{}, hn::BitCast(bits, shifted));
    hn::Store(hn::BitCast(Index{}, low), Index{}, to.at + lane);
}

/// One plane's gradient and start.
struct PlaneOut {
    Eight &start, &x, &y, &doubt;
    EightInt &step, &down;
};
HWY_INLINE void plane(V a0, V a1, V a2, V bx, V by, V cx, V cy, V area, V dx, V dy, V most_x, V most_y, double unit,
                      V steps, PlaneOut out, int lane) {
    const Real d;
    const V b = hn::Sub(a1, a0), c = hn::Sub(a2, a0), scale = hn::Div(hn::Set(d, unit), area);
    const V x = hn::Mul(difference_of_products(b, cy, c, by), scale);
    const V y = hn::Mul(difference_of_products(c, bx, b, cx), scale);
    const V start = hn::MulAdd(y, dy, hn::MulAdd(x, dx, hn::Mul(a0, hn::Set(d, unit))));
    // The gradients are within 5 ulp, the start within 2 more of each term; a sample adds what its steps round off.
    const V reach =
        hn::MulAdd(hn::Abs(x), most_x, hn::MulAdd(hn::Abs(y), most_y, hn::Mul(hn::Abs(a0), hn::Set(d, unit))));
    const V doubt = hn::Add(hn::MulAdd(reach, hn::Set(d, 16 * kUlp), hn::Mul(steps, hn::Set(d, .5))), hn::Set(d, 4.0));
    // Differences that double rounds, or values too far out for a 32-bit fraction, are for the slow path.
    const auto exact = hn::And(hn::And(hn::Eq(hn::Sub(a1, b), a0), hn::Eq(hn::Add(b, a0), a1)),
                               hn::And(hn::Eq(hn::Sub(a2, c), a0), hn::Eq(hn::Add(c, a0), a2)));
    const auto near = hn::Lt(reach, hn::Set(d, 0x1p50));
    hn::Store(start, d, out.start.at + lane);
    store_fraction(x, out.step, lane);
    store_fraction(y, out.down, lane);
    hn::Store(x, d, out.x.at + lane);
    hn::Store(y, d, out.y.at + lane);
    hn::Store(hn::IfThenElse(hn::And(exact, near), doubt, hn::Set(d, 0x1p40)), d, out.doubt.at + lane);
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

/// The triangle's shape and box, as planes need it.
struct Shape {
    V bx, by, cx, cy, area, dx, dy, most_x, most_y;
};
/// A plane through values that are known but for `unsure` of the largest; returns the bound of its error over the box.
HWY_INLINE V over_plane(V a0, V a1, V a2, const Shape& s, PlaneEight& out, int lane) {
    const Real d;
    const V b = hn::Sub(a1, a0), c = hn::Sub(a2, a0), scale = hn::Div(hn::Set(d, 1.0), s.area);
    const V x = hn::Mul(difference_of_products(b, s.cy, c, s.by), scale),
            y = hn::Mul(difference_of_products(c, s.bx, b, s.cx), scale);
    hn::Store(hn::MulAdd(y, s.dy, hn::MulAdd(x, s.dx, a0)), d, out.at.at + lane);
    hn::Store(x, d, out.x.at + lane), hn::Store(y, d, out.y.at + lane);
    // The values come with 3 u of the largest, their differences with 8 of it; over the area that grows as the sides
    // do.
    const V largest = hn::Max(hn::Max(hn::Abs(a0), hn::Abs(a1)), hn::Abs(a2));
    const V lever = hn::MulAdd(hn::Add(hn::Abs(s.by), hn::Abs(s.cy)), s.most_x,
                               hn::Mul(hn::Add(hn::Abs(s.bx), hn::Abs(s.cx)), s.most_y));
    const V grown = hn::Mul(hn::Mul(largest, lever), hn::Abs(scale));
    const V reach = hn::MulAdd(hn::Abs(x), s.most_x, hn::MulAdd(hn::Abs(y), s.most_y, largest));
    return hn::Mul(hn::Add(grown, reach), hn::Set(d, 10 * kUlp));
}

/// Sets up the triangles whose indices stand in `batch`; those beyond `count` repeat one of them.
HWY_INLINE void set_up(Batch& batch, const Canvas& canvas) {
    const Real d;
    const auto* const base = reinterpret_cast<const float*>(canvas.job->vertices.data());
    for (int lane = 0; lane < kBatch; lane += kReals) {
        const auto index = hn::Mul(hn::Load(Index{}, batch.index.at + lane), hn::Set(Index{}, 18));
        V x0 = field(base, index, 0), y0 = field(base, index, 1);
        V x1 = field(base, index, 6), y1 = field(base, index, 7);
        V x2 = field(base, index, 12), y2 = field(base, index, 13);
        const V bx = hn::Sub(x1, x0), by = hn::Sub(y1, y0), cx = hn::Sub(x2, x0), cy = hn::Sub(y2, y0);
        const V area = difference_of_products(bx, cy, cx, by);
        const auto coarse =
            hn::And(hn::And(hn::And(is_coarse(x0), is_coarse(y0)), hn::And(is_coarse(x1), is_coarse(y1))),
                    hn::And(is_coarse(x2), is_coarse(y2)));
        const V low_x = hn::Min(hn::Min(x0, x1), x2), high_x = hn::Max(hn::Max(x0, x1), x2);
        const V low_y = hn::Min(hn::Min(y0, y1), y2), high_y = hn::Max(hn::Max(y0, y1), y2);
        const V c0 = first_centre(low_x, canvas.target.width), c1 = first_centre(high_x, canvas.target.width);
        const V r0 = first_centre(low_y, canvas.target.height), r1 = first_centre(high_y, canvas.target.height);
        const V widest = hn::Max(hn::Abs(low_x), hn::Abs(high_x));
        hn::Store(hn::IfThenZeroElse(coarse, hn::MulAdd(widest, hn::Set(d, 16 * kUlp),
                                                        hn::Set(d, 16 * kUlp * (canvas.target.width + 2)))),
                  d, batch.cross_doubt.at + lane);
        store_int(c0, batch.column0, lane), store_int(c1, batch.column1, lane);
        store_int(r0, batch.row0, lane), store_int(r1, batch.row1, lane);

        const V half = hn::Set(d, .5), dx = hn::Sub(hn::Add(c0, half), x0), dy = hn::Sub(hn::Add(r0, half), y0);
        const V width = hn::Sub(c1, c0);
        const V most_x = hn::Max(hn::Abs(dx), hn::Abs(hn::Add(dx, width)));
        const V most_y = hn::Max(hn::Abs(dy), hn::Abs(hn::Add(dy, hn::Sub(r1, r0))));
        plane(field(base, index, 4), field(base, index, 10), field(base, index, 16), bx, by, cx, cy, area, dx, dy,
              most_x, most_y, 0x1p32 * canvas.job->u_texels / canvas.texture.width, width,
              {batch.u, batch.u_x, batch.u_y, batch.u_doubt, batch.u_step, batch.u_down}, lane);
        plane(field(base, index, 5), field(base, index, 11), field(base, index, 17), bx, by, cx, cy, area, dx, dy,
              most_x, most_y, 0x1p32 * canvas.job->v_texels / canvas.texture.height, width,
              {batch.v, batch.v_x, batch.v_y, batch.v_doubt, batch.v_step, batch.v_down}, lane);

        const auto tiny = hn::And(
            hn::And(hn::Le(hn::Sub(c1, c0), hn::Set(d, 4.0)), hn::Le(hn::Sub(r1, r0), hn::Set(d, 4.0))),
            hn::And(hn::Lt(hn::Sub(high_x, low_x), hn::Set(d, 8.0)), hn::Lt(hn::Sub(high_y, low_y), hn::Set(d, 8.0))));
        store_int(hn::IfThenElseZero(tiny, hn::Set(d, 1.0)), batch.tiny, lane);
        if (!hn::AllFalse(d, tiny)) {
            const V sign = hn::IfThenElse(hn::Lt(area, hn::Zero(d)), hn::Set(d, -1.0), hn::Set(d, 1.0));
            const V sx = hn::Add(c0, half), sy = hn::Add(r0, half);
            set_side(x1, y1, x2, y2, sx, sy, sign, coarse, batch, 0, lane);
            set_side(x2, y2, x0, y0, sx, sy, sign, coarse, batch, 1, lane);
            set_side(x0, y0, x1, y1, sx, sy, sign, coarse, batch, 2, lane);
            hn::Store(hn::DemoteTo(Narrow{}, hn::IfThenZeroElse(coarse, hn::Set(d, 0x1p-15))), Narrow{},
                      batch.side_doubt.at + lane);
        }
        if (canvas.job->perspective) {
            const V w0 = field(base, index, 3), w1 = field(base, index, 9), w2 = field(base, index, 15);
            const auto flat = hn::And(hn::Eq(w0, w1), hn::Eq(w0, w2));
            store_int(hn::IfThenElseZero(flat, hn::Set(d, 1.0)), batch.flat, lane);
            const V one = hn::Set(d, 1.0), i0 = hn::Div(one, w0), i1 = hn::Div(one, w1), i2 = hn::Div(one, w2);
            const Shape shape{bx, by, cx, cy, area, dx, dy, most_x, most_y};
            const V one_error = over_plane(i0, i1, i2, shape, batch.one, lane), least = hn::Min(hn::Min(i0, i1), i2);
            const auto coordinate = [&](int offset, double repeats, PlaneEight& out, Eight& far) HWY_ATTR {
                const Real r;
                const V k = hn::Set(r, repeats);
                const V a0 = hn::Mul(field(base, index, offset), k), a1 = hn::Mul(field(base, index, offset + 6), k),
                        a2 = hn::Mul(field(base, index, offset + 12), k);
                const V error = over_plane(hn::Mul(a0, i0), hn::Mul(a1, i1), hn::Mul(a2, i2), shape, out, lane);
                const V largest = hn::Max(hn::Max(hn::Abs(a0), hn::Abs(a1)), hn::Abs(a2));
                // (N + eN) / (D + eD) - N / D, with |N / D| no more than the largest u and D no less than the least
                // 1/w; and a few roundings of quotients.
                const V lost = hn::Div(hn::MulAdd(largest, one_error, error), hn::Sub(least, one_error));
                hn::Store(hn::Mul(hn::MulAdd(largest, hn::Set(r, 16 * kUlp), hn::Abs(lost)), hn::Set(r, 0x1p33)), r,
                          far.at + lane);
            };
            coordinate(4, static_cast<double>(canvas.job->u_texels) / canvas.texture.width, batch.u_over, batch.u_far);
            coordinate(5, static_cast<double>(canvas.job->v_texels) / canvas.texture.height, batch.v_over, batch.v_far);
        }
        order(x0, y0, x1, y1), order(x1, y1, x2, y2), order(x0, y0, x1, y1);
        const V side = difference_of_products(hn::Sub(x1, x0), hn::Sub(y2, y0), hn::Sub(x2, x0), hn::Sub(y1, y0));
        store_int(first_centre(y1, canvas.target.height), batch.row_mid, lane);
        store_int(hn::Min(hn::Add(hn::Div(hn::Abs(area), hn::Sub(y2, y0)), hn::Set(d, 1.25)), hn::Set(d, 32768.0)),
                  batch.widest, lane);
        store_int(hn::IfThenElse(hn::Gt(side, hn::Zero(d)), hn::Set(d, 1.0), hn::Zero(d)), batch.long_left, lane);
        hn::Store(x0, d, batch.long_x.at + lane), hn::Store(y0, d, batch.long_y.at + lane);
        hn::Store(hn::Div(hn::Sub(x2, x0), hn::Sub(y2, y0)), d, batch.long_slope.at + lane);
        hn::Store(hn::Div(hn::Sub(x1, x0), hn::Sub(y1, y0)), d, batch.top_slope.at + lane);
        hn::Store(x1, d, batch.low_x.at + lane), hn::Store(y1, d, batch.low_y.at + lane);
        hn::Store(hn::Div(hn::Sub(x2, x1), hn::Sub(y2, y1)), d, batch.low_slope.at + lane);
    }
}

/// Eight rows of one triangle.
struct Rows {
    EightInt x0, x1, u, v;
};

struct Columns {
    double low, high, doubt, bias;
};
HWY_INLINE V crossing(V x, const Columns& c) {
    const Real d;
    // A quarter inside the next centre: what lies beyond the box is never in doubt.
    return hn::Min(hn::Max(hn::Sub(x, hn::Set(d, .5 + c.bias)), hn::Set(d, c.low - .25)), hn::Set(d, c.high - .25));
}

HWY_INLINE const Vertex* corners_of(const Canvas& canvas, int index) {
    return canvas.job->vertices.data() + std::ptrdiff_t{index} * 3;
}

/// The rows whose crossings lie in doubt, again.
HWY_NOINLINE void cross_again(const Batch& b, int t, int row, int count, int low_column, int high_column,
                              const Canvas& canvas, Rows& rows) {
    const Vertex* corner = corners_of(canvas, b.index.at[t]);
    std::array<const Vertex*, 3> p{corner, corner + 1, corner + 2};
    std::stable_sort(p.begin(), p.end(), [](const Vertex* a, const Vertex* c) { return a->y < c->y; });
    for (int n = 0; n < count; ++n) {
        const bool top = row + n < b.row_mid.at[t];
        const int far = first_pixel(*p[0], *p[2], row + n),
                  near = top ? first_pixel(*p[0], *p[1], row + n) : first_pixel(*p[1], *p[2], row + n);
        const auto inside = [&](int x) { return std::clamp(x, low_column, high_column); };
        rows.x0.at[n] = inside(b.long_left.at[t] != 0 ? far : near);
        rows.x1.at[n] = inside(b.long_left.at[t] != 0 ? near : far);
        ++canvas.counters->crossings;
    }
}

/// Where eight rows from `row` on begin and end, and u and v at their beginnings.
HWY_INLINE void cross(const Batch& b, int t, int row, int count, int low_column, int high_column, const Canvas& canvas,
                      Rows& rows) {
    const Real d;
    const double doubt = b.cross_doubt.at[t];
    const Columns columns{static_cast<double>(low_column), static_cast<double>(high_column), doubt,
                          doubt == 0 ? 0x1p-31 : 0};
    bool again = false;
    for (int lane = 0; lane < kBatch; lane += kReals) {
        const V n = hn::Iota(d, row + lane), y = hn::Add(n, hn::Set(d, .5));
        const V far = hn::MulAdd(hn::Sub(y, hn::Set(d, b.long_y.at[t])), hn::Set(d, b.long_slope.at[t]),
                                 hn::Set(d, b.long_x.at[t]));
        const V top = hn::MulAdd(hn::Sub(y, hn::Set(d, b.long_y.at[t])), hn::Set(d, b.top_slope.at[t]),
                                 hn::Set(d, b.long_x.at[t]));
        const V low =
            hn::MulAdd(hn::Sub(y, hn::Set(d, b.low_y.at[t])), hn::Set(d, b.low_slope.at[t]), hn::Set(d, b.low_x.at[t]));
        const V near = hn::IfThenElse(hn::Lt(n, hn::Set(d, b.row_mid.at[t])), top, low);
        const bool left = b.long_left.at[t] != 0;
        const V from = crossing(left ? far : near, columns), to = crossing(left ? near : far, columns);
        if (doubt != 0) {
            const auto close = [&](V x) HWY_ATTR {
                return hn::Lt(hn::Abs(hn::Sub(x, hn::Round(x))), hn::Set(Real{}, doubt));
            };
            again =
                again || !hn::AllFalse(d, hn::And(hn::Or(close(from), close(to)), hn::Lt(n, hn::Set(d, row + count))));
        }
        const V first = hn::Ceil(from);
        store_int(first, rows.x0, lane), store_int(hn::Ceil(to), rows.x1, lane);
        const V down = hn::Sub(n, hn::Set(d, b.row0.at[t])), right = hn::Sub(first, hn::Set(d, b.column0.at[t]));
        const auto start = [&](const Eight& a, const Eight& x, const Eight& by_row, const Eight& unsure) HWY_ATTR {
            const Real r;
            return hn::MulAdd(right, hn::Set(r, x.at[t]),
                              hn::MulAdd(down, hn::Set(r, by_row.at[t]), hn::Set(r, a.at[t] + unsure.at[t])));
        };
        store_fraction(start(b.u, b.u_x, b.u_y, b.u_doubt), rows.u, lane);
        store_fraction(start(b.v, b.v_x, b.v_y, b.v_doubt), rows.v, lane);
    }
    if (again) cross_again(b, t, row, count, low_column, high_column, canvas, rows);
}

HWY_NOINLINE void texels_again(const Batch& b, int t, int row, int count, const Canvas& canvas, const Rows& rows) {
    TexelDecider decider(std::span<const Vertex, 3>(corners_of(canvas, b.index.at[t]), 3), *canvas.job, canvas.texture,
                         *canvas.counters);
    const auto u_x = static_cast<uint32_t>(std::llrint(b.u_x.at[t])),
               v_x = static_cast<uint32_t>(std::llrint(b.v_x.at[t]));
    const auto u_least = static_cast<uint32_t>(2 * b.u_doubt.at[t]) + 1,
               v_least = static_cast<uint32_t>(2 * b.v_doubt.at[t]) + 1;
    for (int n = 0; n < count; ++n) {
        auto u = static_cast<uint32_t>(rows.u.at[n]), v = static_cast<uint32_t>(rows.v.at[n]);
        uint32_t* const out = canvas.target.pixels + (row + n) * canvas.target.pitch;
        for (int x = rows.x0.at[n]; x < rows.x1.at[n]; ++x, u += u_x, v += v_x) {
            const bool sure = (u << (32 - canvas.u_shift)) >= u_least << (32 - canvas.u_shift) &&
                              (v << (32 - canvas.v_shift)) >= v_least << (32 - canvas.v_shift);
            if (!sure) out[x] = canvas.texture.texels[decider.at(x, row + n)];
        }
    }
}

/// The texels of those lanes that `in` has; the others hold anything.
template <class Tag>
HWY_INLINE hn::Vec<Tag> gather_some(Tag p, hn::Mask<Tag> in, const uint32_t* texels, hn::Vec<Tag> place) {
#if HWY_TARGET <= HWY_AVX3
    constexpr size_t kLanes = hn::MaxLanes(p);
    if constexpr (kLanes == 16)
        return hn::Vec<Tag>{_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), in.raw, place.raw, texels, 4)};
    else if constexpr (kLanes == 8)
        return hn::Vec<Tag>{_mm256_mmask_i32gather_epi32(_mm256_setzero_si256(), in.raw, place.raw, texels, 4)};
    else
        return hn::Vec<Tag>{_mm_mmask_i32gather_epi32(_mm_setzero_si128(), in.raw, place.raw, texels, 4)};
#else
    static_cast<void>(in);
    return hn::GatherIndex(p, texels, hn::BitCast(hn::Rebind<int32_t, Tag>{}, place));
#endif
}

/// The rows of one triangle, as many pixels at once as `Tag` has lanes.
template <class Tag>
HWY_INLINE void draw_rows(Tag p, const Batch& b, int t, const Canvas& canvas) {
    const hn::Rebind<int32_t, Tag> s;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    const auto u_x = hn::Set(p, static_cast<uint32_t>(b.u_step.at[t])),
               v_x = hn::Set(p, static_cast<uint32_t>(b.v_step.at[t]));
    const auto lanes = hn::Iota(p, 0);
    const auto u_lanes = hn::Mul(u_x, lanes), v_lanes = hn::Mul(v_x, lanes);
    const auto u_step = hn::Mul(u_x, hn::Set(p, kLanes)), v_step = hn::Mul(v_x, hn::Set(p, kLanes));
    const int u_up = 32 - canvas.u_shift, v_up = 32 - canvas.v_shift;
    const auto u_least = hn::Set(p, (static_cast<uint32_t>(2 * b.u_doubt.at[t]) + 1) << u_up),
               v_least = hn::Set(p, (static_cast<uint32_t>(2 * b.v_doubt.at[t]) + 1) << v_up);
    const auto mask_rows = hn::Set(p, static_cast<uint32_t>((canvas.texture.height - 1) * canvas.texture.width));
    const auto all = hn::Set(p, ~0U);
    const auto* const texels = canvas.texture.texels;
    const auto place_of = [&](auto u, auto v) HWY_ATTR {
        return hn::Or(hn::And(hn::ShiftRightSame(v, canvas.v_up), mask_rows), hn::ShiftRightSame(u, canvas.u_shift));
    };
    const auto fetch = [&](auto u, auto v) HWY_ATTR {
        return hn::GatherIndex(Tag{}, texels, hn::BitCast(hn::Rebind<int32_t, Tag>{}, place_of(u, v)));
    };
    uint64_t samples = 0;
    for (int row = b.row0.at[t]; row < b.row1.at[t]; row += kBatch) {
        Rows rows;
        const int count = std::min(kBatch, b.row1.at[t] - row);
        cross(b, t, row, count, b.column0.at[t], b.column1.at[t], canvas, rows);
        auto least_u = all, least_v = all;
        uint32_t* line = canvas.target.pixels + row * canvas.target.pitch;
        for (int n = 0; n < count; ++n, line += canvas.target.pitch) {
            const int x0 = rows.x0.at[n];
            int left = rows.x1.at[n] - x0;
            if (left <= 0) continue;
            samples += static_cast<uint64_t>(left);
            uint32_t* out = line + x0;
            auto u = hn::Add(hn::Set(p, static_cast<uint32_t>(rows.u.at[n])), u_lanes);
            auto v = hn::Add(hn::Set(p, static_cast<uint32_t>(rows.v.at[n])), v_lanes);
            for (; left >= kLanes; left -= kLanes, out += kLanes) {
                hn::StoreU(fetch(u, v), p, out);
                least_u = hn::Min(least_u, hn::ShiftLeftSame(u, u_up)),
                least_v = hn::Min(least_v, hn::ShiftLeftSame(v, v_up));
                u = hn::Add(u, u_step), v = hn::Add(v, v_step);
            }
            if (left > 0) {
                const auto in = hn::FirstN(p, static_cast<size_t>(left));
                hn::BlendedStore(fetch(u, v), in, p, out);
                least_u = hn::Min(least_u, hn::IfThenElse(in, hn::ShiftLeftSame(u, u_up), all));
                least_v = hn::Min(least_v, hn::IfThenElse(in, hn::ShiftLeftSame(v, v_up), all));
            }
        }
        if (!hn::AllFalse(p, hn::Or(hn::Lt(least_u, u_least), hn::Lt(least_v, v_least))))
            texels_again(b, t, row, count, canvas, rows);
    }
    canvas.counters->samples += samples;
    static_cast<void>(s);
}

/// A triangle within 4 x 4 samples. False: some sample lies too near to a side, nothing was drawn.
HWY_INLINE bool draw_tiny(const Batch& b, int t, const Canvas& canvas) {
    const hn::CappedTag<uint32_t, 16> p;
    const hn::CappedTag<float, 16> f;
    const hn::CappedTag<int32_t, 16> s;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p)), kParts = 16 / kLanes;
    const int column = b.column0.at[t], row = b.row0.at[t];
    const auto lx = hn::And(hn::Iota(p, 0), hn::Set(p, 3U));
    uint32_t inside = 0;
    const auto fx = hn::ConvertTo(f, hn::BitCast(s, lx));
    for (int part = 0; part < kParts; ++part) {
        const auto fy =
            hn::ConvertTo(f, hn::BitCast(s, hn::ShiftRight<2>(hn::Iota(p, static_cast<uint32_t>(part * kLanes)))));
        const auto e = [&](size_t n) HWY_ATTR {
            return hn::MulAdd(fx, hn::Set(f, b.side_x[n].at[t]),
                              hn::MulAdd(fy, hn::Set(f, b.side_y[n].at[t]), hn::Set(f, b.side_one[n].at[t])));
        };
        const auto e0 = e(0), e1 = e(1), e2 = e(2);
        const auto nearest = hn::Min(hn::Min(hn::Abs(e0), hn::Abs(e1)), hn::Abs(e2));
        if (!hn::AllFalse(f, hn::Lt(nearest, hn::Set(f, b.side_doubt.at[t])))) return false;
        const auto in = hn::And(
            hn::And(hn::Ge(e0, hn::Set(f, b.side_least[0].at[t])), hn::Ge(e1, hn::Set(f, b.side_least[1].at[t]))),
            hn::Ge(e2, hn::Set(f, b.side_least[2].at[t])));
        uint8_t bits[8] = {};
        hn::StoreMaskBits(f, in, bits);
        uint32_t word = 0;
        std::memcpy(&word, bits, 4);
        inside |= word << (part * kLanes);
    }
    if (column + 4 > canvas.target.width) inside &= 0x1111U * ((1U << (canvas.target.width - column)) - 1);
    if (row + 4 > canvas.target.height) inside &= (1U << (4 * (canvas.target.height - row))) - 1;
    if (inside == 0) return true;
    canvas.counters->samples += static_cast<uint64_t>(std::popcount(inside));
    const int u_up = 32 - canvas.u_shift, v_up = 32 - canvas.v_shift;
    const auto u_start = static_cast<uint32_t>(static_cast<int64_t>(b.u.at[t] + b.u_doubt.at[t])),
               v_start = static_cast<uint32_t>(static_cast<int64_t>(b.v.at[t] + b.v_doubt.at[t]));
    const auto mask_rows = hn::Set(p, static_cast<uint32_t>((canvas.texture.height - 1) * canvas.texture.width));
    const auto u_least = hn::Set(p, (static_cast<uint32_t>(2 * b.u_doubt.at[t]) + 1) << u_up),
               v_least = hn::Set(p, (static_cast<uint32_t>(2 * b.v_doubt.at[t]) + 1) << v_up);
    alignas(64) uint32_t texels[16];
    uint32_t unsure = 0;
    for (int part = 0; part < kParts; ++part) {
        const auto ly = hn::ShiftRight<2>(hn::Iota(p, static_cast<uint32_t>(part * kLanes)));
        const auto u =
            hn::Add(hn::Set(p, u_start), hn::Add(hn::Mul(lx, hn::Set(p, static_cast<uint32_t>(b.u_step.at[t]))),
                                                 hn::Mul(ly, hn::Set(p, static_cast<uint32_t>(b.u_down.at[t])))));
        const auto v =
            hn::Add(hn::Set(p, v_start), hn::Add(hn::Mul(lx, hn::Set(p, static_cast<uint32_t>(b.v_step.at[t]))),
                                                 hn::Mul(ly, hn::Set(p, static_cast<uint32_t>(b.v_down.at[t])))));
        const auto place =
            hn::Or(hn::And(hn::ShiftRightSame(v, canvas.v_up), mask_rows), hn::ShiftRightSame(u, canvas.u_shift));
#if HWY_TARGET <= HWY_AVX3
        const auto got = hn::Vec<decltype(p)>{_mm512_mask_i32gather_epi32(
            _mm512_setzero_si512(), static_cast<__mmask16>(inside), place.raw, canvas.texture.texels, 4)};
#else
        const auto got = hn::GatherIndex(p, canvas.texture.texels, hn::BitCast(s, place));
#endif
        hn::Store(got, p, texels + part * kLanes);
        uint8_t bits[8] = {};
        hn::StoreMaskBits(
            p, hn::Or(hn::Lt(hn::ShiftLeftSame(u, u_up), u_least), hn::Lt(hn::ShiftLeftSame(v, v_up), v_least)), bits);
        uint32_t word = 0;
        std::memcpy(&word, bits, 4);
        unsure |= word << (part * kLanes);
    }
    uint32_t* out = canvas.target.pixels + row * canvas.target.pitch + column;
    const hn::CappedTag<uint32_t, 4> four;
    for (int n = 0; n < 4; ++n, out += canvas.target.pitch) {
        const uint8_t bits[8] = {static_cast<uint8_t>(inside >> (4 * n) & 15)};
        if (bits[0] != 0) hn::BlendedStore(hn::Load(four, texels + 4 * n), hn::LoadMaskBits(four, bits), four, out);
    }
    if ((unsure & inside) != 0) {
        TexelDecider decider(std::span<const Vertex, 3>(corners_of(canvas, b.index.at[t]), 3), *canvas.job,
                             canvas.texture, *canvas.counters);
        for (uint32_t m = unsure & inside; m != 0; m &= m - 1) {
            const int n = std::countr_zero(m), x = column + (n & 3), y = row + (n >> 2);
            canvas.target.pixels[y * canvas.target.pitch + x] = canvas.texture.texels[decider.at(x, y)];
        }
    }
    return true;
}

/// Eight rows of a triangle in perspective: how u and v go on from their first pixels.
struct Slopes {
    EightFloat u, v, one;  ///< numerators [2^-26 repeats] and denominator for one pixel
    double u_doubt = 0, v_doubt = 0;
};

constexpr int kBand = 64;  ///< so many pixels float32 carries u and v [px]

/// @return  the most that u may be wrong in a row; `first` is u at the rows' beginnings [2^-32 repeats].
HWY_INLINE double slopes_of(const Batch& b, int t, int row, int count, const Rows& rows, const PlaneEight& p,
                            double far, Eight& first, EightFloat& slope, EightFloat& one_slope) {
    const Real d;
    const Narrow f;
    V most = hn::Zero(d);
    for (int lane = 0; lane < kBatch; lane += kReals) {
        const V x0 = hn::PromoteTo(d, hn::Load(Index{}, rows.x0.at + lane)),
                x1 = hn::PromoteTo(d, hn::Load(Index{}, rows.x1.at + lane));
        const V right = hn::Sub(x0, hn::Set(d, b.column0.at[t])), down = hn::Iota(d, row + lane - b.row0.at[t]);
        const V steps = hn::Max(hn::Sub(hn::Sub(x1, x0), hn::Set(d, 1.0)), hn::Zero(d));
        const V over = hn::MulAdd(right, hn::Set(d, b.one.x.at[t]),
                                  hn::MulAdd(down, hn::Set(d, b.one.y.at[t]), hn::Set(d, b.one.at.at[t])));
        const V at =
            hn::MulAdd(right, hn::Set(d, p.x.at[t]), hn::MulAdd(down, hn::Set(d, p.y.at[t]), hn::Set(d, p.at.at[t])));
        const V one = hn::Div(hn::Set(d, 1.0), over), one_x = hn::Mul(hn::Set(d, b.one.x.at[t]), one);
        const V inverse = hn::Div(hn::Set(d, 1.0), hn::MulAdd(steps, one_x, hn::Set(d, 1.0))),
                kappa = hn::Max(inverse, hn::Set(d, 1.0));
        const V start = hn::Mul(at, one);
        const V numerator = hn::Mul(
            hn::Mul(hn::NegMulAdd(start, hn::Set(d, b.one.x.at[t]), hn::Set(d, p.x.at[t])), one), hn::Set(d, 0x1p26));
        // float32: two slopes, product, sum and quotient, each 2^-24 of it, the sum's more where the denominator
        // shrinks; then one rounding to whole 2^-26.
        const V relative = hn::Abs(hn::Mul(hn::Mul(steps, numerator), inverse));
        V doubt = hn::MulAdd(hn::Mul(relative, hn::Set(d, 0x1p-18)), hn::Add(hn::Set(d, 7.0), kappa),
                             hn::Set(d, 64 * .6 + far + 3));
        doubt = hn::IfThenElse(hn::Lt(relative, hn::Set(d, 0x1p30)), doubt, hn::Set(d, 0x1p40));
        const auto there = hn::And(hn::Lt(x0, x1), hn::Lt(hn::Iota(d, lane), hn::Set(d, count)));
        most = hn::Max(most, hn::IfThenElseZero(there, doubt));
        hn::Store(hn::Mul(start, hn::Set(d, 0x1p32)), d, first.at + lane);
        hn::Store(hn::DemoteTo(f, numerator), f, slope.at + lane);
        hn::Store(hn::DemoteTo(f, one_x), f, one_slope.at + lane);
    }
    return hn::GetLane(hn::MaxOfLanes(d, most));
}

HWY_INLINE void bias(const Eight& first, double doubt, EightInt& to) {
    const Real d;
    for (int lane = 0; lane < kBatch; lane += kReals)
        store_fraction(hn::Add(hn::Load(d, first.at + lane), hn::Set(d, doubt)), to, lane);
}

HWY_NOINLINE void all_texels_again(const Batch& b, int t, int row, int count, const Canvas& canvas, const Rows& rows) {
    TexelDecider decider(std::span<const Vertex, 3>(corners_of(canvas, b.index.at[t]), 3), *canvas.job, canvas.texture,
                         *canvas.counters);
    for (int n = 0; n < count; ++n)
        for (int x = rows.x0.at[n]; x < rows.x1.at[n]; ++x)
            canvas.target.pixels[(row + n) * canvas.target.pitch + x] = canvas.texture.texels[decider.at(x, row + n)];
}

template <class Tag>
HWY_INLINE void draw_perspective(Tag p, Batch& b, int t, const Canvas& canvas) {
    const hn::Rebind<int32_t, Tag> s;
    const hn::Rebind<float, Tag> f;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    const int u_up = 32 - canvas.u_shift, v_up = 32 - canvas.v_shift;
    const auto mask_rows = hn::Set(p, static_cast<uint32_t>((canvas.texture.height - 1) * canvas.texture.width));
    const auto all = hn::Set(p, ~0U);
    const auto* const texels = canvas.texture.texels;
    const int first_column = b.column0.at[t], last_column = b.column1.at[t];
    const auto lanes = hn::ConvertTo(f, hn::Iota(s, 0));
    uint64_t samples = 0;
    for (int band = first_column; band < last_column; band += kBand)
        for (int row = b.row0.at[t]; row < b.row1.at[t]; row += kBatch) {
            Rows rows;
            Slopes slope;
            Eight u_first, v_first;
            const int count = std::min(kBatch, b.row1.at[t] - row);
            cross(b, t, row, count, band, std::min(band + kBand, last_column), canvas, rows);
            slope.u_doubt = slopes_of(b, t, row, count, rows, b.u_over, b.u_far.at[t], u_first, slope.u, slope.one);
            slope.v_doubt = slopes_of(b, t, row, count, rows, b.v_over, b.v_far.at[t], v_first, slope.v, slope.one);
            bias(u_first, slope.u_doubt, rows.u), bias(v_first, slope.v_doubt, rows.v);
            auto least_u = all, least_v = all;
            const double most_u = std::ldexp(1.0, canvas.u_shift - 2), most_v = std::ldexp(1.0, canvas.v_shift - 2);
            if (!(slope.u_doubt < most_u && slope.v_doubt < most_v)) {
                all_texels_again(b, t, row, count, canvas, rows);
                for (int n = 0; n < count; ++n)
                    samples += static_cast<uint64_t>(std::max(0, rows.x1.at[n] - rows.x0.at[n]));
                continue;
            }
            const auto u_least = hn::Set(p, (static_cast<uint32_t>(2 * slope.u_doubt) + 1) << u_up),
                       v_least = hn::Set(p, (static_cast<uint32_t>(2 * slope.v_doubt) + 1) << v_up);
            uint32_t* line = canvas.target.pixels + row * canvas.target.pitch;
            for (int n = 0; n < count; ++n, line += canvas.target.pitch) {
                const int x0 = rows.x0.at[n];
                int left = rows.x1.at[n] - x0;
                if (left <= 0) continue;
                samples += static_cast<uint64_t>(left);
                uint32_t* out = line + x0;
                const auto u0 = hn::Set(p, static_cast<uint32_t>(rows.u.at[n])),
                           v0 = hn::Set(p, static_cast<uint32_t>(rows.v.at[n]));
                const auto u_n = hn::Set(f, slope.u.at[n]), v_n = hn::Set(f, slope.v.at[n]),
                           one_n = hn::Set(f, slope.one.at[n]);
                auto i = lanes;
                for (; left > 0; left -= kLanes, out += kLanes, i = hn::Add(i, hn::Set(f, kLanes))) {
                    const auto inverse = hn::Div(i, hn::MulAdd(i, one_n, hn::Set(f, 1.0F)));
                    const auto u = hn::Add(u0, hn::ShiftLeft<6>(hn::BitCast(p, hn::NearestInt(hn::Mul(u_n, inverse)))));
                    const auto v = hn::Add(v0, hn::ShiftLeft<6>(hn::BitCast(p, hn::NearestInt(hn::Mul(v_n, inverse)))));
                    const auto place = hn::Or(hn::And(hn::ShiftRightSame(v, canvas.v_up), mask_rows),
                                              hn::ShiftRightSame(u, canvas.u_shift));
                    const auto got = hn::GatherIndex(p, texels, hn::BitCast(s, place));
                    if (left >= kLanes) {
                        hn::StoreU(got, p, out);
                        least_u = hn::Min(least_u, hn::ShiftLeftSame(u, u_up)),
                        least_v = hn::Min(least_v, hn::ShiftLeftSame(v, v_up));
                    } else {
                        const auto in = hn::FirstN(p, static_cast<size_t>(left));
                        hn::BlendedStore(got, in, p, out);
                        least_u = hn::Min(least_u, hn::IfThenElse(in, hn::ShiftLeftSame(u, u_up), all));
                        least_v = hn::Min(least_v, hn::IfThenElse(in, hn::ShiftLeftSame(v, v_up), all));
                    }
                }
            }
            if (!hn::AllFalse(p, hn::Or(hn::Lt(least_u, u_least), hn::Lt(least_v, v_least)))) {
                TexelDecider decider(std::span<const Vertex, 3>(corners_of(canvas, b.index.at[t]), 3), *canvas.job,
                                     canvas.texture, *canvas.counters);
                for (int n = 0; n < count; ++n) {
                    const auto u0 = hn::Set(p, static_cast<uint32_t>(rows.u.at[n])),
                               v0 = hn::Set(p, static_cast<uint32_t>(rows.v.at[n]));
                    const auto u_n = hn::Set(f, slope.u.at[n]), v_n = hn::Set(f, slope.v.at[n]),
                               one_n = hn::Set(f, slope.one.at[n]);
                    auto i = lanes;
                    for (int x = rows.x0.at[n]; x < rows.x1.at[n]; x += kLanes, i = hn::Add(i, hn::Set(f, kLanes))) {
                        const auto inverse = hn::Div(i, hn::MulAdd(i, one_n, hn::Set(f, 1.0F)));
                        const auto u =
                            hn::Add(u0, hn::ShiftLeft<6>(hn::BitCast(p, hn::NearestInt(hn::Mul(u_n, inverse)))));
                        const auto v =
                            hn::Add(v0, hn::ShiftLeft<6>(hn::BitCast(p, hn::NearestInt(hn::Mul(v_n, inverse)))));
                        uint8_t bits[8] = {};
                        hn::StoreMaskBits(p,
                                          hn::Or(hn::Lt(hn::ShiftLeftSame(u, u_up), u_least),
                                                 hn::Lt(hn::ShiftLeftSame(v, v_up), v_least)),
                                          bits);
                        uint32_t m = 0;
                        std::memcpy(&m, bits, 4);
                        for (; m != 0; m &= m - 1)
                            if (const int at = x + std::countr_zero(m); at < rows.x1.at[n])
                                canvas.target.pixels[(row + n) * canvas.target.pitch + at] =
                                    texels[decider.at(at, row + n)];
                    }
                }
            }
        }
    canvas.counters->samples += samples;
}

HWY_INLINE void draw_triangle(Batch& b, int t, const Canvas& canvas) {
    if (canvas.job->perspective && b.flat.at[t] == 0) {
        if (b.widest.at[t] <= 24) return draw_perspective(hn::CappedTag<uint32_t, 8>{}, b, t, canvas);
        return draw_perspective(hn::ScalableTag<uint32_t>{}, b, t, canvas);
    }
    if (b.tiny.at[t] != 0 && draw_tiny(b, t, canvas)) return;
    const int widest = b.widest.at[t];
    if (widest <= 4) return draw_rows(hn::CappedTag<uint32_t, 4>{}, b, t, canvas);
    if (widest <= 24) return draw_rows(hn::CappedTag<uint32_t, 8>{}, b, t, canvas);
    draw_rows(hn::ScalableTag<uint32_t>{}, b, t, canvas);
}

HWY_NOINLINE void draw_slowly(int index, const Canvas& canvas) {
    ++canvas.counters->slow;
    const Vertex* const p = corners_of(canvas, index);
    const std::span<const Vertex, 3> corners(p, 3);
    const ExactTriangle triangle(corners, canvas.job->u_texels, canvas.job->v_texels);
    if (triangle.winding() == 0 || (canvas.job->cull_back && triangle.winding() < 0)) return;
    TexelDecider decider(corners, *canvas.job, canvas.texture, *canvas.counters);
    const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
    const auto end = static_cast<float>(canvas.target.height);
    const int first = static_cast<int>(std::clamp(std::floor(low) - 1, 0.0F, end)),
              last = static_cast<int>(std::clamp(std::ceil(high) + 1, 0.0F, end));
    for (int y = first; y < last; ++y) {
        const PixelRange row = triangle.row(y, 0, canvas.target.width);
        for (Integer x = row.x0; x < row.x1; ++x, ++canvas.counters->samples)
            canvas.target.pixels[y * canvas.target.pitch + x] =
                canvas.texture.texels[decider.at(static_cast<int>(x), y)];
    }
}

HWY_INLINE void flush(Batch& batch, int& count, const Canvas& canvas) {
    if (count == 0) return;
    for (int n = count; n < kBatch; ++n) batch.index.at[n] = batch.index.at[0];
    set_up(batch, canvas);
    for (int t = 0; t < count; ++t) {
        const double most = 0x1p31 / std::max(canvas.texture.width, canvas.texture.height);
        if ((canvas.job->perspective && batch.flat.at[t] == 0) ||
            (batch.u_doubt.at[t] < most / 2 && batch.v_doubt.at[t] < most / 2))
            draw_triangle(batch, t, canvas);
        else
            draw_slowly(batch.index.at[t], canvas);
    }
    count = 0;
}

HWY_ATTR void draw_all(const RasterTarget& target, const RasterTexture& texture, const RasterJob& job,
                       RasterCounters& counters) {
    const Real d;
    const int u_bits = std::countr_zero(static_cast<unsigned>(texture.width)),
              v_bits = std::countr_zero(static_cast<unsigned>(texture.height));
    const Canvas canvas{target, texture, &job, &counters, 32 - u_bits, 32 - v_bits, 32 - v_bits - u_bits};
    const auto* const base = reinterpret_cast<const float*>(job.vertices.data());
    const int all = static_cast<int>(job.vertices.size() / 3);
    Batch batch;
    int waiting = 0;
    for (int first = 0; first < all; first += kReals) {
        const auto number = hn::Min(hn::Iota(Index{}, first), hn::Set(Index{}, all - 1));
        const auto index = hn::Mul(number, hn::Set(Index{}, 18));
        for (int line = 0; line < kReals * 72; line += 64)
            hwy::Prefetch(reinterpret_cast<const char*>(base) + std::ptrdiff_t{first} * 72 + 2048 + line);
        const V x0 = field(base, index, 0), y0 = field(base, index, 1), x1 = field(base, index, 6),
                y1 = field(base, index, 7), x2 = field(base, index, 12), y2 = field(base, index, 13);
        const V c0 = first_centre(hn::Min(hn::Min(x0, x1), x2), target.width),
                c1 = first_centre(hn::Max(hn::Max(x0, x1), x2), target.width);
        const V r0 = first_centre(hn::Min(hn::Min(y0, y1), y2), target.height),
                r1 = first_centre(hn::Max(hn::Max(y0, y1), y2), target.height);
        auto keep = hn::And(hn::Lt(c0, c1), hn::Lt(r0, r1));
        const V area = difference_of_products(hn::Sub(x1, x0), hn::Sub(y2, y0), hn::Sub(x2, x0), hn::Sub(y1, y0));
        const auto coarse =
            hn::And(hn::And(hn::And(is_coarse(x0), is_coarse(y0)), hn::And(is_coarse(x1), is_coarse(y1))),
                    hn::And(is_coarse(x2), is_coarse(y2)));
        const auto fine =
            hn::Or(coarse, hn::And(hn::And(hn::And(is_fine(x0), is_fine(y0)), hn::And(is_fine(x1), is_fine(y1))),
                                   hn::And(is_fine(x2), is_fine(y2))));
        const auto faces = job.cull_back ? hn::Gt(area, hn::Zero(d)) : hn::Ne(area, hn::Zero(d));
        keep = hn::And(keep, hn::Or(faces, hn::Not(fine)));
        uint8_t kept[8] = {}, good[8] = {};
        hn::StoreMaskBits(d, keep, kept);
        hn::StoreMaskBits(d, fine, good);
        unsigned mask = kept[0];
        if (first + kReals > all) mask &= (1U << (all - first)) - 1;
        for (; mask != 0; mask &= mask - 1) {
            const int n = std::countr_zero(mask);
            if ((good[0] >> n & 1) == 0) {
                flush(batch, waiting, canvas);
                draw_slowly(first + n, canvas);
                continue;
            }
            batch.index.at[waiting++] = first + n;
            if (waiting == kBatch) flush(batch, waiting, canvas);
        }
    }
    flush(batch, waiting, canvas);
    counters.triangles += static_cast<uint64_t>(all);
}

const RegisterTarget kRegistered(HWY_TARGET, draw_all);

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
