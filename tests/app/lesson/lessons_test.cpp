// The lessons that come with the program: every one loads, every step and answer in it exists.
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/lesson/facts.h"
#include "app/lesson/questions.h"
#include "app/state/lesson_cursor.h"
#include "app/state/store.h"
#include "core/base/file.h"
#include "core/scene/json.h"
#include "tests/cases.h"

namespace texelscope::lessons_test {
namespace {

const std::filesystem::path kRoot = TEXELSCOPE_SOURCE_DIR;

[[nodiscard]] const std::vector<Lesson>& lessons() {
    static const std::vector<Lesson> all = [] {
        std::vector<Error> errors;
        auto found = load_lessons(kRoot / "lessons", errors);
        for (const Error& error : errors) ADD_FAILURE() << error.text();
        return found;
    }();
    return all;
}

[[nodiscard]] std::shared_ptr<Document> document_of(const Lesson& lesson) {
    auto document = std::make_shared<Document>();
    document->id = lesson.id;
    document->lesson = lesson;
    auto scene = load_scene(lesson.file.parent_path() / lesson.scene, kRoot / "assets");
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().text());
    if (scene) {
        EXPECT_TRUE(scene->warnings.empty()) << lesson.id;
        document->scene = scene->scene;
    }
    return document;
}

/// Calls f(store, beat) at each beat, reached by PgDn alone.
void at_each_beat(const Lesson& lesson, const std::shared_ptr<const Document>& document, const auto& f) {
    Store store(opened(document, State{}));
    for (std::size_t n = 0; n < lesson.beats.size(); ++n) {
        if (n > 0) store.dispatch(action::Advance{});
        ASSERT_EQ(store.state().cursor.beat, static_cast<int>(n));
        f(store, lesson.beats[n]);
    }
}

[[nodiscard]] std::string where(const Lesson& lesson, const Beat& beat) {
    return lesson.file.string() + ":" + std::to_string(beat.line);
}

TEST(Lessons, TheFirstFiveAreThere) {
    std::set<int> numbers;
    for (const Lesson& lesson : lessons()) numbers.insert(lesson.number);
    for (const int number : {1, 2, 3, 4, 5, 6, 9, 14}) EXPECT_EQ(numbers.count(number), 1U) << number;
}

TEST(Lessons, PrintedTheyAreTheSameLesson) {
    for (const Lesson& lesson : lessons()) {
        const std::string printed = print_lesson(lesson);
        const auto again = parse_lesson(printed, lesson.file);
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(print_lesson(*again), printed);
    }
}

TEST(Lessons, HaveFiveToEightBeatsAndAPrediction) {
    for (const Lesson& lesson : lessons()) {
        EXPECT_GE(lesson.beats.size(), 5U) << lesson.id;
        EXPECT_LE(lesson.beats.size(), 8U) << lesson.id;
        int predictions = 0;
        for (const Beat& beat : lesson.beats) predictions += beat.prediction.has_value();
        EXPECT_GE(predictions, 1) << lesson.id;
    }
}

TEST(Lessons, EveryStepExistsAndEveryPinPointsAtSomething) {
    for (const Lesson& lesson : lessons()) {
        at_each_beat(lesson, document_of(lesson), [&](Store& store, const Beat& beat) {
            const State& state = store.state();
            if (beat.set.step) {
                EXPECT_EQ(state.cursor.step.text(), beat.set.step->text()) << where(lesson, beat);
                EXPECT_TRUE(store.derived().visit().found) << where(lesson, beat);
            }
            if (!beat.set.pin) return;
            EXPECT_NE(state.pinned.kind, Selection::Kind::none) << where(lesson, beat);
            EXPECT_TRUE(state.pinned.kind != Selection::Kind::line || state.pinned.line > 0) << where(lesson, beat);
            if (state.pinned.kind != Selection::Kind::name) return;
            EXPECT_TRUE(value_named(store.derived().visit(), state.pinned.name)) << where(lesson, beat);
        });
    }
}

TEST(Lessons, TheQuirkOfJellyCubesChangesPixelsWhereABeatShowsIt) {
    int shown = 0;
    for (const Lesson& lesson : lessons()) {
        at_each_beat(lesson, document_of(lesson), [&](Store& store, const Beat& beat) {
            if (!store.derived().scene().size_twice) return;
            ++shown;
            const Image with = store.derived().final_picture();
            store.dispatch(action::SetSizeTwice{false});
            EXPECT_NE(store.derived().final_picture(), with) << where(lesson, beat);
            store.dispatch(action::SetSizeTwice{true});
        });
    }
    EXPECT_GT(shown, 0);
}

TEST(Lessons, EveryQuirkChangesAPixelAndItsGuiltyLineIsPinned) {
    for (const Lesson& lesson : lessons()) {
        const auto document = document_of(lesson);
        const Method& method = *find_method(lesson.method);
        for (const std::string& id : lesson.quirks) {
            const QuirkInfo& quirk = method.quirks[static_cast<std::size_t>(quirk_number(method, id).value())];
            if (quirk.kind == QuirkKind::form) continue;
            const auto pictures_differ = [&](const VariantInfo& variant) {
                const NumberFormat format = number_format(lesson.format).value_or(NumberFormat::f64);
                const Drawing plain(document->scene, {&method, format, variant.quirks, {}});
                const Drawing on(document->scene, with_quirks(plain, {{id, true}})),
                    off(document->scene, with_quirks(plain, {{id, false}}));
                return render(on) != render(off) || write_counts(on) != write_counts(off);
            };
            EXPECT_TRUE(pictures_differ(method.variants.front()) || pictures_differ(method.variants.back()))
                << lesson.id << ' ' << id;
            const std::string line = "line quirk." + std::string(quirk.field);
            bool pinned = false;
            for (const Beat& beat : lesson.beats)
                pinned = pinned || (beat.set.pin && beat.set.pin->rfind(line, 0) == 0);
            EXPECT_TRUE(pinned) << lesson.id << ": no beat pins " << line;
        }
    }
}

/// A number as one would type it: all digits where it has to be met exactly.
[[nodiscard]] std::string typed(double number, double tolerance) {
    return tolerance > 0 ? fmt::format("{:.6f}", number) : fmt::format("{:.15g}", number);
}

/// The answer that is right.
[[nodiscard]] Answer right_answer(const Prediction& asked, const Accepted& accepted) {
    Answer answer;
    if (asked.kind == Prediction::Kind::choice) answer.chosen = {accepted.options.front()};
    if (asked.kind == Prediction::Kind::many) answer.chosen = accepted.options;
    if (accepted.number) answer.typed = typed(*accepted.number, accepted.tolerance);
    for (const glm::ivec2 place : accepted.places)
        if (static_cast<int>(answer.places.size()) < accepted.least) answer.places.push_back(place);
    return answer;
}

/// Answers that are wrong.
[[nodiscard]] std::vector<Answer> wrong_answers(const Prediction& asked, const Accepted& accepted) {
    std::vector<Answer> wrong;
    const int options = static_cast<int>(asked.options.size());
    const auto is_right = [&](int n) { return std::count(accepted.options.begin(), accepted.options.end(), n) > 0; };
    for (int n = 0; n < options; ++n) {
        Answer answer;
        if (asked.kind == Prediction::Kind::choice && !is_right(n)) answer.chosen = {n}, wrong.push_back(answer);
        if (asked.kind != Prediction::Kind::many) continue;
        answer.chosen = accepted.options;
        if (is_right(n))
            answer.chosen.erase(std::find(answer.chosen.begin(), answer.chosen.end(), n));
        else
            answer.chosen.push_back(n);
        wrong.push_back(answer);
    }
    Answer answer;
    if (asked.kind == Prediction::Kind::number)
        answer.typed = typed(accepted.number.value_or(0) + accepted.tolerance + 1, accepted.tolerance),
        wrong.push_back(answer);
    if (options == 0 && asked.kind != Prediction::Kind::number)
        answer.places.assign(static_cast<std::size_t>(accepted.least), {-7, -7}), wrong.push_back(answer);
    return wrong;
}

void expect_one_answer(const Prediction& asked, Store& store, const std::string& place) {
    Derived& derived = store.derived();
    const Accepted once = accepted(asked, derived.drawing(), derived.steps(), store.state().cursor.step);
    const Accepted twice = accepted(asked, derived.drawing(), derived.steps(), store.state().cursor.step);
    EXPECT_EQ(once.options, twice.options) << place;
    EXPECT_EQ(once.number, twice.number) << place;
    EXPECT_EQ(once.places, twice.places) << place;
    EXPECT_FALSE(once.sentence.empty()) << place;
    ASSERT_TRUE(asked.kind != Prediction::Kind::choice || !once.options.empty()) << place;
    const Grade right = grade(asked, right_answer(asked, once), derived, store.state());
    EXPECT_EQ(right.verdict, Answer::Verdict::right) << place;
    EXPECT_TRUE(right.explain.empty()) << place;
    for (const Answer& answer : wrong_answers(asked, once)) {
        const Grade wrong = grade(asked, answer, derived, store.state());
        EXPECT_EQ(wrong.verdict, Answer::Verdict::wrong) << place;
        ASSERT_FALSE(wrong.explain.empty()) << place;
        EXPECT_EQ(derived.steps().nearest(wrong.explain, level_of(wrong.explain)), wrong.explain)
            << place << ' ' << wrong.explain.text();
    }
}

TEST(Lessons, PredictionsHaveOneAnswerInAHundredRandomScenes) {
    std::mt19937 random(1);  // NOLINT: the same scenes every time
    for (const Lesson& lesson : lessons()) {
        const auto document = document_of(lesson);
        for (int n = 0; n <= static_cast<int>(cases(100, 20)); ++n) {
            auto moved = std::make_shared<Document>(*document);
            const Framebuffer& frame = moved->scene.framebuffer;
            std::uniform_int_distribution<int> x(-16, 8 * (frame.width + 2)), y(-16, 8 * (frame.height + 2)),
                one_in(0, 3);
            for (Polygon& polygon : moved->scene.polygons) {
                for (Vertex& vertex : polygon.vertices) {
                    if (n == 0 || one_in(random) > 1) continue;
                    vertex.x = static_cast<float>(x(random)) / 8, vertex.y = static_cast<float>(y(random)) / 8;
                }
            }
            at_each_beat(lesson, moved, [&](Store& store, const Beat& beat) {
                if (beat.prediction)
                    expect_one_answer(*beat.prediction, store, where(lesson, beat) + " scene " + std::to_string(n));
            });
            if (testing::Test::HasFailure()) return;
        }
    }
}

[[nodiscard]] std::string readme() {
    const auto text = read_file(kRoot / "lessons/README.md", std::size_t{1} << 20);
    EXPECT_TRUE(text);
    return text ? *text : std::string();
}

TEST(Readme, ItsWholeLessonIsOne) {
    const std::string text = readme();
    const std::size_t from = text.find("## A whole lesson"), to = text.find("and its scene:");
    ASSERT_NE(from, std::string::npos);
    ASSERT_NE(to, std::string::npos);
    std::string lesson;
    for (std::size_t at = text.find("    +++", from); at < to;) {
        const std::size_t end = text.find('\n', at);
        const std::string line = text.substr(at, end - at);
        lesson += (line.rfind("    ", 0) == 0 ? line.substr(4) : line) + '\n';
        at = end + 1;
    }
    const auto read = parse_lesson(lesson, "lessons/22-my-lesson/lesson.md");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->number, 22);
    EXPECT_EQ(read->beats.size(), 3U);
}

