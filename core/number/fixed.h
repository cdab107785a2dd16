// Fixed<I, F>: I bits before the point (the sign among them) and F behind it, as integer units computed
// before fast floating point. Results round toward zero, so -(a * b) = (-a) * b; leaving the range follows
// NumberMode and is marked on the value for good.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/number/real.h"

namespace texelscope {

__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): __extension__ takes a typedef only

template <int I, int F>
class Fixed {
public:
    static constexpr int kIntegerBits = I, kFractionBits = F;
    static constexpr std::int64_t kMax = (std::int64_t{1} << (I + F - 1)) - 1;  ///< greatest raw value in range
    static constexpr std::int64_t kMin = -kMax - 1;

    constexpr Fixed() = default;
    constexpr explicit Fixed(Integer whole, NumberMode mode = {})
        : Fixed(settle(static_cast<Int128>(whole) * (Int128{1} << F), mode, false)) {}

    /// To nearest, ties to even. A value that is not finite is marked, and saturates.
    [[nodiscard]] static Fixed from(double x, NumberMode mode) {
        if (std::isnan(x)) return settle(0, mode, true);
        const double raw = std::nearbyint(std::ldexp(x, F));
        const double limit = 9.0e18;
        if (std::abs(raw) > limit) return settle(static_cast<std::int64_t>(std::copysign(limit, raw)), mode, true);
        return settle(static_cast<std::int64_t>(raw), mode, false);
    }
    /// For tapes and tests: the value that has this representation.
    [[nodiscard]] static constexpr Fixed from_raw(std::int64_t raw, bool overflowed, NumberMode mode) {
        Fixed x;
        x.raw_ = raw;
        x.flags_ = static_cast<std::uint64_t>(mode.overflow) | (mode.floor_products ? kFloorProducts : 0) |
                   (overflowed ? kOverflowed : 0);
        return x;
    }

    [[nodiscard]] constexpr std::int64_t raw() const { return raw_; }  ///< [2^-F]
    [[nodiscard]] constexpr bool overflowed() const {
        return (flags_ & kOverflowed) != 0;
    }  ///< it, or an operand, left the range
    [[nodiscard]] constexpr NumberMode mode() const {
        return {static_cast<Overflow>(flags_ & kPolicy), (flags_ & kFloorProducts) != 0};
    }

    friend constexpr Fixed operator+(Fixed a, Fixed b) { return settle(Int128{a.raw_} + b.raw_, a, b); }
    friend constexpr Fixed operator-(Fixed a, Fixed b) { return settle(Int128{a.raw_} - b.raw_, a, b); }
    friend constexpr Fixed operator-(Fixed a) { return settle(-Int128{a.raw_}, a, a); }
    friend constexpr Fixed operator*(Fixed a, Fixed b) {
        const Int128 product = Int128{a.raw_} * b.raw_;
        const bool down = (a.mode().floor_products || b.mode().floor_products) && product < 0;
        const Int128 unit = Int128{1} << F;
        return settle((down ? product - (unit - 1) : product) / unit, a, b);
    }
    /// Division by zero is marked and saturates by the sign of `a`; 0 / 0 is 0.
    friend constexpr Fixed operator/(Fixed a, Fixed b) {
        if (b.raw_ == 0) {
            const std::int64_t end = a.raw_ > 0 ? kMax : a.raw_ < 0 ? kMin : 0;
            return settle(end, merged(a, b), true);
        }
        return settle(Int128{a.raw_} * (Int128{1} << F) / b.raw_, a, b);
    }
    friend constexpr bool operator==(Fixed a, Fixed b) { return a.raw_ == b.raw_; }
    friend constexpr bool operator<(Fixed a, Fixed b) { return a.raw_ < b.raw_; }
    friend constexpr bool operator>(Fixed a, Fixed b) { return a.raw_ > b.raw_; }
    friend constexpr bool operator<=(Fixed a, Fixed b) { return a.raw_ <= b.raw_; }
    friend constexpr bool operator>=(Fixed a, Fixed b) { return a.raw_ >= b.raw_; }

