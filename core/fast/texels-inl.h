// From u and v in units to texels, and which of them may be wrong: Certainty.
#if defined(TEXELSCOPE_TEXELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_TEXELS_INL
#undef TEXELSCOPE_TEXELS_INL
#else
#define TEXELSCOPE_TEXELS_INL
#endif

#include <bit>
#include <cmath>
#include <optional>

#include "core/fast/decide.h"
#include "core/fast/setup-inl.h"
#include "core/fast/watch.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// The upper 32 bits of each product.
template <class Pixels>
HWY_INLINE Pixels upper_half(Pixels a, Pixels b) {
    using Tag = hn::DFromV<Pixels>;
    const Tag p;
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(p, static_cast<uint32_t>(uint64_t{hn::GetLane(a)} * hn::GetLane(b) >> 32));
#else
    const hn::RepartitionToWide<Tag> wide;
    const auto odd_lanes = [&](auto lanes)
                               HWY_ATTR { return hn::BitCast(Tag{}, hn::ShiftRight<32>(hn::BitCast(wide, lanes))); };
    const auto even = odd_lanes(hn::MulEven(a, b));
    const auto odd = hn::BitCast(p, hn::MulEven(odd_lanes(a), odd_lanes(b)));
    return hn::OddEven(odd, even);
#endif
}

/// Certainty of one triangle's u or v.
struct Certain {
    double bias = 0;
    uint32_t least = 0;
    bool fits = false;
};

/// u or v of one triangle, as many at once as the tag has lanes.
template <class Tag, Addressing kAddressing>
struct Axis {
    hn::Vec<Tag> least, size;
    int shift;
    double bias;

    HWY_INLINE Axis(const Certain& certain, int shift_of_texel, int texels)
        : shift(shift_of_texel), bias(certain.bias) {
        least = hn::Set(Tag{}, certain.least), size = hn::Set(Tag{}, static_cast<uint32_t>(texels));
    }
    /// What follows the texel's bits, at the top of 32.
    [[nodiscard]] HWY_INLINE hn::Vec<Tag> rest(hn::Vec<Tag> u) const {
        if constexpr (kAddressing == Addressing::any_size) return hn::Mul(u, size);
        return hn::ShiftLeftSame(u, 32 - shift);
    }
    [[nodiscard]] HWY_INLINE hn::Mask<Tag> unsure(hn::Vec<Tag> u) const { return hn::Lt(rest(u), least); }
    [[nodiscard]] HWY_INLINE hn::Vec<Tag> index(hn::Vec<Tag> u) const {
        const Tag p;
        if constexpr (kAddressing == Addressing::powers) {
            return hn::ShiftRightSame(u, shift);
        } else if constexpr (kAddressing == Addressing::any_size) {
            return upper_half(u, size);
        } else {
            const hn::Rebind<int32_t, Tag> s;
            const auto texel = hn::ShiftRightSame(hn::BitCast(s, u), shift);
            return hn::BitCast(p, hn::Min(hn::Max(texel, hn::Zero(s)), hn::Sub(hn::BitCast(s, size), hn::Set(s, 1))));
        }
    }
};

/// Half of WideTriangle::Gaps [units]; 0 where nobody has asked.
struct HalfGaps {
    double u = 0, v = 0;
};

/// The units of a texel.
HWY_INLINE double texel_units(const Canvas& canvas, const CoordinateEight& u, int t, int size) {
    return canvas.addressing == Addressing::any_size ? 0x1p32 / size : static_cast<double>(int64_t{1} << u.shift.at[t]);
}

HWY_INLINE Certain certain_of(const Canvas& canvas, const CoordinateEight& u, int t, int size, double doubt,
                              double half_gap) {
    const One d;
    const double texel = texel_units(canvas, u, t, size);
    const double per_texel = canvas.addressing == Addressing::any_size ? size : 0x1p32 / texel;
    const Certainty<One> c(d, hn::Set(d, doubt), hn::Set(d, half_gap), hn::Set(d, texel), hn::Set(d, per_texel));
    return {hn::GetLane(c.bias), static_cast<uint32_t>(hn::GetLane(c.least)), hn::AllTrue(d, c.fits)};
}
/// Of both, by how much they are in doubt.
struct CertainPair {
    Certain u, v;

