// All triangles of a job: a cheap pass drops what need not be drawn, the rest is set up eight at a time and drawn in
// order. Immediately, not by bins: on one thread that was faster for every size of triangle. Where threads draw bands
// of rows, they first do the cheap pass together and note whose triangles are whose.
#if defined(TEXELSCOPE_TRIANGLES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_TRIANGLES_INL
#undef TEXELSCOPE_TRIANGLES_INL
#else
#define TEXELSCOPE_TRIANGLES_INL
#endif

#include <algorithm>
#include <bit>

#include <hwy/cache_control.h>

#include "core/fast/affine-inl.h"
#include "core/fast/block_batch-inl.h"
#include "core/fast/depth_tiles-inl.h"
#include "core/fast/dispatch.h"
#include "core/fast/look-inl.h"
#include "core/fast/overdraw-inl.h"
#include "core/fast/perspective-inl.h"
#include "core/fast/small-inl.h"
#include "core/fast/tiny-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// Rows up to these are drawn side by side, or 8 pixels at once: measured [px].
constexpr int kNarrow = 8, kMedium = 24;

/// Every sample by the exact triangle: for coordinates whose differences double does not hold.
HWY_NOINLINE void draw_slowly(int triangle, const Canvas& canvas) {
    const RasterTarget& target = canvas.target;
    if (is_refused(triangle, canvas)) return void(++canvas.counters->refused);
    ++canvas.counters->slow;
    Decider decider(canvas, triangle);
    const int winding = decider.exact().winding();
    if (winding == 0 || (canvas.job->cull_back && winding < 0)) return;
    const Vertex* const p = canvas.corners(triangle);
    const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
    const auto row = [&](float y) {
        const double inside = static_cast<double>(y) - target.y0;
        return static_cast<int>(std::clamp(inside, 0.0, static_cast<double>(target.height)));
    };
    for (int y = row(std::floor(low) - 1); y < row(std::ceil(high) + 1); ++y) {
        const Integer left = target.x0;
        const PixelRange range = decider.exact().row(Integer{y} + target.y0, left, left + target.width);
        for (Integer column = range.x0; column < range.x1; ++column) {
            const auto x = static_cast<int>(column - left);
            ++canvas.counters->samples;
            if (canvas.job->depth) {
                float& nearest = target.depth[y * target.pitch + x];
                const float z = decider.depth(x, y);
                if (!(z < nearest)) continue;
                nearest = z;
            }
            target.pixels[y * target.pitch + x] = canvas.texture.texels[decider.texel(x, y)];
        }
    }
}

/// Narrow vectors only where they are met most: each width is compiled anew.
template <Addressing kAddressing, bool kDepth, bool kCertain>
HWY_INLINE void draw_triangle(const Batch& b, int t, const Canvas& canvas) {
    if (b.one_texel.at[t] != 0) return fill_rows<kDepth>(b, t, canvas);
    constexpr bool kMost = kAddressing == Addressing::powers;
    const hn::ScalableTag<uint32_t> wide;
    const hn::CappedTag<uint32_t, kMost ? 8 : hn::MaxLanes(wide)> medium;
    if constexpr (kMost)
        if (!canvas.job->perspective && b.small.at[t] != 0) {
            if constexpr (!kDepth)
                if (b.tiny.at[t] != 0 && draw_tiny<kAddressing>(b, t, canvas)) return;
            if (draw_small<kAddressing, kDepth>(b, t, canvas)) return;
        }
    const int widest = b.widest.at[t];
    if (canvas.job->perspective && (b.flat.at[t] == 0 || !canvas.settings->skip(RasterSkip::equal_w))) {
        Pieces pieces(b, t, canvas);
        if (widest <= kMedium && draw_perspective<true, kAddressing, kDepth, kCertain>(medium, b, t, canvas, pieces))
            return;
#if HWY_TARGET == HWY_AVX2
        if constexpr (kMost && !kDepth)
            if (b.one.x.at[t] != 0 && fits_halves(canvas))
                return void(draw_perspective<false, Addressing::halves, false, kCertain>(wide, b, t, canvas, pieces));
#endif
        return void(draw_perspective<false, kAddressing, kDepth, kCertain>(wide, b, t, canvas, pieces));
    }
    if (canvas.job->perspective) ++canvas.counters->of(RasterSkip::equal_w);
    if constexpr (kMost && !kDepth)
        if (widest <= kNarrow) return draw_columns<kAddressing, kCertain>(b, t, canvas);
    if (widest <= kMedium) return draw_rows<false, kAddressing, kDepth, kCertain>(medium, b, t, canvas);
    if constexpr (kDepth)
        draw_depth_tiles<kAddressing>(b, t, canvas);
    else
        draw_rows<true, kAddressing, kDepth, kCertain>(wide, b, t, canvas);
}

