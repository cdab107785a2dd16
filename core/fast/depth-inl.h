// The depth test: z is affine over the screen, in double, and rounded to float32 once. The bound e of its error decides
// whether that rounding is certain: z - e and z + e give the same float32, or the exact triangle is asked.
#if defined(TEXELSCOPE_DEPTH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_DEPTH_INL
#undef TEXELSCOPE_DEPTH_INL
#else
#define TEXELSCOPE_DEPTH_INL
#endif

#include "core/fast/texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// z along one row.
template <class Tag>
class DepthRow {
public:
    using Float = hn::Rebind<float, Tag>;

    HWY_INLINE DepthRow(const Batch& b, int t, int row)
        : at_(b.z.at.at[t] + (row - b.row0.at[t]) * b.z.y.at[t]),
          x_(b.z.x.at[t]),
          unsure_(b.z_unsure.at[t]),
          column0_(b.column0.at[t]),
          level_(b.level_z.at[t] != 0) {}

    /// z of the pixels from x on, those of `in` right.
    [[nodiscard]] HWY_INLINE hn::Vec<Float> at(int x, int y, hn::Mask<Tag> in, Again& again) const {
        const Float f;
        if (level_) return hn::Set(f, static_cast<float>(at_));
        const double first = at_ + (x - column0_) * x_;
        const auto low = from(first - unsure_), high = from(first + unsure_);
        const auto doubt = hn::And(hn::RebindMask(f, in), hn::Ne(low, high));
        if (hn::AllFalse(f, doubt)) return low;
        alignas(64) float z[hn::MaxLanes(f)];
        hn::Store(low, f, z);
        for (uint32_t m = bits_of(f, doubt); m != 0; m &= m - 1) {
            const int n = std::countr_zero(m);
            z[n] = again.depth(x + n, y);
        }
        return hn::Load(f, z);
    }

private:
    [[nodiscard]] HWY_INLINE hn::Vec<Float> from(double first) const {
        const Float f;
        using Wide = hn::CappedTag<double, hn::MaxLanes(Float{})>;
        constexpr int kWide = static_cast<int>(hn::MaxLanes(Wide{}));
        const auto z = [&](int skip) HWY_ATTR {
            return hn::MulAdd(hn::Iota(Wide{}, skip), hn::Set(Wide{}, x_), hn::Set(Wide{}, first));
        };
        if constexpr (kWide == static_cast<int>(hn::MaxLanes(f))) return hn::DemoteTo(f, z(0));
#if HWY_TARGET != HWY_SCALAR
        else
            return hn::Combine(f, hn::DemoteTo(hn::Half<Float>{}, z(kWide)), hn::DemoteTo(hn::Half<Float>{}, z(0)));
#endif
    }

    double at_, x_, unsure_;
    int column0_;
    bool level_;
};

/// The pixels of `in` from x on, of row y, which pass the depth test; it is left nearer.
template <class Tag>
HWY_INLINE hn::Mask<Tag> pass_depth(const DepthRow<Tag>& depth, int x, int y, hn::Mask<Tag> in, Again& again,
                                    const Canvas& canvas) {
    const hn::Rebind<float, Tag> f;
    float* const line = canvas.target.depth + y * std::ptrdiff_t{canvas.target.pitch};
    const float* const end = line + canvas.target.width;
    const auto z = depth.at(x, y, in, again), old = load_some(f, hn::RebindMask(f, in), line + x, end);
    const auto nearer = hn::And(hn::RebindMask(f, in), hn::Lt(z, old));
    store_some(z, nearer, f, line + x, end);
    return hn::RebindMask(Tag{}, nearer);
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
