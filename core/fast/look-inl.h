// A cheap look at triangles, sixteen at a time, in float32: which of them need not be set up, and where the others are.
#if defined(TEXELSCOPE_LOOK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_LOOK_INL
#undef TEXELSCOPE_LOOK_INL
#else
#define TEXELSCOPE_LOOK_INL
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include <hwy/cache_control.h>

#include "core/fast/setup-inl.h"
#include "core/geometry/polygon.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// Whether the triangle has no picture.
HWY_INLINE bool is_refused(int triangle, const Canvas& canvas) {
    const std::span<const Vertex, 3> corners(canvas.corners(triangle), 3);
    return !std::all_of(corners.begin(), corners.end(),
                        [&](const Vertex& c) { return is_finite(c) && (c.w > 0 || !canvas.job->perspective); });
}

/// Triangles looked at together, in float32.
using Look = hn::CappedTag<float, 16>;
using LookInt = hn::Rebind<int32_t, Look>;
constexpr int kLook = static_cast<int>(hn::MaxLanes(Look{}));
using Looks = hn::Vec<Look>;

/// Lanes of triangles, and what is known of them without a set-up.
struct Looked {
    alignas(64) int32_t index[kLook];  ///< which triangle
    uint32_t keep;                     ///< bit n: lane n is to be drawn
    alignas(64) int32_t column0[kLook], row0[kLook], column1[kLook], row1[kLook];
    alignas(64) float nearest[kLook];
};

/// Fetches the vertices that will be looked at soon after triangle `first`'s.
HWY_INLINE void fetch_vertices(const Canvas& canvas, int first) {
    constexpr int kAhead = 2048;  // [bytes]
    constexpr int kTriangle = 3 * sizeof(Vertex);
    const auto* const bytes = reinterpret_cast<const char*>(canvas.job->vertices.data());
    for (int line = 0; line < kLook * kTriangle; line += 64)
        hwy::Prefetch(bytes + std::ptrdiff_t{first} * kTriangle + kAhead + line);
}

/// Along one axis, the samples that triangles may own, of a target from `origin` on.
struct Extent {
    Looks low, high;      ///< of the corners, from the origin
    Looks first, beyond;  ///< samples

    /// Where the origin is no less than 0, a difference within the target is exact: it is a multiple of the
    /// coordinate's last place, and no larger. Elsewhere it is rounded, and the box is larger by what that may be.
    HWY_INLINE Extent(const Looks (&at)[3], int origin, int size) {
        const Look d;
        const Looks zero = hn::Zero(d), most = hn::Set(d, static_cast<float>(size)), half = hn::Set(d, .5F);
        const Looks from = hn::Set(d, static_cast<float>(origin));
        const bool exact = origin >= 0 && origin < 1 << 23;
        const float rounding = exact ? 0 : 0x1p-23F * (std::abs(static_cast<float>(origin)) + static_cast<float>(size));
        low = hn::Sub(hn::Sub(hn::Min(hn::Min(at[0], at[1]), at[2]), from), hn::Set(d, rounding));
        high = hn::Add(hn::Sub(hn::Max(hn::Max(at[0], at[1]), at[2]), from), hn::Set(d, rounding));
        // Numbers in [0, 2^23) less a half are exact, or what they lose does not matter to the whole number above.
        first = hn::Ceil(hn::Sub(hn::Min(hn::Max(low, zero), most), half));
        beyond = hn::Ceil(hn::Sub(hn::Min(hn::Max(high, zero), most), half));
    }
    [[nodiscard]] HWY_INLINE hn::Mask<Look> outside(int size) const {
        const Look d;
        return hn::Or(hn::Le(high, hn::Zero(d)), hn::Ge(low, hn::Set(d, static_cast<float>(size))));
    }
};

/// The samples that triangles may own, and how near they come.
struct Boxes {
    Extent x, y;

    HWY_INLINE Boxes(const Fields<Look>& f, const RasterTarget& target)
        : x(f.x, target.x0, target.width), y(f.y, target.y0, target.height) {}
    HWY_INLINE void store(const Fields<Look>& f, Looked& looked) const {
        const LookInt i;
        hn::Store(hn::ConvertTo(i, x.first), i, looked.column0),
            hn::Store(hn::ConvertTo(i, x.beyond), i, looked.column1);
        hn::Store(hn::ConvertTo(i, y.first), i, looked.row0), hn::Store(hn::ConvertTo(i, y.beyond), i, looked.row1);
        hn::Store(hn::Min(hn::Min(f.z[0], f.z[1]), f.z[2]), Look{}, looked.nearest);
    }
};

/// Twice the area, and how much float32 may have lost of it.
struct LooseArea {
    Looks area, doubt;

