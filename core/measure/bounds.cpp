#include "core/measure/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/measure/rung_kernels.h"

namespace texelscope::bounds {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
constexpr double kSlack = 1 + 1e-6;  ///< for the rounding of these formulas themselves

using Values = std::array<double, 3>;  ///< of an attribute, at the corners

/// n roundings in a row: Higham, Accuracy and Stability of Numerical Algorithms, lemma 3.1.
[[nodiscard]] double gamma(int n, double unit) { return n * unit / (1 - n * unit); }

/// What all formulas are made of: where the samples lie, and the slopes with their errors.
struct Plane {
    double across = 0, down = 0;      ///< the farthest sample from corner 0 [px]
    double right = 0, bottom = 0;     ///< the greatest |X| and |Y| of a sample
    double x0 = 0, y0 = 0, a0 = 0;    ///< corner 0, absolute values
    double slope_x = 0, slope_y = 0;  ///< true, with their signs
    double slope_error_x = 0, slope_error_y = 0;
    double most_x = 0, most_y = 0;  ///< of |slope| as computed
    double steps = 0;               ///< the most samples of a row, from the box's left side on
};

/// Errors of N / Δ, N and Δ differences of two products of differences: each product has three roundings and the last
/// difference one more, so |δN| ≤ γ_4 (|P| + |Q|). Then |δ(N/Δ)| ≤ (|δN| + |N/Δ| |δΔ|) / (|Δ| − |δΔ|), and one rounding
/// of the quotient.
[[nodiscard]] Plane plane_of(Corners c, const Values& a, double unit) {
    Plane p;
    const auto x = [&](int n) { return double{c[static_cast<std::size_t>(n)].x}; };
    const auto y = [&](int n) { return double{c[static_cast<std::size_t>(n)].y}; };
    const auto [left, right] = std::minmax({x(0), x(1), x(2)});
    const auto [top, bottom] = std::minmax({y(0), y(1), y(2)});
    p.x0 = std::abs(x(0)), p.y0 = std::abs(y(0)), p.a0 = std::abs(a[0]);
    p.across = std::max(right - x(0), x(0) - left) + 1, p.down = std::max(bottom - y(0), y(0) - top) + 1;
    p.right = std::max(std::abs(left), std::abs(right)) + 1, p.bottom = std::max(std::abs(top), std::abs(bottom)) + 1;
    p.steps = std::floor(right) - std::floor(left) + 1;

    const double g = gamma(4, unit);
    const double x1 = x(1) - x(0), x2 = x(2) - x(0), y1 = y(1) - y(0), y2 = y(2) - y(0);
    const double a1 = a[1] - a[0], a2 = a[2] - a[0];
    const double area = x1 * y2 - x2 * y1, area_error = g * (std::abs(x1 * y2) + std::abs(x2 * y1));
    p.slope_x = (a1 * y2 - a2 * y1) / area, p.slope_y = (x1 * a2 - x2 * a1) / area;
    if (!(area_error < std::abs(area))) {
        p.slope_error_x = p.slope_error_y = p.most_x = p.most_y = kNothing;
        return p;
    }
    const auto error = [&](double slope, double products) {
        const double before = (g * products + std::abs(slope) * area_error) / (std::abs(area) - area_error);
        return before + unit * (std::abs(slope) + before);
    };
    p.slope_error_x = error(p.slope_x, std::abs(a1 * y2) + std::abs(a2 * y1));
    p.slope_error_y = error(p.slope_y, std::abs(x1 * a2) + std::abs(x2 * a1));
    p.most_x = std::abs(p.slope_x) + p.slope_error_x, p.most_y = std::abs(p.slope_y) + p.slope_error_y;
    return p;
}

/// Every formula computes a_0 + (X − x_0) a_x + (Y − y_0) a_y in some order: this much comes from the slopes.
[[nodiscard]] double from_slopes(const Plane& p) { return p.across * p.slope_error_x + p.down * p.slope_error_y; }
/// The greatest |a| on the way to a sample.
[[nodiscard]] double size_of(const Plane& p) { return p.a0 + p.across * p.most_x + p.down * p.most_y; }

/// a_k has three roundings on each of its terms, and the sum X a_x + Y a_y + a_k three more: of numbers as large as
/// the distance from the origin makes them, however small their sum is.
[[nodiscard]] double direct(const Plane& p, double unit) {
    const double g = gamma(3, unit), k = p.a0 + p.x0 * p.most_x + p.y0 * p.most_y;
    return from_slopes(p) + g * k + g * (p.right * p.most_x + p.bottom * p.most_y + (1 + g) * k);
}
/// X − x_0, the product and two sums: four roundings, of numbers as large as the triangle's own.
[[nodiscard]] double based(const Plane& p, double unit) { return from_slopes(p) + gamma(4, unit) * size_of(p); }
/// n additions, each of which rounds a number of at most size_of, and what is already wrong with it.
[[nodiscard]] double additions(const Plane& p, double unit) {
    const double start = direct(p, unit);
    return start + gamma(static_cast<int>(p.steps), unit) * (size_of(p) + start);
}
/// The tile's corner lies up to a tile outside the box. What is left, below 1, and both slopes are rounded to float,
/// then a product and two sums: four roundings. Adding the whole texels again is one in double.
[[nodiscard]] double tile(Plane p, double unit) {
    constexpr double kReach = kTileSide - 1;
    p.across += kReach, p.down += kReach;
    return based(p, kDouble) + gamma(4, unit) * (1 + kReach * (p.most_x + p.most_y)) + kDouble * size_of(p);
}
/// Half a unit of 2^-16 at the start, and half a unit for each step.
[[nodiscard]] double fixed(const Plane& p) { return based(p, kDouble) + (p.steps + 1) * 0x1p-17; }

[[nodiscard]] Values us(Corners c) { return {c[0].u, c[1].u, c[2].u}; }
[[nodiscard]] Values vs(Corners c) { return {c[0].v, c[1].v, c[2].v}; }
[[nodiscard]] double range_of(const Values& a) {
    const auto [low, high] = std::minmax({a[0], a[1], a[2]});
    return high - low;
}
[[nodiscard]] double most_of(const Values& a) { return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])}); }
[[nodiscard]] double depth_ratio(Corners c) {
    const auto [near, far] = std::minmax({c[0].w, c[1].w, c[2].w});
    return double{far} / near;
}

