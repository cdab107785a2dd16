// Texels that int32 or float32 left unsure: one by one, or, where a triangle has them again and again (samples on
// borders of texels, or as near as float32 rounds a simple ratio's u and v at the corners), all from there on in
// vectors of double. Its bound is so small that half of the gap between a border and any sample not on it is nearly
// always more: then ties, too, cost no test (Certainty). They count as certain, as nothing is decided twice.
#if defined(TEXELSCOPE_FINE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_FINE_INL
#undef TEXELSCOPE_FINE_INL
#else
#define TEXELSCOPE_FINE_INL
#endif

#include <bit>

#include "core/fast/crossings-inl.h"
#include "core/fast/depth-inl.h"
#include "core/fast/pieces-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// The unsure texel of the target's pixel (x, y). False: double cannot tell it, and `only_double`.
HWY_INLINE bool mend_pixel(Again& again, int x, int y, bool only_double, const Canvas& canvas) {
    uint32_t& pixel = canvas.target.pixels[y * canvas.target.pitch + x];
    if (only_double) return again.texel_in_double(x, y, pixel);
    pixel = again.texel(x, y);
    return true;
}

/// The same for those of pixels [x, x + lanes) of a row that are unsure.
template <class Tag>
HWY_NOINLINE bool mend(Tag p, Again& again, int x, int y, hn::Mask<Tag> unsure, bool only_double,
                       const Canvas& canvas) {
    for (uint32_t m = bits_of(p, unsure); m != 0; m &= m - 1)
        if (!mend_pixel(again, x + std::countr_zero(m), y, only_double, canvas)) return false;
    return true;
}

/// The pixels of `in` whose texels are to be looked up: with early z those that pass the depth test, which is left
/// nearer; else all.
template <class Tag>
HWY_INLINE hn::Mask<Tag> test_early(const DepthRow<Tag>& depth, int x, int y, hn::Mask<Tag> in, Again& again,
                                    const Canvas& canvas) {
    if (!canvas.settings->skip(RasterSkip::early_z)) return in;
    const auto nearer = pass_depth(depth, x, y, in, again, canvas);
    if (hn::AllFalse(Tag{}, nearer)) again.note_spared();
    return nearer;
}

/// The depth test comes last.
template <Addressing kAddressing, class Tag>
HWY_NOINLINE void put_late(Tag p, const Texels<Tag, kAddressing>& texels, hn::Vec<Tag> u, hn::Vec<Tag> v,
                           const DepthRow<Tag>& depth, int x, int y, hn::Mask<Tag> in, Again& again,
                           const Canvas& canvas) {
    uint32_t* const line = canvas.target.pixels + y * std::ptrdiff_t{canvas.target.pitch};
    alignas(64) uint32_t found[hn::MaxLanes(p)];
    hn::Store(texels.fetch(u, v), p, found);
    for (uint32_t m = bits_of(p, hn::And(in, texels.unsure(u, v))); m != 0; m &= m - 1)
        found[std::countr_zero(m)] = again.texel(x + std::countr_zero(m), y);
    const auto nearer = pass_depth(depth, x, y, in, again, canvas);
    store_some(hn::Load(p, found), nearer, p, line + x, line + canvas.target.width);
}

/// Stores the texels of what test_early() has left at (x, y) and to its right, right ones at once: no later pass could
/// tell them apart.
template <Addressing kAddressing, class Tag>
HWY_INLINE void put_tested(Tag p, const Texels<Tag, kAddressing>& texels, hn::Vec<Tag> u, hn::Vec<Tag> v,
                           const DepthRow<Tag>& depth, int x, int y, hn::Mask<Tag> shown, Again& again,
                           const Canvas& canvas) {
    if (!canvas.settings->skip(RasterSkip::early_z))
        return put_late(p, texels, u, v, depth, x, y, shown, again, canvas);
    uint32_t* const line = canvas.target.pixels + y * std::ptrdiff_t{canvas.target.pitch};
    store_some(texels.fetch(u, v), shown, p, line + x, line + canvas.target.width);
    if (const auto unsure = hn::And(shown, texels.unsure(u, v)); !hn::AllFalse(p, unsure))
        mend(p, again, x, y, unsure, false, canvas);
}