    /// In 2^-24 of the products: each of their factors is off by 1, they by 1 more, the difference by 1. Less than half
    /// of what is taken, the rest is for products that underflow.
    HWY_INLINE explicit LooseArea(const Fields<Look>& f) {
        const Look d;
        const Looks bx = hn::Sub(f.x[1], f.x[0]), by = hn::Sub(f.y[1], f.y[0]), cx = hn::Sub(f.x[2], f.x[0]),
                    cy = hn::Sub(f.y[2], f.y[0]);
        const Looks p = hn::Mul(bx, cy), q = hn::Mul(cx, by);
        area = hn::Sub(p, q);
        doubt = hn::MulAdd(hn::Add(hn::Abs(p), hn::Abs(q)), hn::Set(d, 0x1p-20F), hn::Set(d, 0x1p-120F));
    }
};

/// The area's sign where double holds the corners' differences; else 1.
HWY_NOINLINE int sign_of_area(int triangle, const Canvas& canvas) {
    int32_t index[kReals];
    std::fill_n(index, kReals, triangle);
    const Real d;
    const Eights f(Narrow{}, ByIndex{reinterpret_cast<const float*>(canvas.job->vertices.data()), index});
    if (hn::AllFalse(d, is_fine(f, canvas.target))) return 1;
    const double area = hn::GetLane(Corners(f, canvas.target).area());
    return (area > 0) - (area < 0);
}

/// Triangles whose area's sign float32 does not tell, or with a number that is not finite: `doubt`, of those kept.
HWY_NOINLINE void look_again(uint32_t doubt, const Canvas& canvas, Looked& looked) {
    RasterCounters& counters = *canvas.counters;
    for (; doubt != 0; doubt &= doubt - 1) {
        const int lane = std::countr_zero(doubt), triangle = looked.index[lane];
        const auto drop = [&](std::uint64_t& counter) { ++counter, looked.keep &= ~(1U << lane); };
        if (is_refused(triangle, canvas)) {
            drop(counters.refused);
        } else {
            const int sign = sign_of_area(triangle, canvas);
            if (sign == 0 && canvas.settings->skip(RasterSkip::zero_area))
                drop(counters.of(RasterSkip::zero_area));
            else if (sign < 0 && canvas.job->cull_back && canvas.settings->skip(RasterSkip::back_face))
                drop(counters.of(RasterSkip::back_face));
        }
    }
}

/// Looks at triangles [first, first + kLook) and says which of them are to be drawn; none from `all` on.
template <bool kBoxes>
HWY_NOINLINE void look_at(int first, int all, const Canvas& canvas, Looked& looked) {
    const Look d;
    const RasterSettings& settings = *canvas.settings;
    hn::Store(lanes_from(LookInt{}, first), LookInt{}, looked.index);
    const auto floats_of = [&](int triangle) { return reinterpret_cast<const float*>(canvas.corners(triangle)); };
    const float* from = floats_of(first);
    float last[kLook * kTriangleFloats];
    if (first + kLook > all) {  // the last once more: nothing is read beyond it
        for (int n = 0; n < kLook; ++n)
            std::copy_n(floats_of(std::min(first + n, all - 1)), kTriangleFloats, last + n * kTriangleFloats);
        from = last;
    }
    const Fields<Look> f(d, InOrder{from});
    auto there = hn::FirstN(d, static_cast<size_t>(std::clamp(all - first, 0, kLook)));
    const auto drop = [&](RasterSkip skip, hn::Mask<Look> which) HWY_ATTR {
        if (!settings.skip(skip)) return;
        const auto dropped = hn::And(there, which);
        canvas.counters->of(skip) += hn::CountTrue(Look{}, dropped);
        there = hn::AndNot(which, there);
    };
    const Boxes box(f, canvas.target);
    drop(RasterSkip::off_screen, hn::Or(box.x.outside(canvas.target.width), box.y.outside(canvas.target.height)));
    drop(RasterSkip::no_sample, hn::Or(hn::Ge(box.x.first, box.x.beyond), hn::Ge(box.y.first, box.y.beyond)));
    const LooseArea loose(f);
    if (canvas.job->cull_back) drop(RasterSkip::back_face, hn::Lt(hn::Add(loose.area, loose.doubt), hn::Zero(d)));
    if constexpr (kBoxes) box.store(f, looked);
    looked.keep = bits_of(d, there);
    const auto sure = hn::Gt(hn::Abs(loose.area), loose.doubt);
    if (const auto doubt = hn::AndNot(sure, there); !hn::AllFalse(d, doubt))
        look_again(bits_of(d, doubt), canvas, looked);
}

/// What hidden triangles are told by, of those that were looked at before.
HWY_NOINLINE void find_boxes(const Canvas& canvas, Looked& looked) {
    const Fields<Look> f(Look{}, ByIndex{reinterpret_cast<const float*>(canvas.job->vertices.data()), looked.index});
    Boxes(f, canvas.target).store(f, looked);
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