    [[nodiscard]] HWY_INLINE bool fits() const { return u.fits && v.fits; }
    /// Whether no texel needs a test.
    [[nodiscard]] HWY_INLINE bool sure() const { return fits() && u.least == 0 && v.least == 0; }
};
HWY_INLINE CertainPair certain_of(const Canvas& canvas, const Batch& b, int t, double u_doubt, double v_doubt,
                                  const HalfGaps& gaps) {
    return {certain_of(canvas, b.u, t, canvas.texture.width, u_doubt, gaps.u),
            certain_of(canvas, b.v, t, canvas.texture.height, v_doubt, gaps.v)};
}
/// Of an affine triangle, as it was set up.
HWY_INLINE CertainPair certain_of(const Batch& b, int t) {
    const auto of = [t](const CoordinateEight& u) HWY_ATTR {
        return Certain{u.doubt.at[t], static_cast<uint32_t>(u.least.at[t]), true};
    };
    return {of(b.u), of(b.v)};
}
/// Of a narrow one in perspective.
HWY_INLINE CertainPair narrow_certain_of(const Batch& b, int t) {
    const auto of = [t](const FloatEight& u) HWY_ATTR {
        const auto least = static_cast<uint32_t>(u.least.at[t]);
        return Certain{u.doubt.at[t], least, least != ~0U};
    };
    return {of(b.u_along), of(b.v_along)};
}

/// Both, and the texture.
template <class Tag, Addressing kAddressing>
struct Texels {
    using Pixels = hn::Vec<Tag>;
    Axis<Tag, kAddressing> u, v;
    Pixels pitch;
    const uint32_t* texels;

    HWY_INLINE Texels(const Canvas& canvas, const Batch& b, int t, const CertainPair& certain)
        : u(certain.u, b.u.shift.at[t], canvas.texture.width),
          v(certain.v, b.v.shift.at[t], canvas.texture.height),
          texels(canvas.texture.texels) {
        pitch = hn::Set(Tag{}, static_cast<uint32_t>(canvas.texture.pitch));
    }
    /// Where in the texture.
    [[nodiscard]] HWY_INLINE Pixels place(Pixels at_u, Pixels at_v) const {
        return hn::Add(hn::Mul(v.index(at_v), pitch), u.index(at_u));
    }
    [[nodiscard]] HWY_INLINE Pixels fetch(Pixels at_u, Pixels at_v) const { return fetch(place(at_u, at_v)); }
    [[nodiscard]] HWY_INLINE Pixels fetch(Pixels at) const { return look_up(Tag{}, texels, at); }
    [[nodiscard]] HWY_INLINE hn::Mask<Tag> unsure(Pixels at_u, Pixels at_v) const {
        return hn::Or(u.unsure(at_u), v.unsure(at_v));
    }
};

/// The least of what follows the texels' bits: whether some texel may be wrong, found out once for many.
template <class Tag, Addressing kAddressing>
struct Least {
    hn::Vec<Tag> u, v;

    HWY_INLINE Least() { u = v = hn::Set(Tag{}, ~0U); }
    HWY_INLINE void see(const Texels<Tag, kAddressing>& texels, hn::Vec<Tag> at_u, hn::Vec<Tag> at_v) {
        u = hn::Min(u, texels.u.rest(at_u)), v = hn::Min(v, texels.v.rest(at_v));
    }
    /// Those of `in` alone: where samples tie, what lies beyond a row's end often does, too.
    HWY_INLINE void see(const Texels<Tag, kAddressing>& texels, hn::Vec<Tag> at_u, hn::Vec<Tag> at_v,
                        hn::Mask<Tag> in) {
        u = hn::IfThenElse(in, hn::Min(u, texels.u.rest(at_u)), u);
        v = hn::IfThenElse(in, hn::Min(v, texels.v.rest(at_v)), v);
    }
    [[nodiscard]] HWY_INLINE bool is_sure(const Texels<Tag, kAddressing>& texels) const {
        return hn::AllFalse(Tag{}, hn::Or(hn::Lt(u, texels.u.least), hn::Lt(v, texels.v.least)));
    }
};

/// Stores the texels of as many pixels as there are lanes.
template <bool kCertain, Addressing kAddressing, class Tag>
HWY_INLINE void put_all(Tag p, const Texels<Tag, kAddressing>& texels, hn::Vec<Tag> u, hn::Vec<Tag> v, uint32_t* out,
                        Least<Tag, kAddressing>& least) {
    store_looked_up(p, texels.texels, texels.place(u, v), out);
    if constexpr (kCertain) least.see(texels, u, v);
}
/// Of the first `count` of them, in a row that goes on to `end`.
template <bool kCertain, Addressing kAddressing, class Tag>
HWY_INLINE void put_some(Tag p, const Texels<Tag, kAddressing>& texels, hn::Vec<Tag> u, hn::Vec<Tag> v, int count,
                         uint32_t* out, const uint32_t* end, Least<Tag, kAddressing>& least) {
    const auto in = hn::FirstN(p, static_cast<size_t>(count));
    store_some(texels.fetch(u, v), in, p, out, end);
    if constexpr (kCertain) least.see(texels, u, v, in);
}

