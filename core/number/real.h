// What a method may do with its numbers, whatever their type: + - * /, comparisons, the roundings below, and
// small whole numbers on either side of an operator. double and float are themselves; Fixed, Exact and
// Recorded<T> follow the same rules. There is no implicit way from double into T: write fractions as T(1) / 2.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>

namespace texelscope {

using Integer = std::int64_t;  ///< wide enough for any texel index before it is wrapped

/// How the fixed-point formats behave where a result leaves their range.
enum class Overflow : std::uint8_t {
    mark,      ///< go on with the true value in 64 bits; the value is marked
    saturate,  ///< the nearest value inside the range; marked
    wrap,      ///< modulo the range, as the processor does it; marked
};

/// The choices a number format leaves open. Only Fixed has any.
struct NumberMode {
    Overflow overflow = Overflow::mark;
    bool floor_products = false;  ///< quirk: a product's shift rounds down, so that (-a) * b differs from -(a * b)
    friend bool operator==(const NumberMode&, const NumberMode&) = default;
};

template <class T>
struct NumberTypes {
    using Int = Integer;
    using Truth = bool;
};
/// The type of loop variables and texel indices of a method over T: Integer, or a recorded one.
template <class T>
using IntegerOf = typename NumberTypes<T>::Int;
/// The type of decisions of a method over T: bool, or a recorded one.
template <class T>
using TruthOf = typename NumberTypes<T>::Truth;

inline constexpr double kIntegerLimit =
    4.0e18;  ///< roundings saturate here, below 2^62: sums of two stay inside 64 bits

/// The whole number of a double that is one already, saturating; NaN gives 0.
[[nodiscard]] constexpr Integer saturated_integer(double whole) noexcept {
    if (!(whole > -kIntegerLimit)) return whole <= -kIntegerLimit ? -static_cast<Integer>(kIntegerLimit) : 0;
    return static_cast<Integer>(whole < kIntegerLimit ? whole : kIntegerLimit);
}

[[nodiscard]] inline Integer trunc(std::floating_point auto x) noexcept { return saturated_integer(x); }
[[nodiscard]] inline Integer floor(std::floating_point auto x) noexcept {
    const Integer whole = saturated_integer(x);  // no libm call: this is in the pixel loop
    return whole - (x < static_cast<decltype(x)>(whole));
}
[[nodiscard]] inline Integer ceil(std::floating_point auto x) noexcept {
    const Integer whole = saturated_integer(x);
    return whole + (x > static_cast<decltype(x)>(whole));
}
/// To nearest, ties to even.
[[nodiscard]] inline Integer round_even(std::floating_point auto x) noexcept {
    return saturated_integer(std::nearbyint(static_cast<double>(x)));
}

/// The nearest float32, as an array of float32 keeps it. Only double has digits to lose.
[[nodiscard]] constexpr double single(double x) noexcept { return static_cast<double>(static_cast<float>(x)); }
[[nodiscard]] constexpr float single(float x) noexcept { return x; }
template <class T>
requires(!std::is_arithmetic_v<T>) [[nodiscard]] const T& single(const T& x) { return x; }

/// `c ? a : b` for values, so that a recorded choice is on the tape. Both are computed: never guard a division.
template <class V>
[[nodiscard]] constexpr V choose(bool c, const V& a, const V& b) noexcept {
    return c ? a : b;
}
template <class V>
requires std::is_arithmetic_v<V>
[[nodiscard]] constexpr V lesser(V a, V b) noexcept { return b < a ? b : a; }
template <class V>
requires std::is_arithmetic_v<V>
[[nodiscard]] constexpr V greater(V a, V b) noexcept { return a < b ? b : a; }

/// The value without its tape, for indexing.
[[nodiscard]] constexpr Integer plain(Integer i) noexcept { return i; }
[[nodiscard]] constexpr bool plain(bool b) noexcept { return b; }

/// An input of a method: a scene's float32 as a T, rounded to nearest where T is coarser.
template <class T>
struct Input;
template <std::floating_point T>
struct Input<T> {
    [[nodiscard]] static constexpr T from(double x, NumberMode) noexcept { return static_cast<T>(x); }
};

/// The nearest double, for pictures and tables.
[[nodiscard]] constexpr double approximate(std::floating_point auto x) noexcept { return static_cast<double>(x); }

template <class T>
concept Real = requires(T a, T b, IntegerOf<T> i, TruthOf<T> c) {
    { a + b } -> std::same_as<T>;
    { a - b } -> std::same_as<T>;
    { a* b } -> std::same_as<T>;
    { a / b } -> std::same_as<T>;
    { i + a } -> std::same_as<T>;
    { -a } -> std::same_as<T>;
    { a < b } -> std::same_as<TruthOf<T>>;
    { floor(a) } -> std::same_as<IntegerOf<T>>;
    { trunc(a) } -> std::same_as<IntegerOf<T>>;
    { ceil(a) } -> std::same_as<IntegerOf<T>>;
    { round_even(a) } -> std::same_as<IntegerOf<T>>;
    { choose(c, a, b) } -> std::same_as<T>;
    { lesser(a, b) } -> std::same_as<T>;
    { greater(a, b) } -> std::same_as<T>;
};

static_assert(Real<double> && Real<float>);

}  // namespace texelscope
