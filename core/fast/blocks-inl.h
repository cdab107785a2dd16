// Affine triangles by blocks of 4 x 4 samples (patches-inl.h), where rows would load texels one by one. Where each
// block lies, what it shows and which samples are inside is found for 32 of them at once: four strips of four rows,
// eight blocks each. The first of each triangle of a batch are found before any is drawn, so that to draw them need not
// wait.
#if defined(TEXELSCOPE_BLOCKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_BLOCKS_INL
#undef TEXELSCOPE_BLOCKS_INL
#else
#define TEXELSCOPE_BLOCKS_INL
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/fast/affine-inl.h"
#include "core/fast/patches-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

#if HWY_TARGET <= HWY_AVX3

constexpr int kWindow = 8;  ///< blocks of each strip at once
constexpr int kWindowWidth = kBlock * kWindow, kBlocks = kRows / kBlock * kWindow, kHalf = kBlocks / 2;

/// No row of fewer samples is drawn by blocks, and where it has fewer than these, no block is expected to be whole:
/// measured [px].
constexpr int kLeastWide = 9, kLeastWhole = 56;

/// A patch is 2^32 parts.
constexpr double kPartsInTexel = 0x1p32 / kPatch;
/// What follows the texel's bits, modulo a patch.
constexpr uint32_t kInTexel = ~0U >> kPatchBits;

using BlockInt = hn::Rebind<int32_t, Block>;
using BlockBytes = hn::Repartition<uint8_t, Block>;
using RowNumbers = hn::Vec<BlockInt>;  ///< of each of kRows rows

/// Whether the patch of any block of the triangle holds all of its texels. They spread over what u and v change from
/// one corner of it to the opposite one, and twice the doubt at each of these two: Certainty lets the doubt be no more
/// than an eighth of a texel.
HWY_INLINE bool has_patches(const Batch& b, int t, const Canvas& canvas) {
    const auto fits = [&](const CoordinateEight& u, int bits) {
        const double spread = (std::abs(u.plane.x.at[t]) + std::abs(u.plane.y.at[t])) * (kBlock - 1);
        // In double parts are whole up to 2^51: 24 half ulps of 2^45 are 2^-3.
        const double texel = static_cast<double>(int64_t{1} << (32 - bits)), parts = kPartsInTexel / texel;
        return bits > kPatchBits && u.unsure.at[t] * parts < .125 && spread <= (kPatch - 1.5) * texel;
    };
    return fits(b.u, canvas.u_bits) && fits(b.v, canvas.v_bits);
}
/// Whether blocks are faster than rows: of a block that no more than a third of is inside, rows store less.
HWY_INLINE bool is_by_blocks(const Batch& b, int t, const Canvas& canvas) {
    const int widest = b.widest.at[t];
    if (b.good.at[t] == 0 || b.tiny.at[t] != 0 || b.one_texel.at[t] != 0 || widest < kLeastWide) return false;
    const int64_t samples = int64_t{widest} * (b.row1.at[t] - b.row0.at[t]);
    return samples >= int64_t{kBlock} * (b.column1.at[t] - b.column0.at[t]) && has_patches(b, t, canvas);
}

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

/// u or v of one triangle's blocks. They are counted in units of Canvas::addressing, and modulo a patch in parts of
/// 2^32, which are finer: what rounding to whole ones loses is hardly ever in doubt.
struct BlockAxis {
    int shift;            ///< of units to texels
    double parts;         ///< in a unit
    double to_least;      ///< from a block's first sample to where none is at less [units]
    double bias;          ///< Certain::bias [units]
    uint32_t least_rest;  ///< Certain::least
    Samples lanes;        ///< of each sample from there [parts]; the lowest bit is set
    Samples tested;       ///< if one of these bits is set, the texel is certain