/// A plane's value at some pixels of the box; setup-inl.h bounds what it loses.
template <class D>
HWY_INLINE hn::Vec<D> plane_at(D d, const PlaneEight& p, int t, hn::Vec<D> right, hn::Vec<D> down) {
    return hn::MulAdd(right, hn::Set(d, p.x.at[t]), hn::MulAdd(down, hn::Set(d, p.y.at[t]), hn::Set(d, p.at.at[t])));
}

/// Texels of one triangle that int32 or float32 could not tell: in double, and exactly where that cannot either.
class Again {
public:
    HWY_INLINE Again(const Canvas& canvas, const Batch& b, int t, bool perspective)
        : canvas_(canvas), b_(b), t_(t), perspective_(perspective), decider_(canvas, b.index.at[t]) {}
    HWY_INLINE ~Again() { canvas_.counters->of(RasterSkip::early_z) += static_cast<uint64_t>(spared_); }
    Again(const Again&) = delete;
    Again& operator=(const Again&) = delete;

    /// The texel of the target's pixel (x, y), where double can tell it.
    [[nodiscard]] HWY_NOINLINE bool texel_in_double(int x, int y, uint32_t& texel) {
        const RasterTexture& texture = canvas_.texture;
        ++canvas_.counters->in_double, ++asked_;
        const double right = x - b_.column0.at[t_], down = y - b_.row0.at[t_];
        TexelIndex index;
        if (!decided(right, down, b_.u, b_.u_over, u_unsure(), texture.width, index.u) ||
            !decided(right, down, b_.v, b_.v_over, v_unsure(), texture.height, index.v))
            return false;
        texel = texture.texels[place_of(texture, index)];
        watch(canvas_, x, y, DecidedBy::in_double);
        return true;
    }
    /// The same, in any case.
    [[nodiscard]] uint32_t texel(int x, int y) {
        uint32_t texel = 0;
        return texel_in_double(x, y, texel) ? texel : canvas_.texture.texels[decider_.texel(x, y)];
    }
    [[nodiscard]] float depth(int x, int y) { return decider_.depth(x, y); }
    /// Bounds of what double has lost [units].
    [[nodiscard]] double u_unsure() const { return perspective_ ? b_.u_far.at[t_] : b_.u.unsure.at[t_]; }
    [[nodiscard]] double v_unsure() const { return perspective_ ? b_.v_far.at[t_] : b_.v.unsure.at[t_]; }
    /// Some samples were behind what stands there, and no texel was looked up for them.
    void note_spared() { spared_ = true; }
    /// Whether so many texels of the first `rows` rows were asked for, with `more` to come, that to draw finely costs
    /// less: chance alone asks for one in some ten thousand.
    [[nodiscard]] bool often(int rows, int more = 0) const { return asked_ + more > 1 && (asked_ + more) * 4 > rows; }
    [[nodiscard]] const HalfGaps& half_gaps() {
        if (half_gaps_) return *half_gaps_;
        const WideTriangle::Gaps gaps = decider_.gaps();
        if (canvas_.settings->watch != nullptr) canvas_.settings->watch->by_gap = true;
        return half_gaps_.emplace(HalfGaps{gaps.u / 2 * texel_units(canvas_, b_.u, t_, canvas_.texture.width),
                                           gaps.v / 2 * texel_units(canvas_, b_.v, t_, canvas_.texture.height)});
    }

private:
    [[nodiscard]] double at(const PlaneEight& p, double right, double down) const {
        const One d;
        return hn::GetLane(plane_at(d, p, t_, hn::Set(d, right), hn::Set(d, down)));
    }
    /// Whether floor(u) is certain [texels].
    [[nodiscard]] bool decided(double right, double down, const CoordinateEight& u, const PlaneEight& over,
                               double unsure, int size, Integer& index) const {
        const double value = perspective_ ? at(over, right, down) / at(b_.one, right, down) : at(u.plane, right, down);
        // A quotient by a size that is no power of two rounds once more.
        const double texel = texel_units(canvas_, u, t_, size);
        const double texels = value / texel, off = unsure / texel + std::abs(texels) * 4 * kUlp;
        const double below = std::floor(texels - off), above = std::floor(texels + off);
        if (!(below == above) || std::abs(below) > 0x1p50) return false;
        index = static_cast<Integer>(below);
        return true;
    }

    const Canvas& canvas_;
    const Batch& b_;
    int t_;
    bool perspective_;
    int asked_ = 0;  ///< texels in double
    bool spared_ = false;
    std::optional<HalfGaps> half_gaps_;
    Decider decider_;
};

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
