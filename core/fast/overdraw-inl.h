// Without a depth test later triangles are drawn over earlier ones: a first pass over all finds which tiles each covers
// whole, by where rows begin and end in the first and the last row of a tile. Triangles being convex, rows between
// begin no later and end no earlier than one of these two.
#if defined(TEXELSCOPE_OVERDRAW_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_OVERDRAW_INL
#undef TEXELSCOPE_OVERDRAW_INL
#else
#define TEXELSCOPE_OVERDRAW_INL
#endif

#include <algorithm>

#include "core/fast/crossings-inl.h"
#include "core/fast/pieces-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// Sets up what cross() asks for, of the triangles whose indices stand in `batch`. `good` asks for less than set_up()
/// does: what that refuses is drawn slowly, and covers as much.
HWY_NOINLINE void set_up_crossings(Batch& batch, const Canvas& canvas) {
    const Real d;
    const auto* const base = reinterpret_cast<const float*>(canvas.job->vertices.data());
    for (int lane = 0; lane < kBatch; lane += kReals) {
        const Eights f(Narrow{}, ByIndex{base, batch.index.at + lane});
        const Corners p(f, canvas.target);
        set_up_box(p, p.coarse(), canvas, batch, lane);
        const V area = p.area();
        set_up_sides(p, area, canvas, batch, lane);
        auto good = hn::And(has_finite_values(f), is_fine(f, canvas.target));
        if (canvas.job->perspective)
            good = hn::And(good, hn::Gt(least_of(promote(f.w[0]), promote(f.w[1]), promote(f.w[2])), hn::Zero(d)));
        const auto drawn = canvas.job->cull_back ? hn::Gt(area, hn::Zero(d)) : hn::Ne(area, hn::Zero(d));
        store_int(hn::IfThenElseZero(hn::And(good, drawn), hn::Set(d, 1.0)), batch.good.at + lane);
    }
}

/// Notes the tiles that triangle t of the batch covers. A tile that the target's right end cuts counts as it is; one
/// that its lower end cuts is left out: cross() knows no rows beyond.
HWY_NOINLINE void note_covered(const Batch& b, int t, const Canvas& canvas, LastCovers& covers) {
    constexpr int kHeight = LastCovers::kHeight, kHeightBits = LastCovers::kHeightBits;
    constexpr int kWidth = LastCovers::kWidth, kWidthBits = LastCovers::kWidthBits;
    const int end = b.row1.at[t] >> kHeightBits;  // rows of tiles
    for (int row = (b.row0.at[t] + kHeight - 1) >> kHeightBits; row < end; row += kRows) {
        Rows first, last;
        const int count = std::min(kRows, end - row), y = row << kHeightBits;
        const Columns columns{b.column0.at[t], b.column1.at[t]};
        cross<kHeight>(b, t, y, count, columns, canvas, first);
        cross<kHeight>(b, t, y + kHeight - 1, count, columns, canvas, last);
        for (int n = 0; n < count; ++n) {
            const int x0 = std::max(first.x0.at[n], last.x0.at[n]), x1 = std::min(first.x1.at[n], last.x1.at[n]);
            const int beyond = x1 == canvas.target.width ? kWidth - 1 : 0;
            const int left = (x0 + kWidth - 1) >> kWidthBits, right = (x1 + beyond) >> kWidthBits;
            if (left < right) covers.note(row + n, left, right, b.index.at[t]);
        }
    }
}

/// Whether later triangles cover all tiles that the triangle's box meets.
HWY_NOINLINE bool is_covered(int triangle, const PixelBox& box, const Canvas& canvas) {
    constexpr int kWidthBits = LastCovers::kWidthBits, kHeightBits = LastCovers::kHeightBits, kMost = LastCovers::kMost;
    if (box.x0 >= box.x1 || box.y0 >= box.y1) return false;
    const int end = ((box.x1 - 1) >> kWidthBits) + 1;
    for (int row = box.y0 >> kHeightBits; row <= (box.y1 - 1) >> kHeightBits; ++row)
        for (int column = box.x0 >> kWidthBits; column < end; column += kMost)
            if (uncovered(*canvas.covers, row, column, std::min(kMost, end - column), triangle) != 0) return false;
    ++canvas.counters->of(RasterSkip::overdrawn);
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
