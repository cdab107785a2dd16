// Fixed against whole numbers of any size.
#include "core/number/fixed.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace texelscope {
namespace {

using Wide = boost::multiprecision::cpp_int;

constexpr NumberMode kMark{Overflow::mark, false}, kSaturate{Overflow::saturate, false}, kWrap{Overflow::wrap, false};

template <class F>
constexpr int kBits = F::kIntegerBits + F::kFractionBits;

/// What the policy makes of a true raw result.
template <class F>
std::int64_t settled(const Wide& raw, Overflow policy) {
    if (raw <= F::kMax && raw >= F::kMin) return raw.convert_to<std::int64_t>();
    const Wide end = Wide(1) << 61;
    switch (policy) {
        case Overflow::saturate: return raw > 0 ? F::kMax : F::kMin;
        case Overflow::wrap: {
            const Wide size = Wide(1) << kBits<F>;
            Wide low = raw % size;
            if (low < 0) low += size;
            return (low > F::kMax ? Wide(low - size) : low).template convert_to<std::int64_t>();
        }
        case Overflow::mark: break;
    }
    return (raw >= end ? Wide(end - 1) : raw <= -end ? Wide(1 - end) : raw).template convert_to<std::int64_t>();
}

Wide floor_divided(const Wide& a, const Wide& b) { return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0); }

template <class F>
void check_pair(std::int64_t raw_a, std::int64_t raw_b, NumberMode mode) {
    const F a = F::from_raw(raw_a, false, mode), b = F::from_raw(raw_b, false, mode);
    const Wide x = raw_a, y = raw_b, unit = Wide(1) << F::kFractionBits;
    const auto expect = [&](F result, const Wide& raw, const char* what) {
        ASSERT_EQ(result.raw(), settled<F>(raw, mode.overflow))
            << raw_a << what << raw_b << ", policy " << int(mode.overflow);
        ASSERT_EQ(result.overflowed(), raw > F::kMax || raw < F::kMin) << raw_a << what << raw_b;
    };
    expect(a + b, x + y, " + ");
    expect(a - b, x - y, " - ");
    expect(a * b, mode.floor_products ? floor_divided(x * y, unit) : Wide(x * y / unit), " * ");
    if (raw_b != 0) expect(a / b, x * unit / y, " / ");
    expect(-a, -x, " negated ");
    ASSERT_EQ(a < b, raw_a < raw_b);
    ASSERT_EQ(a <= b, raw_a <= raw_b);
    ASSERT_EQ(a == b, raw_a == raw_b);
    ASSERT_EQ(lesser(a, b).raw(), std::min(raw_a, raw_b));
    ASSERT_EQ(greater(a, b).raw(), std::max(raw_a, raw_b));
}

template <class F>
class FixedNumbers : public testing::Test {};
using Formats = testing::Types<Fixed16, Fixed8>;
TYPED_TEST_SUITE(FixedNumbers, Formats);

TYPED_TEST(FixedNumbers, FollowThePoliciesOfOverflow) {
    std::mt19937_64 random(11);
    const auto any = [&] {
        const auto size = static_cast<int>(random() % kBits<TypeParam>);
        const auto raw = static_cast<std::int64_t>(random() >> (64 - size - 1) >> 1);
        return random() % 2 == 0 ? raw : -raw;
    };
    for (int n = 0; n < 60000; ++n) {
        for (const NumberMode mode : {kMark, kSaturate, kWrap, NumberMode{Overflow::mark, true}}) {
            check_pair<TypeParam>(any(), any(), mode);
            if (this->HasFatalFailure()) return;
        }
    }
    for (const std::int64_t a :
         {TypeParam::kMin, TypeParam::kMin + 1, std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, TypeParam::kMax}) {
        for (const std::int64_t b :
             {TypeParam::kMin, std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, TypeParam::kMax}) {
            for (const NumberMode mode : {kMark, kSaturate, kWrap}) check_pair<TypeParam>(a, b, mode);
        }
    }
}

TYPED_TEST(FixedNumbers, MarkedValuesGoOnBeyondTheRange) {
    const std::int64_t beyond = TypeParam::kMax * 1000;
    check_pair<TypeParam>(beyond, -beyond, kMark);
    check_pair<TypeParam>(std::int64_t{1} << 60, std::int64_t{1} << 60, kMark);
    const TypeParam end = TypeParam::from_raw(std::int64_t{1} << 60, true, kMark);
    EXPECT_TRUE((end - end).overflowed());  // the mark stays, though the result is in range
    EXPECT_EQ((end - end).raw(), 0);
}