    friend constexpr Fixed operator+(Integer a, Fixed b) { return Fixed(a, b.mode()) + b; }
    friend constexpr Fixed operator+(Fixed a, Integer b) { return a + Fixed(b, a.mode()); }
    friend constexpr Fixed operator-(Integer a, Fixed b) { return Fixed(a, b.mode()) - b; }
    friend constexpr Fixed operator-(Fixed a, Integer b) { return a - Fixed(b, a.mode()); }
    friend constexpr Fixed operator*(Integer a, Fixed b) { return Fixed(a, b.mode()) * b; }
    friend constexpr Fixed operator*(Fixed a, Integer b) { return a * Fixed(b, a.mode()); }
    friend constexpr Fixed operator/(Integer a, Fixed b) { return Fixed(a, b.mode()) / b; }
    friend constexpr Fixed operator/(Fixed a, Integer b) { return a / Fixed(b, a.mode()); }
    friend constexpr bool operator==(Fixed a, Integer b) { return a == Fixed(b); }
    friend constexpr bool operator<(Fixed a, Integer b) { return a < Fixed(b); }
    friend constexpr bool operator>(Fixed a, Integer b) { return a > Fixed(b); }
    friend constexpr bool operator<=(Fixed a, Integer b) { return a <= Fixed(b); }
    friend constexpr bool operator>=(Fixed a, Integer b) { return a >= Fixed(b); }

    friend constexpr Integer floor(Fixed a) { return a.raw_ >> F; }
    friend constexpr Integer trunc(Fixed a) { return a.raw_ / (std::int64_t{1} << F); }
    friend constexpr Integer ceil(Fixed a) { return -((-a.raw_) >> F); }
    friend constexpr Integer round_even(Fixed a) {
        const std::int64_t half = std::int64_t{1} << (F - 1), rest = a.raw_ & (2 * half - 1), down = a.raw_ >> F;
        return down + (rest > half || (rest == half && (down & 1)));
    }
    friend constexpr Fixed lesser(Fixed a, Fixed b) { return b < a ? b : a; }
    friend constexpr Fixed greater(Fixed a, Fixed b) { return a < b ? b : a; }
    friend double approximate(Fixed a) { return std::ldexp(static_cast<double>(a.raw_), -F); }

private:
    /// The numbers of one run are all of one mode, or constants in the mode that asks for least.
    [[nodiscard]] static constexpr NumberMode merged(Fixed a, Fixed b) {
        const NumberMode m = a.mode(), n = b.mode();
        return {m.overflow > n.overflow ? m.overflow : n.overflow, m.floor_products || n.floor_products};
    }
    [[nodiscard]] static constexpr Fixed settle(Int128 raw, Fixed a, Fixed b) {
        return settle(raw, merged(a, b), a.overflowed() || b.overflowed());
    }
    [[nodiscard]] static constexpr Fixed settle(Int128 raw, NumberMode mode, bool overflowed) {
        const bool outside = raw > kMax || raw < kMin;
        if (outside) raw = brought_back(raw, mode.overflow);
        return from_raw(static_cast<std::int64_t>(raw), overflowed || outside, mode);
    }
    [[nodiscard]] static constexpr Int128 brought_back(Int128 raw, Overflow policy) {
        constexpr Int128 kEnd = std::numeric_limits<std::int64_t>::max() / 4;  // a negation still fits in 64 bits
        switch (policy) {
            case Overflow::saturate: return raw > 0 ? kMax : kMin;
            case Overflow::wrap: {
                const auto low = static_cast<std::uint64_t>(raw) << (64 - I - F);
                return static_cast<std::int64_t>(low) >> (64 - I - F);
            }
            case Overflow::mark: break;
        }
        return raw > kEnd ? kEnd : raw < -kEnd ? -kEnd : raw;
    }

    static constexpr std::uint64_t kPolicy = 3, kFloorProducts = 4, kOverflowed = 8;
    // Two words and no padding: gcc 12 at -O3 loses parts of arrays of structs that end in padding.
    std::int64_t raw_ = 0;
    std::uint64_t flags_ = 0;  ///< mode and overflowed
};

template <int I, int F>
struct Input<Fixed<I, F>> {
    [[nodiscard]] static Fixed<I, F> from(double x, NumberMode mode) { return Fixed<I, F>::from(x, mode); }
};

using Fixed16 = Fixed<16, 16>;
using Fixed8 = Fixed<8, 8>;
static_assert(Real<Fixed16> && Real<Fixed8>);

}  // namespace texelscope
