// Exact: a rational number of any size; the method run with it is its own error oracle. What has no value
// (x / 0, a coordinate that is not finite) is `undefined`: every comparison with it is false, as with NaN.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "core/number/real.h"

namespace texelscope {

/// top * 2^exponent / bottom: bottom is odd and at least 1, top odd or 0, without a common divisor. What floats become
/// by sums and products has bottom 1: neither is reduced, which would be most of the time.
/// Compiled once, in exact.cpp: in line in every method it would be half of the time that the library takes to build.
class Exact {
public:
    using Rational =
        boost::multiprecision::number<boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
                                      boost::multiprecision::et_off>;

    Exact();
    explicit Exact(Integer whole);
    explicit Exact(const Rational& value);
    Exact(const Exact& other);
    Exact(Exact&& other) noexcept;
    Exact& operator=(const Exact& other);
    Exact& operator=(Exact&& other) noexcept;
    ~Exact();

    /// Every finite double is a rational; others are undefined.
    [[nodiscard]] static Exact from(double x);
    [[nodiscard]] static Exact undefined();

    [[nodiscard]] Rational value() const;
    [[nodiscard]] bool is_undefined() const { return undefined_; }

    friend Exact operator+(const Exact& a, const Exact& b);
    friend Exact operator-(const Exact& a, const Exact& b);
    friend Exact operator*(const Exact& a, const Exact& b);
    friend Exact operator/(const Exact& a, const Exact& b);
    friend Exact operator-(const Exact& a);
    friend bool operator==(const Exact& a, const Exact& b);
    friend bool operator<(const Exact& a, const Exact& b);
    friend bool operator>(const Exact& a, const Exact& b) { return b < a; }
    friend bool operator<=(const Exact& a, const Exact& b);
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

    friend Integer floor(const Exact& a);
    friend Integer trunc(const Exact& a) { return a < 0 ? ceil(a) : floor(a); }
    friend Integer ceil(const Exact& a) { return -floor(-a); }
    friend Integer round_even(const Exact& a);
    friend Exact lesser(const Exact& a, const Exact& b) { return b < a ? b : a; }
    friend Exact greater(const Exact& a, const Exact& b) { return a < b ? b : a; }
    friend double approximate(const Exact& a);

private:
    /// Up to 256 bits lie in the number itself.
    using Whole =
        boost::multiprecision::number<boost::multiprecision::cpp_int_backend<256>, boost::multiprecision::et_off>;

    Exact(Whole top, int exponent, Whole bottom);

    [[nodiscard]] static bool either(const Exact& a, const Exact& b) { return a.undefined_ || b.undefined_; }
    void make_odd();

    struct Aligned {
        Whole top;
        int exponent;
    };
    /// The numerator of a + b, or of a - b, over both denominators; over a's alone where they are equal.
    [[nodiscard]] static Aligned aligned(const Exact& a, const Exact& b, bool minus);
    [[nodiscard]] static Exact sum(const Exact& a, const Exact& b, bool minus);
    /// top * 2^exponent / (b1 * b2)
    [[nodiscard]] static Exact quotient(Whole top, int exponent, const Whole& b1, const Whole& b2);
    [[nodiscard]] Whole floor_big() const;

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
