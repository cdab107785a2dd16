// The screen drives: each pixel asks for its texel, by two additions (S5: N. Holzschuch, "Textures: un peu de maths").
// For parallelograms; corrected or as printed: a variant is a preset of the quirks.
#pragma once

#include <span>

#include "core/method/face.h"
#include "core/method/texel.h"

namespace texelscope {

/// What the source does otherwise than meant; all off is the corrected method.
struct BackwardAffineQuirks {
    bool add_first = false;
};

template <Real T, Traceable Trace>
struct BackwardAffine {
    using Number = T;
    using Int = IntegerOf<T>;
    using Quirks = BackwardAffineQuirks;

    Rect frame;
    const Texture& texture;
    float lightness;
    bool cull_back;
    Quirks quirk;
    NumberMode mode;
    Trace trace;

    Fate draw(std::span<const Vertex> polygon, auto&& put) const {
        trace.stage("corners");
        const Face<T> face = face_of(*this, polygon, false);
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
        if (row.empty()) return;

        const T &a = inverse[0][0], &d = inverse[1][0];
        const T x = trace("X", T(row.first) + T(1) / 2);
        T u = trace("u_start", value_at(inverse[0], x, row.at));
        T v = trace("v_start", value_at(inverse[1], x, row.at));
        for (const Int i : trace.walk('x', row.first, row.last)) {
            if (quirk.add_first) u = u + a, v = v + d;  // Q1
            if (trace.wanted('x', i)) put(i, j, fragment_at(*this, u, v));
            if (!quirk.add_first) u = u + a, v = v + d;
        }
    }
};

}  // namespace texelscope
