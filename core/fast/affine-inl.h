// Affine triangles: u and v step in int32 along a row from a start in double, which wraps as a texture repeats.
#if defined(TEXELSCOPE_AFFINE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXELSCOPE_AFFINE_INL
#undef TEXELSCOPE_AFFINE_INL
#else
#define TEXELSCOPE_AFFINE_INL
#endif

#include "core/fast/crossings-inl.h"
#include "core/fast/fine-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texelscope {
namespace HWY_NAMESPACE {

/// These rows are drawn once more: nobody has decided their pixels.
HWY_NOINLINE void forget(const Canvas& canvas, int row, int count, const Rows& rows) {
    const RasterWatch* const told = canvas.settings->watch;
    if (told == nullptr) return;
    for (int n = 0; n < count; ++n)
        for (int x = rows.x0.at[n]; x < rows.x1.at[n]; ++x) told->deciders[(row + n) * canvas.target.pitch + x] = 0;
}

/// The rows after `row` whose bits are set in `which`, some texels of which are unsure. Returns as mend() does.
template <Addressing kAddressing, class Tag>
HWY_NOINLINE bool rows_again(Tag p, const Batch& b, int t, int row, uint32_t which, const Rows& rows, Again& again,
                             bool only_double, const Canvas& canvas, const Texels<Tag, kAddressing>& texels) {
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    const auto u_x = hn::Set(p, static_cast<uint32_t>(b.u.step.at[t])),
               v_x = hn::Set(p, static_cast<uint32_t>(b.v.step.at[t]));
    for (; which != 0; which &= which - 1) {
        const int n = std::countr_zero(which);
        const auto u0 = hn::Set(p, static_cast<uint32_t>(rows.u.at[n])),
                   v0 = hn::Set(p, static_cast<uint32_t>(rows.v.at[n]));
        for (int x = rows.x0.at[n]; x < rows.x1.at[n]; x += kLanes) {
            const auto steps = lanes_from(p, static_cast<uint32_t>(x - rows.x0.at[n]));
            const auto in = hn::FirstN(p, static_cast<size_t>(rows.x1.at[n] - x));
            const auto unsure = texels.unsure(hn::Add(hn::Mul(u_x, steps), u0), hn::Add(hn::Mul(v_x, steps), v0));
            if (const auto asked = hn::And(in, unsure); !hn::AllFalse(p, asked))
                if (!mend(p, again, x, row + n, asked, only_double, canvas)) return false;
        }
    }
    return true;
}

/// The rows of a triangle that lies in one texel.
template <bool kDepth>
HWY_NOINLINE void fill_rows(const Batch& b, int t, const Canvas& canvas) {
    const Pixel p;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    const Vertex& corner = *canvas.corners(b.index.at[t]);
    const auto index = [](float u, int texels) { return static_cast<Integer>(std::floor(double{u} * texels)); };
    const TexelIndex texel{index(corner.u, canvas.job->u_texels), index(corner.v, canvas.job->v_texels)};
    const uint32_t colour = canvas.texture.texels[place_of(canvas.texture, texel)];
    ++canvas.counters->of(RasterSkip::one_texel);
    [[maybe_unused]] Again again(canvas, b, t, false);
    const std::ptrdiff_t pitch = canvas.target.pitch;
    Pieces pieces(b, t, canvas);
    for (Piece piece; pieces.next(b, t, piece);) {
        Rows rows;
        if (!cross(b, t, piece, canvas, rows)) continue;
        for (int n = 0, y = piece.row; n < piece.count; ++n, ++y) {
            int x = rows.x0.at[n], left = rows.x1.at[n] - x;
            if (left <= 0) continue;
            canvas.counters->samples += static_cast<uint64_t>(left);
            [[maybe_unused]] const DepthRow<Pixel> depth(b, t, y);
            uint32_t* const line = canvas.target.pixels + y * pitch;
            if constexpr (!kDepth)
                std::fill_n(line + x, left, colour);
            else
                for (; left > 0; left -= kLanes, x += kLanes) {
                    const auto in = hn::FirstN(p, static_cast<size_t>(left));
                    store_some(hn::Set(p, colour), pass_depth(depth, x, y, in, again, canvas), p, line + x,
                               line + canvas.target.width);
                }
        }
    }
}

/// The rows of one triangle, as many pixels at once as `Tag` has lanes. kWide: it is so wide that each row is asked
/// whether it is sure, else some at once are; with a depth test such ones are draw_depth_tiles()'s.
template <bool kWide, Addressing kAddressing, bool kDepth, bool kCertain, class Tag>
HWY_NOINLINE void draw_rows(Tag p, const Batch& b, int t, const Canvas& canvas) {
    static_assert(!kWide || !kDepth);
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    Texels<Tag, kAddressing> texels(canvas, b, t, certain_of(b, t));
    Again again(canvas, b, t, false);
    bool ties_known = false;
    const auto u_x = hn::Set(p, static_cast<uint32_t>(b.u.step.at[t])),
               v_x = hn::Set(p, static_cast<uint32_t>(b.v.step.at[t]));
    const auto lanes = hn::Iota(p, 0);
    const auto u_lanes = hn::Mul(u_x, lanes), v_lanes = hn::Mul(v_x, lanes);
    const auto u_step = hn::Mul(u_x, hn::Set(p, kLanes)), v_step = hn::Mul(v_x, hn::Set(p, kLanes));
    const std::ptrdiff_t pitch = canvas.target.pitch;
    const bool level =
        kWide && b.u.step.at[t] == 0 && b.v.step.at[t] == 0 && canvas.settings->skip(RasterSkip::zero_gradient);
    if (level) ++canvas.counters->of(RasterSkip::zero_gradient);
    uint64_t samples = 0;
    Pieces pieces(b, t, canvas);
    for (Piece piece; pieces.next(b, t, piece);) {
        Rows rows;
        const int row = piece.row;
        int count = piece.count;
        if (!cross(b, t, piece, canvas, rows)) continue;
        start(b, t, row, count, texels.u.bias, texels.v.bias, rows);
        Least<Tag, kAddressing> least;
        uint32_t unsure = 0;
        const uint64_t before = samples;
        for (int n = 0, y = row; n < count; ++n, ++y) {
            int x = rows.x0.at[n], left = rows.x1.at[n] - x;
            if (left <= 0) continue;
            samples += static_cast<uint64_t>(left);
            auto u = hn::Add(hn::Set(p, static_cast<uint32_t>(rows.u.at[n])), u_lanes);
            auto v = hn::Add(hn::Set(p, static_cast<uint32_t>(rows.v.at[n])), v_lanes);
            if constexpr (kDepth) {
                const DepthRow<Tag> depth(b, t, y);
                for (; left > 0; left -= kLanes, x += kLanes) {
                    const auto in = hn::FirstN(p, static_cast<size_t>(left));
                    const auto shown = test_early(depth, x, y, in, again, canvas);
                    if (!hn::AllFalse(p, shown)) put_tested(p, texels, u, v, depth, x, y, shown, again, canvas);
                    u = hn::Add(u, u_step), v = hn::Add(v, v_step);
                }
            } else {
                uint32_t* out = canvas.target.pixels + y * pitch + x;
                const uint32_t* const end = out - x + canvas.target.width;
                if (kWide && level) {
                    const auto found = texels.fetch(u, v);
                    least.see(texels, u, v);
                    for (; left >= kLanes; left -= kLanes, out += kLanes) hn::StoreU(found, p, out);
                    if (left > 0) store_some(found, hn::FirstN(p, static_cast<size_t>(left)), p, out, end);
                    left = 0;
                }
                for (; left >= kLanes; left -= kLanes, out += kLanes) {
                    put_all<kCertain>(p, texels, u, v, out, least);
                    u = hn::Add(u, u_step), v = hn::Add(v, v_step);
                }
                if (left > 0) put_some<kCertain>(p, texels, u, v, left, out, end, least);
                // Two such rows one after another: they may show that the next had better be drawn otherwise.
                if constexpr (kWide && kCertain)
                    if (!least.is_sure(texels)) {
                        unsure |= 1U << n, least = {};
                        if ((unsure & unsure >> 1) != 0) count = n + 1;
                    }
            }
        }
        if (!kWide && !kDepth && kCertain && !least.is_sure(texels)) unsure = (1U << count) - 1;
        bool finely = false;
        if (unsure != 0 && !rows_again(p, b, t, row, unsure, rows, again, !ties_known, canvas, texels)) {
            // One that double cannot tell is rarely alone: these rows once more, past all ties.
            const CertainPair certain = certain_of(canvas, b, t, b.u.doubt.at[t], b.v.doubt.at[t], again.half_gaps());
            texels = Texels<Tag, kAddressing>(canvas, b, t, certain);
            forget(canvas, row, count, rows);
            ties_known = true, count = 0, samples = before, finely = !certain.sure();
        } else if (kDepth || unsure != 0) {
            finely = again.often(row + count - b.row0.at[t]);
        }
        pieces.give_back(piece, count);
        if (finely && draw_finely<false, kAddressing, kDepth>(b, t, pieces, again, canvas, samples)) break;
    }
    canvas.counters->samples += samples;
}

/// The same for a triangle whose rows have but a few pixels: the rows' first pixels side by side, then their second
/// ones.
template <Addressing kAddressing, bool kCertain>
HWY_NOINLINE void draw_columns(const Batch& b, int t, const Canvas& canvas) {
    using Tag = hn::CappedTag<uint32_t, kBatch>;
    const Tag p;
    const hn::Rebind<int32_t, Tag> s;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(p));
    Texels<Tag, kAddressing> texels(canvas, b, t, certain_of(b, t));
    Again again(canvas, b, t, false);
    bool ties_known = false;
    const auto u_x = hn::Set(p, static_cast<uint32_t>(b.u.step.at[t])),
               v_x = hn::Set(p, static_cast<uint32_t>(b.v.step.at[t]));
    const Columns columns{b.column0.at[t], b.column1.at[t]};
    const std::ptrdiff_t pitch = canvas.target.pitch;
    uint64_t samples = 0;
    for (int row = b.row0.at[t]; row < b.row1.at[t]; row += kRows) {
        Rows rows;
        const int count = std::min(kRows, b.row1.at[t] - row);
        cross(b, t, row, count, columns, canvas, rows);
        start(b, t, row, count, texels.u.bias, texels.v.bias, rows);
        for (int n = count; n % kLanes != 0; ++n) rows.x0.at[n] = rows.x1.at[n] = 0;
        Least<Tag, kAddressing> least;
        const uint64_t before = samples;
        for (int n = 0; n < count; n += kLanes) {
            const auto load = [&](const OfRows<int32_t>& of) HWY_ATTR { return hn::Load(s, of.at + n); };
            const auto width = hn::Sub(load(rows.x1), load(rows.x0)), which = hn::Iota(s, 0);
            const auto there = hn::Gt(width, hn::Zero(s));
            uint32_t inside = bits_of(s, there);
            if (inside == 0) continue;
            // Every lane draws, so that no branch depends on how many do: rows without pixels are another row once
            // more, those that have ended their last pixel.
            const int some = std::countr_zero(inside);
            const auto taken = [&](hn::Vec<decltype(s)> own, int32_t other)
                                   HWY_ATTR { return hn::BitCast(p, hn::IfThenElse(there, own, hn::Set(s, other))); };
            auto u = taken(load(rows.u), rows.u.at[n + some]), v = taken(load(rows.v), rows.v.at[n + some]);
            auto at = hn::Add(hn::Mul(taken(which, some), hn::Set(p, static_cast<uint32_t>(pitch))),
                              taken(load(rows.x0), rows.x0.at[n + some]));
            uint32_t* const out = canvas.target.pixels + (row + n) * pitch;
            for (int i = 1; inside != 0; ++i) {
                samples += static_cast<uint64_t>(std::popcount(inside));
                scatter_looked_up(p, texels.texels, texels.place(u, v), at, out);
                if constexpr (kCertain) least.see(texels, u, v);
                const auto in = hn::RebindMask(p, hn::Gt(width, hn::Set(s, i)));
                inside = bits_of(p, in);
                u = hn::IfThenElse(in, hn::Add(u, u_x), u), v = hn::IfThenElse(in, hn::Add(v, v_x), v);
                at = hn::IfThenElse(in, hn::Add(at, hn::Set(p, 1U)), at);
            }
        }
        if (!kCertain || least.is_sure(texels)) continue;
        if (!rows_again(p, b, t, row, (1U << count) - 1, rows, again, !ties_known, canvas, texels)) {
            texels = Texels<Tag, kAddressing>(
                canvas, b, t, certain_of(canvas, b, t, b.u.doubt.at[t], b.v.doubt.at[t], again.half_gaps()));
            forget(canvas, row, count, rows);
            ties_known = true, row -= kRows, samples = before;
        }
    }
    canvas.counters->samples += samples;
}

}  // namespace HWY_NAMESPACE
}  // namespace texelscope
HWY_AFTER_NAMESPACE();
#endif
