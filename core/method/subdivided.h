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
        const Samples<T> rows = rows_of(*this, face.outline);
        for (const Int j : trace.each('y', rows.first, rows.last)) draw_row(face, inverse, j, put);
        return Fate::written;
    }

    void draw_row(const Face<T>& face, const Matrix3<T>& inverse, const Int& j, auto&& put) const {
        const Samples<T> row = row_of(*this, face.outline, j);

        Integer next = plain(row.first);
        const Integer final = plain(row.last) - 1;
        Span s;
        for (const Int i : trace.walk('x', row.first, row.last)) {
            if (plain(i) == next) {
                const Integer end = span_end(inverse, row.at, next, final);
                s = corrected(inverse, row.at, i, end);
                next = greater(end, next + 1);
            }
            if (trace.wanted('x', i)) put(i, j, fragment_at(*this, s.u, s.v));
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
        const T w = T(1) / value_at(inverse[2], x, y);
        return {value_at(inverse[0], x, y) * w, value_at(inverse[1], x, y) * w};
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
        const T w0 = value_at(inverse[2], x0, y), w1 = value_at(inverse[2], x1, y);
        const T near = greater(w0, w1), far = lesser(w0, w1);
        const Place a = at(inverse, x0, y), b = at(inverse, x1, y);
        const auto small = [&](const T& delta) {
            const T size = plain(delta < 0) ? -delta : delta, e = T(1) / 16;
            return plain(size <= e) || plain(near * ((size - e) * (size - e)) <= far * ((size + e) * (size + e)));
        };
        return small(b.u - a.u) && small(b.v - a.v);
    }
};

}  // namespace texelscope
