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
            const Samples<T> rows = rows_of(*this, face.outline);
            for (const Int j : trace.each('y', rows.first, rows.last)) draw_row(face, inverse, j, put);
        } else {
            const Samples<T> columns = columns_of(*this, face.outline);
            for (const Int i : trace.each('x', columns.first, columns.last)) draw_column(face, inverse, i, put);
        }
        return Fate::written;
    }
    static T magnitude(const T& a) { return plain(a < 0) ? -a : a; }

    void draw_row(const Face<T>& face, const Matrix3<T>& inverse, const Int& j, auto&& put) const {
        const Samples<T> row = row_of(*this, face.outline, j);
        if (row.empty()) return;

        const T x = trace("X", T(row.first) + T(1) / 2);
        const T w = depth(inverse, x, row.at);
        T u = trace("u_start", value_at(inverse[0], x, row.at) * w);
        T v = trace("v_start", value_at(inverse[1], x, row.at) * w);
        const T du = trace("du", inverse[0][0] * w);
        const T dv = trace("dv", inverse[1][0] * w);
        for (const Int i : trace.walk('x', row.first, row.last)) {
            if (trace.wanted('x', i)) put(i, j, fragment_at(*this, u, v));
            u = u + du;
            v = v + dv;
        }
    }
    void draw_column(const Face<T>& face, const Matrix3<T>& inverse, const Int& i, auto&& put) const {
        const Samples<T> column = column_of(*this, face.outline, i);
        if (column.empty()) return;

        const T y = trace("Y", T(column.first) + T(1) / 2);
        const T w = depth(inverse, column.at, y);
        T u = trace("u_start", value_at(inverse[0], column.at, y) * w);
        T v = trace("v_start", value_at(inverse[1], column.at, y) * w);
        const T du = trace("du", inverse[0][1] * w);
        const T dv = trace("dv", inverse[1][1] * w);
        for (const Int j : trace.walk('y', column.first, column.last)) {
            if (trace.wanted('y', j)) put(i, j, fragment_at(*this, u, v));
            u = u + du;
            v = v + dv;
        }
    }
    /// The only division of a row or column.
    T depth(const Matrix3<T>& inverse, const T& x, const T& y) const {
        return trace("w", T(1) / value_at(inverse[2], x, y));
    }
};

}  // namespace texelscope
