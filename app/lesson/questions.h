// The questions that predictions ask: the engine computes their answers from the scene as it stands.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "app/lesson/lesson.h"
#include "app/state/state.h"
#include "core/method/steps.h"

namespace texelscope {

class Derived;

/// All that is right, and why. Exactly one such set follows from a scene, a step and a question.
struct Accepted {
    std::vector<int> options{};        ///< of a choice: any one of these; of many: exactly these, ascending
    std::optional<double> number{};    ///< nothing: the scene has no such number, and an empty answer is right
    double tolerance = 0;              ///< of the number, either way
    std::vector<glm::ivec2> places{};  ///< any of these; a line is {line, 0}; none: an empty answer is right
    int least = 1;                     ///< so many of `places`, at least
    Path step{};                       ///< that explains a wrong answer
    std::vector<Path> option_steps{};  ///< the same for each option, where they differ
    std::string sentence{};            ///< why it is so, with $mathematics$
};

/// `answer` of a prediction, read: a question and its arguments.
struct QuestionCall {
    const struct Question* question = nullptr;
    std::vector<double> numbers{};
    std::vector<std::string> words{};
    std::vector<std::pair<std::string, bool>> quirks{};  ///< asked for as if these were so
};

/// What a question looks at.
struct Asked {
    const Drawing& drawing;
    Steps& steps;      ///< of the drawing
    const Path& step;  ///< the cursor's
    const QuestionCall& call;

    [[nodiscard]] int whole(std::size_t n) const { return static_cast<int>(call.numbers[n]); }
    /// The cursor's shape; -1 without shapes.
    [[nodiscard]] int shape() const;
};

struct Question {
    std::string_view name;
    /// Its arguments: NAME, FIELD, RACER, RUNG, METHOD, VARIANT and NUMBER are words, FROM, TO, V, OUTSIDE, INSIDE and
    /// E0 to E2 numbers, others whole numbers; "?" behind one: may be left out.
    std::string_view form;
    Prediction::Kind kind = Prediction::Kind::choice;
    std::string_view options;  ///< what the options stand for, in order, divided by "|"; empty where there are none
    std::string_view method;   ///< that it is about; empty: any
    bool quirks = false;       ///< takes switches such as inclusive=on
    std::string_view says;     ///< what it asks, for README and lists
    Accepted (*answer)(const Asked&) = nullptr;
};

inline constexpr std::string_view kErrorPlace = "error-place";  ///< the view `front` lets it be answered by a click

/// All, in the order of lessons/README.md.
[[nodiscard]] std::span<const Question> questions();
[[nodiscard]] const Question* find_question(std::string_view name);
[[nodiscard]] int option_count(const Question& question);
/// Reads `pixel-of-byte 137`, or says what was expected.
Result<QuestionCall> parse_question(std::string_view text, const Method& method);

/// What is accepted as the prediction's answer over a drawing. A prediction that no question answers accepts nothing.
[[nodiscard]] Accepted accepted(const Prediction& asked, const Drawing& drawing, Steps& steps, const Path& step);

struct Grade {
    Answer::Verdict verdict = Answer::Verdict::open;  ///< open where nothing was answered yet
    std::string sentence{};                           ///< for the person, with $mathematics$
    Path explain{};                                   ///< the step that explains it; empty where it is right or open
};
/// Compares an answer with what is accepted. Of places, all that were marked must be right.
[[nodiscard]] Grade grade(const Prediction& asked, const Answer& answer, const Accepted& accepted);
[[nodiscard]] Grade grade(const Prediction& asked, const Answer& answer, Derived& derived, const State& state);

/// A number as people type it: digits, one point or comma, a sign. Nothing where it is anything else.
[[nodiscard]] std::optional<double> typed_number(std::string_view text);

}  // namespace texelscope
