// Which triangles of a batch are drawn by blocks (blocks-inl.h), and how: the first blocks of each are found before any
// is drawn, so that to draw them need not wait.
#if defined(TEXELSCOPE_BLOCK_BATCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_BLOCK_BATCH_INL
#undef TEXELSCOPE_BLOCK_BATCH_INL
#else
#define TEXELSCOPE_BLOCK_BATCH_INL
#endif

#include <bit>
#include <type_traits>
#include <utility>

#include "core/fast/affine_blocks-inl.h"
#include "core/fast/past_ties-inl.h"
#include "core/fast/perspective-inl.h"
#include "core/fast/perspective_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

#if HWY_TARGET <= HWY_AVX3

/// Bit t: of triangle t blocks are faster than rows. Of a block that no more than a third of is inside, rows store
/// less.
template <class Kind>
HWY_INLINE uint32_t by_blocks(const Batch& b, const Canvas& canvas) {
    const Real d;
    const V widest = load_int(b.widest);
    const V samples = hn::Mul(widest, hn::Sub(load_int(b.row1), load_int(b.row0)));
    const V least = hn::Mul(hn::Sub(load_int(b.column1), load_int(b.column0)), hn::Set(d, double{kBlock}));
    const auto wide = hn::And(hn::Ge(widest, hn::Set(d, double{kLeastWide})), hn::Ge(samples, least));
    return bits_of(d, hn::And(wide, Kind::serves(b, canvas)));
}

/// The unsure texels of some blocks. Returns as mend() does; false with `only_double` also where the rows so far have
/// so many that the triangle had better be drawn otherwise.
template <class Kind>
HWY_NOINLINE bool blocks_again(const typename Kind::Found& found, const Kind& kind, Again& again, bool only_double,
                               int rows, const Canvas& canvas) {
    const auto pitch = static_cast<uint32_t>(canvas.target.pitch);
    const uint32_t blocks = (found.parts | found.wholes) & ~found.beyond;
    uint32_t asked[kBlocks];
    int all = 0;
    for (uint32_t which = blocks; which != 0; which &= which - 1) {
        const int n = std::countr_zero(which);
        asked[n] = found.inside[n] & kind.unsure(found, n);
        all += std::popcount(asked[n]);
    }
    if (only_double && again.often(rows, all)) return false;
    for (uint32_t which = blocks; which != 0; which &= which - 1) {
        const int n = std::countr_zero(which);
        for (uint32_t samples = asked[n]; samples != 0; samples &= samples - 1) {
            const int sample = std::countr_zero(samples);
            const int x = static_cast<int>(found.out[n] % pitch) + sample % kBlock;
            const int y = found.row + static_cast<int>(found.out[n] / pitch) + sample / kBlock;
            if (!mend_pixel(again, x, y, only_double, canvas)) return false;
        }
    }
    return true;
}

/// A triangle by blocks, the first of which are found.
template <class Kind>
struct BlockDrawing {
    Kind kind;
    BlockWindows<Kind> windows;
    typename Kind::Found first;
    bool more;  ///< there are such
};

/// Whether rows are faster: float32 cannot tell most of the blocks.
template <class Found>
[[nodiscard]] HWY_INLINE bool is_beyond(const Found& found) {
    return std::popcount(found.beyond) * 2 > std::popcount(found.parts | found.wholes);
}

/// The window's piece is drawn once more. It is a whole strip: where somebody watches, nobody looks for covers.
HWY_NOINLINE void forget_piece(const Batch& b, int t, const Window& window, const Canvas& canvas) {
    if (canvas.settings->watch == nullptr) return;
    Pieces pieces(b, t, canvas, window.row);
    Piece piece;
    Rows rows;
    if (!pieces.next(b, t, piece)) return;
    cross(b, t, piece, canvas, rows);
    forget(canvas, piece.row, piece.count, rows);
}

