// Two passes along the axes in place of one across the plane: tmp[x][v] from the texture's rows, then the picture's
// columns from tmp (S5: N. Holzschuch, "Textures: un peu de maths"). Corrected or as printed, by quirks.
#pragma once

#include <span>
#include <vector>

#include "core/method/face.h"
#include "core/method/texel.h"

namespace texelscope {

/// What the source does otherwise than meant; all off is the corrected method.
struct TwoPassQuirks {
    bool forward = false;
};

template <Real T, Traceable Trace>
struct TwoPass {
    using Number = T;
    using Int = IntegerOf<T>;
    using Quirks = TwoPassQuirks;

    /// Which texel of row v came to column x in the first pass. A row more than the texture's on either side.
    struct Buffer {
        static constexpr Integer kNone = INT64_MIN;
        Integer x0 = 0, x1 = 0, v0 = 0, v1 = 0;
        std::vector<Integer> u;

        [[nodiscard]] Integer& at(Integer x, Integer v) {
            return u[static_cast<std::size_t>((v - v0) * (x1 - x0) + x - x0)];
        }
        [[nodiscard]] Integer at(Integer x, Integer v) const {
            return u[static_cast<std::size_t>((v - v0) * (x1 - x0) + x - x0)];
        }
    };
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
        trace.stage("inverse");
        const Matrix3<T> inverse = inverse_of(*this, face);

        Buffer tmp = empty_buffer(face, on_texture);
        if (tmp.u.empty()) return Fate::written;
        quirk.forward ? first_pass_forward(on_texture, map, tmp) : first_pass(map, tmp);
        quirk.forward ? second_pass_forward(map, tmp, put) : second_pass(face, inverse, tmp, put);
        return Fate::written;
    }

    Buffer empty_buffer(const Face<T>& face, const Outline<T>& on_texture) const {
        const auto columns = face.outline.columns(), rows = on_texture.rows();
        Buffer tmp;
        tmp.x0 = greater(plain(floor(columns.low)), Integer(frame.x0));
        tmp.x1 = lesser(plain(ceil(columns.high)), Integer(frame.x1));
        tmp.v0 = plain(floor(rows.low)) - 1, tmp.v1 = plain(ceil(rows.high)) + 1;
        if (tmp.x1 > tmp.x0)
            tmp.u.assign(static_cast<std::size_t>((tmp.x1 - tmp.x0) * (tmp.v1 - tmp.v0)), Buffer::kNone);
        return tmp;
    }

    /// tmp[x][v]: where does column x cut row v of the texture?
    void first_pass(const Matrix3<T>& map, Buffer& tmp) const {
        trace.stage("pass 1");
        for (const Int v : trace.fill('v', tmp.v0, tmp.v1)) {
            for (const Int x : trace.fill('x', tmp.x0, tmp.x1)) {
                if (lost(map, x)) continue;
                const T u = trace("u", u_at(map, T(x) + T(1) / 2, T(v) + T(1) / 2));
                tmp.at(plain(x), plain(v)) = plain(floor(u));
            }
        }
    }
    /// (m_11 u + m_12 v + m_13) / (m_31 u + m_32 v + m_33) = x, solved for u.
    T u_at(const Matrix3<T>& map, const T& x, const T& v) const {
        return ((map[2][1] * v + map[2][2]) * x - map[0][1] * v - map[0][2]) / (map[0][0] - map[2][0] * x);
    }
    /// The column runs along one row of the texture, as all do after a quarter turn: no u is better than another.
    bool lost(const Matrix3<T>& map, const Int& x) const {
        return plain(map[0][0] - map[2][0] * (T(x) + T(1) / 2) == 0);
    }
    void second_pass(const Face<T>& face, const Matrix3<T>& inverse, const Buffer& tmp, auto&& put) const {
        trace.stage("pass 2");
        for (const Int x : trace.each('x', tmp.x0, tmp.x1)) {
            const Samples<T> column = column_of(*this, face.outline, x);
            for (const Int y : trace.each('y', column.first, column.last)) {
                const T Y = trace("Y", T(y) + T(1) / 2);
                const T v = trace("v", value_at(inverse[1], column.at, Y) / value_at(inverse[2], column.at, Y));
                put(x, y, pixel(tmp, plain(x), v));
            }
        }
    }
    Pixel pixel(const Buffer& tmp, Integer x, const T& v) const {
        Pixel p;
        const Integer row = lesser(greater(plain(floor(v)), tmp.v0), tmp.v1 - 1), u = tmp.at(x, row);
        if (u == Buffer::kNone) return p.fate = trace.fate(Fate::undefined), p;
        const Int column = trace("tmp", u);
        p.u = trace("u", T(column) + T(1) / 2);
        p.v = v;
        p.texel = read_texel(*this, p.u, p.v);
        p.fate = trace.fate(Fate::written);
        return p;
    }

    /// As printed, each pass is driven by what it reads: what magnifies leaves holes.
    void first_pass_forward(const Outline<T>& on_texture, const Matrix3<T>& map, Buffer& tmp) const {
        trace.stage("pass 1");
        for (const Int v : trace.fill('v', tmp.v0, tmp.v1)) {
            const T V = trace("v_c", T(v) + T(1) / 2);
            const auto span = on_texture.row(V);
            if (span.empty) continue;
            for (const Int u : trace.fill('u', ceil(span.from - T(1) / 2), ceil(span.to - T(1) / 2))) {
                const T U = trace("u_c", T(u) + T(1) / 2);
                const T w = trace("w", value_at(map[2], U, V));
                const Int x = trace("x", floor(value_at(map[0], U, V) / w));
                if (!has_no_value(w) && plain(x) >= tmp.x0 && plain(x) < tmp.x1) tmp.at(plain(x), plain(v)) = plain(u);
            }
        }
    }
    void second_pass_forward(const Matrix3<T>& map, const Buffer& tmp, auto&& put) const {
        trace.stage("pass 2");
        for (const Int x : trace.each('x', tmp.x0, tmp.x1))
            for (const Int v : trace.each('v', tmp.v0, tmp.v1)) {
                const Integer u = tmp.at(plain(x), plain(v));
                if (u == Buffer::kNone) continue;
                const Pixel p = moved(map, u, x, v);
                if (p.fate == Fate::written) put(x, p.y, p);
            }
    }
    Pixel moved(const Matrix3<T>& map, Integer u, const Int& x, const Int& v) const {
        Pixel p;
        const Int column = trace("tmp", u);
        p.u = trace("u", T(column) + T(1) / 2);
        p.v = trace("v_c", T(v) + T(1) / 2);
        const T U = trace("u_x", u_at(map, T(x) + T(1) / 2, p.v));
        const T w = trace("w", value_at(map[2], U, p.v));
        const T Y = trace("Y", value_at(map[1], U, p.v) / w);
        p.y = trace("y", floor(Y));
        if (has_no_value(Y)) return p.fate = trace.fate(Fate::undefined), p;
        if (plain(p.y) < frame.y0 || plain(p.y) >= frame.y1) return p.fate = trace.fate(Fate::off_screen), p;
        p.texel = read_texel(*this, p.u, p.v);
        p.fate = trace.fate(Fate::written);
        return p;
    }
};

}  // namespace texelscope
