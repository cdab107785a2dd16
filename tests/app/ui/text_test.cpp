#include "app/ui/text.h"

#include <gtest/gtest.h>

#include "app/ui/prose.h"
#include "app/ui/sfnt.h"
#include "tests/app/ui/screen.h"

namespace texelscope::ui {
namespace {

TEST(Utf8, BadBytesAreReplacedOneByOne) {
    const std::string text = "a\xFF\xC3(\xE2\x82";
    std::size_t at = 0, count = 0;
    while (at < text.size()) {
        const std::size_t before = at;
        static_cast<void>(next_code_point(text, at));
        ASSERT_GT(at, before);
        ++count;
    }
    EXPECT_EQ(count, 6U);
}

TEST(Utf8, EveryCodePointIsReadBack) {
    std::size_t at = 0;
    EXPECT_EQ(next_code_point("≈", at), U'≈');
    EXPECT_EQ(at, 3U);
    EXPECT_EQ(previous_code_point("a≈", 4), 1U);
}

TEST(Text, ElidedFitsItsWidth) {
    const Font& font = test_fonts().face(Face::prose);
    const std::string text = "Half-planes and the bounding box";
    for (float width = 0; width < 300; width += 7) EXPECT_LE(text_width(font, elided(font, text, width)), width);
    EXPECT_EQ(elided(font, text, 1000), text);
}

TEST(Text, WrappedLinesFitAndLoseNothing) {
    const Font& font = test_fonts().face(Face::prose);
    const std::string text = "One step right adds a gradient; incomprehensibilities break within.";
    for (const float width : {20.0F, 60.0F, 200.0F}) {
        std::string joined;
        for (const std::string_view line : wrapped(font, text, width)) {
            EXPECT_LE(text_width(font, line), width);
            for (const char c : line)
                if (c != ' ') joined += c;
        }
        std::string expected;
        for (const char c : text)
            if (c != ' ') expected += c;
        EXPECT_EQ(joined, expected);
    }
}

TEST(Text, EveryWidthMakesProgress) {
    const Font& font = test_fonts().face(Face::prose);
    EXPECT_EQ(wrapped(font, "abc", 0).size(), 3U);
}

TEST(Fonts, ChangingFiguresDoNotMoveInCode) {
    for (const Face face : {Face::code, Face::code_note, Face::line_number, Face::count, Face::ruler}) {
        const Font& font = test_fonts().face(face);
        EXPECT_FLOAT_EQ(text_width(font, "1111"), text_width(font, "8888"));
        EXPECT_FLOAT_EQ(text_width(font, "−1"), text_width(font, "88"));
    }
}

TEST(Fonts, EveryFaceHasTheCharactersOfTheScreen) {
    const Fonts& fonts = test_fonts();
    for (std::size_t f = 0; f < kFaceCount; ++f)
        for (const char* s : {"−", "×", "≈", "≤", "≥", "→", "←", "↑", "↓", "…", "▶", "✓", "Δ", "é", "ž", "·", "⌊"}) {
            std::size_t at = 0;
            const auto c = static_cast<ImWchar>(next_code_point(s, at));
            EXPECT_NE(fonts.face(static_cast<Face>(f)).im->FindGlyphNoFallback(c), nullptr) << s << " in face " << f;
        }
}

TEST(Fonts, AFileThatIsNoFontIsAnError) {
    const std::vector<unsigned char> bytes(1000, 7);
    EXPECT_FALSE(read_font_metrics(bytes));
    EXPECT_FALSE(read_font_metrics({}));
}

TEST(Prose, MarksAreRead) {
    const auto spans = spans_of("**First.** adds $u_x$ to `u`, costs \\$5 and * stays");
    ASSERT_EQ(spans.size(), 6U);
    EXPECT_EQ(spans[0].kind, Span::Kind::strong);
    EXPECT_EQ(spans[2].kind, Span::Kind::math);
    EXPECT_EQ(spans[2].text, "u_x");
    EXPECT_EQ(spans[4].kind, Span::Kind::code);
    EXPECT_EQ(spans[5].text, ", costs $5 and * stays");
}

TEST(Prose, LinesKeepToTheWidth) {
    const auto spans =
        spans_of("One step right adds $u_x$ to $u$ and $v_x$ to $v$. One step down adds $u_y$ and $v_y$.");
    for (const float width : {80.0F, 150.0F, 300.0F}) {
        const ProseLayout layout = layout_prose(test_fonts(), spans, width);
        for (const ProseItem& item : layout.items) EXPECT_LE(item.at.x + item.width, width + 0.5F);
        EXPECT_GT(layout.height, 0);
    }
}

TEST(Prose, APointAfterAFormulaStaysOnItsLine) {
    const auto spans = spans_of("aaaa $u_x$.");
    const float whole = layout_prose(test_fonts(), spans, 1000).width;
    const ProseLayout narrow = layout_prose(test_fonts(), spans, whole - 1);
    EXPECT_EQ(narrow.lines, 2);
    EXPECT_EQ(narrow.items[1].at.y, narrow.items[2].at.y);
}

TEST(Prose, NarrowerIsNeverLower) {
    const auto spans = spans_of("A sentence of several words, with $\\frac{a}{b}$ in it and `code` behind.");
    float before = 0;
    for (float width = 600; width > 40; width -= 20) {
        const float height = layout_prose(test_fonts(), spans, width).height;
        EXPECT_GE(height, before);
        before = height;
    }
}

TEST(Prose, UnreadableMathematicsStandsAsWritten) {
    const ProseLayout layout = layout_prose(test_fonts(), spans_of("see $a +$"), 1000);
    ASSERT_GE(layout.items.size(), 2U);
    EXPECT_EQ(layout.items[1].text, "a");
}

}  // namespace
}  // namespace texelscope::ui
