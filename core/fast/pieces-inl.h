// The pieces of a triangle that are drawn, from top to bottom: some rows at once. Where it is known what later
// triangles cover (core/fast/last_covers.h), these are cut to the tiles that none does.
#if defined(TEXELSCOPE_PIECES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_PIECES_INL
#undef TEXELSCOPE_PIECES_INL
#else
#define TEXELSCOPE_PIECES_INL
#endif

#include <algorithm>
#include <bit>

#include "core/fast/crossings-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// The target's rows [row, row + count), at most kRows, and columns [x0, x1) of them.
struct Piece {
    int row, count, x0, x1;
};

/// The rows of a piece. Returns whether any sample is inside.
HWY_INLINE bool cross(const Batch& b, int t, const Piece& piece, const Canvas& canvas, Rows& rows) {
    return cross(b, t, piece.row, piece.count, {piece.x0, piece.x1}, canvas, rows);
}

/// Of tiles from one on, which triangle `index` is to be drawn in: bit n, tile n, of at most LastCovers::kMost.
HWY_NOINLINE uint64_t uncovered(const LastCovers& covers, int row, int column, int count, int32_t index) {
    const PixelInt s;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(s));
    static_assert(kLanes <= LastCovers::kVector);
    const int32_t* const last = covers.from(row, column);
    uint64_t bits = 0;
    for (int n = 0; n < count; n += kLanes)
        bits |= uint64_t{bits_of(s, hn::Lt(hn::LoadU(s, last + n), hn::Set(s, index + 1)))} << n;
    return bits & (~uint64_t{0} >> (LastCovers::kMost - count));
}

/// Those of one triangle, one after another.
class Pieces {
    static constexpr int kWidthBits = LastCovers::kWidthBits, kMost = LastCovers::kMost;
    static_assert(LastCovers::kHeight == kRows);  // the rows of a piece lie in the same tiles

public:
    Pieces() = default;
    HWY_INLINE Pieces(const Batch& b, int t, const Canvas& canvas) : Pieces(b, t, canvas, b.row0.at[t]) {}
    /// @param row  the first
    HWY_INLINE Pieces(const Batch& b, int t, const Canvas& canvas, int row) { begin(b, t, canvas, row); }
    HWY_INLINE void begin(const Batch& b, int t, const Canvas& canvas, int row) {
        covers_ = canvas.covers, row_ = row;
        if (covers_ != nullptr) counters_ = canvas.counters, noted_ = false, go_to_strip(b, t, b.column0.at[t]);
    }

    /// The next piece; false: there are no more.
    HWY_INLINE bool next(const Batch& b, int t, Piece& piece) {
        if (HWY_UNLIKELY(covers_ != nullptr)) return next_run(b, t, piece);
        if (row_ >= b.row1.at[t]) return false;
        piece = {row_, std::min(kRows, b.row1.at[t] - row_), b.column0.at[t], b.column1.at[t]};
        row_ += piece.count;
        return true;
    }
    /// Only so many rows of `piece`, the last that next() gave, are drawn: the others are still to come.
    HWY_INLINE void give_back(const Piece& piece, int drawn) {
        if (drawn == piece.count) return;
        if (covers_ == nullptr)
            row_ = piece.row + drawn;
        else
            rest_ = {piece.row + drawn, piece.count - drawn, piece.x0, piece.x1};
    }
    /// next() will give the piece that begins there once more, and go on.
    HWY_INLINE void go_to(const Batch& b, int t, int row, int column) {
        row_ = row;
        if (covers_ != nullptr) go_to_strip(b, t, column);
    }

private:
    HWY_NOINLINE bool next_run(const Batch& b, int t, Piece& piece) {
        if (rest_.count > 0) {
            piece = rest_, rest_.count = 0;
            return true;
        }
        const int column0 = b.column0.at[t], column1 = b.column1.at[t], row1 = b.row1.at[t];
        while (runs_ == 0) {
            column_ += kMost;
            if (column_ << kWidthBits < column1) {
                look(b, t);
            } else {
                row_ += count_;
                if (row_ >= row1) return false;
                go_to_strip(b, t, column0);
            }
        }
        const int first = std::countr_zero(runs_), tiles = std::countr_one(runs_ >> first);
        runs_ &= tiles == kMost ? 0 : ~(((uint64_t{1} << tiles) - 1) << first);
        piece = {row_, count_, std::max(column0, (column_ + first) << kWidthBits),
                 std::min(column1, (column_ + first + tiles) << kWidthBits)};
        return true;
    }
    /// Goes to the rows from row_ on that lie in the same tiles, and there to the tile of `column`.
    HWY_NOINLINE void go_to_strip(const Batch& b, int t, int column) {
        count_ = std::clamp(b.row1.at[t] - row_, 0, kRows - row_ % kRows), column_ = column >> kWidthBits,
        rest_.count = 0;
        look(b, t);
    }
    /// Which tiles from column_ on are to be drawn.
    HWY_INLINE void look(const Batch& b, int t) {
        runs_ = 0;
        const int column1 = b.column1.at[t];
        if (count_ == 0 || column_ << kWidthBits >= column1) return;
        const int tiles = std::min(kMost, ((column1 - 1) >> kWidthBits) - column_ + 1);
        runs_ = uncovered(*covers_, row_ >> LastCovers::kHeightBits, column_, tiles, b.index.at[t]);
        if (noted_ || std::popcount(runs_) == tiles) return;
        noted_ = true, ++counters_->of(RasterSkip::overdrawn);
    }

    const LastCovers* covers_;
    int row_;
    // Where it is known what later triangles cover:
    int count_;      ///< rows from row_ on
    int column_;     ///< tile 0 of runs_
    uint64_t runs_;  ///< bit n: tile n is to be drawn, and has not been given
    Piece rest_;     ///< of the last piece that was given
    bool noted_;     ///< that something is left out
    RasterCounters* counters_;
};

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