/// Sets up the triangles that wait and draws them.
template <Addressing kAddressing, bool kDepth, bool kCertain>
HWY_INLINE void flush(Batch& batch, int& count, const Canvas& canvas) {
    if (count == 0) return;
    for (int n = count; n < kBatch; ++n) batch.index.at[n] = batch.index.at[0];
    set_up(batch, canvas);
    Blocked<kAddressing == Addressing::powers && !kDepth> blocks(batch, count, canvas);
    for (int t = 0; t < count; ++t) {
        ++canvas.counters->drawn;
        // Culled only here where the skip is off: it costs what it costs, and shows nothing.
        if (canvas.job->cull_back && batch.good.at[t] != 0 && batch.front.at[t] == 0) continue;
        if (RasterWatch* const watch = canvas.settings->watch)
            watch->u_doubt = batch.u.doubt.at[t] / texel_units(canvas, batch.u, t, canvas.texture.width),
            watch->v_doubt = batch.v.doubt.at[t] / texel_units(canvas, batch.v, t, canvas.texture.height);
        if (blocks.has(t))
            blocks.template draw<kCertain>(batch, t, canvas);
        else if (batch.good.at[t] != 0)
            draw_triangle<kAddressing, kDepth, kCertain>(batch, t, canvas);
        else
            draw_slowly(batch.index.at[t], canvas);
        if constexpr (kDepth) {
            if (batch.good.at[t] != 0)
                canvas.counters->of(RasterSkip::level_z) += static_cast<uint64_t>(batch.level_z.at[t]);
            PixelBox box{batch.column0.at[t], batch.row0.at[t], batch.column1.at[t], batch.row1.at[t]};
            if (batch.good.at[t] == 0) box = {0, 0, canvas.target.width, canvas.target.height};
            if (box.x0 < box.x1 && box.y0 < box.y1) canvas.tiles->touch(box);
        }
    }
    count = 0;
}

/// Looks at triangles [first, last), which begin and end a block, and notes the strips of those to be drawn.
HWY_ATTR void sort_out(const Canvas& canvas, int first, int last, const Strips& strips) {
    const LookInt i;
    const hn::Rebind<int8_t, LookInt> byte;
    const int all = canvas.triangles(), rows = canvas.target.height;
    for (; first < last; first += kLook) {
        fetch_vertices(canvas, first);
        Looked looked;
        look_at<true>(first, all, canvas, looked);
        const uint8_t bytes[8] = {static_cast<uint8_t>(looked.keep), static_cast<uint8_t>(looked.keep >> 8)};
        const auto keep = hn::LoadMaskBits(i, bytes);
        // Where triangles between samples are not dropped, they have one row all the same.
        const auto r0 = hn::Min(hn::Load(i, looked.row0), hn::Set(i, rows - 1));
        const auto r1 = hn::Max(hn::Sub(hn::Load(i, looked.row1), hn::Set(i, 1)), r0);
        const auto s0 = hn::ShiftRightSame(r0, strips.shift), s1 = hn::ShiftRightSame(r1, strips.shift);
        hn::StoreU(hn::DemoteTo(byte, hn::IfThenElse(keep, s0, hn::Set(i, Strips::kMost))), byte, &strips.first[first]);
        hn::StoreU(hn::DemoteTo(byte, hn::IfThenElseZero(keep, s1)), byte, &strips.last[first]);
    }
}

/// Bit n: whether triangle first + n is to be drawn in the band.
HWY_INLINE uint64_t find_own(const Band& band, int first) {
    const hn::CappedTag<int8_t, Strips::kBlock> d;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(d));
    const auto begin = hn::Set(d, static_cast<int8_t>(band.begin)), end = hn::Set(d, static_cast<int8_t>(band.end));
    uint64_t own = 0;
    for (int n = 0; n < Strips::kBlock; n += kLanes) {
        const auto s0 = hn::LoadU(d, &band.strips->first[first + n]), s1 = hn::LoadU(d, &band.strips->last[first + n]);
        uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, hn::AndNot(hn::Lt(s1, begin), hn::Lt(s0, end)), bytes);
        uint64_t bits = 0;
        std::memcpy(&bits, bytes, 8);
        own |= bits << n;
    }
    return own;
}

