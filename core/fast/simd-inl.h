// Numbers of eight triangles, or of eight rows, side by side; for each SIMD target.
#if defined(TEXELSCOPE_SIMD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_SIMD_INL
#undef TEXELSCOPE_SIMD_INL
#else
#define TEXELSCOPE_SIMD_INL
#endif

#include <bit>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

#include "core/geometry/vertex.h"

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

/// A number of the triangles' first corners, or `offset` floats after it.
HWY_INLINE V field(const float* base, hn::Vec<Index> index, int offset) {
    return hn::PromoteTo(Real{}, hn::GatherIndex(Narrow{}, base + offset, index));
}

#if !HWY_NATIVE_FMA
/// What a rounded product has lost: a b - p, exactly, from halves whose products are exact (Veltkamp 1968, Dekker
/// 1971). Nothing here is near the ends of double's range.
HWY_INLINE V lost_of_product(V a, V b, V p) {
    const auto split = [](V x, V& low) HWY_ATTR {
        const V big = hn::Mul(x, hn::Set(Real{}, 134217729.0)), high = hn::Sub(big, hn::Sub(big, x));
        low = hn::Sub(x, high);
        return high;
    };
    V a_low, b_low;
    const V a_high = split(a, a_low), b_high = split(b, b_low), rest = hn::Sub(hn::Mul(a_high, b_high), p);
    return hn::Add(hn::Add(hn::Add(rest, hn::Mul(a_high, b_low)), hn::Mul(a_low, b_high)), hn::Mul(a_low, b_low));
}
#endif

/// a b - c d with at most 2 ulp of error, so that its sign is right.
HWY_INLINE V difference_of_products(V a, V b, V c, V d) {
    const V q = hn::Mul(c, d);
#if HWY_NATIVE_FMA  // 1.5 ulp (Kahan; Jeannerod, Louvet, Muller 2013)
    return hn::Add(hn::MulSub(a, b, q), hn::NegMulAdd(c, d, q));
#else  // close products differ exactly (Sterbenz), others lose half an ulp; then what each of them had lost comes back
    const V p = hn::Mul(a, b);
    return hn::Add(hn::Sub(p, q), hn::Sub(lost_of_product(a, b, p), lost_of_product(c, d, q)));
#endif
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

/// Bit n is lane n.
template <class Tag>
HWY_INLINE uint32_t bits_of(Tag d, hn::Mask<Tag> mask) {
    uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    uint32_t bits = 0;
    std::memcpy(&bits, bytes, 4);
    return bits;
}

/// The lanes of `mask` at `from`; nothing else is read.
template <class Tag>
HWY_INLINE hn::Vec<Tag> load_some(Tag d, hn::Mask<Tag> mask, const hn::TFromD<Tag>* from) {
#if HWY_TARGET <= HWY_AVX2
    return hn::MaskedLoad(mask, d, from);
#else  // without such an instruction, lane by lane
    alignas(64) hn::TFromD<Tag> lanes[hn::MaxLanes(d)] = {};
    for (uint32_t m = bits_of(d, mask); m != 0; m &= m - 1) lanes[std::countr_zero(m)] = from[std::countr_zero(m)];
    return hn::Load(d, lanes);
#endif
}
/// Stores the lanes of `mask` to `to`; nothing else is written, not even what stands there.
template <class Tag>
HWY_INLINE void store_some(hn::Vec<Tag> value, hn::Mask<Tag> mask, Tag d, hn::TFromD<Tag>* to) {
#if HWY_TARGET <= HWY_AVX2
    hn::BlendedStore(value, mask, d, to);
#else
    alignas(64) hn::TFromD<Tag> lanes[hn::MaxLanes(d)];
    hn::Store(value, d, lanes);
    for (uint32_t m = bits_of(d, mask); m != 0; m &= m - 1) to[std::countr_zero(m)] = lanes[std::countr_zero(m)];
#endif
}

/// table[place] of each lane. By single loads: gather instructions are slower than these on many machines (2,400 texels
/// a microsecond against 1,900 on the one that this was measured on, with rows of 200 from a turned texture).
template <class Tag>
HWY_INLINE hn::Vec<Tag> look_up(Tag p, const uint32_t* table, hn::Vec<Tag> place) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(p, table[hn::GetLane(place)]);
#else
    if constexpr (hn::MaxLanes(p) > 4) {
        const hn::Half<Tag> half;
        return hn::Combine(p, look_up(half, table, hn::UpperHalf(half, place)),
                           look_up(half, table, hn::LowerHalf(half, place)));
    } else {
        const hn::Repartition<uint64_t, Tag> pairs;
        const uint64_t low = hn::GetLane(hn::BitCast(pairs, place)),
                       high = hn::ExtractLane(hn::BitCast(pairs, place), 1);
        auto found = hn::Set(p, table[static_cast<uint32_t>(low)]);
        found = hn::InsertLane(found, 1, table[low >> 32]);
        found = hn::InsertLane(found, 2, table[static_cast<uint32_t>(high)]);
        return hn::InsertLane(found, 3, table[high >> 32]);
    }
#endif
}

HWY_INLINE V least_of(V a, V b, V c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE V most_of(V a, V b, V c) { return hn::Max(hn::Max(a, b), c); }

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
