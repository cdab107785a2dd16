#include <gtest/gtest.h>

#include "app/lesson/prose.h"
#include "app/lesson/questions.h"

namespace texelscope {
namespace {

using Verdict = Answer::Verdict;

[[nodiscard]] Prediction asked(Prediction::Kind kind, std::size_t options = 0) {
    Prediction prediction;
    prediction.kind = kind;
    prediction.options.resize(options);
    return prediction;
}
[[nodiscard]] Answer chosen(std::vector<int> options) {
    Answer answer;
    answer.chosen = std::move(options);
    return answer;
}
[[nodiscard]] Answer typed(std::string text) {
    Answer answer;
    answer.typed = std::move(text);
    return answer;
}
[[nodiscard]] Answer marked(std::vector<glm::ivec2> places) {
    Answer answer;
    answer.places = std::move(places);
    return answer;
}
const Path kStep{{{'t', 0}, {'s', 1}}}, kOther{{{'t', 0}, {'s', 2}}};

TEST(Grade, AnyAcceptedOptionIsARightChoice) {
    const Prediction p = asked(Prediction::Kind::choice, 3);
    const Accepted a{.options = {0, 2}, .step = kStep};
    EXPECT_EQ(grade(p, chosen({0}), a).verdict, Verdict::right);
    EXPECT_EQ(grade(p, chosen({2}), a).verdict, Verdict::right);
    EXPECT_EQ(grade(p, chosen({1}), a).verdict, Verdict::wrong);
    EXPECT_EQ(grade(p, chosen({1}), a).explain, kStep);
    EXPECT_EQ(grade(p, chosen({}), a).verdict, Verdict::open);
}

TEST(Grade, ManyMustBeJustTheAcceptedOnesAndTheFirstWrongOneIsExplained) {
    const Prediction p = asked(Prediction::Kind::many, 3);
    const Accepted a{.options = {0, 1}, .step = kStep, .option_steps = {kStep, kOther, kStep}};
    EXPECT_EQ(grade(p, chosen({1, 0}), a).verdict, Verdict::right);
    EXPECT_EQ(grade(p, chosen({0}), a).verdict, Verdict::wrong);
    EXPECT_EQ(grade(p, chosen({0}), a).explain, kOther);
    EXPECT_EQ(grade(p, chosen({0, 1, 2}), a).verdict, Verdict::wrong);
    EXPECT_EQ(grade(p, chosen({}), {.step = kStep}).verdict, Verdict::right);
}

TEST(Grade, NumbersAreRightWithinTheirTolerance) {
    const Prediction p = asked(Prediction::Kind::number);
    const Accepted a{.number = 8.25, .tolerance = .01, .step = kStep};
    EXPECT_EQ(grade(p, typed("8.25"), a).verdict, Verdict::right);
    EXPECT_EQ(grade(p, typed(" 8,255 "), a).verdict, Verdict::right);
    EXPECT_EQ(grade(p, typed("8.3"), a).verdict, Verdict::wrong);
    EXPECT_EQ(grade(p, typed("eight"), a).verdict, Verdict::open);
    EXPECT_EQ(grade(p, typed(""), a).verdict, Verdict::open);
    EXPECT_EQ(grade(p, typed(""), {.step = kStep}).verdict, Verdict::right);
}

TEST(Grade, AllMarkedPlacesMustBeAccepted) {
    const Prediction p = asked(Prediction::Kind::pixel);
    const Accepted a{.places = {{1, 2}, {3, 4}}, .step = kStep};
    EXPECT_EQ(grade(p, marked({{3, 4}}), a).verdict, Verdict::right);
    EXPECT_EQ(grade(p, marked({{3, 4}, {1, 2}}), a).verdict, Verdict::right);
    EXPECT_EQ(grade(p, marked({{3, 4}, {5, 5}}), a).verdict, Verdict::wrong);
    EXPECT_EQ(grade(p, marked({}), a).verdict, Verdict::open);
    EXPECT_EQ(grade(p, marked({}), {.step = kStep}).verdict, Verdict::right);
    EXPECT_EQ(grade(p, marked({{0, 0}}), {.step = kStep}).verdict, Verdict::wrong);
}

TEST(TypedNumber, ReadsWhatPeopleTypeAndNothingElse) {
    EXPECT_EQ(typed_number("137"), 137);
    EXPECT_EQ(typed_number("−0.5"), -0.5);
    EXPECT_EQ(typed_number("+1,25"), 1.25);
    EXPECT_EQ(typed_number(".5"), 0.5);
    EXPECT_EQ(typed_number("5."), 5);
    for (const char* text : {"", " ", "-", ".", "1.2.3", "1e3", "nan", "0x10", "1 2", "1234567890123456", "--1"}) {
        EXPECT_FALSE(typed_number(text)) << text;
    }
}

TEST(Prose, LengthCountsWhatIsSeen) {
    EXPECT_EQ(visible_length("**ab** `c` $u_x$"), 2 + 1 + 1 + 1 + 2);
    EXPECT_EQ(visible_length("$\\Delta$ − ü"), 1 + 3 + 1);
    EXPECT_EQ(visible_length(""), 0);
}

TEST(Prose, OnlyTextIsReadable) {
    EXPECT_EQ(unreadable_at("Δ ≤ 0\n\t€ 😀"), std::string::npos);
    for (const char* text : {"\x01", "\x7F", "\xC0\x80", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\xE2\x82", "\xC2\x85"}) {
        EXPECT_EQ(unreadable_at(text), 0U) << text;
    }
}

}  // namespace
}  // namespace texelscope
