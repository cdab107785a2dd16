// Perspective in float32, relative to the middle of a row (or of 256 pixels of it): there u_0 = N/D in double, and i
// pixels further u = u_0 + i n / (1 + i d) with n = (N_x - u_0 D_x)/D and d = D_x/D. The whole part is gone, float32 is
// enough.
#if defined(TEXELSCOPE_PERSPECTIVE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_PERSPECTIVE_INL
#undef TEXELSCOPE_PERSPECTIVE_INL
#else
#define TEXELSCOPE_PERSPECTIVE_INL
#endif

#include "core/fast/affine-inl.h"
#include "core/fast/halves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

constexpr int kSegment = 256;  ///< so many pixels float32 carries u and v [px]

/// Adding it rounds |value| < 2^22 to whole numbers, which then stand in float32's lowest bits.
constexpr float kWholeFloat = 0x1.8p23F;

/// How u or v goes on from the middles of some rows: i pixels further by i n / (1 + i d).
struct Slope {
    OfRows<float> n;        ///< [units]
    OfRows<double> middle;  ///< [units]
    int shift = 0;          ///< float32 counts in 2^shift units
    float scale = 1;        ///< 2^-shift
    double doubt = 0;       ///< FloatBound::doubt

    /// @param size_bits  log2 of the texture's size; halves alone ask
    template <Addressing kAddressing>
    HWY_INLINE void bound(double relative, double kappa, double far, [[maybe_unused]] int size_bits) {
        const One d;
        const auto most = hn::Set(d, relative), largest = hn::Set(d, kappa);
        if constexpr (kAddressing == Addressing::halves) {
            // Half a 2^-16 of a texel is lost of the middle, and half of one of what comes to it, which must fit int32.
            shift = kHalfBits - size_bits, scale = 1.0F / static_cast<float>(1 << shift);
            const double rounding = 1.1 * (1 << shift) + 3;
            const bool fits = relative < 0x1p30 * (1 << shift);
            doubt = fits ? hn::GetLane(lost_by_float(d, most, largest)) + rounding + far : kNoBound;
            return;
        }
        const FloatBound<One> bound(d, most, largest, hn::Set(d, far));
        shift = static_cast<int>(hn::GetLane(bound.shift)), scale = static_cast<float>(hn::GetLane(bound.scale));
        doubt = hn::GetLane(bound.doubt);
    }
};
struct Slopes {
    OfRows<float> d, before;  ///< before: pixels from a row's first to its middle
    Slope u, v;
    bool divides = true;  ///< d is not 0: else i / (1 + i d) is i
};

