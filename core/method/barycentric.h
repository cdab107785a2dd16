// Triangles by the weights of their corners, in perspective (S4: B. Smith, naive barycentric perspective
// demonstration, 2022). Corrected or as printed: a variant is a preset of the quirks.
#pragma once

#include <array>
#include <span>

#include "core/geometry/vertex.h"
#include "core/method/texel.h"
#include "core/trace/trace.h"

namespace texelscope {

/// What the source does otherwise than meant, and how it paints; all off is the corrected method.
struct BarycentricQuirks {
    bool inclusive = false, corners = false, truncate = false;
    bool edges = false;   ///< its picture, not a fault: samples near a side are tinted, green and red in turn
    bool affine = false;  ///< not in the source: as if all depths were one
};

template <Real T, Traceable Trace>
struct Barycentric {
    using Number = T;
    using Int = IntegerOf<T>;
    using Truth = TruthOf<T>;
    using Quirks = BarycentricQuirks;

    struct Corner {
        T x{}, y{}, u{}, v{}, w{};
    };
    using Corners = std::array<Corner, 3>;
    /// u/w, v/w and 1/w of a corner: affine over the screen, which u and v in perspective are not.
    struct Homogeneous {
        T u{}, v{}, one{};
    };
    struct Box {
        Int x0, x1, y0, y1;
    };
    struct Setup {
        Corners p;
        T area{}, half{};
        std::array<Truth, 3> owns{};  ///< whether the samples on the side across from the corner are ours
        std::array<Homogeneous, 3> q{};
        Box box{};
        Fate fate = Fate::written;
    };
    struct Pixel {
        T x{}, y{};
        std::array<T, 3> e{};  ///< weights: shares of the area, 1 at their corner and 0 on the side across
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
    int shape = 0;  ///< its number in the scene: even ones are tinted green

    Fate draw(std::span<const Vertex> triangle, auto&& put) const {
        const Setup s = setup(triangle);
        if (s.fate != Fate::written) return s.fate;
        trace.stage("pixels");
        for (const Int j : trace.each('y', s.box.y0, s.box.y1))
            for (const Int i : trace.each('x', s.box.x0, s.box.x1)) put(i, j, pixel(s, i, j));
        return Fate::written;
    }

    Setup setup(std::span<const Vertex> triangle) const {
        Setup s;
        trace.stage("corners");
        for (int n = 0; n < 3; ++n) s.p[n] = corner(triangle, n);
        s.half = Input<T>::from(quirk.corners ? 0.0F : 0.5F, mode);
        s.area = trace("A", area(s.p[0].x, s.p[0].y, s.p[1].x, s.p[1].y, s.p[2].x, s.p[2].y));
        if (s.area == 0)
            s.fate = trace.fate(Fate::zero_area);
        else if (plain(s.area != s.area))
            s.fate = trace.fate(Fate::undefined);
        else if (cull_back && s.area < 0)
            s.fate = trace.fate(Fate::culled);
        if (s.fate != Fate::written) return s;

        trace.stage("over w");
        for (int n = 0; n < 3; ++n) s.q[n] = over_w(s.p[n], n);
        trace.stage("owners");
        for (int n = 0; n < 3; ++n) s.owns[n] = owner(s, n);
        trace.stage("box");
        s.box = bounds(s.p);
        if (s.box.x0 >= s.box.x1 || s.box.y0 >= s.box.y1) s.fate = trace.fate(Fate::off_screen);
        return s;
    }