/// What is no number stands for no promise.
[[nodiscard]] double worse(double a, double b) { return std::isnan(b) ? kNothing : std::max(a, b); }

/// The worse of u and v; with what a method without perspective makes of depths that differ.
[[nodiscard]] double worst_affine(Corners c, double unit, auto&& error_of) {
    double worst = 0;
    for (const Values& a : {us(c), vs(c)})
        worst = worse(worst, error_of(plane_of(c, a, unit)) + affine_for_perspective(range_of(a), depth_ratio(c)));
    return worst * kSlack;
}

/// u = N / D from planes of u/w and 1/w in double, each of which is off by what `rounding` says.
struct Quotient {
    double error = 0;              ///< of N / D, before any error of the division itself
    double most = 0;               ///< |u| as computed
    double change = 0, ratio = 1;  ///< the most that u changes, and D's factor at most, over one pixel to the right
};
/// The corners' u/w and 1/w have one rounding each; inside the triangle the plane passes it on in shares of 1. Then
/// |δ(N/D)| ≤ (|δN| + |u| |δD|) / (D − |δD|), where |u| is at most a corner's, and D at least a corner's.
/// du/dx = (N_x − u D_x) / D, and over n pixels D changes by n D_x.
[[nodiscard]] Quotient quotient_of(Corners c, const Values& a, double (*rounding)(const Plane&, double) = based) {
    Values over, inverse;
    for (std::size_t n = 0; n < 3; ++n) over[n] = a[n] / c[n].w, inverse[n] = 1.0 / c[n].w;
    const Plane numerator = plane_of(c, over, kDouble), denominator = plane_of(c, inverse, kDouble);
    const double n_error = kDouble * most_of(over) + rounding(numerator, kDouble);
    const double d_error = kDouble * most_of(inverse) + rounding(denominator, kDouble);
    const double least = std::min({inverse[0], inverse[1], inverse[2]});
    if (!(d_error < least)) return {kNothing, kNothing, kNothing, 1};
    Quotient q;
    q.error = (n_error + most_of(a) * d_error) / (least - d_error);
    q.most = most_of(a) + q.error;
    for (const double u : a)
        q.change = std::max(q.change, std::abs(numerator.slope_x - u * denominator.slope_x) / least);
    q.ratio = 1 + std::abs(denominator.slope_x) / least;
    return q;
}