/// The slopes of rows [row, row + count); with kBound how far they take u and v, too.
template <bool kBound, Addressing kAddressing>
HWY_INLINE void slopes_of(const Batch& b, int t, int row, int count, const Canvas& canvas, const Rows& rows,
                          Slopes& slopes) {
    const Real d;
    const Narrow f;
    const V one = hn::Set(d, 1.0), column = hn::Set(d, b.column0.at[t]), d_x = hn::Set(d, b.one.x.at[t]);
    V kappas = one, u_most = hn::Zero(d), v_most = u_most;
    for (int lane = 0; lane < count; lane += kReals) {
        const V x0 = hn::PromoteTo(d, hn::Load(Index{}, rows.x0.at + lane)),
                x1 = hn::PromoteTo(d, hn::Load(Index{}, rows.x1.at + lane));
        if (hn::AllFalse(d, hn::Lt(x0, x1))) continue;
        const V length = hn::Sub(x1, x0), before = hn::Floor(hn::Mul(length, hn::Set(d, .5)));
        const V right = hn::Sub(hn::Add(x0, before), column), down = lanes_from(d, row + lane - b.row0.at[t]);
        const auto at = [&](const PlaneEight& p) HWY_ATTR { return plane_at(Real{}, p, t, right, down); };
        const V inverse = hn::Div(one, at(b.one)), slope = hn::Mul(d_x, inverse);
        const V u = hn::Mul(at(b.u_over), inverse), v = hn::Mul(at(b.v_over), inverse);
        const V u_n = hn::Mul(hn::NegMulAdd(u, d_x, hn::Set(d, b.u_over.x.at[t])), inverse),
                v_n = hn::Mul(hn::NegMulAdd(v, d_x, hn::Set(d, b.v_over.x.at[t])), inverse);
        if constexpr (kBound) {
            // 1 + i d is least at an end, and no pixel is farther from the middle than the first. Beyond the row it may
            // be less than 0.
            const auto there = hn::And(hn::Lt(x0, x1), hn::Lt(lanes_from(d, lane), hn::Set(d, count)));
            const V after = hn::Sub(hn::Sub(length, one), before);
            const V kappa = hn::Div(one, hn::Min(hn::NegMulAdd(before, slope, one), hn::MulAdd(after, slope, one)));
            const V reach = hn::Mul(before, kappa);
            // Where no pixel is, D may be 0, and NaN would hide what the other rows need.
            const auto far = [&](V n) HWY_ATTR { return hn::IfThenElseZero(there, hn::Mul(hn::Abs(n), reach)); };
            kappas = hn::Max(kappas, hn::IfThenElse(there, kappa, one));
            u_most = hn::Max(u_most, far(u_n)), v_most = hn::Max(v_most, far(v_n));
        }
        hn::Store(u, d, slopes.u.middle.at + lane), hn::Store(v, d, slopes.v.middle.at + lane);
        hn::Store(hn::DemoteTo(f, u_n), f, slopes.u.n.at + lane),
            hn::Store(hn::DemoteTo(f, v_n), f, slopes.v.n.at + lane);
        hn::Store(hn::DemoteTo(f, slope), f, slopes.d.at + lane);
        hn::Store(hn::DemoteTo(f, before), f, slopes.before.at + lane);
    }
    if constexpr (kBound) {
        const double kappa = hn::GetLane(hn::MaxOfLanes(d, kappas));
        slopes.u.bound<kAddressing>(hn::GetLane(hn::MaxOfLanes(d, u_most)), kappa, b.u_far.at[t], canvas.u_bits);
        slopes.v.bound<kAddressing>(hn::GetLane(hn::MaxOfLanes(d, v_most)), kappa, b.v_far.at[t], canvas.v_bits);
    }
}

/// Halves in 2^shift units.
template <Addressing kAddressing>
HWY_INLINE void bias(const Slope& slope, double by, int count, OfRows<int32_t>& to) {
    const Real d;
    for (int lane = 0; lane < count; lane += kReals) {
        V at = hn::Add(hn::Load(d, slope.middle.at + lane), hn::Set(d, by));
        if constexpr (kAddressing == Addressing::halves) at = hn::Mul(at, hn::Set(d, slope.scale));
        store_fraction(at, to.at + lane);
    }
}

/// One row: u and v, some pixels at once.
template <class Tag, Addressing kAddressing>
struct PerspectiveRow {
    using Float = hn::Rebind<float, Tag>;
    hn::Vec<Tag> u0, v0;
    hn::Vec<Float> u_n, v_n, d;
    int u_shift, v_shift;
    bool divides;

