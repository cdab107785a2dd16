// Recorded<T> computes what T computes, bit for bit, and the roundings of floats are those of the mathematics.
#include "core/number/recorded.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace texelscope {
namespace {

template <class T>
bool identical(const T& a, const T& b) {
    if constexpr (std::is_arithmetic_v<T>)
        return std::memcmp(&a, &b, sizeof a) == 0;
    else
        return full_text(a) == full_text(b) && overflowed(a) == overflowed(b);
}

template <class T>
T number(std::mt19937& random) {
    const auto x = static_cast<float>(
        std::ldexp(static_cast<double>(random()) - 2147483648.0, static_cast<int>(random() % 40) - 36));
    return Input<T>::from(random() % 5 == 0 ? static_cast<float>(static_cast<int>(random() % 5) - 2) : x, {});
}

template <class T>
class RecordedNumbers : public testing::Test {};
using Numbers = testing::Types<double, float, Fixed16, Fixed8, Exact>;
TYPED_TEST_SUITE(RecordedNumbers, Numbers);

/// A chain of operations as a method has them, for plain and recorded numbers alike.
template <class N>
N mixture(const N& a, const N& b, const N& c, int kind) {
    const IntegerOf<N> i = floor(a);
    switch (kind) {
        case 0: return a * b - c * (a + 3) / 2;
        case 1: return choose(a < b || !(c <= b), (a - c) / b, -a);
        case 2: return lesser(a, b) + greater(b, c) * N(i) - 1;
        case 3: return N(round_even(b) - trunc(c) + ceil(a)) + c / 4;
        case 4: return N(euclidean_modulo(i, Integer{12}) & Integer{7}) * a;
        default: return 5 - a / (1 + b) * (2 * c);
    }
}

TYPED_TEST(RecordedNumbers, ComputeTheSameBits) {
    using T = TypeParam;
    std::mt19937 random(4);
    for (int n = 0; n < 3000; ++n) {
        const T a = number<T>(random), b = number<T>(random), c = number<T>(random);
        TapeWriter writer;
        const auto input = [&](const T& x) { return Recorded<T>(x, &writer, writer.tape.push(Op::input, x)); };
        const Recorded<T> ra = input(a), rb = input(b), rc = input(c);
        for (int kind = 0; kind < 6; ++kind) {
            const Recorded<T> recorded = mixture(ra, rb, rc, kind);
            const T plain_value = mixture(a, b, c, kind);
            ASSERT_TRUE(identical(recorded.value(), plain_value))
                << kind << ": " << full_text(a) << ", " << full_text(b) << ", " << full_text(c);
            const Value& on_tape = writer.tape.operations.at(static_cast<std::size_t>(recorded.operation())).value;
            ASSERT_TRUE(identical(std::get<T>(on_tape), plain_value)) << kind;
        }
    }
}

TYPED_TEST(RecordedNumbers, LeaveNothingWhileMuted) {
    using T = TypeParam;
    TapeWriter writer;
    const Recorded<T> a(T(3), &writer, writer.tape.push(Op::input, T(3)));
    ++writer.muted;
    const Recorded<T> product = a * a;
    EXPECT_EQ(writer.tape.operations.size(), 1U);
    EXPECT_LT(product.operation(), 0);
    --writer.muted;
    const Recorded<T> sum = product.carried("p", 7) + a;
    EXPECT_EQ(full_text(sum.value()), "12");
    ASSERT_EQ(writer.tape.names.size(), 1U);
    EXPECT_EQ(writer.tape.names[0].name.text(), "p");
}

TEST(Real, FloatsRoundAsTheMathematicsDo) {
    for (int n = -400; n <= 400; ++n) {
        const double x = n / 16.0;
        EXPECT_EQ(floor(x), static_cast<Integer>(std::floor(x)));
        EXPECT_EQ(ceil(x), static_cast<Integer>(std::ceil(x)));
        EXPECT_EQ(trunc(x), static_cast<Integer>(std::trunc(x)));
        EXPECT_EQ(round_even(x), static_cast<Integer>(std::nearbyint(x)));
        EXPECT_EQ(floor(static_cast<float>(x)), floor(x));
        EXPECT_EQ(ceil(static_cast<float>(x)), ceil(x));
    }
}

TEST(Real, RoundingsSaturateInsideSixtyTwoBits) {
    constexpr Integer kEnd = 4000000000000000000;
    for (const double x : {4e18, 1e19, 1e300, static_cast<double>(INFINITY)}) {
        for (const Integer up : {floor(x), ceil(x), trunc(x), round_even(x)}) EXPECT_LE(std::abs(up - kEnd), 1);
        for (const Integer down : {floor(-x), ceil(-x), trunc(-x), round_even(-x)}) EXPECT_LE(std::abs(down + kEnd), 1);
    }
    EXPECT_EQ(floor(NAN), 0);
    EXPECT_EQ(round_even(static_cast<double>(NAN)), 0);
}

}  // namespace
}  // namespace texelscope
