#include "app/ui/math.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace texelscope::ui {
namespace {

TEST(Number, EqualsStandsOnlyBesideTheValueItself) {
    EXPECT_EQ(equals_sign(format_number(446.875).exact), "=");
    EXPECT_EQ(equals_sign(format_number(-474.25).exact), "=");
    EXPECT_EQ(equals_sign(format_number(0.0625).exact), "=");
    EXPECT_EQ(equals_sign(format_number(0.03125).exact), "≈");
    EXPECT_EQ(equals_sign(format_number(0.1).exact), "≈");
    EXPECT_EQ(equals_sign(format_number(1.0 / 3).exact), "≈");
}

TEST(Number, ExactTextReadsBackAsTheValue) {
    for (int i = -4000; i <= 4000; ++i) {
        const double value = i / 16.0;
        const Number n = format_number(value);
        ASSERT_TRUE(n.exact) << value;
        const bool minus = n.text.rfind(kMinus, 0) == 0;
        const double magnitude = std::stod(minus ? n.text.substr(kMinus.size()) : n.text);
        EXPECT_EQ(minus ? -magnitude : magnitude, value);
        EXPECT_EQ(n.negative, value < 0);
    }
}

TEST(Number, RoundedTextHasFourDecimalsAndLiesWithinHalfAUnit) {
    for (int i = 1; i < 2000; ++i) {
        const double value = i / 7.0 + 1e-3;
        const Number n = format_number(value);
        if (n.exact) continue;
        EXPECT_EQ(n.text.size() - n.text.find('.') - 1, 4U) << n.text;
        EXPECT_NEAR(std::stod(n.text), value, 0.5e-4 + 1e-12);
    }
}

TEST(Number, MinusIsNoHyphen) {
    EXPECT_EQ(format_number(-18.5).text, "−18.5");
    EXPECT_EQ(format_full(-0.1), "−0.1");
    EXPECT_EQ(format_number(-18.5).text.find('-'), std::string::npos);
}

TEST(Number, ZeroHasNoSign) { EXPECT_EQ(format_number(-0.0).text, "0"); }

TEST(Number, TinyAndHugeValuesKeepTheirFigures) {
    EXPECT_EQ(format_number(std::ldexp(1, -15)).text, "3.0518·10⁻⁵");
    EXPECT_EQ(format_number(-1.5e12).text, "−1.5000·10¹²");
    EXPECT_FALSE(format_number(std::ldexp(1, -15)).exact);
}

TEST(Number, NotANumberAndInfinityHaveNames) {
    EXPECT_EQ(format_number(std::numeric_limits<double>::quiet_NaN()).text, "NaN");
    EXPECT_EQ(format_number(-std::numeric_limits<double>::infinity()).text, "−∞");
}

TEST(Symbol, NamesCarryTheirRole) {
    EXPECT_EQ(symbol("u_x").role, Role::u);
    EXPECT_EQ(symbol("v").role, Role::v);
    EXPECT_EQ(symbol("E_A").role, Role::text);
    EXPECT_EQ(symbol("n_{A,x}").sub, "A,x");
}

TEST(MathParser, ReadsWhatLessonsWrite) {
    for (const char* text : {"u_x", "E_A", "\\Delta", "1/z", "u/z", "u = u_x X + u_y Y + u_k", "n_{A,x}", "y_end = 19",
                             "\\frac{y_1 - y_0}{x_1 - x_0}", "\\floor{u} & 15 = 7", "k = -(x_1 n_x + y_1 n_y)",
                             "E_B > 0", "x_l = round(5.667)", "a \\le b", "2 \\cdot 3", "Δ"})
        EXPECT_TRUE(parse_math(text)) << text;
}

TEST(MathParser, BindsProductsCloserThanSums) {
    const auto e = parse_math("a + b c - d");
    ASSERT_TRUE(e);
    EXPECT_EQ(e->op, Op::sum);
    ASSERT_EQ(e->parts.size(), 3U);
    EXPECT_EQ(e->parts[1].op, Op::product);
    EXPECT_EQ(e->parts[2].op, Op::negation);
}

TEST(MathParser, SaysWhereItFailed) {
    for (const char* text : {"", "u_", "(a", "a +", "\\nonsense", "a $ b", "\\frac{a}", "f(a,)"}) {
        const auto e = parse_math(text);
        ASSERT_FALSE(e) << text;
        EXPECT_EQ(e.error().where.rfind("character ", 0), 0U) << text;
    }
}

TEST(MathParser, RefusesDepthAndLengthWithoutBound) {
    EXPECT_FALSE(parse_math(std::string(100, '(') + "a" + std::string(100, ')')));
    EXPECT_FALSE(parse_math(std::string(100'000, 'a')));
}

}  // namespace
}  // namespace texelscope::ui