/// r (2 − D r) turns the relative error e of r into e², and rounds three times; the product N r rounds once.
[[nodiscard]] double newton(Corners c, int steps) {
    double e = kReciprocalError;
    for (int n = 0; n < steps; ++n) e = e * e + gamma(3, kDouble) * (1 + e) * (1 + e);
    double worst = 0;
    for (const Values& a : {us(c), vs(c)}) {
        const Quotient q = quotient_of(c, a);
        worst = worse(worst, q.error + q.most * (e + kDouble * (1 + e)));
    }
    return worst * kSlack;
}

/// The method inverts a matrix whose planes count from the screen's origin. Its rounding is not derived but allowed
/// for: 16 times that of planes set up the direct way.
[[nodiscard]] double allowance(Corners c, const Values& a) {
    const Quotient q = quotient_of(c, a, direct);
    return 16 * (q.error + kDouble * q.most);
}

/// Over a span of n pixels, as affine_for_perspective; neither |Δu| nor r exceeds the triangle's own.
[[nodiscard]] double every(Corners c, int n) {
    double worst = 0;
    for (const Values& a : {us(c), vs(c)}) {
        const Quotient q = quotient_of(c, a);
        const double range = std::min(range_of(a), n * q.change), r = std::min(depth_ratio(c), 1 + n * (q.ratio - 1));
        worst = worse(worst, affine_for_perspective(range, r) + allowance(c, a));
    }
    return worst * kSlack;
}

}  // namespace

double affine_for_perspective(double range, double r) {
    return r > 1 ? range * (std::sqrt(r) - 1) / (std::sqrt(r) + 1) : 0;
}

double direct_float(Corners c) {
    return worst_affine(c, kFloat, [](const Plane& p) { return direct(p, kFloat); });
}
double direct_double(Corners c) {
    return worst_affine(c, kDouble, [](const Plane& p) { return direct(p, kDouble); });
}
double based_float(Corners c) {
    return worst_affine(c, kFloat, [](const Plane& p) { return based(p, kFloat); });
}
double based_double(Corners c) {
    return worst_affine(c, kDouble, [](const Plane& p) { return based(p, kDouble); });
}
double additions_float(Corners c) {
    return worst_affine(c, kFloat, [](const Plane& p) { return additions(p, kFloat); });
}
double tile_float(Corners c) {
    return worst_affine(c, kDouble, [](const Plane& p) { return tile(p, kFloat); });
}
double fixed_16_16(Corners c) { return worst_affine(c, kDouble, fixed); }
double newton_0(Corners c) { return newton(c, 0); }
double newton_1(Corners c) { return newton(c, 1); }
double newton_2(Corners c) { return newton(c, 2); }
double every_8(Corners c) { return every(c, 8); }
double every_16(Corners c) { return every(c, 16); }
double every_32(Corners c) { return every(c, 32); }
double adaptive(Corners c) {
    double rounding = 0;
    for (const Values& a : {us(c), vs(c)}) rounding = worse(rounding, allowance(c, a));
    return (1.0 / 16 + rounding) * kSlack;
}
double none(Corners) { return 0; }

}  // namespace texelscope::bounds
