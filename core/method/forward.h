// The texture drives: every texel writes the pixel that its middle falls on. So magnifying leaves holes, and shrinking
// writes pixels again and again (S5: N. Holzschuch, "Textures: un peu de maths").
#pragma once

#include <span>

#include "core/method/face.h"
#include "core/method/texel.h"

namespace texelscope {

/// The source says nothing that it does not mean.
struct ForwardQuirks {};

template <Real T, Traceable Trace>
struct Forward {
    using Number = T;
    using Int = IntegerOf<T>;
    using Quirks = ForwardQuirks;

    struct Pixel {
        T u{}, v{};
        Int x{}, y{};
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
        const Outline<T> on_texture = texture_outline(face);
        if (const Fate fate = texture_fate(*this, face, on_texture); fate != Fate::written) return fate;
        trace.stage("map");
        const Matrix3<T> map = map_of(*this, face);

        trace.stage("texels");
        const auto rows = on_texture.rows();
        const Int first = trace("first_v", ceil(rows.low - T(1) / 2)),
                  last = trace("last_v", ceil(rows.high - T(1) / 2));
        for (const Int v : trace.each('v', first, last)) draw_row(on_texture, map, v, put);
        return Fate::written;
    }

    void draw_row(const Outline<T>& on_texture, const Matrix3<T>& map, const Int& v, auto&& put) const {
        const T centre = trace("v_c", T(v) + T(1) / 2);
        const auto span = on_texture.row(centre);
        if (span.empty) return;
        const Int first = trace("first_u", ceil(span.from - T(1) / 2)),
                  last = trace("last_u", ceil(span.to - T(1) / 2));
        for (const Int u : trace.each('u', first, last)) {
            const Pixel p = pixel(map, u, centre);
            if (p.fate == Fate::written) put(p.x, p.y, p);
        }
    }

    Pixel pixel(const Matrix3<T>& map, const Int& u, const T& v) const {
        Pixel p;
        p.u = trace("u_c", T(u) + T(1) / 2);
        p.v = v;
        const T w = trace("w", value_at(map[2], p.u, p.v));
        const T X = trace("X", value_at(map[0], p.u, p.v) / w);
        const T Y = trace("Y", value_at(map[1], p.u, p.v) / w);
        p.x = trace("x", floor(X));
        p.y = trace("y", floor(Y));
        if (has_no_value(X) || has_no_value(Y)) return p.fate = trace.fate(Fate::undefined), p;
        if (!frame.contains(plain(p.x), plain(p.y))) return p.fate = trace.fate(Fate::off_screen), p;
        p.texel = read_texel(*this, p.u, p.v);
        p.fate = trace.fate(Fate::written);
        return p;
    }
};

}  // namespace texelscope
