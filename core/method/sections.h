// Convex polygons without triangulation: sections between corners, each between two straight sides (S2:
// oldskoolpython, "Texture Mapping (Tutorial)", October 2021). Corrected or as printed, by quirks.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "core/geometry/vertex.h"
#include "core/method/texel.h"
#include "core/trace/trace.h"

namespace texelscope {

/// What the source does otherwise than meant; all off is the corrected method.
struct SectionsQuirks {
    bool ghost = false, end_texel = false, whole_pixels = false;
};

template <Real T, Traceable Trace>
struct Sections {
    using Int = IntegerOf<T>;
    using Truth = TruthOf<T>;
    using Quirks = SectionsQuirks;

    struct Node {
        T x{}, y{}, u{}, v{};
    };
    using Ring = boost::container::small_vector<Node, 8>;  ///< a vector, but few corners need no allocation
    struct Section {
        std::size_t left = 0, right = 0;
        T y_beg{}, y_end{};
        Int first{}, last{};
    };  ///< rows half-open
    struct End {
        T m{}, x{}, u{}, v{};
    };  ///< where a row meets a side
    struct Row {
        End l, r;
        Int first{}, last{};
        Integer count = 0;
    };  ///< pixels first, … up to but without last
    struct Pixel {
        T x{}, s{}, u{}, v{};  ///< s: how far along the row, 0 at the left end, 1 at the right
        Texel<T> texel{};
        Fate fate = Fate::written;
        Note note = Note::none;
    };

    Rect frame;
    const Texture& texture;
    float lightness;
    bool cull_back;
    Quirks quirk;
    NumberMode mode;
    Trace trace;

    Fate draw(std::span<const Vertex> polygon, auto&& put) const {
        trace.stage("ring");
        const Ring ring = nodes(polygon);
        const T a = area(ring);
        if (a == 0) return trace.fate(Fate::zero_area);
        if (cull_back && a < 0) return trace.fate(Fate::culled);

        std::vector<Section> drawn;
        const T lowest = bottom(ring);
        Section s = first_section(ring);
        for (std::size_t k = 1; k < ring.size() && plain(s.y_beg < lowest); ++k) {
            trace.stage("section");
            s = section(ring, s);
            if (quirk.ghost) drawn.push_back(s);
            if (quirk.ghost) {  // a row beyond the picture may leave its ghost inside
                const Int first = greater(s.first, Int(frame.y0 - kRowsBeyond)),
                          last = lesser(s.last, Int(frame.y1 + kRowsBeyond));
                for (const Int j : trace.stray('y', first, last)) draw_row(ring, s, drawn, j, put);
            } else {
                const Int first = greater(s.first, Int(frame.y0)), last = lesser(s.last, Int(frame.y1));
                for (const Int j : trace.each('y', first, last)) draw_row(ring, s, drawn, j, put);
            }
            s = advanced(ring, s);
        }
        return Fate::written;
    }

    Ring nodes(std::span<const Vertex> polygon) const {
        Ring ring(polygon.size());
        for (int n = 0; n < int(ring.size()); ++n) {
            const T x = Input<T>::from(polygon[n].x, mode), y = Input<T>::from(polygon[n].y, mode);
            ring[n].x = trace({"x", n}, quirk.whole_pixels ? T(trunc(x)) : x);
            ring[n].y = trace({"y", n}, quirk.whole_pixels ? T(trunc(y)) : y);
            ring[n].u = trace({"u", n}, Input<T>::from(polygon[n].u, mode));
            ring[n].v = trace({"v", n}, Input<T>::from(polygon[n].v, mode));
        }
        return ring;
    }
    std::size_t top(const Ring& ring) const {
        std::size_t best = 0;
        for (std::size_t n = 1; n < ring.size(); ++n)
            if (plain(ring[n].y < ring[best].y)) best = n;
        return best;
    }
    T bottom(const Ring& ring) const {
        T y = ring[0].y;
        for (const Node& node : ring) y = plain(y < node.y) ? node.y : y;
        return y;
    }
    /// Twice the signed area: positive where the ring runs clockwise on the screen.
    T area(const Ring& ring) const {
        T sum = T(0);
        for (std::size_t n = 2; n < ring.size(); ++n)
            sum = sum + ((ring[n - 1].x - ring[0].x) * (ring[n].y - ring[0].y) -
                         (ring[n].x - ring[0].x) * (ring[n - 1].y - ring[0].y));
        return trace("area", sum);
    }

