// Bounded<T>: a number of a method together with a bound of what rounding has cost it so far (running error analysis:
// J. H. Wilkinson, 1963; N. J. Higham, Accuracy and Stability of Numerical Algorithms, 3.3). A method run over it gives
// the same values, and for each sample the most that u and v may be off: the bound that it must keep.
//   x + y  errors add; then one rounding of the result
//   x y    |x| e_y + |y| e_x + e_x e_y; then one rounding
//   x / y  (|x| e_y + |y| e_x) / (|y| (|y| - e_y)), without end where e_y >= |y|; then one rounding
// One rounding is half a unit in the last place of a float: 2^-24 or 2^-53 of the result, or half the least denormal
// where products and quotients fall below; of fixed point 2^-F, for products and quotients only. Beyond its range a
// number has no bound. Decisions are those of the values: on a triangle both sides of one compute the same plane.
#pragma once

#include <cmath>
#include <limits>

#include "core/number/fixed.h"
#include "core/number/real.h"

namespace texelscope {

/// What one operation's result may be off by itself.
template <class T>
struct Rounding;
template <std::floating_point T>
struct Rounding<T> {
    static constexpr double kHalfUlp = std::numeric_limits<T>::epsilon() / 2.0;
    [[nodiscard]] static double of_sum(T x) { return std::isfinite(x) ? std::abs(double{x}) * kHalfUlp : INFINITY; }
    [[nodiscard]] static double of_product(T x) { return of_sum(x) + double{std::numeric_limits<T>::denorm_min()}; }
};
template <int I, int F>
struct Rounding<Fixed<I, F>> {
    [[nodiscard]] static double of_sum(Fixed<I, F> x) { return x.overflowed() ? INFINITY : 0; }
    [[nodiscard]] static double of_product(Fixed<I, F> x) { return x.overflowed() ? INFINITY : std::ldexp(1.0, -F); }
};

template <class T>
class Bounded {
public:
    Bounded() = default;
    explicit Bounded(Integer whole) : value_(make(whole)) {
        const bool lost = !(Rounding<T>::of_sum(value_) < INFINITY);
        set(lost ? INFINITY : std::abs(static_cast<double>(whole) - approximate(value_)));
    }
    [[nodiscard]] static Bounded of(const T& value, double error) {
        Bounded b;
        b.value_ = value;
        b.set(error);
        return b;
    }

    [[nodiscard]] const T& value() const { return value_; }
    [[nodiscard]] double error() const { return error_; }  ///< at most; infinite: no bound

    friend Bounded operator+(const Bounded& a, const Bounded& b) { return sum(a, b, a.value_ + b.value_); }
    friend Bounded operator-(const Bounded& a, const Bounded& b) { return sum(a, b, a.value_ - b.value_); }
    friend Bounded operator-(const Bounded& a) { return of(-a.value_, a.error_); }
    friend Bounded operator*(const Bounded& a, const Bounded& b) {
        const T product = a.value_ * b.value_;
        return of(product,
                  a.size() * b.error_ + b.size() * a.error_ + a.error_ * b.error_ + Rounding<T>::of_product(product));
    }
    friend Bounded operator/(const Bounded& a, const Bounded& b) {
        const T quotient = a.value_ / b.value_;
        if (!(b.error_ < b.size())) return of(quotient, INFINITY);
        const double lost = (a.size() * b.error_ + b.size() * a.error_) / (b.size() * (b.size() - b.error_));
        return of(quotient, lost + Rounding<T>::of_product(quotient));
    }

    friend Bounded operator+(Integer a, const Bounded& b) { return Bounded(a) + b; }
    friend Bounded operator+(const Bounded& a, Integer b) { return a + Bounded(b); }
    friend Bounded operator-(Integer a, const Bounded& b) { return Bounded(a) - b; }
    friend Bounded operator-(const Bounded& a, Integer b) { return a - Bounded(b); }
    friend Bounded operator*(Integer a, const Bounded& b) { return Bounded(a) * b; }
    friend Bounded operator*(const Bounded& a, Integer b) { return a * Bounded(b); }
    friend Bounded operator/(Integer a, const Bounded& b) { return Bounded(a) / b; }
    friend Bounded operator/(const Bounded& a, Integer b) { return a / Bounded(b); }

    friend bool operator==(const Bounded& a, const Bounded& b) { return a.value_ == b.value_; }
    friend bool operator!=(const Bounded& a, const Bounded& b) { return !(a.value_ == b.value_); }
    friend bool operator<(const Bounded& a, const Bounded& b) { return a.value_ < b.value_; }
    friend bool operator>(const Bounded& a, const Bounded& b) { return a.value_ > b.value_; }
    friend bool operator<=(const Bounded& a, const Bounded& b) { return a.value_ <= b.value_; }
    friend bool operator>=(const Bounded& a, const Bounded& b) { return a.value_ >= b.value_; }
    friend bool operator==(const Bounded& a, Integer b) { return a == Bounded(b); }
    friend bool operator<(const Bounded& a, Integer b) { return a < Bounded(b); }
    friend bool operator>(const Bounded& a, Integer b) { return a > Bounded(b); }
    friend bool operator<=(const Bounded& a, Integer b) { return a <= Bounded(b); }
    friend bool operator>=(const Bounded& a, Integer b) { return a >= Bounded(b); }

    friend Integer floor(const Bounded& a) { return floor(a.value_); }
    friend Integer trunc(const Bounded& a) { return trunc(a.value_); }
    friend Integer ceil(const Bounded& a) { return ceil(a.value_); }
    friend Integer round_even(const Bounded& a) { return round_even(a.value_); }
    friend Bounded lesser(const Bounded& a, const Bounded& b) { return b < a ? b : a; }
    friend Bounded greater(const Bounded& a, const Bounded& b) { return a < b ? b : a; }
    friend double approximate(const Bounded& a) { return approximate(a.value_); }

private:
    [[nodiscard]] static T make(Integer whole) {
        if constexpr (std::floating_point<T>)
            return static_cast<T>(whole);
        else
            return T(whole);
    }
    [[nodiscard]] double size() const { return std::abs(approximate(value_)); }
    /// What double loses of the bound itself: a few parts in 2^53.
    void set(double error) { error_ = error < INFINITY ? error * (1 + 0x1p-48) : INFINITY; }
    [[nodiscard]] static Bounded sum(const Bounded& a, const Bounded& b, const T& value) {
        return of(value, a.error_ + b.error_ + Rounding<T>::of_sum(value));
    }

    T value_{};
    double error_ = 0;
};

template <class T>
struct Input<Bounded<T>> {
    [[nodiscard]] static Bounded<T> from(double x, NumberMode mode) {
        const T value = Input<T>::from(x, mode);
        const bool lost = !(Rounding<T>::of_sum(value) < INFINITY);
        return Bounded<T>::of(value, lost ? INFINITY : std::abs(x - approximate(value)));
    }
};

static_assert(Real<Bounded<double>> && Real<Bounded<float>> && Real<Bounded<Fixed16>>);

}  // namespace texelscope