    HWY_INLINE void set_up(const CoordinateEight& u, int t, int bits) {
        const Block p;
        shift = 32 - bits, parts = static_cast<double>(int64_t{1} << (bits - kPatchBits));
        const double x = u.plane.x.at[t], y = u.plane.y.at[t];
        // A quarter of a texel less: the doubts of both.
        to_least =
            (std::min(x, 0.0) + std::min(y, 0.0)) * (kBlock - 1) - static_cast<double>(int64_t{1} << (shift - 2));
        const auto in_parts = [&](double a) HWY_ATTR {
            return hn::Set(p, static_cast<uint32_t>(std::bit_cast<uint64_t>(a * parts + kWholeDouble)));
        };
        const auto right = hn::Mul(place_of_lane(), in_parts(x)), down = hn::Mul(four_of_lane(), in_parts(y));
        lanes = hn::Or(hn::Add(hn::Add(right, down), in_parts(-to_least)), hn::Set(p, 1));
    }
    /// @param unsure    bound of what double has lost [units]
    /// @param half_gap  as Certainty has it [units]
    HWY_INLINE void use(double unsure, double half_gap) {
        const One d;
        // What is rounded to whole parts: a block's least, how far its first sample is from there, that by its lowest
        // bit, too, and three steps each to the right and down.
        const Certainty<One> c(d, hn::Set(d, unsure * parts + 6), hn::Set(d, half_gap * parts),
                               hn::Set(d, kPartsInTexel), hn::Set(d, kPatch));
        bias = hn::GetLane(c.bias) * static_cast<double>(int64_t{1} << shift) * (1 / kPartsInTexel);
        least_rest = static_cast<uint32_t>(hn::GetLane(c.least));
        // The certificate asks for no more than that, rounded up to a power of two: for nothing but the lowest bit
        // where it is 0.
        const uint32_t doubtful = std::bit_ceil(std::max(2U, (least_rest >> kPatchBits) + 1));
        tested = hn::Set(Block{}, least_rest == 0 ? 1 : kInTexel & ~(doubtful - 1));
    }
    /// Samples of a block that are in doubt.
    [[nodiscard]] HWY_INLINE uint32_t unsure(uint32_t block) const {
        const Block p;
        const auto rest = hn::ShiftLeft<kPatchBits>(hn::Add(hn::Set(p, block), lanes));
        return bits_of(p, hn::Lt(rest, hn::Set(p, least_rest)));
    }
    [[nodiscard]] HWY_INLINE bool sure() const { return least_rest == 0; }
};

/// u and v of one triangle's blocks.
struct BlockAxes {
    BlockAxis u, v;

    HWY_INLINE void set_up(const Batch& b, int t, const Canvas& canvas) {
        u.set_up(b.u, t, canvas.u_bits), v.set_up(b.v, t, canvas.v_bits);
        use(b, t, {});
    }
    HWY_INLINE void use(const Batch& b, int t, const HalfGaps& gaps) {
        u.use(b.u.unsure.at[t], gaps.u), v.use(b.v.unsure.at[t], gaps.v);
    }
    [[nodiscard]] HWY_INLINE bool sure() const { return u.sure() && v.sure(); }
};

/// The blocks of a window, ready to be drawn: those of even places in their strips, then those of odd ones.
struct Blocks {
    alignas(64) uint32_t u[kBlocks], v[kBlocks];  ///< from the patch to where they are least [parts]
    alignas(64) uint32_t texel[kBlocks];          ///< the patch' first
    alignas(64) uint32_t out[kBlocks];            ///< the first pixel, from the first of `row`
    alignas(64) uint16_t inside[kBlocks];         ///< bit n: sample n is
    uint32_t parts, wholes;                       ///< bit n: block n has some samples inside; is drawn as a whole
    int row;
    uint32_t samples;  ///< of the strips if these are their last blocks, else 0
};

/// The rows of the strips from `row` on.
HWY_INLINE void cross_strips(const Batch& b, int t, const Canvas& canvas, int row, Rows& rows) {
    const int count = std::min(kRows, b.row1.at[t] - row);
    cross(b, t, row, count, {b.column0.at[t], b.column1.at[t]}, canvas, rows);
}

