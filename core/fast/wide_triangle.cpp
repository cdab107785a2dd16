#include "core/fast/wide_triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/number/float_bits.h"

namespace texelscope {
namespace {

__extension__ using Wide = __int128;

constexpr double kMost = 0x1p120;  ///< 128 bits hold all sums of a few terms below it
constexpr int kMostSteps = 40;     ///< of Euclid's algorithm: simple ratios need few

/// Three or six numbers as whole multiples of 2^-bits.
template <std::size_t N>
struct Scaled {
    std::array<std::int64_t, N> value{};
    int bits = 0;
    double most = 0;  ///< the largest size
};
template <std::size_t N>
[[nodiscard]] std::optional<Scaled<N>> scaled(const std::array<float, N>& values, int least_bits) {
    constexpr int kMostBits = 40;
    Scaled<N> all;
    all.bits = least_bits;
    for (const float value : values)
        if (value != 0) all.bits = std::max(all.bits, -lowest_exponent(value));
    if (all.bits > kMostBits) return std::nullopt;
    const auto unit = static_cast<double>(std::int64_t{1} << all.bits);
    for (std::size_t n = 0; n < N; ++n) {
        const double whole = static_cast<double>(values[n]) * unit;
        all.most = std::max(all.most, std::abs(whole));
        if (all.most > 0x1p60) return std::nullopt;
        all.value[n] = static_cast<std::int64_t>(whole);
    }
    return all;
}

/// The power of two in a number that is not 0.
[[nodiscard]] int twos_in(Wide a) {
    const auto low = static_cast<std::uint64_t>(a);
    return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(a >> 64));
}

/// 0 where it takes too long. Powers of two go first: what is left is short, and short divisions are fast.
[[nodiscard]] Wide greatest_common_divisor(Wide a, Wide b) {
    a = a < 0 ? -a : a, b = b < 0 ? -b : b;
    if (a == 0 || b == 0) return a + b;
    const int a_twos = twos_in(a), b_twos = twos_in(b);
    a >>= a_twos, b >>= b_twos;
    for (int step = 0; b != 0; ++step) {
        if (step == kMostSteps) return 0;
        const bool is_short = ((a | b) >> 64) == 0;
        const Wide rest = is_short ? Wide(static_cast<std::uint64_t>(a) % static_cast<std::uint64_t>(b)) : a % b;
        a = b, b = rest;
    }
    return a << std::min(a_twos, b_twos);
}

[[nodiscard]] Integer floor_quotient(Wide top, Wide bottom) {
    const Wide quotient = top / bottom;
    return static_cast<Integer>(quotient - (quotient * bottom > top ? 1 : 0));
}

}  // namespace

std::optional<WideTriangle> WideTriangle::make(std::span<const Vertex, 3> p, int u_texels, int v_texels, int x0,
                                               int y0) {
    // A sample lies at an odd number of halves.
    const auto places = scaled<6>({p[0].x, p[1].x, p[2].x, p[0].y, p[1].y, p[2].y}, 1);
    const auto w = scaled<3>({p[0].w, p[1].w, p[2].w}, 0);
    const auto u = scaled<3>({p[0].u, p[1].u, p[2].u}, 0), v = scaled<3>({p[0].v, p[1].v, p[2].v}, 0);
    if (!places || !w || !u || !v) return std::nullopt;
    const bool flat = w->value[0] == w->value[1] && w->value[0] == w->value[2];
    const double reach = places->most + std::ldexp(std::abs(x0) + std::abs(y0) + 0x1p15, places->bits);
    const double weight = flat ? 1 : w->most * w->most;
    const double largest =
        std::max({std::ldexp(1.0, std::max(u->bits, v->bits)), u->most * u_texels, v->most * v_texels});
    if (!(16 * reach * reach * weight * largest < kMost)) return std::nullopt;

    const std::span x = std::span(places->value).first<3>(), y = std::span(places->value).last<3>();
    const Wide area = Wide(x[1] - x[0]) * (y[2] - y[0]) - Wide(x[2] - x[0]) * (y[1] - y[0]);
    if (area == 0) return std::nullopt;
    const int turn = area > 0 ? 1 : -1;
    const Wide half = Wide(1) << (places->bits - 1);
    std::array<Plane, 3> side;  // doubled area with the sample across from corner n, positive inside
    std::array<Wide, 3> others{1, 1, 1};
    for (std::size_t n = 0; n < 3; ++n) {
        const std::size_t a = (n + 1) % 3, b = (n + 2) % 3;
        const Wide right = Wide(y[a] - y[b]) * turn, down = Wide(x[b] - x[a]) * turn;
        side[n] = {right * 2 * half, down * 2 * half, 0};
        side[n].one = right * ((2 * Wide(x0) + 1) * half - x[a]) + down * ((2 * Wide(y0) + 1) * half - y[a]);
        if (!flat) others[n] = Wide(w->value[a]) * w->value[b];
    }
    const auto weighted = [&](const std::array<Wide, 3>& value) {
        Plane sum;
        for (std::size_t n = 0; n < 3; ++n)
            sum.x += side[n].x * value[n], sum.y += side[n].y * value[n], sum.one += side[n].one * value[n];
        return sum;
    };
    const auto over_w = [&](const Scaled<3>& a, int texels) {
        return weighted(
            {others[0] * a.value[0] * texels, others[1] * a.value[1] * texels, others[2] * a.value[2] * texels});
    };
    const auto shifted = [](const Plane& a, int bits) {
        const Wide unit = Wide(1) << bits;
        return Plane{a.x * unit, a.y * unit, a.one * unit};
    };
    const Plane one = weighted(others);
    const Wide most = (area < 0 ? -area : area) * std::max({others[0], others[1], others[2]});
    WideTriangle found;
    found.u_ = over_w(*u, u_texels), found.v_ = over_w(*v, v_texels);
    found.u_one_ = shifted(one, u->bits), found.v_one_ = shifted(one, v->bits);
    found.u_most_ = most << u->bits, found.v_most_ = most << v->bits;
    return found;
}

TexelIndex WideTriangle::texel(int x, int y) const {
    return {floor_quotient(u_.at(x, y), u_one_.at(x, y)), floor_quotient(v_.at(x, y), v_one_.at(x, y))};
}

/// top / bottom - k = (top - k bottom) / bottom: the numerator is a multiple of what divides all of their coefficients.
double WideTriangle::gap(const Plane& top, const Plane& bottom, Wide most) {
    Wide common = bottom.one;
    for (const Wide part : {top.x, top.y, top.one, bottom.x, bottom.y}) {
        common = greatest_common_divisor(common, part);
        if (common == 0) return 0;
    }
    return static_cast<double>(common) / static_cast<double>(most) * (1 - 0x1p-40);
}

WideTriangle::Gaps WideTriangle::gaps() const { return {gap(u_, u_one_, u_most_), gap(v_, v_one_, v_most_)}; }

}  // namespace texelscope
