// Exact: a rational number of any size; the method run with it is its own error oracle. What has no value
// (x / 0, a coordinate that is not finite) is `undefined`: every comparison with it is false, as with NaN.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>

#include "core/number/real.h"

namespace texelscope {

/// top * 2^exponent / bottom: bottom is odd and at least 1, top odd or 0, without a common divisor. What floats become
/// by sums and products has bottom 1: neither is reduced, which would be most of the time.
class Exact {
public:
    using Rational =
        boost::multiprecision::number<boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
                                      boost::multiprecision::et_off>;

    Exact() = default;
    explicit Exact(Integer whole) : top_(whole) { make_odd(); }
    explicit Exact(const Rational& value) : top_(numerator(value)), bottom_(denominator(value)) {
        const auto twos = static_cast<int>(lsb(bottom_));
        bottom_ >>= twos, exponent_ = -twos;
        make_odd();
    }

    /// Every finite double is a rational; others are undefined.
    [[nodiscard]] static Exact from(double x) {
        if (!std::isfinite(x)) return undefined();
        int exponent = 0;
        Exact found(static_cast<Integer>(std::ldexp(std::frexp(x, &exponent), 53)));
        if (x != 0) found.exponent_ += exponent - 53;
        return found;
    }
    [[nodiscard]] static Exact undefined() {
        Exact x;
        x.undefined_ = true;
        return x;
    }

    [[nodiscard]] Rational value() const {
        const Rational::value_type one = 1;
        const Rational fraction{Rational::value_type(top_), Rational::value_type(bottom_)};
        return exponent_ < 0 ? fraction / Rational(one << -exponent_) : fraction * Rational(one << exponent_);
    }
    [[nodiscard]] bool is_undefined() const { return undefined_; }

    friend Exact operator+(const Exact& a, const Exact& b) { return either(a, b) ? undefined() : sum(a, b, false); }
    friend Exact operator-(const Exact& a, const Exact& b) { return either(a, b) ? undefined() : sum(a, b, true); }
    friend Exact operator*(const Exact& a, const Exact& b) {
        return either(a, b) ? undefined() : quotient(a.top_ * b.top_, a.exponent_ + b.exponent_, a.bottom_, b.bottom_);
    }
    friend Exact operator/(const Exact& a, const Exact& b) {
        if (either(a, b) || b.top_.is_zero()) return undefined();
        const Whole top = a.top_ * b.bottom_;
        return quotient(b.top_.sign() < 0 ? Whole(-top) : top, a.exponent_ - b.exponent_, a.bottom_, abs(b.top_));
    }
    friend Exact operator-(const Exact& a) {
        Exact negative = a;
        negative.top_ = -negative.top_;
        return negative;
    }
    friend bool operator==(const Exact& a, const Exact& b) {
        return !either(a, b) && a.exponent_ == b.exponent_ && a.top_ == b.top_ && a.bottom_ == b.bottom_;
    }
    friend bool operator<(const Exact& a, const Exact& b) {
        return !either(a, b) && aligned(a, b, true).top.sign() < 0;
    }
    friend bool operator>(const Exact& a, const Exact& b) { return b < a; }
    friend bool operator<=(const Exact& a, const Exact& b) {
        return !either(a, b) && aligned(a, b, true).top.sign() <= 0;
    }
    friend bool operator>=(const Exact& a, const Exact& b) { return b <= a; }

    friend Exact operator+(Integer a, const Exact& b) { return Exact(a) + b; }
    friend Exact operator+(const Exact& a, Integer b) { return a + Exact(b); }
    friend Exact operator-(Integer a, const Exact& b) { return Exact(a) - b; }
    friend Exact operator-(const Exact& a, Integer b) { return a - Exact(b); }
    friend Exact operator*(Integer a, const Exact& b) { return Exact(a) * b; }
    friend Exact operator*(const Exact& a, Integer b) { return a * Exact(b); }
    friend Exact operator/(Integer a, const Exact& b) { return Exact(a) / b; }
    friend Exact operator/(const Exact& a, Integer b) { return a / Exact(b); }
    friend bool operator==(const Exact& a, Integer b) { return a == Exact(b); }
    friend bool operator<(const Exact& a, Integer b) { return a < Exact(b); }
    friend bool operator>(const Exact& a, Integer b) { return a > Exact(b); }
    friend bool operator<=(const Exact& a, Integer b) { return a <= Exact(b); }
    friend bool operator>=(const Exact& a, Integer b) { return a >= Exact(b); }