TYPED_TEST(FixedNumbers, ProductsAreSymmetricUnlessAskedToFloor) {
    std::mt19937 random(3);
    int differ = 0;
    for (int n = 0; n < 20000; ++n) {
        const auto a = static_cast<std::int64_t>(random() % 4000), b = static_cast<std::int64_t>(random() % 4000);
        const auto product = [](std::int64_t x, std::int64_t y, bool floor) {
            const NumberMode mode{Overflow::mark, floor};
            return (TypeParam::from_raw(x, false, mode) * TypeParam::from_raw(y, false, mode)).raw();
        };
        ASSERT_EQ(product(-a, b, false), -product(a, b, false));
        ASSERT_EQ(product(a, -b, false), -product(a, b, false));
        ASSERT_EQ(product(-a, -b, false), product(a, b, false));
        differ += product(-a, b, true) != -product(a, b, true);
    }
    EXPECT_GT(differ, 10000);
}

TYPED_TEST(FixedNumbers, FloatsAreTakenToTheNearestTiesToEven) {
    const double unit = std::ldexp(1, -TypeParam::kFractionBits);
    for (int n = -40; n <= 40; ++n) {
        EXPECT_EQ(TypeParam::from(n * unit, kMark).raw(), n);
        EXPECT_EQ(TypeParam::from((n + 0.25) * unit, kMark).raw(), n);
        EXPECT_EQ(TypeParam::from((n + 0.75) * unit, kMark).raw(), n + 1);
        EXPECT_EQ(TypeParam::from((n + 0.5) * unit, kMark).raw() % 2, 0);
        EXPECT_EQ(std::abs(TypeParam::from((n + 0.5) * unit, kMark).raw() * 2 - (2 * n + 1)), 1);
    }
}

TYPED_TEST(FixedNumbers, WhatIsNotFiniteIsMarked) {
    for (const NumberMode mode : {kMark, kSaturate, kWrap}) {
        EXPECT_TRUE(TypeParam::from(std::nan(""), mode).overflowed());
        EXPECT_TRUE(TypeParam::from(INFINITY, mode).overflowed());
        EXPECT_TRUE(TypeParam::from(-1e300, mode).overflowed());
    }
    EXPECT_EQ(TypeParam::from(INFINITY, kSaturate).raw(), TypeParam::kMax);
    EXPECT_EQ(TypeParam::from(-INFINITY, kSaturate).raw(), TypeParam::kMin);
}

TYPED_TEST(FixedNumbers, DivisionByZeroIsMarkedAndSaturates) {
    const TypeParam zero, two(2), minus(-2);
    EXPECT_EQ((two / zero).raw(), TypeParam::kMax);
    EXPECT_EQ((minus / zero).raw(), TypeParam::kMin);
    EXPECT_EQ((zero / zero).raw(), 0);
    for (const TypeParam& x : {two / zero, minus / zero, zero / zero}) EXPECT_TRUE(x.overflowed());
}

TYPED_TEST(FixedNumbers, RoundAsTheirRealValuesDo) {
    for (std::int64_t raw = -1500; raw <= 1500; ++raw) {
        const std::int64_t scaled = raw << (TypeParam::kFractionBits - 8);
        const TypeParam x = TypeParam::from_raw(scaled, false, kMark);
        const double real = static_cast<double>(raw) / 256;
        ASSERT_EQ(floor(x), static_cast<Integer>(std::floor(real)));
        ASSERT_EQ(ceil(x), static_cast<Integer>(std::ceil(real)));
        ASSERT_EQ(trunc(x), static_cast<Integer>(std::trunc(real)));
        ASSERT_EQ(round_even(x), static_cast<Integer>(std::nearbyint(real)));
        ASSERT_EQ(approximate(x), real);
    }
}

TYPED_TEST(FixedNumbers, WholeNumbersMixInOnEitherSide) {
    const TypeParam x = TypeParam::from(2.5, kMark);
    EXPECT_EQ(approximate(3 + x), 5.5);
    EXPECT_EQ(approximate(x - 3), -0.5);
    EXPECT_EQ(approximate(3 * x), 7.5);
    EXPECT_EQ(approximate(5 / x), 2);
    EXPECT_TRUE(x < 3 && x > 2 && x == x && !(x == 2));
}

}  // namespace
}  // namespace texelscope
