#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/lesson/lesson.h"

namespace texelscope::parse_test {
namespace {

constexpr std::string_view kFile = "lessons/05-small/lesson.md";

constexpr std::string_view kSmall = R"(+++
title = "Small"
group = "Triangles"
summary = "Two sentences. They say $u_x$."
method = "edge-equations"
views = ["texels", "formula", "code"]
quirks = ["inclusive"]
+++

## The first sentence.

Prose with $E_A \le 0$, **strong** words and `code`.

```set
step = "t0/s5/y11/x16"
level = "pixel"
number = "f32"
quirks = { inclusive = true }
pin = "line quirk.inclusive"
hits = true
against = "sections as-printed f32"
```

## The second one.

```predict
ask = "Which pixel?"
kind = "pixel"
answer = "pixel-of-byte 137"
```
)";

[[nodiscard]] std::string changed(std::string_view from, std::string_view to) {
    std::string text(kSmall);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

constexpr std::array<std::string_view, 2> kViews{"code", "formula"};

TEST(ParseLesson, EveryFieldIsRead) {
    const auto lesson = parse_lesson(kSmall, kFile);
    ASSERT_TRUE(lesson) << lesson.error().text();
    EXPECT_EQ(lesson->id, "05-small");
    EXPECT_EQ(lesson->number, 5);
    EXPECT_EQ(lesson->title, "Small");
    EXPECT_EQ(lesson->variant, "corrected");
    EXPECT_EQ(lesson->format, "f64");
    EXPECT_EQ(lesson->scene, "scene.json");
    EXPECT_EQ(lesson->levels, "TGSPE");
    EXPECT_EQ(lesson->drag, "vertices");
    ASSERT_EQ(lesson->beats.size(), 2U);
    const Beat& first = lesson->beats[0];
    EXPECT_EQ(first.lead, "The first sentence.");
    EXPECT_EQ(first.prose, "Prose with $E_A \\le 0$, **strong** words and `code`.");
    EXPECT_EQ(first.line, 10);
    ASSERT_TRUE(first.set.step);
    EXPECT_EQ(first.set.step->text(), "t0/s5/y11/x16");
    EXPECT_EQ(first.set.level, Level::pixel);
    EXPECT_EQ(first.set.number, "f32");
    ASSERT_EQ(first.set.quirks.size(), 1U);
    EXPECT_EQ(first.set.quirks[0], std::pair(std::string("inclusive"), true));
    EXPECT_EQ(first.set.hits, true);
    EXPECT_EQ(first.set.against, "sections as-printed f32");
    EXPECT_FALSE(first.prediction);
    ASSERT_TRUE(lesson->beats[1].prediction);
    EXPECT_EQ(lesson->beats[1].prediction->kind, Prediction::Kind::pixel);
    EXPECT_EQ(lesson->beats[1].prediction->explain, "auto");
    EXPECT_EQ(lesson->beats[1].prediction->lines.block, 26);
}

TEST(ParseLesson, PrintedTextIsTheSameLesson) {
    const auto lesson = parse_lesson(kSmall, kFile);
    ASSERT_TRUE(lesson) << lesson.error().text();
    const std::string printed = print_lesson(*lesson);
    const auto again = parse_lesson(printed, kFile);
    ASSERT_TRUE(again) << again.error().text() << '\n' << printed;
    EXPECT_EQ(print_lesson(*again), printed);
    EXPECT_EQ(again->beats[0].prose, lesson->beats[0].prose);
}

TEST(ParseLesson, RandomTrianglesSurvivePrinting) {
    const auto lesson = parse_lesson(changed("hits = true", "random = \"300 62.5 7\""), kFile);
    ASSERT_TRUE(lesson) << lesson.error().text();
    EXPECT_EQ(lesson->beats[0].set.random, (RandomTriangles{300, 62.5F, 7}));
    const auto again = parse_lesson(print_lesson(*lesson), kFile);
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->beats[0].set.random, lesson->beats[0].set.random);
}

TEST(ParseLesson, LettersThatLookLikeMarkdownSurvivePrinting) {
    const auto lesson = parse_lesson(changed("Prose with", R"(1\. \_a\_ \[b\] \<c> 3 \$ \* 4 \# \& \~~ end)"), kFile);
    ASSERT_TRUE(lesson) << lesson.error().text();
    const auto again = parse_lesson(print_lesson(*lesson), kFile);
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->beats[0].prose, lesson->beats[0].prose);
}