TEST(Readme, ListsEveryQuestionWithItsArguments) {
    const std::string text = readme();
    for (const Question& question : questions()) {
        const std::string call =
            fmt::format("`{}{}{}`", question.name, question.form.empty() ? "" : " ", question.form);
        EXPECT_NE(text.find(call), std::string::npos) << call;
    }
}

TEST(Lessons, EveryPredictionCanBeSkipped) {
    for (const Lesson& lesson : lessons()) {
        at_each_beat(lesson, document_of(lesson), [&](Store& store, const Beat& beat) {
            if (!beat.prediction) return;
            store.dispatch(action::Skip{});
            ASSERT_FALSE(store.state().work.answers.empty());
            EXPECT_EQ(store.state().work.answers.back().verdict, Answer::Verdict::skipped);
        });
    }
}

TEST(Lessons, TheFiguresOfTheCurriculumHold) {
    const auto answer = [&](int number, std::string_view question) {
        for (const Lesson& lesson : lessons()) {
            if (lesson.number != number) continue;
            Accepted found;
            at_each_beat(lesson, document_of(lesson), [&](Store& store, const Beat& beat) {
                if (!beat.prediction || beat.prediction->answer != question) return;
                found = accepted(*beat.prediction, store.derived().drawing(), store.derived().steps(),
                                 store.state().cursor.step);
            });
            return found;
        }
        return Accepted{};
    };
    EXPECT_EQ(answer(1, "pixel-of-byte 137").places, (std::vector<glm::ivec2>{{13, 1}}));
    EXPECT_EQ(answer(2, "indices").number, 1122334556677);  // 0 1 1 2 2 3 3 4 5 5 6 6 7 7
    EXPECT_EQ(answer(2, "index-beyond uneven_start=off start_ratio=on").number, 8);
    EXPECT_NEAR(answer(3, "hole-share").number.value_or(0), 55.6, .05);
    EXPECT_EQ(answer(3, "hole 3").places.size(), 5120U);
    EXPECT_NEAR(answer(4, "buffer-width 1").number.value_or(0), 16.6, .05);
    EXPECT_EQ(answer(5, "fate 23 14").options, std::vector{2});
    EXPECT_EQ(answer(5, "drawn-after-exchange 1 2").options, std::vector{0});
    EXPECT_EQ(answer(5, "drawn-after-exchange 1 2 one_winding=on").options, std::vector{1});
    EXPECT_EQ(answer(6, "doubles inclusive=on").number, 8);
    EXPECT_EQ(answer(6, "doubles inclusive=on corners=on").number, 9);
    EXPECT_EQ(answer(6, "owner 6 4").options, std::vector{0});
    EXPECT_EQ(answer(9, "changed-coefficients u1 5 7").options, (std::vector{0, 1, 2}));
    const auto middle = answer(12, "row-of-v 4").places;
    EXPECT_FALSE(middle.empty());
    for (const glm::ivec2 place : middle) EXPECT_EQ(place.y, 30);  // 150 in S4's picture, not 175
    EXPECT_NEAR(answer(12, "value u 1 0").number.value_or(0), 8 * (2.0 / 3 + 0.025), 1e-9);
    EXPECT_EQ(answer(13, "zero-in-denominator").options, std::vector{0});
    EXPECT_EQ(answer(14, "sections").number, 4);
    EXPECT_EQ(answer(14, "next-pointer").options, std::vector{1});
    EXPECT_EQ(answer(14, "ghost").places, (std::vector<glm::ivec2>{{0, 0}}));
}

}  // namespace
}  // namespace texelscope::lessons_test
