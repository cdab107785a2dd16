// Triangles by three edge equations and two planes over the screen (S1: A. Griffini, "Texture mapping like it's
// 1995, in Python", PyCon Italia 2026). Corrected or as printed: a variant is a preset of the quirks.
#pragma once

#include <array>
#include <span>

#include "core/geometry/vertex.h"
#include "core/method/edge_arrays.h"
#include "core/method/texel.h"
#include "core/trace/trace.h"

namespace texelscope {

/// What the source does otherwise than meant; all off is the corrected method.
struct EdgeEquationsQuirks {
    bool inclusive = false, one_winding = false, truncate = false, trunc_box = false, wrap_light = false;
    bool corners = false;
    bool arrays = false;        ///< not a fault: four passes over arrays, as the source has them, in place of one loop
    bool exclusive = false;     ///< not in the source: the other careless rule
    bool float_pixels = false;  ///< as published: everything per pixel in float32 arrays, whatever the set-up's type
    bool based = false;      ///< not in the source: the planes are counted from corner 0, not from the screen's origin
    bool additions = false;  ///< S5's loop: along a row u and v grow by u_x and v_x, pixel after pixel
};

template <Real T, Traceable Trace>
struct EdgeEquations {
    using Int = IntegerOf<T>;
    using Truth = TruthOf<T>;
    using Quirks = EdgeEquationsQuirks;

    struct Corner {
        T x, y, u, v;
    };
    using Corners = std::array<Corner, 3>;
    struct Plane {
        T x, y, k;
    };  ///< a = x X + y Y + k over the screen, X and Y counted from Setup::base
    struct Side {
        T x, y, k;
        Truth owns;
    };  ///< E = x X + y Y + k, negative inside; owns: samples on it are ours
    struct Box {
        Int x0, x1, y0, y1;
    };  ///< half-open
    struct Point {
        T x{}, y{};
    };
    struct Setup {
        T delta{}, light{}, half{};
        Point base{};  ///< where both planes have the value k
        Plane u{}, v{};
        std::array<Side, 3> side{};
        Box box{};
        Fate fate = Fate::written;
    };
    struct Pixel {
        T x{}, y{};
        std::array<T, 3> E{};
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
    std::span<const glm::dvec2> unrounded{};  ///< x and y of the corners, where float32 has lost something of them
    double unrounded_light = 1;

    Fate draw(std::span<const Vertex> triangle, auto&& put) const {
        const Setup s = setup(triangle);
        if (s.fate != Fate::written) return s.fate;
        if (quirk.arrays) return draw_arrays(s, put);
        trace.stage("pixels");
        if (quirk.additions) return draw_by_additions(s, put);
        for (const Int j : trace.each('y', s.box.y0, s.box.y1))
            for (const Int i : trace.each('x', s.box.x0, s.box.x1)) put(i, j, pixel(s, i, j));
        return Fate::written;
    }

    Setup setup(std::span<const Vertex> triangle) const {
        Setup s;
        trace.stage("delta");
        const Corners p{corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)};
        s.light = trace("L", Input<T>::from(in_double() ? unrounded_light : lightness, mode));
        s.half = Input<T>::from(quirk.corners ? 0.0F : 0.5F, mode);
        s.delta = trace("Δ", (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y));
        if (s.delta == 0)
            s.fate = trace.fate(Fate::zero_area);
        else if (plain(s.delta != s.delta))
            s.fate = trace.fate(Fate::undefined);
        else if (cull_back && s.delta < 0)
            s.fate = trace.fate(Fate::culled);
        if (s.fate != Fate::written) return s;

        if (quirk.based) s.base = {p[0].x, p[0].y};
        trace.stage("u plane");
        s.u = plane("u", p, p[0].u, p[1].u, p[2].u, s.delta);
        trace.stage("v plane");
        s.v = plane("v", p, p[0].v, p[1].v, p[2].v, s.delta);
        trace.stage("sides");
        for (int e = 0; e < 3; ++e) s.side[e] = half_plane(e, p[e], p[(e + 1) % 3], s.delta);
        trace.stage("box");
        s.box = bounds(p);
        if (s.box.x0 >= s.box.x1 || s.box.y0 >= s.box.y1) s.fate = trace.fate(Fate::off_screen);
        return s;
    }

    Corner corner(std::span<const Vertex> triangle, int n) const {
        Corner c;
        c.x = trace({"x", n}, Input<T>::from(in_double() ? unrounded[n].x : triangle[n].x, mode));
        c.y = trace({"y", n}, Input<T>::from(in_double() ? unrounded[n].y : triangle[n].y, mode));
        c.u = trace({"u", n}, Input<T>::from(triangle[n].u, mode));
        c.v = trace({"v", n}, Input<T>::from(triangle[n].v, mode));
        return c;
    }

