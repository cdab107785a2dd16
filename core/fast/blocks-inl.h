// Triangles by blocks of 4 x 4 samples (patches-inl.h), where rows would load texels one by one. Which samples are
// inside is found for 32 blocks at once: a window of four strips of four rows, eight blocks each. What blocks show is
// found by affine_blocks-inl.h and perspective_blocks-inl.h.
#if defined(TEXELSCOPE_BLOCKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_BLOCKS_INL
#undef TEXELSCOPE_BLOCKS_INL
#else
#define TEXELSCOPE_BLOCKS_INL
#endif

#include <algorithm>

#include "core/fast/fine-inl.h"
#include "core/fast/patches-inl.h"
#include "core/fast/pieces-inl.h"

#if HWY_TARGET <= HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// A window has two halves, side by side: in each four blocks of each strip.
constexpr int kHalf = 16, kBlocks = 2 * kHalf;
constexpr int kHalfWidth = 4 * kBlock, kWindowWidth = 2 * kHalfWidth;  ///< [px]

/// No row of fewer samples is drawn by blocks, and where it has fewer than these, no block is expected to be whole:
/// measured [px].
constexpr int kLeastWide = 9, kLeastWhole = 56;

/// Units in a texel of a texture that has 2^bits of them.
HWY_INLINE double units_in_texel(int bits) { return static_cast<double>(int64_t{1} << (32 - bits)); }

using BlockInt = hn::Rebind<int32_t, Block>;
using BlockBytes = hn::Repartition<uint8_t, Block>;
using RowNumbers = hn::Vec<BlockInt>;  ///< of each of kRows rows

/// Where a lane stands among four, and which four these are.
HWY_INLINE Samples place_of_lane() { return hn::And(hn::Iota(Block{}, 0), hn::Set(Block{}, kBlock - 1)); }
HWY_INLINE Samples four_of_lane() { return hn::ShiftRight<2>(hn::Iota(Block{}, 0)); }

/// The low 32 bits of whole numbers.
HWY_INLINE Samples low_bits_of(V low, V high) {
    const hn::Half<Block> half;
    const hn::Repartition<uint64_t, Real> bits;
    return hn::Combine(Block{}, hn::TruncateTo(half, hn::BitCast(bits, high)),
                       hn::TruncateTo(half, hn::BitCast(bits, low)));
}
/// Two vectors of double, for sixteen lanes.
struct Doubles {
    V low, high;
};
HWY_INLINE Doubles promote(Samples a) {
    const hn::Half<BlockInt> half;
    const auto s = hn::BitCast(BlockInt{}, a);
    return {hn::PromoteTo(Real{}, hn::LowerHalf(half, s)), hn::PromoteTo(Real{}, hn::UpperHalf(half, s))};
}

HWY_INLINE Doubles moved(const Doubles& a, double by) {
    const V step = hn::Set(Real{}, by);
    return {hn::Add(a.low, step), hn::Add(a.high, step)};
}

/// Which blocks of a window are to be drawn: those of the left half, strip by strip, then those of the right one.
struct Window {
    alignas(64) uint32_t out[kBlocks];     ///< the first pixel, from the first of `row`
    alignas(64) uint16_t inside[kBlocks];  ///< bit n: sample n is
    uint32_t parts, wholes;                ///< bit n: block n has some samples inside; is drawn as a whole
    int row, column;                       ///< where its piece begins
    uint32_t samples;                      ///< of the piece if these are its last blocks, else 0
};

/// All blocks of a triangle, one window after another. What they show is for the Kind to find.
template <class Kind>
class BlockWindows {
public:
    /// Returns the first piece; where there is none, no rows.
    HWY_INLINE Piece begin(const Batch& b, int t, const Canvas& canvas) {
        pieces_.begin(b, t, canvas, b.row0.at[t]);
        Piece first;
        return pieces_.next(b, t, first) ? first : Piece{b.row0.at[t], 0, 0, 0};
    }
    /// Goes to the blocks of a piece, whose rows are these.
    HWY_INLINE void start(const Batch& b, int t, const Canvas& canvas, Kind& kind, const Piece& piece,
                          const Rows& rows) {
        const Block p;
        const BlockInt s;
        const int row = piece.row, count = piece.count;
        row_ = row, column_ = piece.x0;
        const auto x0 = load(rows.x0), x1 = load(rows.x1);
        const auto there = hn::And(hn::Lt(x0, x1), hn::FirstN(s, static_cast<size_t>(count)));
        auto left = hn::IfThenElse(there, x0, hn::Set(s, INT32_MAX));
        left = hn::Min(left, hn::Shuffle2301(left)), left = hn::Min(left, hn::Shuffle1032(left));
        first_ = hn::IfThenElseZero(there, hn::Sub(x0, left)), end_ = hn::IfThenElseZero(there, hn::Sub(x1, left));
        columns_ = hn::GetLane(hn::MaxOfLanes(s, end_));
        samples_ = static_cast<uint32_t>(hn::GetLane(hn::SumOfLanes(s, hn::Sub(end_, first_))));

        left = hn::IfThenZeroElse(hn::Eq(left, hn::Set(s, INT32_MAX)), left);
        const auto x = hn::Add(left, hn::ShiftLeft<2>(hn::BitCast(s, place_of_lane())));
        const auto strip = hn::ShiftLeft<2>(hn::BitCast(s, four_of_lane()));
        out_ = hn::BitCast(p, hn::Add(hn::Mul(strip, hn::Set(s, static_cast<int32_t>(canvas.target.pitch))), x));
        const Doubles right = promote(hn::BitCast(p, hn::Sub(x, hn::Set(s, b.column0.at[t]))));
        const Doubles down = promote(hn::BitCast(p, hn::Add(strip, hn::Set(s, row - b.row0.at[t]))));
        kind.go_to(b, t, right, down);
    }
    /// The next window is the first of its piece once more.
    HWY_INLINE void go_to(const Batch& b, int t, const Window& window) {
        pieces_.go_to(b, t, window.row, window.column), columns_ = 0;
    }
    [[nodiscard]] HWY_INLINE Pieces& pieces() { return pieces_; }