/// The triangles to be drawn, in order, some at a time: of all of them, or of a band.
class Queue {
public:
    /// @param boxes  whether anybody asks where triangles are
    HWY_INLINE Queue(const Canvas& canvas, bool boxes) : canvas_(canvas), boxes_(boxes), all_(canvas.triangles()) {
        if (canvas.band == nullptr) return;
        for (int32_t& triangle : ahead_) triangle = find_next();
    }

    /// False: there are no more.
    HWY_INLINE bool next(Looked& looked) {
        if (canvas_.band != nullptr) return next_of_band(looked);
        if (first_ >= all_) return false;
        fetch_vertices(canvas_, first_);
        if (boxes_)
            look_at<true>(first_, all_, canvas_, looked);
        else
            look_at<false>(first_, all_, canvas_, looked);
        first_ += kLook;
        return true;
    }

private:
    HWY_INLINE bool next_of_band(Looked& looked) {
        int count = 0;
        for (int32_t* next; count < kLook && *(next = &ahead_[taken_ % kAhead]) != kNone; ++count, ++taken_) {
            looked.index[count] = *next;
            *next = find_next();
        }
        if (count == 0) return false;
        looked.keep = (1U << count) - 1;
        for (; count < kLook; ++count) looked.index[count] = looked.index[0];
        if (boxes_) find_boxes(canvas_, looked);
        return true;
    }

    /// The band's triangle after those found before, or kNone. Its corners are fetched: they may be far from the
    /// last's.
    HWY_INLINE int find_next() {
        const Band& band = *canvas_.band;
        for (; own_ == 0; first_ += Strips::kBlock) {
            if (first_ >= band.strips->bytes) return kNone;
            own_ = find_own(band, first_);
        }
        const int triangle = first_ - Strips::kBlock + std::countr_zero(own_);
        own_ &= own_ - 1;
        const auto* const corners = reinterpret_cast<const char*>(canvas_.corners(triangle));
        hwy::Prefetch(corners), hwy::Prefetch(corners + 3 * sizeof(Vertex) - 1);
        return triangle;
    }

    static constexpr int kNone = -1;
    static constexpr unsigned kAhead = 32;

    const Canvas& canvas_;
    bool boxes_;
    int all_;
    int first_ = 0;          ///< not looked at yet
    uint64_t own_ = 0;       ///< bit n: triangle n of the block before that is the band's and not yet found
    int32_t ahead_[kAhead];  ///< a ring of those found and not yet taken
    unsigned taken_ = 0;
};

/// Finds the covers of the canvas.
HWY_ATTR void find_covers(const Canvas& canvas, LastCovers& covers) {
    RasterCounters uncounted;  // what is left out: that is for those who draw
    Canvas looking = canvas;
    looking.counters = &uncounted;
    Queue queue(looking, false);
    Batch batch;
    Looked looked;
    int waiting = 0;
    const auto flush = [&]() HWY_ATTR {
        for (int n = waiting; n < kBatch; ++n) batch.index.at[n] = batch.index.at[0];
        set_up_crossings(batch, looking);
        for (int t = 0; t < waiting; ++t)
            if (batch.good.at[t] != 0) note_covered(batch, t, looking, covers);
        waiting = 0;
    };
    while (queue.next(looked))
        for (uint32_t mask = looked.keep; mask != 0; mask &= mask - 1) {
            batch.index.at[waiting++] = looked.index[std::countr_zero(mask)];
            if (waiting == kBatch) flush();
        }
    if (waiting > 0) flush();
}

[[nodiscard]] HWY_INLINE PixelBox box_of(const Looked& looked, int lane) {
    return {looked.column0[lane], looked.row0[lane], looked.column1[lane], looked.row1[lane]};
}

/// Whether all that the triangle could draw is hidden.
HWY_INLINE bool is_hidden(const Looked& looked, int lane, const Canvas& canvas) {
    if (!canvas.settings->skip(RasterSkip::hidden)) return false;
    const PixelBox box = box_of(looked, lane);
    if (box.x0 >= box.x1 || box.y0 >= box.y1 || !canvas.tiles->hides(box, looked.nearest[lane])) return false;
    ++canvas.counters->of(RasterSkip::hidden);
    return true;
}

