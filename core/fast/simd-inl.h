// Numbers of eight triangles, or of some rows, side by side; for each SIMD target.
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

constexpr int kBatch = 8;         ///< triangles set up at once
constexpr int kRows = 16;         ///< rows of one triangle crossed at once, at most
constexpr double kUlp = 0x1p-53;  ///< half a unit in the last place of 1

using Real = hn::CappedTag<double, kBatch>;
using Narrow = hn::Rebind<float, Real>;
using Index = hn::Rebind<int32_t, Real>;
using Pixel = hn::ScalableTag<uint32_t>;
using PixelInt = hn::ScalableTag<int32_t>;
constexpr int kReals = static_cast<int>(hn::MaxLanes(Real{}));
using V = hn::Vec<Real>;
using One = hn::CappedTag<double, 1>;  ///< for formulas that serve eight triangles and single ones alike

/// Numbers of eight triangles.
struct alignas(64) Eight {
    double at[kBatch];
};
struct alignas(64) EightFloat {
    float at[kBatch];
};
struct alignas(64) EightInt {
    int32_t at[kBatch];
};

/// A number of each row.
template <class Number>
struct alignas(64) OfRows {
    Number at[kRows];
};

constexpr int kTriangleFloats = 3 * sizeof(Vertex) / sizeof(float);

/// Where triangles lie: one after the other, or by their indices.
struct InOrder {
    const float* first;
    [[nodiscard]] HWY_INLINE const float* at(int lane) const { return first + lane * kTriangleFloats; }
};
struct ByIndex {
    const float* base;
    const int32_t* triangles;
    [[nodiscard]] HWY_INLINE const float* at(int lane) const {
        return base + std::ptrdiff_t{triangles[lane]} * kTriangleFloats;
    }
};

/// Floats [first, first + 4) of each triangle: loads of four and a transposition, where gather instructions would need
/// five times as long.
template <class D, class Where>
HWY_INLINE void four_of(D n, const Where& where, int first, hn::Vec<D>& a, hn::Vec<D>& b, hn::Vec<D>& c,
                        hn::Vec<D>& d) {
    const auto from = [&](int lane) { return where.at(lane) + first; };
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(D{}));
#if HWY_TARGET <= HWY_SSE4
    if constexpr (kLanes >= 4) {
        const hn::CappedTag<float, 4> four;
        const auto row = [&](int lane) HWY_ATTR {  // of every fourth triangle
            if constexpr (kLanes == 4) {
                return hn::LoadU(four, from(lane));
            } else if constexpr (kLanes == 8) {
                return hn::Combine(D{}, hn::LoadU(four, from(lane + 4)), hn::LoadU(four, from(lane)));
            } else {
                const hn::Half<D> half;
                return hn::Combine(D{},
                                   hn::Combine(half, hn::LoadU(four, from(lane + 12)), hn::LoadU(four, from(lane + 8))),
                                   hn::Combine(half, hn::LoadU(four, from(lane + 4)), hn::LoadU(four, from(lane))));
            }
        };
        const auto r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
        const hn::RepartitionToWide<D> pairs;
        const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(n, r0, r1)),
                   low23 = hn::BitCast(pairs, hn::InterleaveLower(n, r2, r3)),
                   high01 = hn::BitCast(pairs, hn::InterleaveUpper(n, r0, r1)),
                   high23 = hn::BitCast(pairs, hn::InterleaveUpper(n, r2, r3));
        a = hn::BitCast(n, hn::InterleaveLower(pairs, low01, low23));
        b = hn::BitCast(n, hn::InterleaveUpper(pairs, low01, low23));
        c = hn::BitCast(n, hn::InterleaveLower(pairs, high01, high23));
        d = hn::BitCast(n, hn::InterleaveUpper(pairs, high01, high23));
        return;
    }
#endif
    alignas(16) float lanes[4][kLanes];
    for (int lane = 0; lane < kLanes; ++lane)
        for (int number = 0; number < 4; ++number) lanes[number][lane] = from(lane)[number];
    a = hn::Load(n, lanes[0]), b = hn::Load(n, lanes[1]), c = hn::Load(n, lanes[2]), d = hn::Load(n, lanes[3]);
}

/// The corners of some triangles, side by side.
template <class D>
struct Fields {
    hn::Vec<D> x[3], y[3], z[3], w[3], u[3], v[3];

    template <class Where>
    HWY_INLINE Fields(D d, const Where& where) {
        four_of(d, where, 0, x[0], y[0], z[0], w[0]);
        four_of(d, where, 4, u[0], v[0], x[1], y[1]);
        four_of(d, where, 8, z[1], w[1], u[1], v[1]);
        four_of(d, where, 12, x[2], y[2], z[2], w[2]);
        hn::Vec<D> again;  // who asks for no u or v needs none of these loads
        four_of(d, where, 14, again, again, u[2], v[2]);
    }
};
/// Of those that are set up together.
using Floats = hn::Vec<Narrow>;
using Eights = Fields<Narrow>;
HWY_INLINE V promote(Floats a) { return hn::PromoteTo(Real{}, a); }

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