/// All blocks of a triangle, one window after another.
class BlockWindows {
public:
    /// Goes to the strips from `row` on.
    HWY_INLINE void go_to(const Batch& b, int t, const Canvas& canvas, const BlockAxes& axes, int row) {
        Rows rows;
        cross_strips(b, t, canvas, row, rows);
        go_to(b, t, canvas, axes, row, rows);
    }
    HWY_INLINE void go_to(const Batch& b, int t, const Canvas& canvas, const BlockAxes& axes, int row,
                          const Rows& rows) {
        const Block p;
        const BlockInt s;
        const int count = std::min(kRows, b.row1.at[t] - row);
        const auto x0 = load(rows.x0), x1 = load(rows.x1);
        const auto there = hn::And(hn::Lt(x0, x1), hn::FirstN(s, static_cast<size_t>(count)));
        auto left = hn::IfThenElse(there, x0, hn::Set(s, INT32_MAX));
        left = hn::Min(left, hn::Shuffle2301(left)), left = hn::Min(left, hn::Shuffle1032(left));
        first_ = hn::IfThenElseZero(there, hn::Sub(x0, left)), end_ = hn::IfThenElseZero(there, hn::Sub(x1, left));
        columns_ = hn::GetLane(hn::MaxOfLanes(s, end_));
        samples_ = static_cast<uint32_t>(hn::GetLane(hn::SumOfLanes(s, hn::Sub(end_, first_))));

        left = hn::IfThenZeroElse(hn::Eq(left, hn::Set(s, INT32_MAX)), left);
        const auto x = hn::Add(left, hn::ShiftLeft<3>(hn::BitCast(s, place_of_lane())));
        const auto strip = hn::ShiftLeft<2>(hn::BitCast(s, four_of_lane()));
        out_ = hn::BitCast(p, hn::Add(hn::Mul(strip, hn::Set(s, static_cast<int32_t>(canvas.target.pitch))), x));
        right_ = promote(hn::BitCast(p, hn::Sub(x, hn::Set(s, b.column0.at[t]))));
        const Doubles down = promote(hn::BitCast(p, hn::Add(strip, hn::Set(s, row - b.row0.at[t]))));
        const auto start = [&](const CoordinateEight& u, const BlockAxis& axis, Doubles& at) HWY_ATTR {
            const Real d;
            const V first = hn::Set(d, u.plane.at.at[t] + (axis.bias + axis.to_least)), y = hn::Set(d, u.plane.y.at[t]);
            at = {hn::MulAdd(down.low, y, first), hn::MulAdd(down.high, y, first)};
        };
        start(b.u, axes.u, u_), start(b.v, axes.v, v_);
        row_ = row;
    }