/// Drops those that the tiles which they meet, as they are known, hide: small ones, which meet four at most.
HWY_INLINE void drop_hidden(const Canvas& canvas, Looked& looked) {
    const Look f;
    const LookInt i;
    if (!canvas.settings->skip(RasterSkip::hidden)) return;
    const auto load = [](const int32_t(&a)[kLook]) HWY_ATTR { return hn::Load(LookInt{}, a); };
    const auto x0 = load(looked.column0), x1 = load(looked.column1), y0 = load(looked.row0), y1 = load(looked.row1);
    const auto some = hn::And(hn::Lt(x0, x1), hn::Lt(y0, y1));
    const auto one = hn::Set(i, 1);
    const auto tile = [&](hn::Vec<LookInt> pixel)
                          HWY_ATTR { return hn::IfThenElseZero(some, hn::ShiftRight<DepthTiles::kBits>(pixel)); };
    const auto left = tile(x0), right = tile(hn::Sub(x1, one)), top = tile(y0), bottom = tile(hn::Sub(y1, one));
    const auto two = hn::Set(i, 2);
    const auto small = hn::And(hn::Lt(hn::Sub(right, left), two), hn::Lt(hn::Sub(bottom, top), two));
    const auto pitch = hn::Set(i, canvas.tiles->columns());
    const auto far = hn::GatherIndex(f, canvas.tiles->farthest_of_four(), hn::Add(hn::Mul(top, pitch), left));
    const auto behind = hn::Ge(hn::Load(f, looked.nearest), far);
    const uint32_t hidden = looked.keep & bits_of(f, behind) & bits_of(i, hn::And(some, small));
    looked.keep &= ~hidden, canvas.counters->of(RasterSkip::hidden) += static_cast<uint64_t>(std::popcount(hidden));
}

/// Fetches what a small triangle will be drawn over: before it is set up, others are looked at.
HWY_INLINE void fetch_ahead(const Looked& looked, int lane, const Canvas& canvas) {
    constexpr int kMostRows = 16;
    const int row0 = looked.row0[lane], row1 = std::min(looked.row1[lane], row0 + kMostRows);
    // Vectors under a mask touch the lines of all of their lanes.
    const int width = std::max(looked.column1[lane] - looked.column0[lane], 8) - 1;
    std::ptrdiff_t at = row0 * canvas.target.pitch + looked.column0[lane];
    for (int row = row0; row < row1; ++row, at += canvas.target.pitch) {
        hwy::Prefetch(canvas.target.depth + at), hwy::Prefetch(canvas.target.depth + at + width);
        hwy::Prefetch(canvas.target.pixels + at), hwy::Prefetch(canvas.target.pixels + at + width);
    }
}

template <Addressing kAddressing, bool kDepth, bool kCertain>
HWY_INLINE void draw_triangles(const Canvas& canvas) {
    const bool covered = !kDepth && canvas.covers != nullptr;
    Queue queue(canvas, kDepth || covered);
    Batch batch;
    Looked looked;
    int waiting = 0;
    while (queue.next(looked)) {
        if constexpr (kDepth) drop_hidden(canvas, looked);
        for (uint32_t mask = looked.keep; mask != 0; mask &= mask - 1) {
            const int lane = std::countr_zero(mask);
            if (kDepth && is_hidden(looked, lane, canvas)) continue;
            if (covered && is_covered(looked.index[lane], box_of(looked, lane), canvas)) continue;
            if constexpr (kDepth) fetch_ahead(looked, lane, canvas);
            batch.index.at[waiting++] = looked.index[lane];
            if (waiting == kBatch) flush<kAddressing, kDepth, kCertain>(batch, waiting, canvas);
        }
    }
    flush<kAddressing, kDepth, kCertain>(batch, waiting, canvas);
}

template <Addressing kAddressing>
HWY_INLINE void draw_addressed(const Canvas& canvas) {
    if (canvas.job->depth) return draw_triangles<kAddressing, true, true>(canvas);
    if constexpr (kAddressing == Addressing::powers)
        if (!canvas.settings->certain) return draw_triangles<kAddressing, false, false>(canvas);
    draw_triangles<kAddressing, false, true>(canvas);
}

HWY_ATTR void draw_all(const Canvas& canvas) {
    switch (canvas.addressing) {
        case Addressing::powers: {
            if constexpr (HWY_TARGET != HWY_SCALAR) return draw_addressed<Addressing::powers>(canvas);
            Canvas plain = canvas;  // without lanes there are no blocks of samples
            plain.addressing = Addressing::any_size;
            return draw_addressed<Addressing::any_size>(plain);
        }
        case Addressing::any_size: return draw_addressed<Addressing::any_size>(canvas);
        case Addressing::clamped: return draw_addressed<Addressing::clamped>(canvas);
        case Addressing::halves: return;  // no canvas's own
    }
}

const RegisterTarget kRegistered(HWY_TARGET, {draw_all, sort_out, find_covers});

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
