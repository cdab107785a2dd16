#include "core/exact/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/number/float_bits.h"

namespace texelscope {
namespace {

/// Numbers as whole multiples of 2^exponent.
template <class Whole, std::size_t N>
struct Scaled {
    std::array<Whole, N> value;
    int exponent = 0;
};
/// In the largest unit, up to 2^highest, that all of them are multiples of.
template <class Whole, std::size_t N>
[[nodiscard]] Scaled<Whole, N> scaled(const std::array<float, N>& values, int highest) {
    Scaled<Whole, N> all;
    all.exponent = highest;
    for (const float value : values)
        if (value != 0) all.exponent = std::min(all.exponent, lowest_exponent(value));
    for (std::size_t n = 0; n < N; ++n) {
        if (values[n] == 0) continue;
        const int exponent = lowest_exponent(values[n]);
        const auto digits = static_cast<std::int64_t>(std::ldexp(static_cast<double>(values[n]), -exponent));
        all.value[n] = Whole(digits) << (exponent - all.exponent);
    }
    return all;
}

template <class Whole>
[[nodiscard]] Whole floor_quotient(const Whole& top, const Whole& bottom) {
    TEXELSCOPE_ASSERT(bottom > 0);
    Whole quotient, rest;
    divide_qr(top, bottom, quotient, rest);
    if (rest < 0) --quotient;
    return quotient;
}

template <class Whole>
[[nodiscard]] Integer clamped(const Whole& value, Integer low, Integer high) {
    return value <= low ? low : value >= high ? high : value.template convert_to<Integer>();
}

/// top / bottom * 2^exponent as a float32. bottom > 0.
template <class Whole>
[[nodiscard]] float nearest_float(const Whole& top, const Whole& bottom, int exponent) {
    if (top == 0) return 0;
    // 30 digits or more of the quotient, the last one telling of a rest: the one rounding, to float32, then goes as it
    // would with all digits.
    Whole above = abs(top), below = bottom;
    const int shift = 30 + static_cast<int>(msb(below)) - static_cast<int>(msb(above));
    if (shift > 0)
        above <<= shift;
    else
        below <<= -shift;
    Whole quotient, rest;
    divide_qr(above, below, quotient, rest);
    const double digits = 2 * quotient.template convert_to<double>() + (rest != 0 ? 1 : 0);
    const auto size = static_cast<float>(std::ldexp(digits, exponent - shift - 1));
    return top < 0 ? -size : size;
}

}  // namespace

ExactTriangle::Whole ExactTriangle::Plane::at(Integer column, Integer line) const {
    return x * (2 * column + 1) + y * (2 * line + 1) + one;
}

ExactTriangle::Plane ExactTriangle::weighted(const std::array<Whole, 3>& value) const {
    Plane sum;
    for (std::size_t n = 0; n < 3; ++n) {
        sum.x += side_[n].x * value[n];
        sum.y += side_[n].y * value[n];
        sum.one += side_[n].one * value[n];
    }
    return sum;
}

ExactTriangle::ExactTriangle(std::span<const Vertex, 3> corners, int u_texels, int v_texels) {
    const auto &p = corners[0], &q = corners[1], &r = corners[2];
    // A sample lies at an odd number of halves: with a unit of at most one half all is whole.
    const auto places = scaled<Whole>(std::array{p.x, q.x, r.x, p.y, q.y, r.y}, -1);
    const Whole half = Whole(1) << (-1 - places.exponent);
    const std::span x = std::span(places.value).first<3>(), y = std::span(places.value).last<3>();

    area_ = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    winding_ = area_ > 0 ? 1 : area_ < 0 ? -1 : 0;
    if (winding_ == 0) return;
    area_ *= winding_;
    for (std::size_t n = 0; n < 3; ++n) {
        const std::size_t a = (n + 1) % 3, b = (n + 2) % 3;
        const Whole right = (y[a] - y[b]) * winding_, down = (x[b] - x[a]) * winding_;
        side_[n] = {right * half, down * half, -(right * x[a] + down * y[a])};
        owns_[n] = right > 0 || (right == 0 && down > 0);
    }

    const auto w = scaled<Whole>(std::array{p.w, q.w, r.w}, std::numeric_limits<int>::max());
    const std::array<Whole, 3> others{w.value[1] * w.value[2], w.value[2] * w.value[0], w.value[0] * w.value[1]};
    const auto over_w = [&](const std::array<Whole, 3>& a, int texels) {
        return weighted({a[0] * others[0] * texels, a[1] * others[1] * texels, a[2] * others[2] * texels});
    };
    const auto u = scaled<Whole>(std::array{p.u, q.u, r.u}, 0), v = scaled<Whole>(std::array{p.v, q.v, r.v}, 0);
    const auto z = scaled<Whole>(std::array{p.z, q.z, r.z}, 0);
    one_ = weighted(others), u_ = over_w(u.value, u_texels), v_ = over_w(v.value, v_texels), z_ = weighted(z.value);
    u_exponent_ = u.exponent, v_exponent_ = v.exponent, z_exponent_ = z.exponent;
}

PixelRange ExactTriangle::row(Integer y, Integer x0, Integer x1) const {
    if (winding_ == 0) return {x0, x0};
    PixelRange range{x0, x1};
    for (std::size_t n = 0; n < 3; ++n) {
        const Whole first = side_[n].at(0, y),
                    step = side_[n].x * 2;  // at pixel (0, y), and for each one further right
        if (step > 0)                       // a left side: first + x step >= 0
            range.x0 = std::max(range.x0, clamped(Whole(-floor_quotient(first, step)), x0, x1));
        else if (step < 0)  // a right side: first + x step > 0
            range.x1 = std::min(range.x1, clamped(Whole(-floor_quotient(Whole(-first), Whole(-step))), x0, x1));
        else if (!(first > 0 || (first == 0 && owns_[n])))
            return {x0, x0};
    }
    return range;
}

TexelIndex ExactTriangle::texel(Integer x, Integer y) const {
    constexpr Integer kLow = std::numeric_limits<Integer>::min(), kHigh = std::numeric_limits<Integer>::max();
    const Whole one = one_.at(x, y);
    const Whole u = floor_quotient(u_.at(x, y), Whole(one << -u_exponent_));
    const Whole v = floor_quotient(v_.at(x, y), Whole(one << -v_exponent_));
    return {clamped(u, kLow, kHigh), clamped(v, kLow, kHigh)};
}

float ExactTriangle::depth(Integer x, Integer y) const { return nearest_float(z_.at(x, y), area_, z_exponent_); }

}  // namespace texelscope
