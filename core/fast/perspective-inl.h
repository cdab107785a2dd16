// Perspective in float32, relative to where a row (or 64 pixels of it) begins: there u_0 = N/D in double, and i pixels
// further u = u_0 + i n / (1 + i d) with n = (N_x - u_0 D_x)/D and d = D_x/D. The whole part is gone, float32 is
// enough.
#if defined(TEXELSCOPE_PERSPECTIVE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_PERSPECTIVE_INL
#undef TEXELSCOPE_PERSPECTIVE_INL
#else
#define TEXELSCOPE_PERSPECTIVE_INL
#endif

#include "core/fast/affine-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// Eight rows of a triangle in perspective: how u and v go on from their first pixels.
struct Slopes {
    EightFloat u, v, one;  ///< numerators [2^6 units] and denominator for one pixel
    double u_doubt = 0, v_doubt = 0;
};

constexpr int kBand = 64;  ///< so many pixels float32 carries u and v [px]

/// @return  the most that u may be wrong in a row; `first` is u at the rows' beginnings [units].
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
        const auto at = [&](const PlaneEight& q) HWY_ATTR {
            const Real r;
            return hn::MulAdd(right, hn::Set(r, q.x.at[t]),
                              hn::MulAdd(down, hn::Set(r, q.y.at[t]), hn::Set(r, q.at.at[t])));
        };
        const V unit = hn::Set(d, 1.0), one = hn::Div(unit, at(b.one)), one_x = hn::Mul(hn::Set(d, b.one.x.at[t]), one);
        const V inverse = hn::Div(unit, hn::MulAdd(steps, one_x, unit)), kappa = hn::Max(inverse, unit);
        const V start = hn::Mul(at(p), one);
        const V numerator = hn::Mul(
            hn::Mul(hn::NegMulAdd(start, hn::Set(d, b.one.x.at[t]), hn::Set(d, p.x.at[t])), one), hn::Set(d, 0x1p-6));
        // float32: two slopes, product, sum and quotient, each 2^-24 of it, the sum's more where the denominator
        // shrinks; then one rounding to whole 2^6 units.
        const V relative = hn::Abs(hn::Mul(hn::Mul(steps, numerator), inverse));
        V doubt = hn::MulAdd(hn::Mul(relative, hn::Set(d, 0x1p-18)), hn::Add(hn::Set(d, 7.0), kappa),
                             hn::Set(d, 64 * .6 + far + 3));
        doubt = hn::IfThenElse(hn::Lt(relative, hn::Set(d, 0x1p30)), doubt, hn::Set(d, 0x1p40));
        const auto there = hn::And(hn::Lt(x0, x1), hn::Lt(hn::Iota(d, lane), hn::Set(d, count)));
        most = hn::Max(most, hn::IfThenElseZero(there, doubt));
        hn::Store(start, d, first.at + lane);
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

/// One row: u and v, some pixels at once.
template <class Tag>
struct PerspectiveRow {
    using Float = hn::Rebind<float, Tag>;
    hn::Vec<Tag> u0, v0;
    hn::Vec<Float> u_n, v_n, one_n;

    HWY_INLINE PerspectiveRow(const Rows& rows, const Slopes& slope, int n) {
        const Tag p;
        const Float f;
        u0 = hn::Set(p, static_cast<uint32_t>(rows.u.at[n])), v0 = hn::Set(p, static_cast<uint32_t>(rows.v.at[n]));
        u_n = hn::Set(f, slope.u.at[n]), v_n = hn::Set(f, slope.v.at[n]), one_n = hn::Set(f, slope.one.at[n]);
    }
    /// i pixels after the row's first.
    HWY_INLINE void at(hn::Vec<Float> i, hn::Vec<Tag>& u, hn::Vec<Tag>& v) const {
        const Float f;
        const auto inverse = hn::Div(i, hn::MulAdd(i, one_n, hn::Set(f, 1.0F)));
        const auto units = [&](auto n) HWY_ATTR {
            return hn::ShiftLeft<6>(hn::BitCast(Tag{}, hn::NearestInt(hn::Mul(n, inverse))));
        };
        u = hn::Add(u0, units(u_n)), v = hn::Add(v0, units(v_n));
    }
};

/// Every texel of some rows in double: float32 cannot tell any.
template <bool kDepth>
HWY_NOINLINE void rows_in_double(const Batch& b, int t, int row, int count, const Rows& rows, Again& again,
                                 const Canvas& canvas) {
    const hn::CappedTag<uint32_t, 4> p;
    for (int n = 0; n < count; ++n)
        for (int x = rows.x0.at[n]; x < rows.x1.at[n]; ++x) {
            if constexpr (kDepth) {
                const DepthRow<decltype(p)> depth(b, t, row + n);
                float* const z = canvas.target.depth + (row + n) * canvas.target.pitch;
                if (hn::AllFalse(p, pass_depth(depth, x, row + n, hn::FirstN(p, 1), z, again))) continue;
            }
            canvas.target.pixels[(row + n) * canvas.target.pitch + x] = again.texel(x, row + n);
        }
}

