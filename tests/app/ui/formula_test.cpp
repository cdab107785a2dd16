#include "app/ui/formula.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "app/ui/text.h"
#include "tests/app/ui/screen.h"

namespace texelscope::ui {
namespace {

MathSetting setting(MathSize size = MathSize::row) { return {&test_fonts(), size, false, false}; }
MathBox box(const Expr& e) { return set_math(e, setting()); }

const MathText& piece(const MathBox& b, std::string_view text, std::size_t nth = 0) {
    for (const MathText& t : b.texts)
        if (t.text == text && nth-- == 0) return t;
    ADD_FAILURE() << "no " << text;
    return b.texts.front();
}

float middle(const MathText& t) { return t.at.x + text_width(*t.font, t.text) / 2; }

TEST(Formula, AFractionIsWiderAndTallerThanItsParts) {
    const MathBox above = box(symbol("u_x")), below = box(number(-446.875)),
                  whole = box(quotient(symbol("u_x"), number(-446.875)));
    EXPECT_GT(whole.width, std::max(above.width, below.width));
    EXPECT_GT(whole.height(), above.height() + below.height());
    EXPECT_GT(whole.ascent, above.height());
    EXPECT_GT(whole.descent, below.height() - test_fonts().math(MathSize::row, MathStyle::upright).em / 2);
}

TEST(Formula, AFractionsBarIsAsWideAsTheFractionAndBetweenItsParts) {
    const MathBox whole = box(quotient(number(1), number(26.25)));
    ASSERT_EQ(whole.inks.size(), 1U);
    EXPECT_FLOAT_EQ(whole.inks[0].area.w, whole.width);
    EXPECT_LT(piece(whole, "1").at.y, whole.inks[0].area.y);
    EXPECT_GT(piece(whole, "26.25").at.y, whole.inks[0].area.bottom());
}

TEST(Formula, ASubscriptIsSmallerAndLower) {
    const MathBox b = box(symbol("u_x"));
    const MathText &base = piece(b, "u"), &sub = piece(b, "x");
    EXPECT_LT(sub.font->em, base.font->em);
    EXPECT_GT(sub.at.y, base.at.y);
    EXPECT_TRUE(sub.subscript);
    EXPECT_EQ(sub.role, Role::u);
}

TEST(Formula, NamesOfThingsStandUprightAndIndicesLean) {
    const Fonts& f = test_fonts();
    EXPECT_EQ(piece(box(symbol("E_A")), "A").font, &f.math(MathSize::row, MathStyle::sub_upright));
    EXPECT_EQ(piece(box(symbol("y_end")), "end").font, &f.math(MathSize::row, MathStyle::sub_upright));
    EXPECT_EQ(piece(box(symbol("u_x")), "x").font, &f.math(MathSize::row, MathStyle::sub_italic));
    EXPECT_EQ(piece(box(symbol("P_1")), "1").font, &f.math(MathSize::row, MathStyle::sub_upright));
}

TEST(Formula, OnlyASecondNegativeNumberStandsInParentheses) {
    const auto count = [](const MathBox& b) {
        return std::count_if(b.texts.begin(), b.texts.end(), [](const MathText& t) { return t.text == "("; });
    };
    EXPECT_EQ(count(box(sum({number(-1), number(2)}))), 0);
    EXPECT_EQ(count(box(sum({number(1), number(-2)}))), 1);
    EXPECT_EQ(count(box(product({number(3), number(-2)}))), 1);
    EXPECT_EQ(count(box(difference(number(3), number(-2)))), 1);
    MathSetting folded = setting();
    folded.fold_signs = true;
    const MathBox b = set_math(sum({number(1), number(-2)}), folded);
    EXPECT_EQ(count(b), 0);
    EXPECT_EQ(piece(b, kMinus).text, kMinus);
}

TEST(Formula, ASumInAProductStandsInParentheses) {
    EXPECT_EQ(piece(box(product({sum({symbol("a"), symbol("b")}), symbol("c")})), "(").text, "(");
}

TEST(Formula, ParenthesesGrowWithTheirContent) {
    const MathBox low = box(call("", {symbol("a")})), tall = box(call("", {quotient(symbol("a"), symbol("b"))}));
    EXPECT_TRUE(low.inks.empty());
    const MathBox inner = box(quotient(symbol("a"), symbol("b")));
    const auto left = std::find_if(tall.inks.begin(), tall.inks.end(),
                                   [](const MathInk& i) { return i.shape == MathShape::left_parenthesis; });
    ASSERT_NE(left, tall.inks.end());
    EXPECT_GE(left->area.h, inner.height());
}

TEST(Formula, ADeterminantsColumnsAreCentredAndItsBarsAsTallAsItsRows) {
    const MathBox b = box(determinant(2, {number(7.75), number(-18.5), number(26.25), number(-5)}));
    EXPECT_NEAR(middle(piece(b, "7.75")), middle(piece(b, "26.25")), 0.01);
    EXPECT_NEAR(middle(piece(b, "−18.5")), middle(piece(b, "−5")), 0.01);
    ASSERT_EQ(b.inks.size(), 2U);
    EXPECT_FLOAT_EQ(b.inks[0].area.h, b.height());
    EXPECT_FLOAT_EQ(b.inks[1].area.right(), b.width);
}

TEST(Formula, TheSameFiguresTakeTheSameRoom) {
    for (const double value : {1111.5, 2345.5, 8080.5}) {
        EXPECT_FLOAT_EQ(box(number(value)).width, box(number(7777.5)).width);
        EXPECT_FLOAT_EQ(box(number(value)).height(), box(number(7777.5)).height());
    }
}

TEST(Formula, EveryLinkKeepsItsRectangleInsideTheBox) {
    const MathBox b = box(relation(linked(symbol("u"), 1), "=",
                                   quotient(linked(number(4), 2), sum({linked(symbol("x_1"), 3), number(-1)}))));
    ASSERT_EQ(b.links.size(), 3U);
    const Area whole{0, -b.ascent, b.width, b.height()};
    for (const MathLink& link : b.links) EXPECT_TRUE(whole.covers(link.area, 0.01F)) << link.id;
    for (const MathLink& x : b.links)
        for (const MathLink& y : b.links) EXPECT_EQ(x.id != y.id, intersection(x.area, y.area).empty());
}

Expr plane(bool numbers) {
    const auto of = [&](const char* name, double value) { return numbers ? number(value) : symbol(name); };
    Expr left = of("u", 7.8842);
    if (!numbers) left = marked(std::move(left));
    return relation(std::move(left), numbers ? "≈" : "=",
                    sum({product({of("u_x", .5348), of("X", 16.5)}), product({of("u_y", .0078), of("Y", 11.5)}),
                         of("u_k", -1.0305)}));
}

TEST(Substitution, NumbersStandCentredUnderTheirSymbols) {
    const MathBox b = set_substitution(plane(false), plane(true), setting(MathSize::display));
    EXPECT_NEAR(middle(piece(b, "X")), middle(piece(b, "16.5")), 0.01);
    EXPECT_NEAR(middle(piece(b, "Y")), middle(piece(b, "11.5")), 0.01);
    EXPECT_NEAR(middle(piece(b, "=")), middle(piece(b, "≈")), 0.01);
    EXPECT_GT(piece(b, "16.5").at.y, piece(b, "X").at.y);
    EXPECT_EQ(piece(b, "≈").role, Role::muted);
}

TEST(Substitution, TheMarkHoldsTheResultInBothRows) {
    const MathBox b = set_substitution(plane(false), plane(true), setting(MathSize::display));
    EXPECT_TRUE(piece(b, "u").on_mark);
    EXPECT_TRUE(piece(b, "7.8842").on_mark);
    EXPECT_FALSE(piece(b, "X").on_mark);
    ASSERT_FALSE(b.inks.empty());
    EXPECT_EQ(b.inks.front().shape, MathShape::mark);
}

TEST(Substitution, NumbersDoNotTouch) {
    const MathBox b = set_substitution(plane(false), plane(true), setting());
    for (const MathText& x : b.texts)
        for (const MathText& y : b.texts) {
            if (&x == &y || x.at.y != y.at.y || x.at.x > y.at.x) continue;
            EXPECT_LE(x.at.x + text_width(*x.font, x.text), y.at.x + 0.01F) << x.text << ' ' << y.text;
        }
}

TEST(Formula, BrokenLinesKeepToTheWidthAndAlignTheirSigns) {
    const Expr long_number = number(123456.7);
    const Expr e = relation_chain({symbol("u"), long_number, long_number, long_number}, {"=", "=", "≈"});
    const float whole = box(e).width;
    const MathBox broken = set_math_broken(e, setting(), whole * .6F);
    EXPECT_LE(broken.width, whole * .6F);
    EXPECT_FLOAT_EQ(piece(broken, "=", 0).at.x, piece(broken, "=", 1).at.x);
    EXPECT_NE(piece(broken, "=", 0).at.y, piece(broken, "=", 1).at.y);
    EXPECT_FLOAT_EQ(set_math_broken(e, setting(), whole).width, whole);
}

TEST(Formula, FittingTakesTheFirstSizeThatFits) {
    const std::array sizes{MathSize::display, MathSize::row, MathSize::note};
    const Expr e = plane(false);
    EXPECT_FLOAT_EQ(set_math_to_fit(e, setting(), 1e6F, sizes).width, set_math(e, setting(MathSize::display)).width);
    EXPECT_FLOAT_EQ(set_math_to_fit(e, setting(), 0, sizes).width, set_math(e, setting(MathSize::note)).width);
}

TEST(Formula, PresentingSubscriptsAreEighteenAndTextTwentyFour) {
    for (std::size_t s = 0; s < kMathSizeCount; ++s) {
        EXPECT_GE(math_px(static_cast<MathSize>(s), {1, true}), 24);
        EXPECT_GE(subscript_px(static_cast<MathSize>(s), {1, true}), 18);
    }
    for (std::size_t f = 0; f < kFaceCount; ++f) EXPECT_GE(face_px(static_cast<Face>(f), {1, true}), 24);
}

}  // namespace
}  // namespace texelscope::ui
