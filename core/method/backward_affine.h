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
        const Face<T> face = face_of(*this, polygon, false);
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
        if (plain(first >= last)) return;

        const auto& [a, b, c] = inverse[0];
        const auto& [d, e, f] = inverse[1];
        const T x = trace("X", T(first) + T(1) / 2);
        T u = trace("u_start", a * x + b * y + c);
        T v = trace("v_start", d * x + e * y + f);
        for (const Int i : trace.walk('x', first, last)) {
            if (quirk.add_first) u = u + a, v = v + d;  // Q1
            if (trace.wanted('x', i)) put(i, j, pixel(u, v));
            if (!quirk.add_first) u = u + a, v = v + d;
        }
    }

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
