// In perspective every n pixels, and affine between them: one division where there were n (what Quake did; the bound
// is exact.md's closed form). n is 16, or chosen row by row so that no texel is off by more than a sixteenth.
#pragma once

#include <span>

#include "core/method/face.h"
#include "core/method/texel.h"

namespace texelscope {

/// Other distances; all off is every 16 pixels.
struct SubdividedQuirks {
    bool every_8 = false, every_32 = false, adaptive = false;
};

template <Real T, Traceable Trace>
struct Subdivided {
    using Number = T;
    using Int = IntegerOf<T>;
    using Quirks = SubdividedQuirks;

    struct Place {
        T u{}, v{};
    };  ///< on the texture [texels]
    struct Span {
        T u{}, v{}, du{}, dv{};
    };
    struct Pixel {
        T u{}, v{};
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
        trace.stage("corners");
        const Face<T> face = face_of(*this, polygon, true);
        if (face.fate != Fate::written) return face.fate;
        trace.stage("inverse");
        const Matrix3<T> inverse = inverse_of(*this, face);

        trace.stage("pixels");
        const auto rows = face.outline.rows();
        const Int first = trace("first_row", greater(ceil(rows.low - T(1) / 2), Int(frame.y0)));
        const Int last = trace("last_row", lesser(ceil(rows.high - T(1) / 2), Int(frame.y1)));
        for (const Int j : trace.each('y', first, last)) draw_row(face, inverse, j, put);
        return Fate::written;
    }

    void draw_row(const Face<T>& face, const Matrix3<T>& inverse, const Int& j, auto&& put) const {
        const T y = trace("Y", T(j) + T(1) / 2);
        const auto span = face.outline.row(y);
        if (span.empty) return;
        const T left = trace("x_l", span.from);
        const T right = trace("x_r", span.to);
        const Int first = trace("first", greater(ceil(left - T(1) / 2), Int(frame.x0)));
        const Int last = trace("last", lesser(ceil(right - T(1) / 2), Int(frame.x1)));

        Integer next = plain(first);
        Span s;
        for (const Int i : trace.walk('x', first, last)) {
            if (plain(i) == next) {
                const Integer end = span_end(inverse, y, next, plain(last) - 1);
                s = corrected(inverse, y, i, end);
                next = greater(end, next + 1);
            }
            if (trace.wanted('x', i)) put(i, j, pixel(s));
            s.u = s.u + s.du;
            s.v = s.v + s.dv;
        }
    }

    /// Right in perspective at both ends: samples `from` and `to`, which the row has.
    Span corrected(const Matrix3<T>& inverse, const T& y, const Int& from, Integer to) const {
        const Place a = at(inverse, T(from) + T(1) / 2, y);
        Span s;
        s.u = trace("u_a", a.u);
        s.v = trace("v_a", a.v);
        s.du = s.dv = T(0);
        const Integer count = to - plain(from);
        if (count <= 0) return s;
        const Place b = at(inverse, T(Int(to)) + T(1) / 2, y);
        const T u_b = trace("u_b", b.u);
        const T v_b = trace("v_b", b.v);
        s.du = trace("du", (u_b - s.u) / T(Int(count)));
        s.dv = trace("dv", (v_b - s.v) / T(Int(count)));
        return s;
    }
    Place at(const Matrix3<T>& inverse, const T& x, const T& y) const {
        const auto on = [&](const Row3<T>& row) { return row[0] * x + row[1] * y + row[2]; };
        const T w = T(1) / on(inverse[2]);
        return {on(inverse[0]) * w, on(inverse[1]) * w};
    }

    /// The sample where the span that begins at `from` ends, at most `last`.
    Integer span_end(const Matrix3<T>& inverse, const T& y, Integer from, Integer last) const {
        if (!quirk.adaptive) return lesser(from + (quirk.every_8 ? 8 : quirk.every_32 ? 32 : 16), last);
        return trace.quiet([&] {
            Integer good = lesser(from + 1, last), bad = last + 1;  // the error grows with the length
            if (exact_enough(inverse, y, from, last)) return last;
            while (good + 1 < bad) {
                const Integer middle = good + (bad - good) / 2;
                (exact_enough(inverse, y, from, middle) ? good : bad) = middle;
            }
            return good;
        });
    }
    /// Affine for perspective is off by at most |Δu| (√r − 1) / (√r + 1) where depths differ by the ratio r; that is
    /// ≤ e exactly where r (|Δu| − e)² ≤ (|Δu| + e)², or |Δu| ≤ e.
    bool exact_enough(const Matrix3<T>& inverse, const T& y, Integer from, Integer to) const {
        const T x0 = T(Int(from)) + T(1) / 2, x1 = T(Int(to)) + T(1) / 2;
        const auto w = [&](const T& x) { return inverse[2][0] * x + inverse[2][1] * y + inverse[2][2]; };
        const T w0 = w(x0), w1 = w(x1);
        const T near = greater(w0, w1), far = lesser(w0, w1);
        const Place a = at(inverse, x0, y), b = at(inverse, x1, y);
        const auto small = [&](const T& delta) {
            const T size = plain(delta < 0) ? -delta : delta, e = T(1) / 16;
            return plain(size <= e) || plain(near * ((size - e) * (size - e)) <= far * ((size + e) * (size + e)));
        };
        return small(b.u - a.u) && small(b.v - a.v);
    }

    Pixel pixel(const Span& s) const {
        Pixel p;
        p.u = trace("u", s.u);
        p.v = trace("v", s.v);
        p.texel = read_texel(*this, p.u, p.v);
        p.fate = trace.fate(Fate::written);
        return p;
    }
};

}  // namespace texelscope