TEST(ParseLesson, ParagraphsStayApart) {
    const auto lesson = parse_lesson(changed("Prose with", "One.\n\n1. Two\nmore, with"), kFile);
    ASSERT_FALSE(lesson);
    const auto plain = parse_lesson(changed("Prose with", "One.\n\nTwo\nmore, with"), kFile);
    ASSERT_TRUE(plain) << plain.error().text();
    EXPECT_EQ(plain->beats[0].prose.substr(0, 20), "One.\n\nTwo more, with");
    const auto again = parse_lesson(print_lesson(*plain), kFile);
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->beats[0].prose, plain->beats[0].prose);
}

TEST(ParseLesson, ABeatMayChangeTheMethodAndWithItTheWords) {
    const std::string text =
        changed("```predict", "```set\nmethod = \"sections\"\nquirks = { ghost = true }\n```\n\n```predict");
    const auto lesson = parse_lesson(text, kFile);
    ASSERT_TRUE(lesson) << lesson.error().text();
    EXPECT_EQ(lesson->beats[1].set.method, "sections");
    const auto again = parse_lesson(print_lesson(*lesson), kFile);
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->beats[1].set.method, "sections");
}

TEST(ParseLesson, AMethodBehindItsPredictionOrOfAnotherNameIsAFault) {
    const auto behind = parse_lesson(std::string(kSmall) + "\n```set\nmethod = \"sections\"\n```\n", kFile);
    ASSERT_FALSE(behind);
    EXPECT_NE(behind.error().what.find("behind the predict block"), std::string::npos) << behind.error().text();
    const auto unknown = parse_lesson(changed("level = \"pixel\"", "method = \"magic\""), kFile);
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().what.find("expected"), std::string::npos) << unknown.error().text();
}

TEST(ParseLesson, LineEndsAndByteOrderMarkMakeNoDifference) {
    std::string text = "\xEF\xBB\xBF";
    for (const char c : kSmall) text += c == '\n' ? "\r\n" : std::string(1, c);
    const auto plain = parse_lesson(kSmall, kFile), other = parse_lesson(text, kFile);
    ASSERT_TRUE(plain);
    ASSERT_TRUE(other) << other.error().text();
    EXPECT_EQ(print_lesson(*plain), print_lesson(*other));
}

TEST(ParseLesson, FoldersWithoutANumberHaveNone) {
    const auto lesson = parse_lesson(kSmall, "mine/lesson.md");
    ASSERT_TRUE(lesson);
    EXPECT_EQ(lesson->id, "mine");
    EXPECT_EQ(lesson->number, 0);
}

struct Fault {
    const char* name;
    std::string_view from, to;
    int line;
    std::string_view says;
};
/// Else the names of tests hold addresses.
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

