// Rungs that no method of core/method is: one idea each, scalar and plain. They stand on the edge equations' own set-up
// and coverage, and put fragments as methods do, so that both are timed alike.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/method/edge_equations.h"

namespace texelscope {

/// The edge equations in T, their planes counted from corner 0.
template <class T>
[[nodiscard]] EdgeEquations<T, NoTrace> based_equations(const Rect& frame, const Texture& texture) {
    return {frame, texture, 1, false, {.based = true}, {}, {}};
}

/// What a plane counted from corner 0 is at (x, y).
template <class Equations, class T>
[[nodiscard]] T value_at(const typename Equations::Setup& s, const typename Equations::Plane& a, T x, T y) {
    return a.k + (x - s.base.x) * a.x + (y - s.base.y) * a.y;
}

/// A fragment whose texel before wrapping is (column, row).
[[nodiscard]] inline Fragment<double> fragment_of(const Texture& texture, double u, double v, Integer column,
                                                  Integer row) {
    Fragment<double> f;
    f.u = u, f.v = v;
    f.texel.column = wrapped(column, texture.width(), texture.wrap);
    f.texel.row = wrapped(row, texture.height(), texture.wrap);
    const Rgb& colour = texture.texels.at(static_cast<int>(f.texel.column), static_cast<int>(f.texel.row));
    f.texel.r = colour.r, f.texel.g = colour.g, f.texel.b = colour.b;
    return f;
}

inline constexpr int kTileSide = 8;  ///< [px]

/// Float counts from the corner of a tile of 8 x 8 pixels, in texels less the whole ones there: neither the distance
/// from the origin nor the size of u is left in the numbers that are rounded. Set-up is in double.
template <class T>
struct TileBased {
    Rect frame;
    const Texture& texture;

    struct Base {
        Integer whole = 0;
        T rest{}, x{}, y{};
    };

    Fate draw(std::span<const Vertex> triangle, auto&& put) const {
        const auto equations = based_equations<double>(frame, texture);
        const auto s = equations.setup(triangle);
        if (s.fate != Fate::written) return s.fate;
        constexpr Integer kMask = ~Integer{kTileSide - 1};
        for (Integer y = s.box.y0 & kMask; y < s.box.y1; y += kTileSide)
            for (Integer x = s.box.x0 & kMask; x < s.box.x1; x += kTileSide) draw_tile(equations, s, x, y, put);
        return Fate::written;
    }
    template <class Equations>
    void draw_tile(const Equations& equations, const typename Equations::Setup& s, Integer x, Integer y,
                   auto&& put) const {
        const Base u = base_of<Equations>(s, s.u, x, y), v = base_of<Equations>(s, s.v, x, y);
        const Integer bottom = lesser(s.box.y1, y + kTileSide), right = lesser(s.box.x1, x + kTileSide);
        for (Integer j = greater(s.box.y0, y); j < bottom; ++j)
            for (Integer i = greater(s.box.x0, x); i < right; ++i) {
                if (equations.cover(s, i, j).fate != Fate::written) continue;
                const T u_rest = u.rest + T(i - x) * u.x + T(j - y) * u.y;
                const T v_rest = v.rest + T(i - x) * v.x + T(j - y) * v.y;
                put(i, j,
                    fragment_of(texture, static_cast<double>(u.whole) + u_rest, static_cast<double>(v.whole) + v_rest,
                                u.whole + floor(u_rest), v.whole + floor(v_rest)));
            }
    }
    template <class Equations>
    [[nodiscard]] Base base_of(const typename Equations::Setup& s, const typename Equations::Plane& a, Integer x,
                               Integer y) const {
        const double here = value_at<Equations>(s, a, static_cast<double>(x) + .5, static_cast<double>(y) + .5);
        const Integer whole = floor(here);
        return {whole, static_cast<T>(here - static_cast<double>(whole)), static_cast<T>(a.x), static_cast<T>(a.y)};
    }
};

/// 16.16 in 32-bit words, two additions a pixel: what ran on machines without floating point. Leaving the range
/// is modulo 2^16 texels, so only where u itself lies beyond ±2^15 is anything lost.
struct FixedSteps {
    Rect frame;
    const Texture& texture;

    Fate draw(std::span<const Vertex> triangle, auto&& put) const {
        const auto equations = based_equations<double>(frame, texture);
        using Equations = EdgeEquations<double, NoTrace>;
        const auto s = equations.setup(triangle);
        if (s.fate != Fate::written) return s.fate;
        const std::uint32_t u_x = fixed(s.u.x), v_x = fixed(s.v.x);
        const double x = static_cast<double>(s.box.x0) + .5;
        for (Integer j = s.box.y0; j < s.box.y1; ++j) {
            const double y = static_cast<double>(j) + .5;
            std::uint32_t u = fixed(value_at<Equations>(s, s.u, x, y)), v = fixed(value_at<Equations>(s, s.v, x, y));
            for (Integer i = s.box.x0; i < s.box.x1; ++i, u += u_x, v += v_x)
                if (equations.cover(s, i, j).fate == Fate::written) {
                    const auto a = static_cast<std::int32_t>(u), b = static_cast<std::int32_t>(v);
                    put(i, j, fragment_of(texture, a * 0x1p-16, b * 0x1p-16, a >> 16, b >> 16));
                }
        }
        return Fate::written;
    }
    [[nodiscard]] static std::uint32_t fixed(double a) { return static_cast<std::uint32_t>(round_even(a * 65536)); }
};

/// Corners at the nearest 1/256 px, as graphics cards have them: their edge functions in whole numbers are exact, for
/// another triangle. |x|, |y| < 2^23. u and v by planes in double, of the corners as given.
struct Coverage24_8 {
    Rect frame;
    const Texture& texture;