    friend Integer floor(const Exact& a) { return saturated(a.floor_big()); }
    friend Integer trunc(const Exact& a) { return a < 0 ? ceil(a) : floor(a); }
    friend Integer ceil(const Exact& a) { return -floor(-a); }
    friend Integer round_even(const Exact& a) {
        if (a.undefined_) return 0;
        const Whole down = a.floor_big();
        const Exact rest = a - Exact(down, 0, 1), half(1, -1, 1);
        return saturated(down) + (rest > half || (rest == half && bit_test(abs(down), 0)));
    }
    friend Exact lesser(const Exact& a, const Exact& b) { return b < a ? b : a; }
    friend Exact greater(const Exact& a, const Exact& b) { return a < b ? b : a; }
    friend double approximate(const Exact& a) {
        if (a.undefined_) return std::nan("");
        constexpr int kDigits = 53, kSmall = 900;  // both are doubles: one rounding, by the division
        if (msb_of(a.top_) < kDigits && msb_of(a.bottom_) < kDigits && std::abs(a.exponent_) < kSmall)
            return std::ldexp(a.top_.convert_to<double>() / a.bottom_.convert_to<double>(), a.exponent_);
        return a.value().convert_to<double>();
    }

private:
    /// Up to 256 bits lie in the number itself.
    using Whole =
        boost::multiprecision::number<boost::multiprecision::cpp_int_backend<256>, boost::multiprecision::et_off>;

    Exact(Whole top, int exponent, Whole bottom)
        : top_(std::move(top)), bottom_(std::move(bottom)), exponent_(exponent) {
        make_odd();
    }

    [[nodiscard]] static bool either(const Exact& a, const Exact& b) { return a.undefined_ || b.undefined_; }
    [[nodiscard]] static int msb_of(const Whole& x) { return x.is_zero() ? 0 : static_cast<int>(msb(abs(x))); }
    void make_odd() {
        if (top_.is_zero()) return void(exponent_ = 0);
        const auto twos = static_cast<int>(lsb(abs(top_)));
        if (twos > 0) top_ >>= twos, exponent_ += twos;
    }

    struct Aligned {
        Whole top;
        int exponent;
    };
    /// The numerator of a + b, or of a - b, over both denominators; over a's alone where they are equal.
    [[nodiscard]] static Aligned aligned(const Exact& a, const Exact& b, bool minus) {
        const int exponent = std::min(a.exponent_, b.exponent_);
        const bool same = a.bottom_ == b.bottom_;
        Whole x = same ? a.top_ : Whole(a.top_ * b.bottom_), y = same ? b.top_ : Whole(b.top_ * a.bottom_);
        x <<= a.exponent_ - exponent, y <<= b.exponent_ - exponent;
        return {minus ? Whole(x - y) : Whole(x + y), exponent};
    }
    [[nodiscard]] static Exact sum(const Exact& a, const Exact& b, bool minus) {
        Aligned s = aligned(a, b, minus);
        return quotient(std::move(s.top), s.exponent, a.bottom_, a.bottom_ == b.bottom_ ? Whole(1) : b.bottom_);
    }
    /// top * 2^exponent / (b1 * b2)
    [[nodiscard]] static Exact quotient(Whole top, int exponent, const Whole& b1, const Whole& b2) {
        if (b1 == 1 && b2 == 1) return {std::move(top), exponent, 1};
        const auto twos = static_cast<int>(lsb(b2));
        Whole bottom = b1 * (b2 >> twos);
        if (const Whole common = gcd(top, bottom); common != 1) top /= common, bottom /= common;
        return {std::move(top), exponent - twos, std::move(bottom)};
    }
    [[nodiscard]] Whole floor_big() const {
        if (undefined_) return 0;
        const Whole top = exponent_ > 0 ? Whole(top_ << exponent_) : top_;
        const Whole bottom = exponent_ < 0 ? Whole(bottom_ << -exponent_) : bottom_;
        const Whole whole = top / bottom;
        return top.sign() < 0 && whole * bottom != top ? Whole(whole - 1) : whole;
    }
    [[nodiscard]] static Integer saturated(const Whole& whole) {
        constexpr auto kEnd = static_cast<Integer>(kIntegerLimit);
        return whole > kEnd ? kEnd : whole < -kEnd ? -kEnd : whole.convert_to<Integer>();
    }

    Whole top_ = 0, bottom_ = 1;
    int exponent_ = 0;
    bool undefined_ = false;
};

template <>
struct Input<Exact> {
    [[nodiscard]] static Exact from(double x, NumberMode) { return Exact::from(x); }
};

static_assert(Real<Exact>);

}  // namespace texelscope