    /// The next window; false: there are no more.
    HWY_INLINE bool next(const Batch& b, int t, const Canvas& canvas, const BlockAxes& axes, Blocks& blocks) {
        if (columns_ <= 0) {
            const int row = row_ + kRows;
            if (row >= b.row1.at[t]) return false;
            go_to(b, t, canvas, axes, row);
        }
        const Block p;
        const BlockInt s;
        // Bit n: column n of the row is inside.
        const auto columns = hn::AndNot(below(first_), below(end_));
        uint32_t wholes = 0;
        const uint32_t even = store_inside(columns, 0, blocks, wholes),
                       odd = store_inside(hn::ShiftRight<kBlock>(columns), kHalf, blocks, wholes);
        blocks.wholes = b.widest.at[t] < kLeastWhole ? 0 : wholes;
        blocks.parts = (even | odd << kHalf) & ~blocks.wholes;
        const V half = hn::Set(Real{}, kBlock);
        store(b, t, canvas, axes, right_, 0, blocks);
        store(b, t, canvas, axes, {hn::Add(right_.low, half), hn::Add(right_.high, half)}, kHalf, blocks);
        hn::Store(out_, p, blocks.out), hn::Store(hn::Add(out_, hn::Set(p, kBlock)), p, blocks.out + kHalf);
        blocks.row = row_, blocks.samples = columns_ <= kWindowWidth ? samples_ : 0;

        const V wide = hn::Set(Real{}, kWindowWidth);
        right_ = {hn::Add(right_.low, wide), hn::Add(right_.high, wide)};
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
    /// Half of the blocks: their samples are every other nibble of each row's columns. Returns those with any inside.
    static HWY_INLINE uint32_t store_inside(Samples columns, int first, Blocks& blocks, uint32_t& wholes) {
        const Block p;
        const BlockBytes bytes;
        const hn::Rebind<uint16_t, Block> masks;
        alignas(16) static constexpr uint8_t kTurned[16] = {0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15};
        const auto nibbles = hn::BitCast(bytes, hn::And(columns, hn::Set(p, 0x0F0F0F0F)));
        const auto rows = hn::BitCast(p, hn::TableLookupBytes(nibbles, hn::LoadDup128(bytes, kTurned)));
        const auto twos =
            hn::Or(rows, hn::ShiftRight<4>(rows));  // of a block's four nibbles, in its first and third byte
        const auto inside =
            hn::Or(hn::And(twos, hn::Set(p, 0xFF)), hn::And(hn::ShiftRight<8>(twos), hn::Set(p, 0xFF00)));
        hn::Store(hn::TruncateTo(masks, inside), masks, blocks.inside + first);
        wholes |= bits_of(p, hn::Eq(inside, hn::Set(p, 0xFFFF))) << first;
        return bits_of(p, hn::Ne(inside, hn::Zero(p)));
    }
    /// u or v of 16 blocks in parts from the patch on; its first texel.
    static HWY_INLINE Samples locate(const CoordinateEight& u, int t, const BlockAxis& axis, const Doubles& at,
                                     const Doubles& right, uint32_t* from_patch) {
        const Real d;
        const V x = hn::Set(d, u.plane.x.at[t]), whole = hn::Set(d, kWholeDouble), parts = hn::Set(d, axis.parts);
        const V low = hn::MulAdd(right.low, x, at.low), high = hn::MulAdd(right.high, x, at.high);
        const auto texel = hn::ShiftRightSame(low_bits_of(hn::Add(low, whole), hn::Add(high, whole)), axis.shift);
        const auto in_parts = low_bits_of(hn::MulAdd(low, parts, whole), hn::MulAdd(high, parts, whole));
        hn::Store(hn::Sub(in_parts, hn::ShiftLeft<32 - kPatchBits>(texel)), Block{}, from_patch);
        return texel;
    }
    HWY_INLINE void store(const Batch& b, int t, const Canvas& canvas, const BlockAxes& axes, const Doubles& right,
                          int first, Blocks& blocks) const {
        const Block p;
        const auto u = locate(b.u, t, axes.u, u_, right, blocks.u + first),
                   v = locate(b.v, t, axes.v, v_, right, blocks.v + first);
        const auto pitch = hn::Set(p, static_cast<uint32_t>(canvas.texture.pitch));
        hn::Store(hn::Add(hn::Mul(v, pitch), u), p, blocks.texel + first);
    }

    int row_, columns_;       ///< the first of the strips; columns to come
    uint32_t samples_;        ///< in the strips
    RowNumbers first_, end_;  ///< columns of the window that are inside
    Samples out_;             ///< of each strip's blocks 0, 2, 4 and 6
    Doubles right_;           ///< their columns of the box
    Doubles u_, v_;           ///< at column 0 of their rows, moved to the least of a block and by the bias [units]
};

/// Draws the blocks whose bits are set. False: some of their texels are unsure.
template <bool kWhole, bool kCertain>
HWY_INLINE bool put_blocks(const Blocks& blocks, uint32_t which, const BlockAxes& axes, const Canvas& canvas) {
    const Block p;
    const auto u_lanes = axes.u.lanes, v_lanes = axes.v.lanes;
    const __m512i u_tested = axes.u.tested.raw, v_tested = axes.v.tested.raw;
    const uint32_t* const texels = canvas.texture.texels;
    const std::ptrdiff_t pitch = canvas.target.pitch, texture_pitch = canvas.texture.pitch;
    uint32_t* const line = canvas.target.pixels + blocks.row * pitch;
    __mmask16 unsure = 0;
    for (; which != 0; which &= which - 1) {
        const int n = std::countr_zero(which);
        const auto u = hn::Add(u_lanes, hn::Set(p, blocks.u[n])), v = hn::Add(v_lanes, hn::Set(p, blocks.v[n]));
        const auto found = look_up_patch(texels + blocks.texel[n], texture_pitch, u, v);
        uint32_t* const out = line + blocks.out[n];
        __mmask16 inside = 0xFFFF;
        if constexpr (kWhole)
            store_block(found, out, pitch);
        else
            store_block(found, inside = load_mask(blocks.inside[n]), out, pitch);
        if constexpr (kCertain)
            unsure = _kor_mask16(unsure, _kor_mask16(_mm512_mask_testn_epi32_mask(inside, u.raw, u_tested),
                                                     _mm512_mask_testn_epi32_mask(inside, v.raw, v_tested)));
    }
    return unsure == 0;
}

/// The unsure texels of some blocks. Returns as mend() does; false with `only_double` also where the rows so far have
/// so many that the triangle had better be drawn otherwise.
HWY_NOINLINE bool blocks_again(const Blocks& blocks, const BlockAxes& axes, Again& again, bool only_double, int rows,
                               const Canvas& canvas) {
    const auto pitch = static_cast<uint32_t>(canvas.target.pitch);
    for (uint32_t which = blocks.parts | blocks.wholes; which != 0; which &= which - 1) {
        const int n = std::countr_zero(which);
        uint32_t asked = blocks.inside[n] & (axes.u.unsure(blocks.u[n]) | axes.v.unsure(blocks.v[n]));
        for (; asked != 0; asked &= asked - 1) {
            const int sample = std::countr_zero(asked);
            const int x = static_cast<int>(blocks.out[n] % pitch) + sample % kBlock;
            const int y = blocks.row + static_cast<int>(blocks.out[n] / pitch) + sample / kBlock;
            if (!mend_pixel(again, x, y, only_double, canvas) || (only_double && again.often(rows))) return false;
        }
    }
    return true;
}

/// A triangle by blocks, the first of which are found.
struct BlockDrawing {
    BlockAxes axes;
    BlockWindows windows;
    Blocks first;
    bool more;  ///< there are such
};

/// The rows of strips from `row` on are drawn once more.
HWY_NOINLINE void forget_strips(const Batch& b, int t, int row, const Canvas& canvas) {
    if (canvas.settings->watch == nullptr) return;
    Rows rows;
    cross_strips(b, t, canvas, row, rows);
    forget(canvas, row, std::min(kRows, b.row1.at[t] - row), rows);
}

template <bool kCertain>
HWY_NOINLINE void draw_blocks(const Batch& b, int t, const Canvas& canvas, BlockDrawing& drawing) {
    Again again(canvas, b, t, false);
    bool ties_known = false;
    uint64_t samples = 0;
    Blocks others;
    BlockAxes& axes = drawing.axes;
    Blocks *now = &drawing.first, *next = &others;
    for (bool more = drawing.more; more; std::swap(now, next)) {
        more = drawing.windows.next(b, t, canvas, axes, *next);
        bool sure = true;
        if (now->wholes != 0) sure = put_blocks<true, kCertain>(*now, now->wholes, axes, canvas);
        sure = put_blocks<false, kCertain>(*now, now->parts, axes, canvas) && sure;
        const int row = now->row;
        if (sure || !kCertain) {
            samples += now->samples;
        } else if (blocks_again(*now, axes, again, !ties_known, row + kRows - b.row0.at[t], canvas)) {
            samples += now->samples;
        } else {
            // As in draw_rows: these strips once more, past all ties.
            axes.use(b, t, again.half_gaps());
            ties_known = true;
            forget_strips(b, t, row, canvas);
            if (!axes.sure() && draw_finely<false, Addressing::powers, false>(b, t, row, again, canvas, samples)) break;
            drawing.windows.go_to(b, t, canvas, axes, row);
            more = drawing.windows.next(b, t, canvas, axes, *next);
        }
    }
    canvas.counters->samples += samples, ++canvas.counters->by_blocks;
}

/// Which triangles of a batch are drawn by blocks.
class BlockBatch {
public:
    HWY_INLINE BlockBatch(const Batch& b, int count, const Canvas& canvas) {
        if (canvas.job->perspective || canvas.texture.apron < kTexelApron) return;
        const hn::CappedTag<int32_t, kBatch> s;
        if (!hn::AllFalse(s, hn::Eq(hn::Load(s, b.tiny.at), hn::Zero(s)))) find(b, count, canvas);
    }
    [[nodiscard]] HWY_INLINE bool has(int t) const { return (which_ >> t & 1) != 0; }
    template <bool kCertain>
    HWY_INLINE void draw(const Batch& b, int t, const Canvas& canvas) {
        draw_blocks<kCertain>(b, t, canvas, drawings_[t]);
    }

private:
    /// One step of all after another: each is a chain of few instructions that wait for each other.
    HWY_NOINLINE void find(const Batch& b, int count, const Canvas& canvas) {
        for (int t = 0; t < count; ++t)
            if ((b.front.at[t] != 0 || !canvas.job->cull_back) && is_by_blocks(b, t, canvas)) which_ |= 1U << t;
        const auto each = [&](auto&& step) HWY_ATTR {
            for (uint32_t m = which_; m != 0; m &= m - 1) step(std::countr_zero(m));
        };
        each([&](int t) HWY_ATTR { drawings_[t].axes.set_up(b, t, canvas); });
        Rows rows[kBatch];
        each([&](int t) HWY_ATTR { cross_strips(b, t, canvas, b.row0.at[t], rows[t]); });
        each([&](int t)
                 HWY_ATTR { drawings_[t].windows.go_to(b, t, canvas, drawings_[t].axes, b.row0.at[t], rows[t]); });
        each([&](int t) HWY_ATTR {
            BlockDrawing& d = drawings_[t];
            d.more = d.windows.next(b, t, canvas, d.axes, d.first);
        });
    }

    uint32_t which_ = 0;
    BlockDrawing drawings_[kBatch];
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
