#include "core/number/exact.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texelscope {
namespace {

[[nodiscard]] int msb_of(const auto& x) { return x.is_zero() ? 0 : static_cast<int>(msb(abs(x))); }

[[nodiscard]] Integer saturated(const auto& whole) {
    constexpr auto kEnd = static_cast<Integer>(kIntegerLimit);
    return whole > kEnd ? kEnd : whole < -kEnd ? -kEnd : whole.template convert_to<Integer>();
}

}  // namespace

Exact::Exact() = default;
Exact::Exact(const Exact& other) = default;
Exact::Exact(Exact&& other) noexcept = default;
Exact& Exact::operator=(const Exact& other) = default;
Exact& Exact::operator=(Exact&& other) noexcept = default;
Exact::~Exact() = default;

Exact::Exact(Integer whole) : top_(whole) { make_odd(); }
Exact::Exact(const Rational& value) : top_(numerator(value)), bottom_(denominator(value)) {
    const auto twos = static_cast<int>(lsb(bottom_));
    bottom_ >>= twos, exponent_ = -twos;
    make_odd();
}
Exact::Exact(Whole top, int exponent, Whole bottom)
    : top_(std::move(top)), bottom_(std::move(bottom)), exponent_(exponent) {
    make_odd();
}

Exact Exact::from(double x) {
    if (!std::isfinite(x)) return undefined();
    int exponent = 0;
    Exact found(static_cast<Integer>(std::ldexp(std::frexp(x, &exponent), 53)));
    if (x != 0) found.exponent_ += exponent - 53;
    return found;
}
Exact Exact::undefined() {
    Exact x;
    x.undefined_ = true;
    return x;
}

Exact::Rational Exact::value() const {
    const Rational::value_type one = 1;
    const Rational fraction{Rational::value_type(top_), Rational::value_type(bottom_)};
    return exponent_ < 0 ? fraction / Rational(one << -exponent_) : fraction * Rational(one << exponent_);
}

void Exact::make_odd() {
    if (top_.is_zero()) return void(exponent_ = 0);
    const auto twos = static_cast<int>(lsb(abs(top_)));
    if (twos > 0) top_ >>= twos, exponent_ += twos;
}

Exact::Aligned Exact::aligned(const Exact& a, const Exact& b, bool minus) {
    const int exponent = std::min(a.exponent_, b.exponent_);
    const bool same = a.bottom_ == b.bottom_;
    Whole x = same ? a.top_ : Whole(a.top_ * b.bottom_), y = same ? b.top_ : Whole(b.top_ * a.bottom_);
    x <<= a.exponent_ - exponent, y <<= b.exponent_ - exponent;
    return {minus ? Whole(x - y) : Whole(x + y), exponent};
}
Exact Exact::sum(const Exact& a, const Exact& b, bool minus) {
    Aligned s = aligned(a, b, minus);
    return quotient(std::move(s.top), s.exponent, a.bottom_, a.bottom_ == b.bottom_ ? Whole(1) : b.bottom_);
}
Exact Exact::quotient(Whole top, int exponent, const Whole& b1, const Whole& b2) {
    if (b1 == 1 && b2 == 1) return {std::move(top), exponent, 1};
    const auto twos = static_cast<int>(lsb(b2));
    Whole bottom = b1 * (b2 >> twos);
    if (const Whole common = gcd(top, bottom); common != 1) top /= common, bottom /= common;
    return {std::move(top), exponent - twos, std::move(bottom)};
}

Exact operator+(const Exact& a, const Exact& b) {
    return Exact::either(a, b) ? Exact::undefined() : Exact::sum(a, b, false);
}
Exact operator-(const Exact& a, const Exact& b) {
    return Exact::either(a, b) ? Exact::undefined() : Exact::sum(a, b, true);
}
Exact operator*(const Exact& a, const Exact& b) {
    if (Exact::either(a, b)) return Exact::undefined();
    return Exact::quotient(a.top_ * b.top_, a.exponent_ + b.exponent_, a.bottom_, b.bottom_);
}
Exact operator/(const Exact& a, const Exact& b) {
    if (Exact::either(a, b) || b.top_.is_zero()) return Exact::undefined();
    const Exact::Whole top = a.top_ * b.bottom_;
    return Exact::quotient(b.top_.sign() < 0 ? Exact::Whole(-top) : top, a.exponent_ - b.exponent_, a.bottom_,
                           abs(b.top_));
}
Exact operator-(const Exact& a) {
    Exact negative = a;
    negative.top_ = -negative.top_;
    return negative;
}
bool operator==(const Exact& a, const Exact& b) {
    return !Exact::either(a, b) && a.exponent_ == b.exponent_ && a.top_ == b.top_ && a.bottom_ == b.bottom_;
}
bool operator<(const Exact& a, const Exact& b) {
    return !Exact::either(a, b) && Exact::aligned(a, b, true).top.sign() < 0;
}
bool operator<=(const Exact& a, const Exact& b) {
    return !Exact::either(a, b) && Exact::aligned(a, b, true).top.sign() <= 0;
}

Exact::Whole Exact::floor_big() const {
    if (undefined_) return 0;
    const Whole top = exponent_ > 0 ? Whole(top_ << exponent_) : top_;
    const Whole bottom = exponent_ < 0 ? Whole(bottom_ << -exponent_) : bottom_;
    const Whole whole = top / bottom;
    return top.sign() < 0 && whole * bottom != top ? Whole(whole - 1) : whole;
}
Integer floor(const Exact& a) { return saturated(a.floor_big()); }
Integer round_even(const Exact& a) {
    if (a.undefined_) return 0;
    const Exact::Whole down = a.floor_big();
    const Exact rest = a - Exact(down, 0, 1), half(1, -1, 1);
    return saturated(down) + (rest > half || (rest == half && bit_test(abs(down), 0)));
}
double approximate(const Exact& a) {
    if (a.undefined_) return std::nan("");
    constexpr int kDigits = 53, kSmall = 900;  // both are doubles: one rounding, by the division
    if (msb_of(a.top_) < kDigits && msb_of(a.bottom_) < kDigits && std::abs(a.exponent_) < kSmall)
        return std::ldexp(a.top_.convert_to<double>() / a.bottom_.convert_to<double>(), a.exponent_);
    return a.value().convert_to<double>();
}

}  // namespace texelscope