/// Adding it rounds |value| < 2^51 to whole numbers, which then stand in double's lowest bits.
constexpr double kWholeDouble = 0x1.8p52;

constexpr double kFineCut = 0x1p-20;  ///< [units]

/// What makes texels certain in a FineRow. Double loses no more at a sample than it does where Again asks it, but for
/// what moving the value loses: three roundings of numbers that are larger by the bias and half a unit, below 2^32
/// units. kFineCut is more than that, twice the bound than the rest. Where a texel is no whole number of units, what
/// lies below a unit counts, too: it is cut off.
HWY_INLINE CertainPair fine_certain_of(const Batch& b, int t, const Again& again, const HalfGaps& gaps,
                                       const Canvas& canvas) {
    const auto cut = [&](int size) {
        return kFineCut +
               (canvas.addressing == Addressing::any_size && !std::has_single_bit(static_cast<unsigned>(size)) ? 1 : 0);
    };
    return certain_of(canvas, b, t, 2 * again.u_unsure() + cut(canvas.texture.width),
                      2 * again.v_unsure() + cut(canvas.texture.height), gaps);
}

/// u and v in double, some pixels at once. They are moved by their bias and rounded down, except that whole numbers may
/// lose a unit. That is as right: what the move puts on a border lies below it, since the bias is more than the error.
template <bool kPerspective, class Tag>
class FineRow {
#if HWY_TARGET == HWY_SCALAR
    using Half = hn::Rebind<double, Tag>;  // all of the one pixel
#else
    using Half = hn::Repartition<double, Tag>;  // every other pixel
#endif
    using Double = hn::Vec<Half>;

public:
    /// Pixels side by side.
    /// @param x  the first
    HWY_INLINE FineRow(const Batch& b, int t, int x, int y, const CertainPair& certain)
        : FineRow(b, t, hn::MulAdd(hn::Iota(Half{}, 0), hn::Set(Half{}, 2.0), hn::Set(Half{}, x - b.column0.at[t])),
                  hn::Set(Half{}, y - b.row0.at[t]), certain) {}
    /// Any in pairs side by side.
    /// @param right, down  every other one's place from the box' first
    HWY_INLINE FineRow(const Batch& b, int t, Double right, Double down, const CertainPair& certain) : right_(right) {
        const Half d;
        const auto along = [&](const PlaneEight& p, Double& at, Double& step) HWY_ATTR {
            at = plane_at(Half{}, p, t, hn::Zero(Half{}), down), step = hn::Set(Half{}, p.x.at[t]);
        };
        along(kPerspective ? b.u_over : b.u.plane, u_, u_x_), along(kPerspective ? b.v_over : b.v.plane, v_, v_x_);
        // Half a unit less, then rounded to the nearest one.
        u_bias_ = hn::Set(d, certain.u.bias - .5), v_bias_ = hn::Set(d, certain.v.bias - .5);
        if constexpr (kPerspective)
            along(b.one, one_, one_x_);
        else
            u_ = hn::Add(u_, u_bias_), v_ = hn::Add(v_, v_bias_);
    }

    /// Of the next pixels [units].
    HWY_INLINE void next(hn::Vec<Tag>& u, hn::Vec<Tag>& v) {
        const Half d;
        Double u_even, v_even;
        at(right_, u_even, v_even);
#if HWY_TARGET == HWY_SCALAR
        const auto low = [](Double a) HWY_ATTR {
            return hn::Set(Tag{}, static_cast<uint32_t>(std::bit_cast<uint64_t>(hn::GetLane(a))));
        };
        u = low(u_even), v = low(v_even);
#else
        Double u_odd, v_odd;
        at(hn::Add(right_, hn::Set(d, 1.0)), u_odd, v_odd);
        u = low_bits(u_odd, u_even), v = low_bits(v_odd, v_even);
#endif
        right_ = hn::Add(right_, hn::Set(d, static_cast<double>(hn::MaxLanes(Tag{}))));
    }