    HWY_INLINE PerspectiveRow(const Rows& rows, const Slopes& slopes, int n)
        : u_shift(slopes.u.shift), v_shift(slopes.v.shift), divides(slopes.divides) {
        const Float f;
        u0 = from(rows.u.at[n], u_shift), v0 = from(rows.v.at[n], v_shift);
        u_n = hn::Set(f, slopes.u.n.at[n] * slopes.u.scale), v_n = hn::Set(f, slopes.v.n.at[n] * slopes.v.scale);
        d = hn::Set(f, slopes.d.at[n]);
    }
    /// i pixels after the row's middle.
    HWY_INLINE void at(hn::Vec<Float> i, hn::Vec<Tag>& u, hn::Vec<Tag>& v) const {
        const Float f;
        const bool must = kAddressing == Addressing::halves || divides;
        const auto quotient = must ? hn::Div(i, hn::MulAdd(i, d, hn::Set(f, 1.0F))) : i;
        if constexpr (kAddressing == Addressing::halves) {
            u = hn::Add(u0, nearest(Tag{}, hn::Mul(u_n, quotient)));
            v = hn::Add(v0, nearest(Tag{}, hn::Mul(v_n, quotient)));
            return;
        }
        const auto whole = hn::Set(f, kWholeFloat);
        u = hn::Add(u0, hn::ShiftLeftSame(hn::BitCast(Tag{}, hn::MulAdd(u_n, quotient, whole)), u_shift));
        v = hn::Add(v0, hn::ShiftLeftSame(hn::BitCast(Tag{}, hn::MulAdd(v_n, quotient, whole)), v_shift));
    }

private:
    [[nodiscard]] static HWY_INLINE hn::Vec<Tag> from(int32_t middle, int shift) {
        if constexpr (kAddressing == Addressing::halves) return hn::Set(Tag{}, static_cast<uint32_t>(middle));
        return hn::Set(Tag{}, static_cast<uint32_t>(middle) - (std::bit_cast<uint32_t>(kWholeFloat) << shift));
    }
};

/// Some pixels of one row, the first of them `to_middle` before its middle. The last ones are a whole vector, too,
/// where there are so many: pixels that it shares with the vector before are drawn twice.
template <bool kCertain, Addressing kAddressing, class Tag>
HWY_INLINE void put_row(Tag p, const Texels<Tag, kAddressing>& texels, const PerspectiveRow<Tag, kAddressing>& along,
                        float to_middle, int count, uint32_t* out, const uint32_t* end,
                        Least<Tag, kAddressing>& least) {
    const hn::Rebind<float, Tag> f;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    auto u = hn::Zero(p), v = u;
    auto i = lanes_from(f, -to_middle);
    if (count < kLanes) {
        along.at(i, u, v);
        return put_some<kCertain>(p, texels, u, v, count, out, end, least);
    }
    uint32_t* const last = out + count - kLanes;
    for (; out < last; out += kLanes) {
        along.at(i, u, v);
        put_all<kCertain>(p, texels, u, v, out, least);
        i = hn::Add(i, hn::Set(f, kLanes));
    }
    along.at(lanes_from(f, static_cast<float>(count - kLanes) - to_middle), u, v);
    put_all<kCertain>(p, texels, u, v, last, least);
}

/// Every texel of some rows in double: float32 cannot tell any.
template <bool kDepth>
HWY_NOINLINE uint64_t rows_in_double(const Batch& b, int t, int row, int count, const Rows& rows, Again& again,
                                     const Canvas& canvas) {
    const hn::CappedTag<uint32_t, 4> p;
    uint64_t samples = 0;
    for (int n = 0; n < count; ++n)
        for (int x = rows.x0.at[n]; x < rows.x1.at[n]; ++x) {
            ++samples;
            uint32_t* const pixel = canvas.target.pixels + (row + n) * canvas.target.pitch + x;
            if constexpr (kDepth) {
                const bool late = !canvas.settings->skip(RasterSkip::early_z);
                const uint32_t texel = late ? again.texel(x, row + n) : 0;
                const DepthRow<decltype(p)> depth(b, t, row + n);
                if (!hn::AllFalse(p, pass_depth(depth, x, row + n, hn::FirstN(p, 1), again, canvas)))
                    *pixel = late ? texel : again.texel(x, row + n);
                else if (!late)
                    again.note_spared();
            } else {
                *pixel = again.texel(x, row + n);
            }
        }
    return samples;
}