/// False: some texels are unsure.
template <bool kCertain, class Kind>
HWY_INLINE bool put_near(const typename Kind::Found& found, uint32_t which, const Kind& kind, const Canvas& canvas) {
    const bool parts = kind.template put<false, kCertain>(found, found.parts & which, canvas);
    if ((found.wholes & which) == 0) return parts;
    return kind.template put<true, kCertain>(found, found.wholes & which, canvas) && parts;
}

template <bool kCertain>
HWY_NOINLINE void draw_blocks(const Batch& b, int t, const Canvas& canvas, BlockDrawing<AffineBlocks>& drawing) {
    Again again(canvas, b, t, false);
    bool ties_known = false;
    uint64_t samples = 0;
    AffineBlocks::Found other;
    AffineBlocks& kind = drawing.kind;
    auto *now = &drawing.first, *next = &other;
    for (bool more = drawing.more; more; std::swap(now, next)) {
        more = drawing.windows.next(b, t, canvas, kind, *next);
        if (put_near<kCertain>(*now, ~0U, kind, canvas) || !kCertain ||
            blocks_again(*now, kind, again, !ties_known, now->row + kRows - b.row0.at[t], canvas)) {
            samples += now->samples;
            continue;
        }
        // As in draw_rows: this piece once more, past all ties.
        kind.use(b, t, canvas, again.half_gaps());
        ties_known = true;
        forget_piece(b, t, *now, canvas);
        drawing.windows.go_to(b, t, *now);
        Pieces& pieces = drawing.windows.pieces();
        if (!kind.sure() && draw_finely<false, Addressing::powers, false>(b, t, pieces, again, canvas, samples)) break;
        more = drawing.windows.next(b, t, canvas, kind, *next);
    }
    canvas.counters->samples += samples, ++canvas.counters->by_blocks;
}

/// One window. Returns as mend() does.
template <bool kCertain>
HWY_INLINE bool put_window(const Batch& b, int t, const PerspectiveBlocks::Found& found, const PerspectiveBlocks& kind,
                           Again& again, bool only_double, const Canvas& canvas) {
    const uint32_t near = ~(found.far | found.beyond);
    bool sure = found.far == 0 || kind.put_far<kCertain>(found, found.far, canvas);
    sure = put_near<kCertain>(found, near, kind, canvas) && sure;
    const int rows = found.row + kRows - b.row0.at[t];
    if (!sure && kCertain && !blocks_again(found, kind, again, only_double, rows, canvas)) return false;
    return found.beyond == 0 || kind.put_in_double(b, t, found, found.beyond, again, only_double, canvas);
}

template <bool kCertain>
HWY_NOINLINE void draw_blocks(const Batch& b, int t, const Canvas& canvas, BlockDrawing<PerspectiveBlocks>& drawing,
                              PastTies& past_ties) {
    Again again(canvas, b, t, true);
    uint64_t samples = 0;
    PerspectiveBlocks::Found other;
    PerspectiveBlocks& kind = drawing.kind;
    past_ties.begin();
    auto *now = &drawing.first, *next = &other;
    for (bool more = drawing.more; more; std::swap(now, next)) {
        if (is_beyond(*now)) {
            forget_piece(b, t, *now, canvas);
            drawing.windows.go_to(b, t, *now);
            draw_perspective<false, Addressing::powers, false, kCertain>(Pixel{}, b, t, canvas,
                                                                         drawing.windows.pieces());
            break;
        }
        more = drawing.windows.next(b, t, canvas, kind, *next);
        const bool known = past_ties.known(), finely = kCertain && known && !kind.sure();
        if (finely || !put_window<kCertain>(b, t, *now, kind, again, !known, canvas))
            past_ties.put(b, t, *now, kind, again, canvas);
        samples += now->samples;
    }
    if (past_ties.known()) past_ties.finish(b, t, kind, again, canvas);
    canvas.counters->samples += samples, ++canvas.counters->by_blocks;
}