template <Addressing kAddressing, class Tag>
HWY_NOINLINE bool perspective_again(Tag p, int row, int count, const Rows& rows, const Slopes& slope, Again& again,
                                    bool only_double, const Canvas& canvas, const Texels<Tag, kAddressing>& texels) {
    const hn::Rebind<float, Tag> f;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    for (int n = 0; n < count; ++n) {
        const PerspectiveRow<Tag> line(rows, slope, n);
        for (int x = rows.x0.at[n]; x < rows.x1.at[n]; x += kLanes) {
            auto u = hn::Zero(p), v = hn::Zero(p);
            line.at(hn::Iota(f, static_cast<float>(x - rows.x0.at[n])), u, v);
            const auto in = hn::FirstN(p, static_cast<size_t>(rows.x1.at[n] - x));
            if (!mend(p, again, x, row + n, hn::And(in, texels.unsure(u, v)), only_double, canvas)) return false;
        }
    }
    return true;
}

template <Addressing kAddressing, bool kDepth, bool kCertain, class Tag>
HWY_NOINLINE void draw_perspective(Tag p, const Batch& b, int t, const Canvas& canvas) {
    const hn::Rebind<float, Tag> f;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    const auto lanes = hn::Iota(f, 0.0F);
    const int last_column = b.column1.at[t];
    const std::ptrdiff_t pitch = canvas.target.pitch;
    uint64_t samples = 0;
    Again again(canvas, b, t, true);
    HalfGaps gaps;
    bool ties_known = false;
    for (int band = b.column0.at[t]; band < last_column; band += kBand)
        for (int row = b.row0.at[t]; row < b.row1.at[t]; row += kBatch) {
            Rows rows;
            Slopes slope;
            Eight u_first, v_first;
            const int count = std::min(kBatch, b.row1.at[t] - row);
            cross(b, t, row, count, {band, std::min(band + kBand, last_column)}, canvas, rows);
            slope.u_doubt = slopes_of(b, t, row, count, rows, b.u_over, b.u_far.at[t], u_first, slope.u, slope.one);
            slope.v_doubt = slopes_of(b, t, row, count, rows, b.v_over, b.v_far.at[t], v_first, slope.v, slope.one);
            const uint64_t before = samples;
            for (int n = 0; n < count; ++n)
                samples += static_cast<uint64_t>(std::max(0, rows.x1.at[n] - rows.x0.at[n]));
            const Texels<Tag, kAddressing> texels(canvas, b, t, slope.u_doubt, slope.v_doubt, gaps);
            if (!texels.fits()) {
                rows_in_double<kDepth>(b, t, row, count, rows, again, canvas);
                continue;
            }
            bias(u_first, texels.u.bias, rows.u), bias(v_first, texels.v.bias, rows.v);
            Least<Tag> least;
            auto u = hn::Zero(p), v = u;
            for (int n = 0, y = row; n < count; ++n, ++y) {
                int x = rows.x0.at[n], left = rows.x1.at[n] - x;
                if (left <= 0) continue;
                const PerspectiveRow<Tag> along(rows, slope, n);
                [[maybe_unused]] const DepthRow<Tag> depth(b, t, y);
                auto i = lanes;
                for (; left > 0; left -= kLanes, x += kLanes, i = hn::Add(i, hn::Set(f, kLanes))) {
                    if constexpr (kDepth) {
                        const auto in = hn::FirstN(p, static_cast<size_t>(left));
                        const auto nearer = pass_depth(depth, x, y, in, canvas.target.depth + y * pitch, again);
                        if (hn::AllFalse(p, nearer)) continue;
                        along.at(i, u, v);
                        put_nearer(p, texels, u, v, x, y, nearer, again, canvas);
                    } else {
                        along.at(i, u, v);
                        uint32_t* const out = canvas.target.pixels + y * pitch + x;
                        if (left >= kLanes)
                            put_all<kCertain>(p, texels, u, v, out, least);
                        else
                            put_some<kCertain>(p, texels, u, v, left, out, least);
                    }
                }
            }
            if (kDepth || !kCertain || least.is_sure(texels)) continue;
            if (!perspective_again(p, row, count, rows, slope, again, !ties_known, canvas, texels))
                gaps = again.half_gaps(), ties_known = true, row -= kBatch, samples = before;
        }
    canvas.counters->samples += samples;
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
