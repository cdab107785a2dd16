// Where the rows of a triangle begin and end, some at once. A row covers [ceil(left - 1/2), ceil(right - 1/2)).
// On the coarse grid two crossings that differ from a sample do so by 2^-30 px or more, while double is off by less
// than 3e-11: 2^-31 taken away before rounding up decides every tie. Elsewhere what lies within the bound of a sample
// is decided again in 128 bits.
#if defined(TEXELSCOPE_CROSSINGS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_CROSSINGS_INL
#undef TEXELSCOPE_CROSSINGS_INL
#else
#define TEXELSCOPE_CROSSINGS_INL
#endif

#include <algorithm>
#include <array>

#include "core/fast/decide.h"
#include "core/fast/setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// Some rows of one triangle, at most kRows.
struct Rows {
    OfRows<int32_t> x0, x1;
    OfRows<int32_t> u, v;  ///< at x0, biased by their doubts [units]
};

/// The part of the target that rows are cut to.
struct Columns {
    int low, high;
};

HWY_INLINE V crossing(V x, const Columns& c, double bias) {
    const Real d;
    // A quarter inside the next centre: what lies beyond the box is never in doubt.
    return hn::Min(hn::Max(hn::Sub(x, hn::Set(d, .5 + bias)), hn::Set(d, c.low - .25)), hn::Set(d, c.high - .25));
}

/// The rows whose crossings lie in doubt, again.
template <int kStep>
HWY_NOINLINE void cross_again(const Batch& b, int t, int row, int count, const Columns& columns, const Canvas& canvas,
                              Rows& rows) {
    const Vertex* const corner = canvas.corners(b.index.at[t]);
    std::array<const Vertex*, 3> p{corner, corner + 1, corner + 2};
    std::stable_sort(p.begin(), p.end(), [](const Vertex* a, const Vertex* c) { return a->y < c->y; });
    const RasterTarget& target = canvas.target;
    for (int n = 0; n < count; ++n) {
        const bool top = row + n * kStep < b.row_mid.at[t];
        const int y = row + n * kStep + target.y0;
        const int far = first_pixel(*p[0], *p[2], y),
                  near = top ? first_pixel(*p[0], *p[1], y) : first_pixel(*p[1], *p[2], y);
        const auto inside = [&](int x) { return std::clamp(x - target.x0, columns.low, columns.high); };
        rows.x0.at[n] = inside(b.long_left.at[t] != 0 ? far : near);
        rows.x1.at[n] = inside(b.long_left.at[t] != 0 ? near : far);
        ++canvas.counters->crossings;
    }
}

/// u at some rows' first pixels, moved by `bias`.
HWY_INLINE void start(const CoordinateEight& u, int t, V right, V down, double bias, int32_t* to) {
    const Real d;
    const V at = hn::Set(d, u.plane.at.at[t] + bias);
    store_fraction(hn::MulAdd(right, hn::Set(d, u.plane.x.at[t]), hn::MulAdd(down, hn::Set(d, u.plane.y.at[t]), at)),
                   to);
}

/// `count` rows from `row` on, every kStep-th. Returns whether any sample is inside.
template <int kStep = 1>
HWY_INLINE bool cross(const Batch& b, int t, int row, int count, const Columns& columns, const Canvas& canvas,
                      Rows& rows) {
    const Real d;
    const double doubt = canvas.settings->certain ? b.cross_doubt.at[t] : 0, bias = doubt == 0 ? 0x1p-31 : 0;
    const auto left = hn::Ne(hn::Set(d, b.long_left.at[t]), hn::Zero(d));
    bool again = false, some = false;
    for (int lane = 0; lane < count; lane += kReals) {
        const V lanes = lanes_from(d, kStep == 1 ? row + lane : lane);
        const V n = kStep == 1 ? lanes : hn::MulAdd(lanes, hn::Set(d, kStep), hn::Set(d, row)),
                y = hn::Add(n, hn::Set(d, .5));
        const V below = hn::Sub(y, hn::Set(d, b.long_y.at[t]));
        const V far = hn::MulAdd(below, hn::Set(d, b.long_slope.at[t]), hn::Set(d, b.long_x.at[t]));
        const V top = hn::MulAdd(below, hn::Set(d, b.top_slope.at[t]), hn::Set(d, b.long_x.at[t]));
        const V low =
            hn::MulAdd(hn::Sub(y, hn::Set(d, b.low_y.at[t])), hn::Set(d, b.low_slope.at[t]), hn::Set(d, b.low_x.at[t]));
        const V near = hn::IfThenElse(hn::Lt(n, hn::Set(d, b.row_mid.at[t])), top, low);
        const V from = crossing(hn::IfThenElse(left, far, near), columns, bias),
                to = crossing(hn::IfThenElse(left, near, far), columns, bias);
        if (doubt != 0) {
            const auto close = [&](V x) HWY_ATTR {
                return hn::Lt(hn::Abs(hn::Sub(x, hn::Round(x))), hn::Set(Real{}, doubt));
            };
            const auto there = hn::Lt(n, hn::Set(d, row + count * kStep));
            again = again || !hn::AllFalse(d, hn::And(hn::Or(close(from), close(to)), there));
        }
        const V first = hn::Ceil(from), end = hn::Ceil(to);
        some = some || !hn::AllFalse(d, hn::Lt(first, end));
        store_int(first, rows.x0.at + lane), store_int(end, rows.x1.at + lane);
    }
    if (!again) return some;
    cross_again<kStep>(b, t, row, count, columns, canvas, rows);
    return true;
}

/// u and v where the rows begin, moved by their biases [units].
HWY_INLINE void start(const Batch& b, int t, int row, int count, double u_bias, double v_bias, Rows& rows) {
    const Real d;
    for (int lane = 0; lane < count; lane += kReals) {
        const V first = hn::PromoteTo(d, hn::Load(Index{}, rows.x0.at + lane));
        const V right = hn::Sub(first, hn::Set(d, b.column0.at[t])), down = lanes_from(d, row + lane - b.row0.at[t]);
        start(b.u, t, right, down, u_bias, rows.u.at + lane), start(b.v, t, right, down, v_bias, rows.v.at + lane);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
