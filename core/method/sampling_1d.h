// One dimension: which of so many texels does each of n pixels take? (S3: A. LaMothe, affine texture mapping, Dr.
// Dobb's Journal, July 1998). Every row of an upright rectangle is sampled alike. Corrected or as printed, by quirks.
#pragma once

#include <span>

#include "core/method/face.h"
#include "core/method/texel.h"

namespace texelscope {

/// What the source does otherwise than meant; all off is the corrected method, which takes the middles of pixels.
struct Sampling1dQuirks {
    bool uneven_start = false, rounded = false;
    bool start_zero = false, start_ratio = false;  ///< not in the source as a choice: its two starts
};

template <Real T, Traceable Trace>
struct Sampling1d {
    using Number = T;
    using Int = IntegerOf<T>;
    using Quirks = Sampling1dQuirks;

    struct Setup {
        T ratio{}, start{}, left{}, top{}, v{}, v_ratio{};
        Int begin{};
    };
    using Pixel = Fragment<T>;

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
        trace.stage("ratio");
        const Setup s = setup(face);

        trace.stage("pixels");
        const Samples<T> rows = rows_of(*this, face.outline);
        for (const Int j : trace.each('y', rows.first, rows.last)) draw_row(face, s, j, put);
        return Fate::written;
    }

    Setup setup(const Face<T>& face) const {
        const auto least = [&](auto axis, bool most) {
            std::size_t best = 0;
            for (std::size_t n = 1; n < face.ring.size(); ++n) {
                const auto &p = face.ring[n], &q = face.ring[best];
                if (most ? plain(q.*axis < p.*axis) : plain(p.*axis < q.*axis)) best = n;
            }
            return face.ring[best];
        };
        using Corner = typename Face<T>::Corner;
        const Corner left = least(&Corner::x, false), right = least(&Corner::x, true);
        const Corner top = least(&Corner::y, false), bottom = least(&Corner::y, true);
        Setup s;
        s.left = left.x;
        s.top = top.y;
        s.v = top.v;
        s.v_ratio = trace("v_ratio", (bottom.v - top.v) / (bottom.y - top.y));
        s.ratio = trace("ratio", (right.u - left.u) / (right.x - left.x));
        if (quirk.rounded) s.ratio = trace("ratio", T(round_even(s.ratio * 100)) / 100);
        s.begin = trace("begin", ceil(left.x - T(1) / 2));
        s.start = trace("start", left.u + start_of(s));
        return s;
    }
    /// How far into the source the first pixel reaches [texels].
    T start_of(const Setup& s) const {
        if (quirk.uneven_start) return plain(s.ratio < 1 && -s.ratio < 1) ? s.ratio : T(0);  // Q1
        if (quirk.start_zero) return T(0);
        if (quirk.start_ratio) return s.ratio;
        return (T(s.begin) + T(1) / 2 - s.left) * s.ratio;
    }

    void draw_row(const Face<T>& face, const Setup& s, const Int& j, auto&& put) const {
        const Samples<T> row = row_of(*this, face.outline, j);
        const T v = trace("v", s.v + (row.at - s.top) * s.v_ratio);
        for (const Int i : trace.each('x', row.first, row.last)) put(i, j, pixel(s, i, v));
    }
    Pixel pixel(const Setup& s, const Int& i, const T& v) const {
        Pixel p;
        const Int n = trace("n", i - s.begin);
        p.u = trace("u", s.start + T(n) * s.ratio);
        p.v = v;
        p.texel = read_texel(*this, p.u, p.v);
        p.fate = trace.fate(Fate::written);
        return p;
    }
};

}  // namespace texelscope