    struct Side {
        std::int64_t x = 0, y = 0, k = 0;  ///< E = x X + y Y + k in units of 2^-16 px², positive inside
        bool owns = false;
    };

    Fate draw(std::span<const Vertex> triangle, auto&& put) const {
        const EdgeEquations<double, NoTrace> equations{frame, texture, 1, false, {}, {}, {}};
        auto s = equations.setup(triangle);
        if (s.fate != Fate::written) return s.fate;
        std::array<std::int64_t, 3> x{}, y{};
        for (std::size_t n = 0; n < 3; ++n) x[n] = snapped(triangle[n].x), y[n] = snapped(triangle[n].y);
        const std::int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (area == 0) return Fate::zero_area;
        std::array<Side, 3> sides;
        for (std::size_t n = 0; n < 3; ++n) {
            const std::size_t a = (n + (area > 0 ? 1 : 2)) % 3, b = (n + (area > 0 ? 2 : 1)) % 3;
            const std::int64_t right = y[a] - y[b], down = x[b] - x[a];
            sides[n] = {right, down, -(right * x[a] + down * y[a]), right > 0 || (right == 0 && down > 0)};
        }
        const Integer x0 = greater(s.box.x0 - 1, Integer{frame.x0}), x1 = lesser(s.box.x1 + 1, Integer{frame.x1});
        const Integer y0 = greater(s.box.y0 - 1, Integer{frame.y0}), y1 = lesser(s.box.y1 + 1, Integer{frame.y1});
        for (Integer j = y0; j < y1; ++j)
            for (Integer i = x0; i < x1; ++i) {
                if (!covers(sides, 256 * i + 128, 256 * j + 128)) continue;
                auto p = equations.sample(s, i, j);
                equations.planes(s, p);
                put(i, j, fragment_of(texture, p.u, p.v, floor(p.u), floor(p.v)));
            }
        return Fate::written;
    }
    [[nodiscard]] static std::int64_t snapped(float a) { return round_even(double{a} * 256); }
    [[nodiscard]] static bool covers(const std::array<Side, 3>& sides, std::int64_t x, std::int64_t y) {
        for (const Side& side : sides) {
            const std::int64_t e = side.x * x + side.y * y + side.k;
            if (e < 0 || (e == 0 && !side.owns)) return false;
        }
        return true;
    }
};

inline constexpr int kReciprocalBits = 11;               ///< of the digits of D that the table is asked with
inline constexpr double kReciprocalError = 0x1.001p-12;  ///< the greatest relative error of the estimate

/// 1/D by a table, as the estimate instructions have it: the reciprocal of the middle of 2048 parts of [1, 2). A part
/// is 2^-11 wide, so no D in it is farther than 2^-12 from the middle. Requires D > 0, neither denormal nor huge.
[[nodiscard]] inline double reciprocal_estimate(double d) {
    static const auto table = [] {
        std::array<double, 1U << kReciprocalBits> t{};
        for (std::size_t n = 0; n < t.size(); ++n)
            t[n] = 1 / (1 + (static_cast<double>(n) + .5) / static_cast<double>(t.size()));
        return t;
    }();
    const auto bits = std::bit_cast<std::uint64_t>(d);
    constexpr std::uint64_t kExponent = 2046;  // of 2^-e where `bits` has that of 2^e: twice the bias, less it
    const auto power = std::bit_cast<double>((kExponent - (bits >> 52U)) << 52U);
    return table[bits >> (52U - kReciprocalBits) & (table.size() - 1)] * power;
}

/// Perspective without a division: an estimate of the reciprocal, and r (2 − D r), which doubles its digits, so often.
template <int kSteps>
struct Newton {
    Rect frame;
    const Texture& texture;

    Fate draw(std::span<const Vertex> triangle, auto&& put) const {
        using Equations = EdgeEquations<double, NoTrace>;
        const auto equations = based_equations<double>(frame, texture);
        const auto s = equations.setup(triangle);
        if (s.fate != Fate::written) return s.fate;
        const typename Equations::Corners p{equations.corner(triangle, 0), equations.corner(triangle, 1),
                                            equations.corner(triangle, 2)};
        const std::array<double, 3> w{triangle[0].w, triangle[1].w, triangle[2].w};
        const auto one = equations.plane("1", p, 1 / w[0], 1 / w[1], 1 / w[2], s.delta);
        const auto u = equations.plane("u", p, p[0].u / w[0], p[1].u / w[1], p[2].u / w[2], s.delta);
        const auto v = equations.plane("v", p, p[0].v / w[0], p[1].v / w[1], p[2].v / w[2], s.delta);
        for (Integer j = s.box.y0; j < s.box.y1; ++j)
            for (Integer i = s.box.x0; i < s.box.x1; ++i) {
                if (equations.cover(s, i, j).fate != Fate::written) continue;
                const double x = static_cast<double>(i) + .5, y = static_cast<double>(j) + .5;
                const double d = value_at<Equations>(s, one, x, y);
                double r = reciprocal_estimate(d);
                for (int n = 0; n < kSteps; ++n) r = r * (2 - d * r);
                const double at_u = value_at<Equations>(s, u, x, y) * r, at_v = value_at<Equations>(s, v, x, y) * r;
                put(i, j, fragment_of(texture, at_u, at_v, floor(at_u), floor(at_v)));
            }
        return Fate::written;
    }
};

}  // namespace texelscope
