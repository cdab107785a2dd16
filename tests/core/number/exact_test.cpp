// Exact against the rationals of GMP, on random expressions.
#include "core/number/exact.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <random>

namespace texelscope {
namespace {

struct Pair {
    Exact exact;
    mpq_class rational;
};

/// Floats of every size, and small whole ones, which meet each other more often.
Pair random_float(std::mt19937& random) {
    const auto small = static_cast<double>(static_cast<int>(random() % 9) - 4);
    const double any = std::ldexp(static_cast<double>(random()) - 2147483648.0, static_cast<int>(random() % 80) - 60);
    const double x = random() % 2 == 0 ? small : static_cast<double>(static_cast<float>(any));
    return {Exact::from(x), mpq_class(x)};
}

std::string text(const Exact& x) { return x.value().str(); }

Integer whole(const mpq_class& x, int direction) {
    mpz_class result;
    if (direction < 0)
        mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    else
        mpz_cdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    const mpz_class end("4000000000000000000");
    if (result > end) result = end;
    if (result < -end) result = -end;
    return result.get_si();
}

void expect_same(const Pair& p) {
    ASSERT_FALSE(p.exact.is_undefined());
    ASSERT_EQ(text(p.exact), p.rational.get_str());
    ASSERT_EQ(floor(p.exact), whole(p.rational, -1));
    ASSERT_EQ(ceil(p.exact), whole(p.rational, 1));
    ASSERT_EQ(trunc(p.exact), whole(p.rational, sgn(p.rational) < 0 ? 1 : -1));
}

TEST(Exact, IsTheSameRationalAsAnotherLibrarys) {
    std::mt19937 random(1);
    for (int n = 0; n < 4000; ++n) {
        Pair sum = random_float(random);
        for (int k = 0; k < 6; ++k) {
            const Pair next = random_float(random);
            switch (random() % 5) {
                case 0: sum = {sum.exact + next.exact, sum.rational + next.rational}; break;
                case 1: sum = {sum.exact - next.exact, sum.rational - next.rational}; break;
                case 2: sum = {sum.exact * next.exact, sum.rational * next.rational}; break;
                case 3: sum = {-sum.exact, -sum.rational}; break;
                default:
                    if (sgn(next.rational) == 0) continue;
                    sum = {sum.exact / next.exact, sum.rational / next.rational};
            }
            ASSERT_EQ(sum.exact < next.exact, sum.rational < next.rational);
            ASSERT_EQ(sum.exact <= next.exact, sum.rational <= next.rational);
            ASSERT_EQ(sum.exact == next.exact, sum.rational == next.rational);
            ASSERT_EQ(text(lesser(sum.exact, next.exact)),
                      mpq_class(sum.rational < next.rational ? sum.rational : next.rational).get_str());
        }
        expect_same(sum);
        if (HasFatalFailure()) return;
    }
}

TEST(Exact, RoundsHalvesToEven) {
    for (int n = -9; n <= 9; ++n) {
        EXPECT_EQ(round_even(Exact(Integer{n}) / 2), static_cast<Integer>(std::nearbyint(n / 2.0))) << n;
        EXPECT_EQ(round_even(Exact(Integer{n}) / 3), static_cast<Integer>(std::nearbyint(n / 3.0))) << n;
    }
}

TEST(Exact, TakesEveryDoubleAsItIs) {
    for (const double x : {0.1, -0.1, 1e-310, 5e-324, 1.7976931348623157e308, -3.0, 0.0}) {
        EXPECT_EQ(text(Exact::from(x)), mpq_class(x).get_str()) << x;
        EXPECT_EQ(approximate(Exact::from(x)), x);
    }
}

TEST(Exact, WithoutAValueEveryComparisonIsFalse) {
    const Exact none = Exact(1) / Exact(0), one(1);
    for (const Exact& x :
         {none, Exact::from(NAN), Exact::from(INFINITY), none + one, one - none, none * one, one / none, -none}) {
        EXPECT_TRUE(x.is_undefined());
        EXPECT_FALSE(x < one || x > one || x <= one || x >= one || x == one || x == x);
        EXPECT_EQ(floor(x), 0);
        EXPECT_TRUE(std::isnan(approximate(x)));
    }
}

}  // namespace
}  // namespace texelscope