/// The rows whose bits are set in `which`, some texels of which are unsure. Returns as mend() does.
template <Addressing kAddressing, class Tag>
HWY_NOINLINE bool perspective_again(Tag p, int row, uint32_t which, const Rows& rows, const Slopes& slopes,
                                    Again& again, bool only_double, const Canvas& canvas,
                                    const Texels<Tag, kAddressing>& texels) {
    const hn::Rebind<float, Tag> f;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    for (; which != 0; which &= which - 1) {
        const int n = std::countr_zero(which);
        const PerspectiveRow<Tag, kAddressing> line(rows, slopes, n);
        for (int x = rows.x0.at[n]; x < rows.x1.at[n]; x += kLanes) {
            auto u = hn::Zero(p), v = hn::Zero(p);
            line.at(lanes_from(f, static_cast<float>(x - rows.x0.at[n]) - slopes.before.at[n]), u, v);
            const auto in = hn::FirstN(p, static_cast<size_t>(rows.x1.at[n] - x));
            if (const auto asked = hn::And(in, texels.unsure(u, v)); !hn::AllFalse(p, asked))
                if (!mend(p, again, x, row + n, asked, only_double, canvas)) return false;
        }
    }
    return true;
}

/// Pixels of one row at once: as many as float32 carries u and v, in whole vectors [px].
HWY_INLINE int segment_of(int widest, int lanes) {
    const int pieces = (widest + kSegment - 1) / kSegment;
    return (widest / std::max(pieces, 1) / lanes + 1) * lanes;
}

/// Pixels [done, done + segment) of each row.
HWY_INLINE void segments_of(const Rows& whole, int count, int done, int segment, Rows& segments) {
    const hn::CappedTag<int32_t, kRows> s;
    for (int lane = 0; lane < count; lane += static_cast<int>(hn::MaxLanes(s))) {
        const auto end = hn::Load(s, whole.x1.at + lane);
        const auto first = hn::Min(hn::Add(hn::Load(s, whole.x0.at + lane), hn::Set(s, done)), end);
        hn::Store(first, s, segments.x0.at + lane);
        hn::Store(hn::Min(hn::Add(first, hn::Set(s, segment)), end), s, segments.x1.at + lane);
    }
}

