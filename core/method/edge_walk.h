// Triangles by scan lines: both sides are walked down by additions, and each row across (S3: A. LaMothe, affine
// texture mapping, Dr. Dobb's Journal, July 1998). Corrected or as printed: a variant is a preset of the quirks.
#pragma once

#include <array>
#include <span>
#include <utility>

#include "core/geometry/vertex.h"
#include "core/method/texel.h"
#include "core/trace/trace.h"

namespace texelscope {

/// What the source does otherwise than meant; all off is the corrected method.
struct EdgeWalkQuirks {
    bool inclusive = false, wrong_sign = false, exchanged = false, apex = false, whole_start = false;
};

template <Real T, Traceable Trace>
struct EdgeWalk {
    using Int = IntegerOf<T>;
    using Truth = TruthOf<T>;
    using Quirks = EdgeWalkQuirks;

    struct Corner {
        T x{}, y{}, u{}, v{};
    };
    struct Side {
        Corner from;
        T x{}, u{}, v{};
    };  ///< what a row adds, from the upper end on
    struct Point {
        T x{}, u{}, v{};
    };  ///< where a row meets a side
    struct Half {
        Side a, b;
        Int first{}, last{};
    };  ///< rows first, … up to but without last
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

    Fate draw(std::span<const Vertex> triangle, auto&& put) const {
        trace.stage("corners");
        std::array<Corner, 3> p{corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)};
        const T area = trace("area", (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y));
        if (area == 0) return trace.fate(Fate::zero_area);
        if (has_no_value(area)) return trace.fate(Fate::undefined);
        if (cull_back && area < 0) return trace.fate(Fate::culled);
        sort_downward(p);

        // The source cuts the long side where the middle corner lies: a flat bottom above, a flat top below.
        trace.stage("split");
        const Corner cut = between(p[0], p[2], p[1].y);
        const Side longest = side("long", p[0], p[2]);
        trace.stage("flat bottom");
        if (plain(p[0].y < p[1].y)) {
            const Half upper =
                half(quirk.whole_start ? side("long", p[0], cut) : longest, side("short", p[0], p[1]), p[0].y, p[1].y);
            rows(upper, start(upper.a, upper.first), put);
        }
        trace.stage("flat top");
        if (plain(p[1].y < p[2].y)) {
            const Half lower =
                half(quirk.whole_start ? side("long", cut, p[2]) : longest, side("short", p[1], p[2]), p[1].y, p[2].y);
            // The long side goes on by the additions of the rows above: so does the neighbour that it is shared with.
            const Point along = quirk.whole_start ? start(lower.a, lower.first)
                                                  : walked(longest, first_row(p[0].y), in_frame(lower.first));
            rows(lower, along, put);
        }
        return Fate::written;
    }

    Corner corner(std::span<const Vertex> triangle, int n) const {
        Corner c;
        c.x = trace({"x", n}, Input<T>::from(triangle[n].x, mode));
        c.y = trace({"y", n}, Input<T>::from(triangle[n].y, mode));
        c.u = trace({"u", n}, Input<T>::from(triangle[n].u, mode));
        c.v = trace({"v", n}, Input<T>::from(triangle[n].v, mode));
        return c;
    }
    void sort_downward(std::array<Corner, 3>& p) const {
        if (plain(p[1].y < p[0].y)) std::swap(p[0], p[1]);
        if (plain(p[2].y < p[1].y)) std::swap(p[1], p[2]);
        if (plain(p[1].y < p[0].y)) std::swap(p[0], p[1]);
    }
    /// The point of a side at height y.
    Corner between(const Corner& upper, const Corner& lower, const T& y) const {
        const T t = trace("t", (y - upper.y) / (lower.y - upper.y));
        Corner c;
        c.x = trace("x_cut", upper.x + t * (lower.x - upper.x));
        c.y = y;
        c.u = trace("u_cut", upper.u + t * (lower.u - upper.u));
        c.v = trace("v_cut", upper.v + t * (lower.v - upper.v));
        return c;
    }
    Side side(const char* name, const Corner& upper, const Corner& lower) const {
        const T dy = trace({"dy_", name}, lower.y - upper.y);
        Side s;
        s.from = upper;
        s.x = trace({"dx_", name}, (lower.x - upper.x) / dy);
        s.u = trace({"du_", name}, (lower.u - upper.u) / dy);
        s.v = trace({"dv_", name}, (lower.v - upper.v) / dy);
        return s;
    }
    Half half(const Side& a, const Side& b, const T& top, const T& bottom) const {
        Half h{a, b};
        h.first = trace("first_row", first_row(top));
        h.last = trace("last_row", lesser(end(top_of(bottom)), Int(frame.y1)));
        return h;
    }
    Int in_frame(const Int& row) const { return lesser(row, Int(frame.y1)); }
    Int first_row(const T& top) const { return greater(top_of(top), Int(frame.y0)); }
    /// The first row, or pixel of a row, from here on: in the source the one that holds the place, whole.
    Int top_of(const T& a) const { return quirk.whole_start ? trunc(a) : ceil(a - T(1) / 2); }
    Int end(const Int& last) const { return quirk.inclusive ? last + 1 : last; }
    /// How far sample `i` lies behind the place that the walk starts from.
    T behind(const Int& i, const T& from) const {
        return quirk.whole_start ? T(i - trunc(from)) : T(i) + T(1) / 2 - from;
    }

