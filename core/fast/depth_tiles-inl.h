// Wide affine triangles under a depth test, tile by tile of core/fast/tiles.h: what lies behind a tile's farthest depth
// is not looked at, and a tile that is covered whole is known to have come nearer.
#if defined(TEXELSCOPE_DEPTH_TILES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_DEPTH_TILES_INL
#undef TEXELSCOPE_DEPTH_TILES_INL
#else
#define TEXELSCOPE_DEPTH_TILES_INL
#endif

#include <algorithm>

#include "core/fast/fine-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// Between which depths a triangle stays.
class DepthBounds {
public:
    HWY_INLINE DepthBounds(const Batch& b, int t, const Canvas& canvas) : b_(b), t_(t) {
        const Vertex* const p = canvas.corners(b.index.at[t]);
        low_ = std::min({p[0].z, p[1].z, p[2].z}), high_ = std::max({p[0].z, p[1].z, p[2].z});
    }
    struct Range {
        double low, high;
    };
    /// Over those samples of the tile from (column, row) on that lie in the triangle's box, where z_unsure bounds the
    /// error of z. A depth is z rounded to float32: it stays between float32 numbers that are bounds of z.
    [[nodiscard]] HWY_INLINE Range over(int column, int row) const {
        constexpr int kLast = DepthTiles::kSide - 1;
        const int column0 = b_.column0.at[t_], row0 = b_.row0.at[t_];
        const auto ends = [](int from, int to, double step, double& low, double& high) HWY_ATTR {
            const double a = from * step, b = to * step;
            low += std::min(a, b), high += std::max(a, b);
        };
        const double at = b_.z.at.at[t_], unsure = 2 * b_.z_unsure.at[t_];
        double low = at, high = at;
        ends(std::max(column, column0) - column0, std::min(column + kLast, b_.column1.at[t_] - 1) - column0,
             b_.z.x.at[t_], low, high);
        ends(std::max(row, row0) - row0, std::min(row + kLast, b_.row1.at[t_] - 1) - row0, b_.z.y.at[t_], low, high);
        return {std::max(low - unsure, double{low_}), std::min(high + unsure, double{high_})};
    }

private:
    const Batch& b_;
    int t_;
    float low_, high_;  ///< of the corners
};

/// Where some rows begin and end.
struct Reach {
    int left = kMaxSize, right = 0;             ///< of all
    int last_left = 0, first_right = kMaxSize;  ///< between these all rows have samples
    int samples = 0;

    HWY_INLINE Reach(const Rows& rows, int count) {
        for (int n = 0; n < count; ++n) {
            const int x0 = rows.x0.at[n], x1 = std::max(x0, rows.x1.at[n]);
            left = std::min(left, x0), right = std::max(right, x1);
            last_left = std::max(last_left, x0), first_right = std::min(first_right, x1);
            samples += x1 - x0;
        }
    }
};

/// Columns [x0, x1) of some rows.
struct Run {
    int x0, x1;
};

/// The runs of tiles, in one row of them, in which a triangle is not known to be hidden.
class TileRuns {
public:
    /// Of rows [row, row + count), which lie in one row of tiles.
    HWY_INLINE TileRuns(const DepthBounds& bounds, int row, int count, const Rows& rows, const Canvas& canvas)
        : reach_(rows, count) {
        const int tile_y = row / kSide, left = reach_.left / kSide * kSide;
        if (!canvas.settings->skip(RasterSkip::hidden_tile)) {
            if (reach_.left < reach_.right) runs_[count_++] = {left, reach_.right};
            return;
        }
        const bool whole_rows = row % kSide == 0 && count == std::min(kSide, canvas.target.height - row);
        for (int x = left; x < reach_.right; x += kSide) {
            const DepthBounds::Range z = bounds.over(x, tile_y * kSide);
            if (canvas.tiles->hides(x / kSide, tile_y, z.low)) {
                dropped_ = true;
                continue;
            }
            if (count_ == 0 || runs_[count_ - 1].x1 < x) runs_[count_++].x0 = x;
            runs_[count_ - 1].x1 = x + kSide;
            // Known before it is so: until then nobody asks.
            if (whole_rows && reach_.last_left <= x && x + kSide <= reach_.first_right)
                canvas.tiles->note_covered(x / kSide, tile_y, static_cast<float>(z.high));
        }
    }
    [[nodiscard]] HWY_INLINE const Run* begin() const { return runs_; }
    [[nodiscard]] HWY_INLINE const Run* end() const { return runs_ + count_; }
    [[nodiscard]] bool dropped() const { return dropped_; }
    [[nodiscard]] int samples() const { return reach_.samples; }

private:
    static constexpr int kSide = DepthTiles::kSide;
    Reach reach_;
    Run runs_[kMaxSize / kSide / 2 + 1];
    int count_ = 0;
    bool dropped_ = false;
};

template <Addressing kAddressing>
HWY_NOINLINE void draw_depth_tiles(const Batch& b, int t, const Canvas& canvas) {
    const Pixel p;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    const Texels<Pixel, kAddressing> texels(canvas, b, t, certain_of(b, t));
    Again again(canvas, b, t, false);
    const DepthBounds bounds(b, t, canvas);
    const auto u_step = static_cast<uint32_t>(b.u.step.at[t]), v_step = static_cast<uint32_t>(b.v.step.at[t]);
    const auto lanes = hn::Iota(p, 0);
    const auto u_lanes = hn::Mul(hn::Set(p, u_step), lanes), v_lanes = hn::Mul(hn::Set(p, v_step), lanes);
    uint64_t samples = 0;
    bool dropped = false;
    for (int row = b.row0.at[t], count = 0; row < b.row1.at[t]; row += count) {
        Rows rows;
        count = std::min(DepthTiles::kSide - row % DepthTiles::kSide, b.row1.at[t] - row);
        cross(b, t, row, count, {b.column0.at[t], b.column1.at[t]}, canvas, rows);
        start(b, t, row, count, texels.u.bias, texels.v.bias, rows);
        const TileRuns runs(bounds, row, count, rows, canvas);
        samples += static_cast<uint64_t>(runs.samples());
        dropped = dropped || runs.dropped();
        for (int n = 0, y = row; n < count; ++n, ++y) {
            const DepthRow<Pixel> depth(b, t, y);
            for (const Run& run : runs) {
                const int end = std::min(rows.x1.at[n], run.x1);
                int x = std::max(rows.x0.at[n], run.x0);
                const auto steps = static_cast<uint32_t>(x - rows.x0.at[n]);
                auto u = hn::Add(hn::Set(p, static_cast<uint32_t>(rows.u.at[n]) + steps * u_step), u_lanes),
                     v = hn::Add(hn::Set(p, static_cast<uint32_t>(rows.v.at[n]) + steps * v_step), v_lanes);
                for (; x < end; x += kLanes) {
                    const auto in = hn::FirstN(p, static_cast<size_t>(end - x));
                    const auto shown = test_early(depth, x, y, in, again, canvas);
                    if (!hn::AllFalse(p, shown)) put_tested(p, texels, u, v, depth, x, y, shown, again, canvas);
                    u = hn::Add(u, hn::Set(p, kLanes * u_step)), v = hn::Add(v, hn::Set(p, kLanes * v_step));
                }
            }
        }
        if (!again.often(row + count - b.row0.at[t])) continue;
        Pieces rest(b, t, canvas, row + count);
        if (draw_finely<false, kAddressing, true>(b, t, rest, again, canvas, samples)) break;
    }
    canvas.counters->samples += samples;
    if (dropped) ++canvas.counters->of(RasterSkip::hidden_tile);
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