const std::vector<Fault> kFaults{
    {"NoFrontMatter", "+++\ntitle", "title", 1, "+++"},
    {"OpenFrontMatter", "\"inclusive\"]\n+++", "\"inclusive\"]", 1, "no end"},
    {"BrokenToml", "title = \"Small\"", "title = ", 2, ""},
    {"MissingTitle", "title = \"Small\"\n", "", 1, "'title'"},
    {"UnknownKey", "group =", "colour = \"red\"\ngroup =", 3, "'colour'"},
    {"WrongType", "\"Triangles\"", "true", 3, "text"},
    {"NumberForText", "\"Triangles\"", "7", 3, "text"},
    {"LongTitle", "\"Small\"", "\"Smaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaall\"", 2, "40"},
    {"LineBreakInTitle", "\"Small\"", "\"Sm\\nall\"", 2, "line"},
    {"BadMathInSummary", "$u_x$", "$u_$", 4, "mathematics"},
    {"UnknownMethod", "\"edge-equations\"", "\"magic\"", 5, "sections"},
    {"UnknownView", "\"texels\"", "\"te xels\"", 6, "view"},
    {"NoViews", "[\"texels\", \"formula\", \"code\"]", "[]", 6, "1 to 3"},
    {"UnknownQuirkOffered", "[\"inclusive\"]", "[\"elusive\"]", 7, "inclusive"},
    {"UnknownVariant", "quirks = [", "variant = \"wrong\"\nquirks = [", 7, "as-printed"},
    {"UnknownLevels", "quirks = [", "levels = \"PT\"\nquirks = [", 7, "TGSPE"},
    {"UnknownDrag", "quirks = [", "drag = \"all\"\nquirks = [", 7, "vertices"},
    {"SceneElsewhere", "quirks = [", "scene = \"../a.json\"\nquirks = [", 7, "beside"},
    {"TextBeforeBeats", "## The first", "The zeroth\n\n## The first", 10, "before the first beat"},
    {"LongLead", "The first sentence.", "The first sentence is so long that it cannot stand on one line of its panel.",
     10, "56"},
    {"OtherHeading", "## The first", "# The first", 10, "##"},
    {"EmptyHeading", "## The first sentence.", "##", 10, "empty"},
    {"BadMath", "$E_A \\le 0$", "$E_A \\leq$", 12, "mathematics"},
    {"Emphasis", "**strong**", "*weak*", 12, "**strong**"},
    {"Link", "**strong**", "[a](b)", 12, "link"},
    {"List", "Prose with", "- Prose with", 12, "list"},
    {"Quotation", "Prose with", "> Prose with", 12, "quotation"},
    {"Entity", "Prose with", "Prose &amp;", 12, "character"},
    {"LongProse", "Prose with",
     "Prose that goes on and on and on and on and on and on and on and on and on and on and on and on and on and on "
     "and on",
     12, "130"},
    {"UnknownBlock", "```set", "```sett", 14, "set or predict"},
    {"BadPath", "t0/s5/y11/x16", "t0/5", 15, "path"},
    {"PathWithoutStage", "t0/s5/y11/x16", "t0/y11", 15, "a stage (/s0) must stand behind t0"},
    {"PathWithoutQuotes", "\"t0/s5/y11/x16\"", "t0", 15, "a text needs quotes"},
    {"LoneDollar", "Prose with $E_A \\le 0$", "It costs $5 or \\$6", 12, "a $ without its partner"},
    {"LoneStar", "Prose with", "Prose * with", 12, "a * without its partner"},
    {"LoneDollarInSummary", "They say $u_x$.", "They cost $5.", 4, "a $ without its partner"},
    {"ViewTwice", "\"texels\", \"formula\"", "\"code\", \"formula\"", 6, "has 'code' twice"},
    {"UnknownIcon", "group =", "icon = \"small\"\ngroup =", 3, "expected array"},
    {"UnknownLevel", "level = \"pixel\"", "level = \"atom\"", 16, "expression"},
    {"UnknownNumber", "\"f32\"", "\"f16\"", 17, "f64"},
    {"UnknownQuirk", "{ inclusive = true }", "{ inklusive = true }", 18, "inclusive"},
    {"QuirkWithoutState", "{ inclusive = true }", "{ inclusive = 1 }", 18, "switches"},
    {"PinOnNothing", "line quirk.inclusive", "line quirk.nothing", 19, "nowhere"},
    {"PinOfNoKind", "\"line quirk.inclusive\"", "\"pixels 1,2\"", 19, "pixel X,Y"},
    {"PinWithoutPlace", "\"line quirk.inclusive\"", "\"pixel 1\"", 19, "pixel X,Y"},
    {"RandomOfTwoNumbers", "hits = true", "random = \"300 60\"", 20, "TRIANGLES SIZE SEED"},
    {"RandomOfFour", "hits = true", "random = \"300 60 1 2\"", 20, "TRIANGLES SIZE SEED"},
    {"RandomTooMany", "hits = true", "random = \"10001 60 1\"", 20, "1 to 10000"},
    {"RandomHalfATriangle", "hits = true", "random = \"2.5 60 1\"", 20, "whole numbers"},
    {"RandomOfNoSize", "hits = true", "random = \"3 0 1\"", 20, "pixels"},
    {"HitsNoTruth", "hits = true", "hits = \"yes\"", 20, "true or false"},
    {"UnknownSetKey", "hits = true", "hints = true", 20, "'hints'"},
    {"AgainstNoMethod", "sections as-printed f32", "section", 21, "the id of a method"},
    {"AgainstNoVariant", "sections as-printed f32", "sections as-published", 21, "variant"},
    {"TwoSets", "## The second one.", "```set\n```\n\n## The second one.", 24, "second set"},
    {"MissingAsk", "ask = \"Which pixel?\"\n", "", 26, "'ask'"},
    {"MissingKind", "kind = \"pixel\"\nanswer", "answer", 26, "'kind'"},
    {"UnknownKind", "kind = \"pixel\"", "kind = \"pixels\"", 28, "texel"},
    {"OtherKind", "kind = \"pixel\"", "kind = \"number\"", 28, "'pixel'"},
    {"UnknownQuestion", "pixel-of-byte 137", "meaning-of-life", 29, "doubles"},
    {"MissingArgument", "pixel-of-byte 137", "pixel-of-byte", 29, "N"},
    {"BadArgument", "pixel-of-byte 137", "pixel-of-byte x", 29, "number"},
    {"TooManyArguments", "pixel-of-byte 137", "pixel-of-byte 1 2", 29, "no '2'"},
    {"QuestionOfOtherMethod", "pixel-of-byte 137", "sections", 29, "lesson's method"},
    {"OptionsTooMany", "kind = \"pixel\"", "kind = \"pixel\"\noptions = [\"a\"]", 29, "options"},
    {"BadExplain", "kind = \"pixel\"", "kind = \"pixel\"\nexplain = \"here\"", 29, "auto"},
    {"BrokenTomlInBlock", "kind = \"pixel\"", "kind = pixel", 28, "a text needs quotes"},
};