    Point start(const Side& s, const Int& row) const {
        const T ahead = trace("ahead", behind(row, s.from.y));
        return {s.from.x + s.x * ahead, s.from.u + s.u * ahead, s.from.v + s.v * ahead};
    }
    Point step(const Point& p, const Side& s) const { return {p.x + s.x, p.u + s.u, p.v + s.v}; }
    Point walked(const Side& s, const Int& from, const Int& to) const {
        return trace.quiet([&] {
            Point p = start(s, from);
            for (Integer j = plain(from); j < plain(to); ++j) p = step(p, s);
            return p;
        });
    }

    void rows(const Half& h, Point a, auto&& put) const {
        Point b = start(h.b, h.first);
        for (const Int j : trace.walk('y', h.first, h.last)) {
            const bool crossed = plain(b.x < a.x);
            if (trace.wanted('y', j)) row(crossed ? b : a, crossed ? a : b, j, put);
            a = step(a, h.a);
            b = step(b, h.b);
        }
    }
    void row(const Point& l, const Point& r, const Int& j, auto&& put) const {
        const T x_l = trace("x_l", l.x);
        const T x_r = trace("x_r", r.x);
        T u = trace("u_l", l.u);
        T v = trace("v_l", l.v);
        const T u_r = trace("u_r", r.u);
        const T v_r = trace("v_r", r.v);
        const Int begin = trace("begin", top_of(x_l));
        const Int first = greater(begin, Int(frame.x0)), last = lesser(end(top_of(x_r)), Int(frame.x1));
        if (plain(first >= last)) return;
        const T dx = trace("dx", x_r - x_l);
        const T du = trace("du", slope(u, u_r, dx));
        const T dv = trace("dv", slope(v, v_r, dx));
        const T ahead = trace("ahead", behind(first, x_l));
        u = u + du * ahead;
        v = v + dv * ahead;
        for (const Int i : trace.walk('x', first, last)) {
            if (trace.wanted('x', i)) put(i, j, pixel(u, v));
            u = u + du;
            v = v + dv;
        }
    }
    T slope(const T& from, const T& to, const T& dx) const {
        if (!quirk.apex && plain(dx == 0)) return T(0);
        return quirk.wrong_sign ? (from - to) / dx : (to - from) / dx;
    }

    Pixel pixel(const T& u, const T& v) const {
        Pixel p;
        p.u = trace("u", u);
        p.v = trace("v", v);
        p.texel.column = trace("column", texel_index(quirk.exchanged ? p.v : p.u, texture.width()));
        p.texel.row = trace("row", texel_index(quirk.exchanged ? p.u : p.v, texture.height()));
        const Rgb& colour = texture.texels.at(int(plain(p.texel.column)), int(plain(p.texel.row)));
        const T light = trace("L", Input<T>::from(lightness, mode));
        p.texel.r = trace("r", shade(colour.r, light));
        p.texel.g = trace("g", shade(colour.g, light));
        p.texel.b = trace("b", shade(colour.b, light));
        p.fate = trace.fate(Fate::written);
        return p;
    }
    Int texel_index(const T& a, int size) const {
        return quirk.whole_start ? wrapped(trunc(a), size, Wrap::mask) : wrapped(floor(a), size, texture.wrap);
    }
    Int shade(int channel, const T& light) const {
        return lightness == 1 ? Int(channel) : lit(T(channel), light, false);
    }
};

}  // namespace texelscope