/// The pieces of one triangle that are left. kNarrow: it is so narrow that its corners bound well enough how far u and
/// v go in a row; else each group of rows is asked. False: nothing is drawn, the corners do not.
template <bool kNarrow, Addressing kAddressing, bool kDepth, bool kCertain, class Tag>
HWY_NOINLINE bool draw_perspective(Tag p, const Batch& b, int t, const Canvas& canvas, Pieces& pieces) {
    const hn::Rebind<float, Tag> f;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    // In double, units are finer.
    constexpr Addressing kInUnits = kAddressing == Addressing::halves ? Addressing::powers : kAddressing;
    const auto lanes = hn::Iota(f, 0.0F);
    const std::ptrdiff_t pitch = canvas.target.pitch;
    const int widest = std::min(b.widest.at[t], b.column1.at[t] - b.column0.at[t]);
    const int segment = kNarrow ? widest : segment_of(widest, kLanes);
    uint64_t samples = 0;
    Again again(canvas, b, t, true);
    HalfGaps gaps;
    bool ties_known = false;
    Slopes slopes;
    slopes.divides = b.one.x.at[t] != 0 || !canvas.settings->skip(RasterSkip::level_w);
    slopes.u.shift = b.u_along.shift.at[t], slopes.u.scale = b.u_along.scale.at[t];
    slopes.v.shift = b.v_along.shift.at[t], slopes.v.scale = b.v_along.scale.at[t];
    CertainPair certain = narrow_certain_of(b, t);
    if (kNarrow && !certain.fits()) return false;
    if (!slopes.divides) ++canvas.counters->of(RasterSkip::level_w);
    Texels<Tag, kAddressing> texels(canvas, b, t, certain);
    for (Piece piece; pieces.next(b, t, piece);) {
        Rows whole, segments;
        Rows& rows = kNarrow ? whole : segments;
        const int row = piece.row, width = std::min(widest, piece.x1 - piece.x0);
        int count = piece.count;
        if (!cross(b, t, piece, canvas, whole)) continue;
        const uint64_t above = samples;
        bool finely = false, mended = kDepth;
        for (int done = 0; done < width; done += segment) {
            if constexpr (!kNarrow) segments_of(whole, count, done, segment, segments);
            const uint64_t before = samples;
            slopes_of<!kNarrow, kAddressing>(b, t, row, count, canvas, rows, slopes);
            if constexpr (!kNarrow) {
                certain = certain_of(canvas, b, t, slopes.u.doubt, slopes.v.doubt, gaps);
                texels = Texels<Tag, kAddressing>(canvas, b, t, certain);
                if (!certain.fits()) {
                    samples += rows_in_double<kDepth>(b, t, row, count, rows, again, canvas), mended = true;
                    continue;
                }
            }
            bias<kAddressing>(slopes.u, texels.u.bias, count, rows.u);
            bias<kAddressing>(slopes.v, texels.v.bias, count, rows.v);
            Least<Tag, kAddressing> least;
            uint32_t unsure = 0;
            [[maybe_unused]] auto u = hn::Zero(p), v = u;
            for (int n = 0, y = row; n < count; ++n, ++y) {
                int x = rows.x0.at[n], left = rows.x1.at[n] - x;
                if (left <= 0) continue;
                samples += static_cast<uint64_t>(left);
                const PerspectiveRow<Tag, kAddressing> along(rows, slopes, n);
                [[maybe_unused]] const DepthRow<Tag> depth(b, t, y);
                const float to_middle = slopes.before.at[n];
                if constexpr (kDepth) {
                    auto i = hn::Sub(lanes, hn::Set(f, to_middle));
                    for (; left > 0; left -= kLanes, x += kLanes, i = hn::Add(i, hn::Set(f, kLanes))) {
                        const auto in = hn::FirstN(p, static_cast<size_t>(left));
                        const auto shown = test_early(depth, x, y, in, again, canvas);
                        if (hn::AllFalse(p, shown)) continue;
                        along.at(i, u, v);
                        put_tested(p, texels, u, v, depth, x, y, shown, again, canvas);
                    }
                } else {
                    uint32_t* const line = canvas.target.pixels + y * pitch;
                    put_row<kCertain>(p, texels, along, to_middle, left, line + x, line + canvas.target.width, least);
                }
                if constexpr (!kNarrow && !kDepth && kCertain)
                    if (!least.is_sure(texels)) {
                        unsure |= 1U << n, least = {};
                        if (done == 0 && (unsure & unsure >> 1) != 0) count = n + 1;  // as in draw_rows
                    }
            }
            if (kDepth || !kCertain) continue;
            if (kNarrow && !least.is_sure(texels)) unsure = (1U << count) - 1;
            if (unsure == 0) continue;
            if (perspective_again(p, row, unsure, rows, slopes, again, !ties_known, canvas, texels)) {
                mended = true;
                continue;
            }
            gaps = again.half_gaps(), ties_known = true;
            if constexpr (kNarrow)
                certain = certain_of(canvas, b, t, certain.u.bias, certain.v.bias, gaps);
            else
                certain = certain_of(canvas, b, t, slopes.u.doubt, slopes.v.doubt, gaps);
            texels = Texels<Tag, kAddressing>(canvas, b, t, certain);
            finely = !certain.sure();
            if (finely) break;
            forget(canvas, row, count, rows);
            done -= segment, samples = before;
        }
        if (finely)
            forget(canvas, row, count, whole), count = 0, samples = above;
        else
            finely = mended && again.often(row + count - b.row0.at[t]);
        pieces.give_back(piece, count);
        if (finely && draw_finely<true, kInUnits, kDepth>(b, t, pieces, again, canvas, samples)) break;
    }
    canvas.counters->samples += samples;
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