    /// The next window; false: there are no more.
    HWY_INLINE bool next(const Batch& b, int t, const Canvas& canvas, Kind& kind, typename Kind::Found& window) {
        while (columns_ <= 0) {
            Piece piece;
            Rows rows;
            if (!pieces_.next(b, t, piece)) return false;
            cross(b, t, piece, canvas, rows);
            start(b, t, canvas, kind, piece, rows);
        }
        const Block p;
        const BlockInt s;
        // Bit n: column n of the row is inside.
        const auto columns = hn::AndNot(below(first_), below(end_));
        const bool both = columns_ > kHalfWidth;
        uint32_t wholes = 0, some = store_inside(columns, 0, window, wholes);
        hn::Store(out_, p, window.out);
        if (both) {
            some |= store_inside(hn::ShiftRight<kHalfWidth>(columns), kHalf, window, wholes);
            hn::Store(hn::Add(out_, hn::Set(p, kHalfWidth)), p, window.out + kHalf);
        }
        window.wholes = b.widest.at[t] < kLeastWhole ? 0 : wholes, window.parts = some & ~window.wholes;
        window.row = row_, window.column = column_, window.samples = columns_ <= kWindowWidth ? samples_ : 0;

        kind.find(b, t, canvas, both, window);
        out_ = hn::Add(out_, hn::Set(p, kWindowWidth));
        first_ = hn::Sub(first_, hn::Set(s, kWindowWidth)), end_ = hn::Sub(end_, hn::Set(s, kWindowWidth));
        columns_ -= kWindowWidth;
        return true;
    }

private:
    using HalfInt = hn::Half<BlockInt>;

    [[nodiscard]] static HWY_INLINE RowNumbers load(const OfRows<int32_t>& rows) {
        return hn::Combine(BlockInt{}, hn::Load(HalfInt{}, rows.at + kRows / 2), hn::Load(HalfInt{}, rows.at));
    }
    /// The lowest n bits: all where n is 32 or more, none below 0.
    [[nodiscard]] static HWY_INLINE Samples below(RowNumbers n) {
        const Block p;
        const auto bit = hn::Shl(hn::Set(p, 1), hn::BitCast(p, hn::Max(n, hn::Zero(BlockInt{}))));
        return hn::Sub(bit, hn::Set(p, 1));
    }
    /// Half of the blocks, by the lower halves of the rows' columns. Returns those with any samples inside.
    static HWY_INLINE uint32_t store_inside(Samples columns, int first, Window& window, uint32_t& wholes) {
        const Block p;
        const BlockBytes bytes;
        const hn::Rebind<uint16_t, Block> masks;
        // Four bits of each of a strip's rows: bytes turned, with two blocks' bits in each.
        alignas(16) static constexpr uint8_t kTurned[16] = {0, 4, 8, 12, 0, 4, 8, 12, 1, 5, 9, 13, 1, 5, 9, 13};
        const auto turned =
            hn::BitCast(p, hn::TableLookupBytes(hn::BitCast(bytes, columns), hn::LoadDup128(bytes, kTurned)));
        const auto odd = hn::ShiftLeft<2>(hn::And(place_of_lane(), hn::Set(p, 1)));
        const auto rows = hn::And(hn::Shr(turned, odd), hn::Set(p, 0x0F0F0F0F));
        const auto twos = hn::Or(rows, hn::ShiftRight<4>(rows));  // of a block's four, in its first and third byte
        const auto inside =
            hn::Or(hn::And(twos, hn::Set(p, 0xFF)), hn::And(hn::ShiftRight<8>(twos), hn::Set(p, 0xFF00)));
        hn::Store(hn::TruncateTo(masks, inside), masks, window.inside + first);
        wholes |= bits_of(p, hn::Eq(inside, hn::Set(p, 0xFFFF))) << first;
        return bits_of(p, hn::Ne(inside, hn::Zero(p))) << first;
    }

    Pieces pieces_;
    int row_, column_;        ///< where the piece begins
    int columns_;             ///< of it to come
    uint32_t samples_;        ///< in it
    RowNumbers first_, end_;  ///< columns of the window that are inside
    Samples out_;             ///< of the left half
};

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();

#endif
#endif
