// Which samples of a block a small triangle owns, and what u and v are there: the sides' values at all of them at once,
// no rows. On the coarse grid, up to 8 px wide, these are whole multiples of 2^-16 below 2^8, which float32 holds
// exactly; elsewhere what comes near 0 is left to the rows.
#if defined(TEXELSCOPE_COVER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_COVER_INL
#undef TEXELSCOPE_COVER_INL
#else
#define TEXELSCOPE_COVER_INL
#endif

#include "core/fast/setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// Bit (y << kBits) + x: whether the triangle owns sample (x, y) of its block, 2^kBits of them wide and high, whatever
/// the target's ends. False: one lies too near to a side.
template <int kBits>
HWY_INLINE bool cover(const Batch& b, int t, uint64_t& inside) {
    const hn::CappedTag<float, 16> f;
    const hn::Rebind<int32_t, decltype(f)> s;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(f));
    inside = 0;
    const bool exact = b.side_doubt.at[t] == 0;
    for (int first = 0; first < 1 << 2 * kBits; first += kLanes) {
        const auto sample = lanes_from(s, first);
        const auto x = hn::ConvertTo(f, hn::And(sample, hn::Set(s, (1 << kBits) - 1))),
                   y = hn::ConvertTo(f, hn::ShiftRight<kBits>(sample));
        const auto e = [&](size_t n) HWY_ATTR {
            const auto at_row = hn::MulAdd(y, hn::Set(f, b.side_y[n].at[t]), hn::Set(f, b.side_one[n].at[t]));
            return hn::MulAdd(x, hn::Set(f, b.side_x[n].at[t]), at_row);
        };
        const auto e0 = e(0), e1 = e(1), e2 = e(2);
        if (!exact) {
            const auto nearest = hn::Min(hn::Min(hn::Abs(e0), hn::Abs(e1)), hn::Abs(e2));
            if (!hn::AllFalse(f, hn::Lt(nearest, hn::Set(f, b.side_doubt.at[t])))) return false;
        }
        const auto in = [&](auto value, size_t n) HWY_ATTR { return hn::Ge(value, hn::Set(f, b.side_least[n].at[t])); };
        inside |= uint64_t{bits_of(f, hn::And(hn::And(in(e0, 0), in(e1, 1)), in(e2, 2)))} << first;
    }
    return true;
}

/// u or v at samples (x, y) of the block, biased by its doubt [units].
template <class Tag>
HWY_INLINE hn::Vec<Tag> units_at(Tag p, const CoordinateEight& u, int t, hn::Vec<Tag> x, hn::Vec<Tag> y) {
    const auto first = static_cast<uint32_t>(static_cast<int64_t>(u.plane.at.at[t] + u.doubt.at[t]));
    const auto at_row = hn::Add(hn::Mul(y, hn::Set(p, static_cast<uint32_t>(u.down.at[t]))), hn::Set(p, first));
    return hn::Add(hn::Mul(x, hn::Set(p, static_cast<uint32_t>(u.step.at[t]))), at_row);
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
