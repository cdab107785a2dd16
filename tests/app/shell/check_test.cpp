// What `check` finds, fault by fault, and the lessons of lessons/README.md, which have none.
#include <algorithm>

#include <gtest/gtest.h>

#include "app/shell/check.h"
#include "core/base/file.h"
#include "tests/app/shell/lesson_folder.h"

namespace texelscope::check_test {
namespace {

const std::filesystem::path kRoot = TEXELSCOPE_SOURCE_DIR;

struct Fault {
    const char* name;
    std::string_view from, to;
    int line;
    std::string_view says;
};

const std::vector<Fault> kFaults{
    {"UnknownView", "\"texels\", \"code\"", "\"texel\", \"code\"", 6,
     "has 'texel', expected buffer, bytes, certificate, code,"},
    {"CanvasIsNoSideView", "\"texels\", \"code\"", "\"canvas\", \"code\"", 6, "has 'canvas', expected buffer"},
    {"ViewTwice", "\"texels\", \"code\"", "\"code\", \"code\"", 6, "has 'code' twice"},
    {"ViewOfAnotherMethod", "\"texels\", \"code\"", "\"texels\", \"code\", \"ring\"", 6,
     "'ring', which is for sections"},
    {"ViewOfAnotherMethodInABeat", "pin = \"name u\"", "pin = \"name u\"\nviews = [\"face\"]", 18, "'face', which is"},
    {"ViewWithoutItsSolid", "\"texels\", \"code\"", "\"texels\", \"solids\"", 6, "'solids', which needs a solid"},
    {"ViewWithoutItsFrames", "\"texels\", \"code\"", "\"frames\", \"code\"", 6, "'frames', which needs a texture"},
    {"ViewWithoutItsTriangles", "\"texels\", \"code\"", "\"texels\", \"race\"", 6,
     "'race', which needs random triangles"},
    {"ViewWithoutItsPalette", "\"texels\", \"code\"", "\"palette\", \"code\"", 6, "'palette', which needs a texture"},
    {"RandomWithoutTriangles", "pin = \"name u\"", "random = \"9 9 1\"", 17, "sets random triangles, but the scene"},
    {"ViewOfAnotherMethodThatABeatSets", "pin = \"line quirk.corners\"",
     "method = \"forward\"\nviews = [\"texels\", \"signs\"]", 32,
     "'signs', which is for edge-equations, but the lesson's method here is forward"},
    {"UnknownIcon", "quirks = [", "icon = \"my icon\"\nquirks = [", 8, "icon is 'my icon', expected array, ratio"},
    {"LevelLeftOut", "\"TGPE\"", "\"TSP\"", 16, "level here is 'expression', but levels = \"TSP\" leaves E out"},
    {"LevelOfTheBeatLeftOut", "pin = \"name u\"", "level = \"scanline\"", 17, "level here is 'scanline'"},
    {"NoQuirkPinned", "line quirk.corners", "line s.half", 8, "no beat pins the guilty line of 'corners'"},
    {"NoSuchExpression", "x6/e8", "x6/e99", 16, "no step t0/s5/y5/x6/e99: t0/s5/y5/x6 has e0 to e14"},
    {"NoSuchPixel", "y5/x6/e8", "y5/x60", 16, "t0/s5/y5 has x2 to x14"},
    {"NoSuchStage", "t0/s5/y5/x6/e8", "t0/s6", 16, "t0 has s0 to s5"},
    {"NoSuchShape", "t0/s5/y5/x6/e8", "t1", 16, "the scene has only t0"},
    {"StageLeftOut", "t0/s5/y5/x6/e8", "t0/e12", 16, "a stage (/s0) must stand behind t0"},
    {"NoQuotes", "\"t0/s5/y5/x6/e8\"", "t0", 16, "a text needs quotes"},
    {"PinnedNameUnknown", "name u", "name uu", 17, "no value at this step"},
    {"PinnedPixelOutside", "name u", "pixel 16,0", 17, "expected 0 to 15, 0 to 11"},
    {"PinnedTexelOutside", "name u", "texel -1,0", 17, "expected 0 to 15, 0 to 15"},
    {"PinnedLineUnknown", "name u", "line 99999", 17, "stands nowhere"},
    {"ValueUnknown", "value u 1 0", "value uu", 23, "'value uu' has no answer here. It has no value there."},
    {"ValueOutside", "value u 1 0", "value u 20 0", 23, "'value u 20 0' has no answer here"},
    {"TexelOutside", "texel-of 6 5", "texel-of 60 50", 37, "has no answer here. No texel is read"},
    {"TexelNotDrawn", "texel-of 6 5", "texel-of 1 1", 37, "has no answer here. No texel is read"},
    {"ExplainedNowhere", "explain = \"t0/s1\"", "explain = \"t0/s1/e7\"", 24, "t0/s1 has e0 to e2"},
    {"TexelsNotShown", "[\"texels\", \"code\"]", "[\"formula\", \"code\"]", 36, "expected texels"},
    {"CodeNotShown",
     "pin = \"name u\"\n```\n\n```predict\nask = \"What is it?\"\nkind = \"number\"\nanswer = \"value u 1 0\"",
     "views = [\"texels\"]\n```\n\n```predict\nask = \"Where?\"\nkind = \"line\"\nanswer = \"guilty-line corners\"", 22,
     "expected code"},
    {"LoneDollar", "Prose.", "It costs $5.", 13, "a $ without its partner"},
    {"LoneDollarInAQuestion", "What is it?", "What is $u?", 21, "a $ without its partner"},
    {"NoScene", "quirks = [", "scene = \"foo.json\"\nquirks = [", 8, "scene is 'foo.json', which is not there"},
};

class LessonCheckFault : public testing::TestWithParam<Fault> {};

TEST_P(LessonCheckFault, IsNamedWithItsLine) {
    const Fault& fault = GetParam();
    const LessonFolder folder;
    folder.change(fault.from, fault.to);
    const LessonCheck check = check_lesson(folder.lesson(), false);
    ASSERT_FALSE(check.faults.empty());
    const Error& first = check.faults.front();
    EXPECT_EQ(first.where, folder.lesson().string() + ":" + std::to_string(fault.line)) << first.what;
    EXPECT_NE(first.what.find(fault.says), std::string::npos) << first.what;
}

INSTANTIATE_TEST_SUITE_P(CheckLesson, LessonCheckFault, testing::ValuesIn(kFaults),
                         [](const auto& fault) { return fault.param.name; });

void expect_no_fault(const std::filesystem::path& file, int beats) {
    const LessonCheck check = check_lesson(file);
    for (const Error& fault : check.faults) ADD_FAILURE() << fault.text();
    EXPECT_EQ(check.beats, beats);
    EXPECT_GT(check.screens, 0);
}

TEST(CheckLesson, FindsNothingWhereNothingIsWrong) {
    const LessonFolder folder;
    const LessonCheck check = check_lesson(folder.lesson(), false);
    EXPECT_TRUE(check.faults.empty()) << check.faults.front().text();
    EXPECT_EQ(check.beats, 2);
    EXPECT_EQ(check.predictions, 2);
    EXPECT_EQ(check.screens, 0);
}

TEST(CheckLesson, FaultsNameTheFileAsItWasNamed) {
    const LessonFolder folder;
    folder.change("x6/e8", "x6/e99");
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path);
    const LessonCheck by_file = check_lesson("lesson.md", false), by_folder = check_lesson(".", false);
    folder.change("title =", "titel =");
    const LessonCheck unread = check_lesson("lesson.md", false);
    std::filesystem::current_path(before);
    ASSERT_EQ(by_file.faults.size(), 1U);
    EXPECT_EQ(by_file.faults[0].where, "lesson.md:16");
    ASSERT_EQ(by_folder.faults.size(), 1U);
    EXPECT_EQ(by_folder.faults[0].where, "./lesson.md:16");
    ASSERT_EQ(unread.faults.size(), 1U);
    EXPECT_EQ(unread.faults[0].where.substr(0, 10), "lesson.md:");
}

TEST(CheckLesson, TheExampleHasNoFault) { expect_no_fault(kRoot / "lessons/example/texture-slides/lesson.md", 6); }

/// The indented block of the README that begins behind `heading`.
[[nodiscard]] std::string block_behind(const std::string& text, std::string_view heading, std::string_view first) {
    std::string block;
    for (std::size_t at = text.find(first, text.find(heading)); at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (!line.empty() && line.rfind("    ", 0) != 0) break;
        block += (line.empty() ? line : line.substr(4)) + '\n';
        at = end + 1;
    }
    return block;
}

TEST(CheckLesson, TheWholeLessonOfTheReadmeHasNoFaultWhereverItLies) {
    const auto readme = read_file(kRoot / "lessons/README.md", std::size_t{1} << 20);
    ASSERT_TRUE(readme);
    const LessonFolder folder;
    folder.write("lesson.md", block_behind(*readme, "## A whole lesson", "    +++"));
    folder.write("scene.json", block_behind(*readme, "and its scene:", "    { \"texelscope\""));
    expect_no_fault(folder.lesson(), 3);
}

}  // namespace
}  // namespace texelscope::check_test