    Corner corner(std::span<const Vertex> triangle, int n) const {
        Corner c;
        c.x = trace({"x", n}, Input<T>::from(triangle[n].x, mode));
        c.y = trace({"y", n}, Input<T>::from(triangle[n].y, mode));
        c.u = trace({"u", n}, Input<T>::from(triangle[n].u, mode));
        c.v = trace({"v", n}, Input<T>::from(triangle[n].v, mode));
        c.w = trace({"w", n}, Input<T>::from(quirk.affine ? 1.0F : triangle[n].w, mode));
        return c;
    }
    /// Signed: positive where a, b, c run clockwise on the screen.
    T area(const T& ax, const T& ay, const T& bx, const T& by, const T& cx, const T& cy) const {
        return ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
    }
    Homogeneous over_w(const Corner& p, int n) const {
        const T inverse = trace({"q_1", n}, T(1) / p.w);
        Homogeneous q;
        q.u = trace({"q_u", n}, p.u * inverse);
        q.v = trace({"q_v", n}, p.v * inverse);
        q.one = inverse;
        return q;
    }
    /// The top-left rule for the side across from corner n.
    Truth owner(const Setup& s, int n) const {
        const bool turned = plain(s.area < 0);
        const Corner &a = s.p[(n + (turned ? 2 : 1)) % 3], &b = s.p[(n + (turned ? 1 : 2)) % 3];
        return trace({"owns", n}, b.y < a.y || (b.y == a.y && a.x < b.x));
    }
    Box bounds(const Corners& p) const {
        const T left = trace("x_min", lesser(lesser(p[0].x, p[1].x), p[2].x));
        const T right = trace("x_max", greater(greater(p[0].x, p[1].x), p[2].x));
        const T top = trace("y_min", lesser(lesser(p[0].y, p[1].y), p[2].y));
        const T bottom = trace("y_max", greater(greater(p[0].y, p[1].y), p[2].y));
        Box box;
        box.x0 = trace("x_a", greater(floor(left), Int(frame.x0)));
        box.x1 = trace("x_b", lesser(floor(right) + 1, Int(frame.x1)));
        box.y0 = trace("y_a", greater(floor(top), Int(frame.y0)));
        box.y1 = trace("y_b", lesser(floor(bottom) + 1, Int(frame.y1)));
        return box;
    }

    Pixel pixel(const Setup& s, const Int& i, const Int& j) const {
        Pixel p;
        p.x = trace("X", T(i) + s.half);
        p.y = trace("Y", T(j) + s.half);
        for (int n = 0; n < 3; ++n) {
            const T part = trace({"part", n}, sub_area(s, n, p));
            p.e[n] = trace({"e", n}, part / s.area);
            if (!trace({"in", n}, inside(s, n, part, p.e[n]))) {
                p.fate = trace.fate(outside_edge((n + 1) % 3));
                return p;
            }
        }
        const T l_u = trace("l_u", s.q[0].u * p.e[0] + s.q[1].u * p.e[1] + s.q[2].u * p.e[2]);
        const T l_v = trace("l_v", s.q[0].v * p.e[0] + s.q[1].v * p.e[1] + s.q[2].v * p.e[2]);
        const T l_1 = trace("l_1", s.q[0].one * p.e[0] + s.q[1].one * p.e[1] + s.q[2].one * p.e[2]);
        p.u = trace("u", l_u / l_1);
        p.v = trace("v", l_v / l_1);
        p.texel = read_texel(*this, p.u, p.v, quirk.truncate);
        if (quirk.edges) tint(p);
        p.fate = trace.fate(Fate::written);
        return p;
    }
    /// The area of the sample with the side across from corner n.
    T sub_area(const Setup& s, int n, const Pixel& p) const {
        const Corner &a = s.p[(n + 1) % 3], &b = s.p[(n + 2) % 3];
        // From the same end for both triangles at this side: then a sample on it has one owner in any number type.
        const bool back = !quirk.inclusive && (plain(b.y < a.y) || (plain(b.y == a.y) && plain(b.x < a.x)));
        return back ? -area(b.x, b.y, a.x, a.y, p.x, p.y) : area(a.x, a.y, b.x, b.y, p.x, p.y);
    }
    Truth inside(const Setup& s, int n, const T& part, const T& e) const {
        if (quirk.inclusive) return e >= 0 && e <= 1;  // Q1
        return plain(s.area < 0) ? part < 0 || (part == 0 && s.owns[n]) : part > 0 || (part == 0 && s.owns[n]);
    }
    /// Near a side the colour is averaged with green or red, in halves.
    void tint(Pixel& p) const {
        const T near = T(1) / 20;
        if (!plain(p.e[0] < near) && !plain(p.e[1] < near) && !plain(p.e[2] < near)) return;
        const bool even = shape % 2 == 0;
        p.texel.r = trace("r", halved(p.texel.r) + halved(Int(even ? 0 : 255)));
        p.texel.g = trace("g", halved(p.texel.g) + halved(Int(even ? 255 : 0)));
        p.texel.b = trace("b", halved(p.texel.b));
    }
    static Int halved(const Int& channel) { return trunc(T(channel) / 2); }
};

}  // namespace texelscope
