// Floors and walls: one depth for a whole row or column, so that the division leaves the inner loop (S5: N. Holzschuch,
// "Textures: un peu de maths"; what Doom did). A face that is neither is drawn as if it were, by the nearer of the two.
#pragma once

#include <span>

#include "core/method/face.h"
#include "core/method/texel.h"

namespace texelscope {

/// A choice that one may want to see; all off is the method.
struct ConstantZQuirks {
    bool other_way = false;
};

template <Real T, Traceable Trace>
struct ConstantZ {
    using Number = T;
    using Int = IntegerOf<T>;
    using Quirks = ConstantZQuirks;

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

        // A floor has g = 0: 1/w does not change along a row. A wall has h = 0: nor does it down a column.
        const T g = magnitude(inverse[2][0]), h = magnitude(inverse[2][1]);
        const bool floor_like = plain(h < g) == quirk.other_way;
        trace.stage(floor_like ? "rows" : "columns");
        if (floor_like) {
            const auto rows = face.outline.rows();
            const Int first = trace("first_row", greater(ceil(rows.low - T(1) / 2), Int(frame.y0)));
            const Int last = trace("last_row", lesser(ceil(rows.high - T(1) / 2), Int(frame.y1)));
            for (const Int j : trace.each('y', first, last)) draw_row(face, inverse, j, put);
        } else {
            const auto columns = face.outline.columns();
            const Int first = trace("first_column", greater(ceil(columns.low - T(1) / 2), Int(frame.x0)));
            const Int last = trace("last_column", lesser(ceil(columns.high - T(1) / 2), Int(frame.x1)));
            for (const Int i : trace.each('x', first, last)) draw_column(face, inverse, i, put);
        }
        return Fate::written;
    }
    static T magnitude(const T& a) { return plain(a < 0) ? -a : a; }

    void draw_row(const Face<T>& face, const Matrix3<T>& inverse, const Int& j, auto&& put) const {
        const T y = trace("Y", T(j) + T(1) / 2);
        const auto span = face.outline.row(y);
        if (span.empty) return;
        const T left = trace("x_l", span.from);
        const T right = trace("x_r", span.to);
        const Int first = trace("first", greater(ceil(left - T(1) / 2), Int(frame.x0)));
        const Int last = trace("last", lesser(ceil(right - T(1) / 2), Int(frame.x1)));
        if (plain(first >= last)) return;

        const T x = trace("X", T(first) + T(1) / 2);
        const T w = depth(inverse, x, y);
        T u = trace("u_start", numerator(inverse[0], x, y) * w);
        T v = trace("v_start", numerator(inverse[1], x, y) * w);
        const T du = trace("du", inverse[0][0] * w);
        const T dv = trace("dv", inverse[1][0] * w);
        for (const Int i : trace.walk('x', first, last)) {
            if (trace.wanted('x', i)) put(i, j, pixel(u, v));
            u = u + du;
            v = v + dv;
        }
    }
    void draw_column(const Face<T>& face, const Matrix3<T>& inverse, const Int& i, auto&& put) const {
        const T x = trace("X", T(i) + T(1) / 2);
        const auto span = face.outline.column(x);
        if (span.empty) return;
        trace("y_t", span.from);
        trace("y_b", span.to);
        const Int first = trace("first", greater(face.outline.first(span), Int(frame.y0)));
        const Int last = trace("last", lesser(face.outline.last(span), Int(frame.y1)));
        if (plain(first >= last)) return;

        const T y = trace("Y", T(first) + T(1) / 2);
        const T w = depth(inverse, x, y);
        T u = trace("u_start", numerator(inverse[0], x, y) * w);
        T v = trace("v_start", numerator(inverse[1], x, y) * w);
        const T du = trace("du", inverse[0][1] * w);
        const T dv = trace("dv", inverse[1][1] * w);
        for (const Int j : trace.walk('y', first, last)) {
            if (trace.wanted('y', j)) put(i, j, pixel(u, v));
            u = u + du;
            v = v + dv;
        }
    }
    /// The only division of a row or column.
    T depth(const Matrix3<T>& inverse, const T& x, const T& y) const {
        return trace("w", T(1) / numerator(inverse[2], x, y));
    }
    static T numerator(const Row3<T>& row, const T& x, const T& y) { return row[0] * x + row[1] * y + row[2]; }

    Pixel pixel(const T& u, const T& v) const {
        Pixel p;
        p.u = trace("u", u);
        p.v = trace("v", v);
        p.texel = read_texel(*this, p.u, p.v);
        p.fate = trace.fate(Fate::written);
        return p;
    }
};

}  // namespace texelscope