    /// Both pointers start at the top; left goes backwards round the ring, right forwards.
    Section first_section(const Ring& ring) const {
        Section s;
        s.left = s.right = top(ring);
        s.y_beg = ring[s.left].y;
        return s;
    }
    Section section(const Ring& ring, Section s) const {
        const Node& l2 = ring[before(ring, s.left)];
        const Node& r2 = ring[after(ring, s.right)];
        trace("left", Integer(s.left));
        trace("right", Integer(s.right));
        s.y_beg = trace("y_beg", s.y_beg);
        s.y_end = trace("y_end", choose(r2.y < l2.y, r2.y, l2.y));
        s.first = trace("first_row", row_at(s.y_beg));
        s.last = trace("last_row", row_at(s.y_end));
        return s;
    }
    Section advanced(const Ring& ring, Section s) const {
        if (plain(ring[after(ring, s.right)].y < ring[before(ring, s.left)].y))
            s.right = after(ring, s.right);
        else
            s.left = before(ring, s.left);
        s.y_beg = s.y_end;
        return s;
    }
    std::size_t before(const Ring& ring, std::size_t n) const { return (n + ring.size() - 1) % ring.size(); }
    std::size_t after(const Ring& ring, std::size_t n) const { return (n + 1) % ring.size(); }
    /// The first row, or column, whose sample is not before `a`.
    Int row_at(const T& a) const { return quirk.whole_pixels ? round_even(a) : ceil(a - T(1) / 2); }
    T sample(const Int& i) const { return quirk.whole_pixels ? T(i) : T(i) + T(1) / 2; }

    void draw_row(const Ring& ring, const Section& s, const std::vector<Section>& drawn, const Int& j,
                  auto&& put) const {
        const Row row = span(ring, s, j);
        if (quirk.ghost && row.count == 1) {  // Q1
            const auto [x, y, p] = ghost(ring, drawn, j);
            trace("x", x);
            trace("y", y);
            trace("r", p.texel.r);
            trace("g", p.texel.g);
            trace("b", p.texel.b);
            trace.fate(p.fate);
            if (frame.contains(x, y)) put(Int(x), Int(y), p);
            return;
        }
        if (plain(j) < frame.y0 || plain(j) >= frame.y1) return;
        const bool right = !quirk.whole_pixels || plain(row.first <= row.last);  // the row may run leftward
        const Int first = right ? greater(row.first, Int(frame.x0)) : lesser(row.first, Int(frame.x1 - 1));
        const Int last = right ? lesser(row.last, Int(frame.x1)) : greater(row.last, Int(frame.x0 - 1));
        if (plain(right ? first >= last : first <= last)) return;
        for (const Int i : trace.toward('x', first, last)) put(i, j, pixel(row, i));
    }

    Row span(const Ring& ring, const Section& s, const Int& j) const {
        Row row;
        const T y = trace("Y", sample(j));
        row.l = end("_l", ring[s.left], ring[before(ring, s.left)], y);
        row.r = end("_r", ring[s.right], ring[after(ring, s.right)], y);
        if (!quirk.whole_pixels && plain(row.r.x < row.l.x)) std::swap(row.l, row.r);
        row.first = trace("first", row_at(row.l.x));
        row.last = trace("last", row_at(row.r.x));
        row.count = plain(row.last) > plain(row.first) ? plain(row.last) - plain(row.first)
                                                       : plain(row.first) - plain(row.last);
        return row;
    }
    /// Each side is followed from its upper end, whichever polygon it belongs to: neighbours meet without a gap.
    End end(const char* side, const Node& upper, const Node& lower, const T& y) const {
        End e;
        e.m = trace({"m", side}, (y - upper.y) / (lower.y - upper.y));
        e.x = trace({"x", side}, upper.x + e.m * (lower.x - upper.x));
        if (quirk.whole_pixels) e.x = trace({"x", side}, T(round_even(e.x)));
        e.u = trace({"u", side}, upper.u + e.m * (lower.u - upper.u));
        e.v = trace({"v", side}, upper.v + e.m * (lower.v - upper.v));
        return e;
    }