    /// As published, a solid's corners are never rounded to float32.
    bool in_double() const { return quirk.float_pixels && !unrounded.empty(); }

    Plane plane(const char* a, const Corners& p, const T& a0, const T& a1, const T& a2, const T& delta) const {
        const T x = trace({a, "_x"}, ((a1 - a0) * (p[2].y - p[0].y) - (a2 - a0) * (p[1].y - p[0].y)) / delta);
        const T y = trace({a, "_y"}, ((p[1].x - p[0].x) * (a2 - a0) - (p[2].x - p[0].x) * (a1 - a0)) / delta);
        if (quirk.based) return {x, y, a0};
        const T k = trace({a, "_k"}, a0 - p[0].x * x - p[0].y * y);
        return {x, y, k};
    }

    Side half_plane(int e, const Corner& from, const Corner& to, const T& delta) const {
        // From the same end for both triangles at this side: then a sample on it has one owner in any number type.
        const Truth back = to.y < from.y || (to.y == from.y && to.x < from.x);
        const bool swapped = !quirk.inclusive && plain(back);
        const Corner& p = swapped ? to : from;
        const Corner& q = swapped ? from : to;
        T x = trace(Name::side("n_x", e), q.y - p.y);
        T y = trace(Name::side("n_y", e), p.x - q.x);
        T k = trace(Name::side("k", e), -(p.x * x + p.y * y));
        if (swapped != (!quirk.one_winding && plain(delta < 0))) {  // turn it, so that inside is negative
            x = trace(Name::side("n_x", e), -x);
            y = trace(Name::side("n_y", e), -y);
            k = trace(Name::side("k", e), -k);
        }
        return {x, y, k, trace(Name::side("owns", e), owns_samples(x, y))};
    }
    /// The top-left rule: a left side owns the samples on it, and so does a level one with the inside below it.
    Truth owns_samples(const T& x, const T& y) const {
        if (quirk.inclusive) return Truth(true);  // Q1
        if (quirk.exclusive) return Truth(false);
        return x < 0 || (x == 0 && y < 0);
    }

    Box bounds(const Corners& p) const {
        const T left = trace("x_min", lesser(lesser(p[0].x, p[1].x), p[2].x));
        const T right = trace("x_max", greater(greater(p[0].x, p[1].x), p[2].x));
        const T top = trace("y_min", lesser(lesser(p[0].y, p[1].y), p[2].y));
        const T bottom = trace("y_max", greater(greater(p[0].y, p[1].y), p[2].y));
        Box box;
        box.x0 = trace("x_a", greater(whole(left), Int(frame.x0)));
        box.x1 = trace("x_b", lesser(whole(right) + 1, Int(frame.x1)));
        box.y0 = trace("y_a", greater(whole(top), Int(frame.y0)));
        box.y1 = trace("y_b", lesser(whole(bottom) + 1, Int(frame.y1)));
        return box;
    }
    Int whole(const T& a) const { return quirk.trunc_box ? trunc(a) : floor(a); }

    Pixel pixel(const Setup& s, const Int& i, const Int& j) const {
        Pixel p = cover(s, i, j);
        if (p.fate != Fate::written) return p;
        address(s, p);
        fetch(s, p);
        return p;
    }

    Pixel sample(const Setup& s, const Int& i, const Int& j) const {
        Pixel p;
        p.x = trace("X", T(i) + s.half);
        p.y = trace("Y", T(j) + s.half);
        return p;
    }
    Pixel cover(const Setup& s, const Int& i, const Int& j) const {
        Pixel p = sample(s, i, j);
        for (int e = 0; e < 3; ++e) {
            const Side& side = s.side[e];
            p.E[e] = trace(Name::side("E", e), affine(p, side.x, side.y, side.k));
            const Truth inside = trace(Name::side("in", e), p.E[e] < 0 || (p.E[e] == 0 && side.owns));
            if (!inside) {
                p.fate = trace.fate(outside_edge(e));
                return p;
            }
        }
        p.fate = trace.fate(Fate::written);
        return p;
    }

