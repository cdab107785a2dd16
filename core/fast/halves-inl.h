// Rows in perspective where a texture is no larger than 2^15: u and v are counted in 2^-16 of a texel, so that the
// whole texels are the upper halves of 32 bits. One product finds where texels stand, and what follows them needs no
// shift to be seen. AVX2 alone needs it: where AVX-512 draws rows, something else takes the time.
#if defined(TEXELSCOPE_HALVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_HALVES_INL
#undef TEXELSCOPE_HALVES_INL
#else
#define TEXELSCOPE_HALVES_INL
#endif

#include "core/fast/texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

constexpr int kHalfBits = 16;
constexpr uint32_t kRest = (1U << kHalfBits) - 1;  ///< what follows a texel

/// The nearest whole numbers of |value| < 2^31.
template <class Tag>
HWY_INLINE hn::Vec<Tag> nearest(Tag p, hn::Vec<hn::Rebind<float, Tag>> value) {
#if HWY_TARGET == HWY_AVX2
    (void)p;
    return hn::Vec<Tag>{_mm256_cvtps_epi32(value.raw)};  // Highway's own looks for larger ones, too
#else
    return hn::BitCast(p, hn::NearestInt(value));
#endif
}

#if HWY_TARGET == HWY_AVX2

/// Whether a texture can be counted so.
HWY_INLINE bool fits_halves(const Canvas& canvas) {
    return canvas.addressing == Addressing::powers && canvas.u_bits < kHalfBits && canvas.v_bits < kHalfBits &&
           canvas.texture.pitch < 1 << (kHalfBits - 1);
}

template <class Tag>
struct Texels<Tag, Addressing::halves> {
    using Pixels = hn::Vec<Tag>;
    using Halves = hn::Repartition<uint16_t, Tag>;
    /// Of u or v.
    struct Side {
        double bias;   ///< [units]
        Pixels least;  ///< what follows a texel must be no less

        HWY_INLINE explicit Side(const Certain& certain) : bias(certain.bias) {
            least = hn::Set(Tag{}, (certain.least + kRest) >> kHalfBits);
        }
        [[nodiscard]] HWY_INLINE hn::Mask<Tag> unsure(Pixels at) const {
            return hn::Lt(hn::And(at, hn::Set(Tag{}, kRest)), least);
        }
    } u, v;
    Pixels highest, steps;  ///< of u below and of v above: the last index; how far apart texels stand
    const uint32_t* texels;

    HWY_INLINE Texels(const Canvas& canvas, const Batch& /*b*/, int /*t*/, const CertainPair& certain)
        : u(certain.u), v(certain.v), texels(canvas.texture.texels) {
        const auto both = [](uint32_t low, uint32_t high) HWY_ATTR { return hn::Set(Tag{}, high << kHalfBits | low); };
        highest = both((1U << canvas.u_bits) - 1, (1U << canvas.v_bits) - 1);
        steps = both(1, static_cast<uint32_t>(canvas.texture.pitch));
    }
    [[nodiscard]] HWY_INLINE Pixels place(Pixels at_u, Pixels at_v) const {
        const Halves h;
        const auto whole = hn::OddEven(hn::BitCast(h, at_v), hn::BitCast(h, hn::ShiftRight<kHalfBits>(at_u)));
        return Pixels{_mm256_madd_epi16(hn::And(hn::BitCast(Tag{}, whole), highest).raw, steps.raw)};
    }
    [[nodiscard]] HWY_INLINE Pixels fetch(Pixels at_u, Pixels at_v) const {
        return look_up(Tag{}, texels, place(at_u, at_v));
    }
    [[nodiscard]] HWY_INLINE hn::Mask<Tag> unsure(Pixels at_u, Pixels at_v) const {
        return hn::Or(u.unsure(at_u), v.unsure(at_v));
    }
};

/// In the lower halves. The upper ones mean nothing.
template <class Tag>
struct Least<Tag, Addressing::halves> {
    using Lookup = Texels<Tag, Addressing::halves>;
    using Halves = typename Lookup::Halves;
    hn::Vec<Halves> u, v;

    HWY_INLINE Least() { u = v = hn::Set(Halves{}, 0xFFFF); }
    HWY_INLINE void see(const Lookup& /*texels*/, hn::Vec<Tag> at_u, hn::Vec<Tag> at_v) {
        const Halves h;
        u = hn::Min(u, hn::BitCast(h, at_u)), v = hn::Min(v, hn::BitCast(h, at_v));
    }
    HWY_INLINE void see(const Lookup& texels, hn::Vec<Tag> at_u, hn::Vec<Tag> at_v, hn::Mask<Tag> in) {
        const auto all = hn::Set(Tag{}, ~0U);
        see(texels, hn::IfThenElse(in, at_u, all), hn::IfThenElse(in, at_v, all));
    }
    [[nodiscard]] HWY_INLINE bool is_sure(const Lookup& texels) const {
        return hn::AllFalse(Tag{}, texels.unsure(hn::BitCast(Tag{}, u), hn::BitCast(Tag{}, v)));
    }
};

#endif

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