/// The triangles of a batch that are drawn by blocks of one kind.
template <class Kind>
class BlockDrawings {
public:
    /// Those of `which` that are.
    HWY_NOINLINE uint32_t find(const Batch& b, uint32_t which, const Canvas& canvas) {
        which &= by_blocks<Kind>(b, canvas);
        if (which == 0) return 0;
        // One step of all after another: each is a chain of few instructions that wait for each other.
        const auto each = [&](auto&& step) HWY_ATTR {
            for (uint32_t m = which; m != 0; m &= m - 1) step(std::countr_zero(m));
        };
        all_.set_up(b, canvas);
        each([&](int t) HWY_ATTR { at_[t].kind.set_up(t, canvas, all_); });
        Rows rows[kBatch];
        Piece first[kBatch];
        each([&](int t) HWY_ATTR { first[t] = at_[t].windows.begin(b, t, canvas); });
        each([&](int t) HWY_ATTR { cross(b, t, first[t], canvas, rows[t]); });
        each([&](int t) HWY_ATTR { at_[t].windows.start(b, t, canvas, at_[t].kind, first[t], rows[t]); });
        each([&](int t) HWY_ATTR {
            BlockDrawing<Kind>& d = at_[t];
            d.more = d.windows.next(b, t, canvas, d.kind, d.first);
            if (d.more && is_beyond(d.first)) which &= ~(1U << t);
        });
        return which;
    }
    [[nodiscard]] HWY_INLINE BlockDrawing<Kind>& at(int t) { return at_[t]; }

private:
    typename Kind::Eights all_;
    BlockDrawing<Kind> at_[kBatch];
};

/// Which triangles of a batch are drawn by blocks.
class BlockBatch {
public:
    HWY_INLINE BlockBatch(const Batch& b, int count, const Canvas& canvas) {
        if (canvas.texture.apron < kTexelApron) return;
        const uint32_t there = (1U << count) - 1;
        const auto bits = [&](const EightInt& flags) HWY_ATTR {
            const hn::CappedTag<int32_t, kBatch> s;
            return bits_of(s, hn::Ne(hn::Load(s, flags.at), hn::Zero(s)));
        };
        uint32_t shown = there & bits(b.good) & ~bits(b.one_texel);
        if (canvas.job->cull_back) shown &= bits(b.front);
        uint32_t affine = 0;
        if (!canvas.job->perspective)
            affine = ~bits(b.small);
        else if (canvas.settings->skip(RasterSkip::equal_w))
            affine = bits(b.flat);
        const uint32_t perspective = canvas.job->perspective ? shown & ~affine : 0;
        if ((shown & affine) != 0) affine_ = affine_drawings_.find(b, shown & affine, canvas);
        if (perspective != 0) perspective_ = perspective_drawings_.find(b, perspective, canvas);
    }
    [[nodiscard]] HWY_INLINE bool has(int t) const { return ((affine_ | perspective_) >> t & 1) != 0; }
    template <bool kCertain>
    HWY_INLINE void draw(const Batch& b, int t, const Canvas& canvas) {
        if ((perspective_ >> t & 1) != 0)
            return draw_blocks<kCertain>(b, t, canvas, perspective_drawings_.at(t), past_ties_);
        if (canvas.job->perspective) ++canvas.counters->of(RasterSkip::equal_w);
        draw_blocks<kCertain>(b, t, canvas, affine_drawings_.at(t));
    }

private:
    uint32_t affine_ = 0, perspective_ = 0;
    BlockDrawings<AffineBlocks> affine_drawings_;
    BlockDrawings<PerspectiveBlocks> perspective_drawings_;
    PastTies past_ties_;
};

#endif

/// None.
struct NoBlockBatch {
    HWY_INLINE NoBlockBatch(const Batch& /*b*/, int /*count*/, const Canvas& /*canvas*/) {}
    [[nodiscard]] static HWY_INLINE bool has(int /*t*/) { return false; }
    template <bool kCertain>
    static HWY_INLINE void draw(const Batch& /*b*/, int /*t*/, const Canvas& /*canvas*/) {}
};

#if HWY_TARGET <= HWY_AVX3
template <bool kSome>
using Blocked = std::conditional_t<kSome, BlockBatch, NoBlockBatch>;
#else
template <bool kSome>
using Blocked = NoBlockBatch;
#endif

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