HWY_INLINE V load_int(const EightInt& from) { return hn::PromoteTo(Real{}, hn::Load(Index{}, from.at)); }
HWY_INLINE void store_int(V value, int32_t* to) { hn::Store(hn::DemoteTo(Index{}, value), Index{}, to); }

/// The low 32 bits of the whole part of |value| < 2^51.
HWY_INLINE void store_fraction(V value, int32_t* to) {
    const Real d;
    const hn::Repartition<uint64_t, Real> bits;
    const V shifted = hn::Add(value, hn::Set(d, 0x1.8p52));
    const auto low = hn::TruncateTo(hn::Rebind<uint32_t, Real>{}, hn::BitCast(bits, shifted));
    hn::Store(hn::BitCast(Index{}, low), Index{}, to);
}

/// first, first + 1 ...: Highway's Iota of a number that the compiler does not know goes through memory, lane by lane,
/// on targets before AVX-512.
template <class D>
HWY_INLINE hn::Vec<D> lanes_from(D d, hn::TFromD<D> first) {
    return hn::Add(hn::Iota(d, 0), hn::Set(d, first));
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

/// The lanes of `mask` at `from`, of a row that goes on to `end`; beyond nothing is read.
template <class Tag>
HWY_INLINE hn::Vec<Tag> load_some(Tag d, hn::Mask<Tag> mask, const hn::TFromD<Tag>* from, const hn::TFromD<Tag>* end) {
#if HWY_TARGET <= HWY_AVX2
    (void)end;
    return hn::MaskedLoad(mask, d, from);
#else  // without such an instruction
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(d));
    if (end - from >= kLanes) return hn::LoadU(d, from);
    alignas(64) hn::TFromD<Tag> lanes[kLanes] = {};
    for (uint32_t m = bits_of(d, mask); m != 0; m &= m - 1) lanes[std::countr_zero(m)] = from[std::countr_zero(m)];
    return hn::Load(d, lanes);
#endif
}
/// Stores the lanes of `mask` to `to`, of a row that goes on to `end`; what else stands in the row stays.
template <class Tag>
HWY_INLINE void store_some(hn::Vec<Tag> value, hn::Mask<Tag> mask, Tag d, hn::TFromD<Tag>* to,
                           const hn::TFromD<Tag>* end) {
#if HWY_TARGET <= HWY_AVX3
    (void)end;
    hn::BlendedStore(value, mask, d, to);
#else  // AVX2's instruction takes five times as long as writing what stands there once more
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(d));
    if (end - to >= kLanes) return hn::StoreU(hn::IfThenElse(mask, value, hn::LoadU(d, to)), d, to);
    alignas(64) hn::TFromD<Tag> lanes[kLanes];
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

/// Stores table[place] of each lane to out, side by side; one by one, which leaves the shuffling of vectors to others.
template <class Tag>
HWY_INLINE void store_looked_up([[maybe_unused]] Tag p, const uint32_t* table, hn::Vec<Tag> place, uint32_t* out) {
#if HWY_TARGET == HWY_SCALAR
    out[0] = table[hn::GetLane(place)];
#else
    constexpr size_t kLanes = hn::MaxLanes(p);
    if constexpr (kLanes > 4) {
        const hn::Half<Tag> half;
        store_looked_up(half, table, hn::LowerHalf(half, place), out);
        store_looked_up(half, table, hn::UpperHalf(half, place), out + kLanes / 2);
    } else {
        const hn::Repartition<uint64_t, Tag> pairs;
        const uint64_t low = hn::GetLane(hn::BitCast(pairs, place)),
                       high = hn::ExtractLane(hn::BitCast(pairs, place), 1);
        out[0] = table[static_cast<uint32_t>(low)], out[1] = table[low >> 32];
        out[2] = table[static_cast<uint32_t>(high)], out[3] = table[high >> 32];
    }
#endif
}

/// Stores table[place] of each lane to out[at], in any order.
template <class Tag>
HWY_INLINE void scatter_looked_up([[maybe_unused]] Tag p, const uint32_t* table, hn::Vec<Tag> place, hn::Vec<Tag> at,
                                  uint32_t* out) {
#if HWY_TARGET == HWY_SCALAR
    out[hn::GetLane(at)] = table[hn::GetLane(place)];
#else
    if constexpr (hn::MaxLanes(p) > 4) {
        const hn::Half<Tag> half;
        scatter_looked_up(half, table, hn::LowerHalf(half, place), hn::LowerHalf(half, at), out);
        scatter_looked_up(half, table, hn::UpperHalf(half, place), hn::UpperHalf(half, at), out);
    } else {
        const hn::Repartition<uint64_t, Tag> pairs;
        const auto two = [&](uint64_t from, uint64_t to) HWY_ATTR {
            out[static_cast<uint32_t>(to)] = table[static_cast<uint32_t>(from)], out[to >> 32] = table[from >> 32];
        };
        two(hn::GetLane(hn::BitCast(pairs, place)), hn::GetLane(hn::BitCast(pairs, at)));
        two(hn::ExtractLane(hn::BitCast(pairs, place), 1), hn::ExtractLane(hn::BitCast(pairs, at), 1));
    }
#endif
}

HWY_INLINE V least_of(V a, V b, V c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE V most_of(V a, V b, V c) { return hn::Max(hn::Max(a, b), c); }

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