class LessonFault : public testing::TestWithParam<Fault> {};

TEST_P(LessonFault, NamesItsLineAndWhatWasExpected) {
    const Fault& fault = GetParam();
    const auto lesson = parse_lesson(changed(fault.from, fault.to), kFile);
    ASSERT_FALSE(lesson);
    EXPECT_EQ(lesson.error().where, std::string(kFile) + ":" + std::to_string(fault.line)) << lesson.error().what;
    EXPECT_NE(lesson.error().what.find(fault.says), std::string::npos) << lesson.error().what;
    EXPECT_EQ(lesson.error().text().find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(ParseLesson, LessonFault, testing::ValuesIn(kFaults),
                         [](const auto& fault) { return fault.param.name; });

TEST(ParseLesson, ViewsAreAmongThoseGiven) {
    const auto lesson = parse_lesson(kSmall, kFile, kViews);
    ASSERT_FALSE(lesson);
    EXPECT_EQ(lesson.error().text(), std::string(kFile) + ":6: views has 'texels', expected code or formula");
    EXPECT_TRUE(parse_lesson(changed("\"texels\", ", ""), kFile, kViews));
}

TEST(ParseLesson, ALessonWithoutBeatsIsAnError) {
    const std::string_view front = kSmall.substr(0, kSmall.find("## The first"));
    const auto lesson = parse_lesson(front, kFile);
    ASSERT_FALSE(lesson);
    EXPECT_NE(lesson.error().what.find("no beats"), std::string::npos);
}

TEST(ParseLesson, WhatIsNoTextIsNamedWithItsLine) {
    const auto lesson = parse_lesson(changed("Prose with", "Prose \xFF with"), kFile);
    ASSERT_FALSE(lesson);
    EXPECT_EQ(lesson.error().where, std::string(kFile) + ":12");
    EXPECT_FALSE(parse_lesson(std::string(kMaxLessonBytes + 1, ' '), kFile));
}

TEST(ParseLesson, BeatsAreBounded) {
    std::string text(kSmall);
    for (int n = 0; n < kMaxBeats; ++n) text += "\n## Another one.\n";
    const auto lesson = parse_lesson(text, kFile);
    ASSERT_FALSE(lesson);
    EXPECT_NE(lesson.error().what.find("64 beats"), std::string::npos) << lesson.error().what;
}

TEST(LoadLessons, AFolderWithoutLessonsHasNoneAndAMissingOneIsNamed) {
    std::vector<Error> errors;
    EXPECT_TRUE(load_lessons(std::string(TEXELSCOPE_SOURCE_DIR) + "/cmake", errors).empty());
    EXPECT_TRUE(errors.empty());
    EXPECT_TRUE(load_lessons("/no/such/folder", errors).empty());
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].where, "/no/such/folder");
}

}  // namespace
}  // namespace texelscope::parse_test
