// The screen drives, in perspective: three additions and two divisions per pixel (S5: N. Holzschuch, "Textures: un peu
// de maths"). Corrected or as printed: a variant is a preset of the quirks.
#pragma once

#include <span>

#include "core/method/face.h"
#include "core/method/texel.h"

namespace texelscope {

/// What the source does otherwise than meant; all off is the corrected method.
struct BackwardProjectiveQuirks {
    bool wrong_slope = false;
    bool reciprocal = false;  ///< not a fault: one division and two products in place of two divisions
};

template <Real T, Traceable Trace>
struct BackwardProjective {
    using Number = T;
    using Int = IntegerOf<T>;
    using Quirks = BackwardProjectiveQuirks;

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
        if (row.empty()) return;

        const T &a = inverse[0][0], &b = inverse[0][1], &d = inverse[1][0], &g = inverse[2][0];
        const T x = trace("X", T(row.first) + T(1) / 2);
        T U = trace("U_start", value_at(inverse[0], x, row.at));
        T V = trace("V_start", value_at(inverse[1], x, row.at));
        T W = trace("W_start", value_at(inverse[2], x, row.at));
        for (const Int i : trace.walk('x', row.first, row.last)) {
            if (trace.wanted('x', i)) put(i, j, pixel(U, V, W));
            U = U + a;
            V = V + (quirk.wrong_slope ? b : d);  // Q1
            W = W + g;
        }
    }

    Fragment<T> pixel(const T& u_over_w, const T& v_over_w, const T& one_over_w) const {
        const T U = trace("U", u_over_w);
        const T V = trace("V", v_over_w);
        const T W = trace("W", one_over_w);
        if (!quirk.reciprocal) return fragment_at(*this, T(U / W), T(V / W));
        const T w = trace("w", T(1) / W);
        return fragment_at(*this, T(U * w), T(V * w));
    }
};

}  // namespace texelscope
