// Exact: a rational number of any size; the method run with it is its own error oracle. What has no value
// (x / 0, a coordinate that is not finite) is `undefined`: every comparison with it is false, as with NaN.
#pragma once

#include <cmath>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>

#include "core/number/real.h"

namespace texelscope {

class Exact {
public:
    using Rational =
        boost::multiprecision::number<boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
                                      boost::multiprecision::et_off>;
    using BigInteger =
        boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

    Exact() = default;
    explicit Exact(Integer whole) : value_(whole) {}
    explicit Exact(Rational value) : value_(std::move(value)) {}

    /// Every finite double is a rational; others are undefined.
    [[nodiscard]] static Exact from(double x) {
        if (!std::isfinite(x)) return undefined();
        int exponent = 0;
        const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
        const int shift = exponent - 53;
        const BigInteger power = BigInteger(1) << (shift < 0 ? -shift : shift);
        return Exact(shift < 0 ? Rational(BigInteger(digits), power) : Rational(BigInteger(digits) * power));
    }
    [[nodiscard]] static Exact undefined() {
        Exact x;
        x.undefined_ = true;
        return x;
    }

    [[nodiscard]] const Rational& value() const { return value_; }
    [[nodiscard]] bool is_undefined() const { return undefined_; }

    friend Exact operator+(const Exact& a, const Exact& b) {
        return either(a, b) ? undefined() : Exact(a.value_ + b.value_);
    }
    friend Exact operator-(const Exact& a, const Exact& b) {
        return either(a, b) ? undefined() : Exact(a.value_ - b.value_);
    }
    friend Exact operator*(const Exact& a, const Exact& b) {
        return either(a, b) ? undefined() : Exact(a.value_ * b.value_);
    }
    friend Exact operator/(const Exact& a, const Exact& b) {
        return either(a, b) || b.value_.is_zero() ? undefined() : Exact(a.value_ / b.value_);
    }
    friend Exact operator-(const Exact& a) { return a.undefined_ ? a : Exact(-a.value_); }
    friend bool operator==(const Exact& a, const Exact& b) { return !either(a, b) && a.value_ == b.value_; }
    friend bool operator<(const Exact& a, const Exact& b) { return !either(a, b) && a.value_ < b.value_; }
    friend bool operator>(const Exact& a, const Exact& b) { return b < a; }
    friend bool operator<=(const Exact& a, const Exact& b) { return !either(a, b) && a.value_ <= b.value_; }
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
        const BigInteger down = a.floor_big();
        const Rational rest = a.value_ - Rational(down), half(1, 2);
        return saturated(down) + (rest > half || (rest == half && bit_test(abs(down), 0)));
    }
    friend Exact lesser(const Exact& a, const Exact& b) { return b < a ? b : a; }
    friend Exact greater(const Exact& a, const Exact& b) { return a < b ? b : a; }
    friend double approximate(const Exact& a) { return a.undefined_ ? std::nan("") : a.value_.convert_to<double>(); }

private:
    [[nodiscard]] static bool either(const Exact& a, const Exact& b) { return a.undefined_ || b.undefined_; }
    [[nodiscard]] BigInteger floor_big() const {
        if (undefined_) return 0;
        const BigInteger top = numerator(value_), bottom = denominator(value_);
        const BigInteger whole = top / bottom;
        return top < 0 && whole * bottom != top ? BigInteger(whole - 1) : whole;
    }
    [[nodiscard]] static Integer saturated(const BigInteger& whole) {
        constexpr auto kEnd = static_cast<Integer>(kIntegerLimit);
        return whole > kEnd ? kEnd : whole < -kEnd ? -kEnd : whole.convert_to<Integer>();
    }

    Rational value_ = 0;
    bool undefined_ = false;
};

template <>
struct Input<Exact> {
    [[nodiscard]] static Exact from(double x, NumberMode) { return Exact::from(x); }
};

static_assert(Real<Exact>);

}  // namespace texelscope