    /// What a plane, or a side, is at the sample.
    T affine(const Pixel& p, const T& x, const T& y, const T& k) const {
        if (!quirk.float_pixels) return p.x * x + p.y * y + k;
        return single(single(single(p.x * single(x)) + single(p.y * single(y))) + single(k));  // float32
    }
    void address(const Setup& s, Pixel& p) const {
        planes(s, p);
        texel_at(p);
    }
    void planes(const Setup& s, Pixel& p) const {
        if (quirk.based) return planes_from_corner(s, p);
        p.u = trace("u", affine(p, s.u.x, s.u.y, s.u.k));
        p.v = trace("v", affine(p, s.v.x, s.v.y, s.v.k));
    }
    void planes_from_corner(const Setup& s, Pixel& p) const {
        p.u = trace("u", s.u.k + (p.x - s.base.x) * s.u.x + (p.y - s.base.y) * s.u.y);
        p.v = trace("v", s.v.k + (p.x - s.base.x) * s.v.x + (p.y - s.base.y) * s.v.y);
    }
    void texel_at(Pixel& p) const {
        p.texel.column = trace("column", texel_index(p.u, texture.width()));
        p.texel.row = trace("row", texel_index(p.v, texture.height()));
    }
    Int texel_index(const T& a, int size) const {
        return quirk.truncate ? wrapped(trunc(a), size, Wrap::mask) : wrapped(floor(a), size, texture.wrap);
    }

    void fetch(const Setup& s, Pixel& p) const {
        const Rgb& colour = texture.texels.at(int(plain(p.texel.column)), int(plain(p.texel.row)));
        p.texel.r = trace("r", shade(s, colour.r));
        p.texel.g = trace("g", shade(s, colour.g));
        p.texel.b = trace("b", shade(s, colour.b));
    }
    Int shade(const Setup& s, int channel) const {
        return lightness == 1 ? Int(channel) : lit(T(channel), s.light, quirk.wrap_light);
    }

    /// Two additions per pixel: only the first sample of a row is multiplied out.
    Fate draw_by_additions(const Setup& s, auto&& put) const {
        for (const Int j : trace.each('y', s.box.y0, s.box.y1)) {
            Pixel next = row_start(s, j);
            for (const Int i : trace.walk('x', s.box.x0, s.box.x1)) {
                if (trace.wanted('x', i)) put(i, j, pixel(s, i, j, next));
                next.u = next.u + s.u.x;
                next.v = next.v + s.v.x;
            }
        }
        return Fate::written;
    }
    Pixel row_start(const Setup& s, const Int& j) const {
        Pixel first;
        first.x = trace("X", T(s.box.x0) + s.half);
        first.y = trace("Y", T(j) + s.half);
        planes(s, first);
        return first;
    }
    Pixel pixel(const Setup& s, const Int& i, const Int& j, const Pixel& walked) const {
        Pixel p = cover(s, i, j);
        if (p.fate != Fate::written) return p;
        p.u = trace("u", walked.u);
        p.v = trace("v", walked.v);
        texel_at(p);
        fetch(s, p);
        return p;
    }

    /// The source's own shape: whole arrays, one pass after the other. Each pass hands its results to the next.
    Fate draw_arrays(const Setup& s, auto&& put) const {
        if constexpr (!Trace::kVisits)
            if (edge_arrays::fit(s.box)) return edge_arrays::draw(*this, s, put);
        trace.stage("mask");
        for (const Int j : trace.each('y', s.box.y0, s.box.y1))
            for (const Int i : trace.each('x', s.box.x0, s.box.x1))
                if (const Pixel p = cover(s, i, j); p.fate != Fate::written) put(i, j, p);
        trace.stage("indices");
        for (const Int j : trace.each('y', s.box.y0, s.box.y1))
            for (const Int i : trace.each('x', s.box.x0, s.box.x1))
                if (masked(s, i, j).fate == Fate::written)
                    trace("address", (j - frame.y0) * frame.width() + (i - frame.x0));
        trace.stage("uv");
        for (const Int j : trace.each('y', s.box.y0, s.box.y1))
            for (const Int i : trace.each('x', s.box.x0, s.box.x1))
                if (Pixel p = masked(s, i, j); p.fate == Fate::written) address(s, p);
        trace.stage("store");
        for (const Int j : trace.each('y', s.box.y0, s.box.y1))
            for (const Int i : trace.each('x', s.box.x0, s.box.x1))
                if (Pixel p = addressed(s, i, j); p.fate == Fate::written) put(i, j, (fetch(s, p), p));
        return Fate::written;
    }
    Pixel masked(const Setup& s, const Int& i, const Int& j) const {
        const Pixel p = trace.quiet([&] { return cover(s, i, j); });
        return trace.fate(p.fate), p;
    }
    Pixel addressed(const Setup& s, const Int& i, const Int& j) const {
        Pixel p = masked(s, i, j);
        if (p.fate == Fate::written) p = trace.quiet([&] { return address(s, p), p; });
        return p;
    }
};

}  // namespace texelscope