    /// Of the places that were given alone, in double's lowest bits [units].
    HWY_INLINE void given(Double& u, Double& v) const { at(right_, u, v); }

private:
    HWY_INLINE void at(Double right, Double& u, Double& v) const {
        const Half d;
        u = hn::MulAdd(right, u_x_, u_), v = hn::MulAdd(right, v_x_, v_);
        if constexpr (kPerspective) {
            const Double inverse = hn::Div(hn::Set(d, 1.0), hn::MulAdd(right, one_x_, one_));
            u = hn::MulAdd(u, inverse, u_bias_), v = hn::MulAdd(v, inverse, v_bias_);
        }
        u = hn::Add(u, hn::Set(d, kWholeDouble)), v = hn::Add(v, hn::Set(d, kWholeDouble));
    }
#if HWY_TARGET != HWY_SCALAR
    [[nodiscard]] static HWY_INLINE hn::Vec<Tag> low_bits(Double odd, Double even) {
        const hn::Repartition<uint64_t, Tag> bits;
        const Tag p;
        return hn::OddEven(hn::BitCast(p, hn::ShiftLeft<32>(hn::BitCast(bits, odd))), hn::BitCast(p, even));
    }
#endif

    Double right_;  ///< the next pixels from the box' left, every other one [px]
    Double u_, u_x_, v_, v_x_, one_, one_x_;
    Double u_bias_, v_bias_;
};

/// The pieces of a triangle that are left; counts their samples. False: nothing is drawn, double is too much in doubt.
template <bool kPerspective, Addressing kAddressing, bool kDepth>
HWY_NOINLINE bool draw_finely(const Batch& b, int t, Pieces& pieces, Again& again, const Canvas& canvas,
                              uint64_t& samples) {
    const CertainPair certain = fine_certain_of(b, t, again, again.half_gaps(), canvas);
    if (!certain.fits()) return false;
    const Pixel p;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    const Texels<Pixel, kAddressing> texels(canvas, b, t, certain);
    const bool sure = certain.sure();
    for (Piece piece; pieces.next(b, t, piece);) {
        Rows rows;
        cross(b, t, piece, canvas, rows);
        for (int n = 0, y = piece.row; n < piece.count; ++n, ++y) {
            [[maybe_unused]] const DepthRow<Pixel> depth(b, t, y);
            const int end = rows.x1.at[n];
            if (rows.x0.at[n] < end) samples += static_cast<uint64_t>(end - rows.x0.at[n]);
            FineRow<kPerspective, Pixel> along(b, t, rows.x0.at[n], y, certain);
            for (int x = rows.x0.at[n]; x < end; x += kLanes) {
                auto u = hn::Zero(p), v = u;
                along.next(u, v);
                const auto in = hn::FirstN(p, static_cast<size_t>(end - x));
                if constexpr (kDepth) {
                    const auto shown = test_early(depth, x, y, in, again, canvas);
                    if (!hn::AllFalse(p, shown)) put_tested(p, texels, u, v, depth, x, y, shown, again, canvas);
                    continue;
                }
                uint32_t* const line = canvas.target.pixels + y * std::ptrdiff_t{canvas.target.pitch};
                uint32_t* const out = line + x;
                if (end - x >= kLanes)
                    hn::StoreU(texels.fetch(u, v), p, out);
                else
                    store_some(texels.fetch(u, v), in, p, out, line + canvas.target.width);
                if (sure) continue;
                if (const auto unsure = hn::And(in, texels.unsure(u, v)); !hn::AllFalse(p, unsure))
                    mend(p, again, x, y, unsure, false, canvas);
            }
        }
    }
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