    Pixel pixel(const Row& row, const Int& i) const {
        Pixel p;
        p.x = trace("X", sample(i));
        p.s = trace("s", quirk.end_texel ? T(i - row.first) / T(end_pixel(row) - row.first)
                                         : (p.x - row.l.x) / (row.r.x - row.l.x));
        p.u = trace("u", row.l.u + p.s * (row.r.u - row.l.u));
        p.v = trace("v", row.l.v + p.s * (row.r.v - row.l.v));
        p.texel.column = trace("column", texel_index(p.u, texture.width()));
        p.texel.row = trace("row", texel_index(p.v, texture.height()));
        fetch(p);
        p.fate = trace.fate(Fate::written);
        return p;
    }
    Int end_pixel(const Row& row) const { return plain(row.first <= row.last) ? row.last - 1 : row.last + 1; }
    Int texel_index(const T& a, int size) const {
        return wrapped(quirk.whole_pixels ? trunc(a) : floor(a), size, texture.wrap);
    }
    void fetch(Pixel& p) const {
        const Rgb& colour = texture.texels.at(int(plain(p.texel.column)), int(plain(p.texel.row)));
        const T light = trace("L", Input<T>::from(lightness, mode));
        p.texel.r = trace("r", shade(colour.r, light));
        p.texel.g = trace("g", shade(colour.g, light));
        p.texel.b = trace("b", shade(colour.b, light));
    }
    Int shade(int channel, const T& light) const {
        return lightness == 1 ? Int(channel) : lit(T(channel), light, false);
    }

    static constexpr Integer kRowsBeyond = 128;   ///< rows above and below the picture whose ghosts are still drawn
    static constexpr Integer kBufferRows = 1024;  ///< as far back as a slot is looked for: far-off corners cost no time
    struct Ghost {
        Integer x = 0, y = 0;
        Pixel pixel;
    };
    /// A row of one pixel is counted but not filled in, so the slot of the row buffer that is drawn for it still
    /// holds what an earlier section left there; in a fresh buffer, texel (0, 0) at pixel (0, 0).
    Ghost ghost(const Ring& ring, const std::vector<Section>& drawn, const Int& j) const {
        return trace.quiet([&] {
            Integer slot = 0;
            const Integer first = greater(plain(drawn.back().first), plain(j) - kBufferRows);
            for (Integer y = first; y < plain(j); ++y) slot += span(ring, drawn.back(), Int(y)).count;
            Ghost g;
            for (std::size_t k = drawn.size() - 1; k-- > 0;)
                if (filled(ring, drawn[k], slot, g)) return g;
            fetch(g.pixel);
            g.pixel.note = Note::ghost;
            return g;
        });
    }
    /// Whether section `s` filled slot number `slot` of the buffer; then `g` is what it put there.
    bool filled(const Ring& ring, const Section& s, Integer slot, Ghost& g) const {
        const Integer last = lesser(plain(s.last), plain(s.first) + kBufferRows);
        for (Integer y = plain(s.first); y < last; ++y) {
            const Row row = span(ring, s, Int(y));
            if (slot >= row.count) {
                slot -= row.count;
                continue;
            }
            if (row.count == 1) return false;
            g.x = plain(row.first) + (plain(row.first <= row.last) ? slot : -slot);
            g.y = y;
            g.pixel = pixel(row, Int(g.x));
            g.pixel.note = Note::ghost;
            return true;
        }
        return false;
    }
};

}  // namespace texelscope
