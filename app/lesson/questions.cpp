#include "app/lesson/questions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"
#include "app/lesson/fields.h"
#include "app/state/compared_run.h"
#include "app/state/derived.h"
#include "app/state/lesson_cursor.h"
#include "core/measure/bill.h"
#include "core/measure/rungs.h"

namespace texelscope {
namespace {

using Kind = Prediction::Kind;

constexpr auto kQuestions = std::to_array<Question>({
    {"pixel-of-byte", "N", Kind::pixel, "", "", false, "the pixel whose byte N is, three bytes a pixel, row by row",
     answers::pixel_of_byte},
    {"byte-of-pixel", "X Y C", Kind::number, "", "", false, "the byte of channel C of pixel X, Y",
     answers::byte_of_pixel},
    {"address-of", "X Y", Kind::number, "", "", false, "the pixel's place in the array: y w + x", answers::address_of},
    {"drawn", "", Kind::number, "", "", true, "how many pixels are drawn at least once", answers::drawn},
    {"doubles", "", Kind::number, "", "", true, "how many pixels are drawn more than once", answers::doubles},
    {"owner", "X Y", Kind::choice, "the first|the second|both|neither", "", true,
     "which of the polygon's first two shapes draw the pixel", answers::owner},
    {"texel-of", "X Y", Kind::texel, "", "", false, "the texel that the pixel reads", answers::texel_of},
    {"value", "NAME DX? DY?", Kind::number, "", "", false,
     "the value of a name at the step, or DX, DY pixels from it; 0.01 either way", answers::value},
    {"row-pixels", "", Kind::number, "", "", false, "how many pixels the shape writes in the step's row",
     answers::row_pixels},
    {"guilty-line", "FIELD", Kind::line, "", "", false, "a line of the listing that asks for the quirk",
     answers::guilty_line},
    {"row-of-v", "V", Kind::pixel, "", "", false, "a pixel whose v comes nearest to V in its column of the polygon",
     answers::row_of_v},
    {"zero-in-denominator", "", Kind::choice, "g|h|i|none", "", false,
     "a coefficient of g X + h Y + i that is exactly 0", answers::zero_in_denominator},
    {"fate", "X Y", Kind::choice, "drawn|side A|side B|side C|never visited", "edge-equations", false,
     "what decides on the sample", answers::fate},
    {"box-samples", "", Kind::number, "", "edge-equations", false, "how many samples the bounding box has",
     answers::box_samples},
    {"drawn-after-exchange", "A B", Kind::choice, "the same|nothing|the box", "edge-equations", true,
     "what is drawn once corners A and B have changed places", answers::drawn_after_exchange},
    {"changed-coefficients", "CORNER FROM TO", Kind::many, "u_x|u_y|u_k|v_x|v_y|v_k", "edge-equations", false,
     "which coefficients change when x0, y1, u2, … goes from one value to another", answers::changed_coefficients},
    {"sections", "", Kind::number, "", "sections", false, "how many sections the polygon has", answers::sections},
    {"next-pointer", "", Kind::choice, "left|right|both", "sections", false,
     "which pointer moves at the end of the step's section", answers::next_pointer},
    {"ghost", "", Kind::pixel, "", "sections", false, "a pixel that a stale slot of the row buffer was drawn to",
     answers::ghost},
    {"double-row", "", Kind::number, "", "edge-walk", true, "the row that both halves of the shape draw",
     answers::double_row},
    {"first-flip", "NEAR FAR FARTHER FARTHEST", Kind::choice, "the first|the second|the third|the fourth|none", "",
     true, "at which distance from the origin a texel of the shape first differs from exact numbers",
     answers::first_flip},
    {"weights-at", "E0 E1 E2", Kind::pixel, "", "barycentric", false, "a pixel with these weights, or next to it",
     answers::weights_at},
    {"visible-faces", "", Kind::number, "", "", false, "how many faces of the shape's solid show us their outside",
     answers::visible_faces},
    {"cut-corners", "", Kind::many, "0 and 7|1 and 6|2 and 5|3 and 4", "", false,
     "which pairs of opposite corners of the small jelly cube lie outside the big one", answers::cut_corners},
    {"cut-weight", "OUTSIDE INSIDE", Kind::number, "", "", false,
     "the weight of the end at OUTSIDE in the cut at 1; 0.01 either way", answers::cut_weight},
    {"indices", "", Kind::number, "", "sampling-1d", true, "the texels that the row takes in turn, a digit each",
     answers::indices},
    {"index-beyond", "", Kind::number, "", "sampling-1d", true,
     "the first index of the row that is outside of the texture", answers::index_beyond},
    {"hole-share", "", Kind::number, "", "forward", false,
     "how many percent of the shape's pixels stay empty, 2.5 either way", answers::hole_share},
    {"hole", "N", Kind::pixel, "", "forward", false, "N pixels of the shape that stay empty", answers::hole},
    {"buffer-width", "SHAPE", Kind::number, "", "two-pass", false,
     "how many columns of tmp a row of the shape's texels takes up, 0.5 either way", answers::buffer_width},
    {"operations-order", "RACER RACER RACER", Kind::number, "", "", false,
     "three methods by how many operations the scene takes, fewest first: 213 where the second has fewest",
     answers::operations_order},
    {"set-up-share", "RACER?", Kind::number, "", "", false,
     "how many percent of the scene's operations are set-up; 10 either way", answers::set_up_share},
    {"frames-1995", "", Kind::number, "", "", false,
     "how many times a second the scene's pixels were drawn at 100 ns each; a twentieth either way",
     answers::frames_1995},
    {kErrorPlace, "RUNG RUNG RUNG", Kind::choice, "less than both|between|more than both", "", false,
     "where the greatest error of the first lies, beside those of the two others", answers::error_place},
    {"needed", "TRIANGLES", Kind::number, "", "", false,
     "how many of so many triangles like the scene's must be drawn, no skip having dropped them; a tenth either way",
     answers::needed},
    {"uncertain", "", Kind::pixel, "", "", false,
     "a pixel of the shape whose texel the certificate of `fast` does not settle", answers::uncertain},
    {"differs", "METHOD VARIANT? NUMBER?", Kind::pixel, "", "", false,
     "a pixel for which another run reads another texel, or that only one of the two draws", answers::differs},
    {"cause", "METHOD VARIANT? NUMBER?", Kind::choice, "coverage|offset|rounding|warp|none", "", false,
     "why another run differs, in most of the pixels in which it does", answers::cause},
});

constexpr std::string_view kPlaces = "Mark it first: point, or move there with I and the arrows.";
constexpr std::string_view kQuestionsChoose = "Choose first.", kType = "Type a number first.",
                           kMore = "Mark {} of them first.", kNotANumber = "'{}' is not a number.";

[[nodiscard]] std::vector<std::string_view> divided(std::string_view text, char by) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(by), text.size());
        if (end > 0) parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

[[nodiscard]] bool is_identifier(std::string_view word) {
    const auto inside = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
               (static_cast<unsigned char>(c) & 0x80U) != 0;
    };
    return !word.empty() && word.size() <= 24 && std::isdigit(static_cast<unsigned char>(word[0])) == 0 &&
           std::all_of(word.begin(), word.end(), inside);
}

/// Takes one argument as the form's `token` wants it; else what was expected.
[[nodiscard]] std::string take_argument(std::string_view token, std::string_view word, const Method& method,
                                        QuestionCall& call) {
    if (token == "RACER") {
        const std::vector<const Method*> all = racers();
        if (std::none_of(all.begin(), all.end(), [&](const Method* m) { return m->id == word; }))
            return "a method that can race, such as edge-walk";
        return call.words.emplace_back(word), std::string{};
    }
    if (token == "NAME" || token == "FIELD" || token == "CORNER") {
        const bool corner = word.size() == 2 && std::string_view("xyuv").find(word[0]) != word.npos &&
                            std::string_view("012").find(word[1]) != word.npos;
        if (token == "CORNER" && !corner) return "a corner's number such as u1";
        if (token == "FIELD" && !quirk_number(method, word)) return fmt::format("a quirk of {}", method.id);
        if (token == "NAME" && !is_identifier(word)) return "a name such as u_x";
        return call.words.emplace_back(word), std::string{};
    }
    if (token == "METHOD" || token == "VARIANT" || token == "NUMBER") {
        std::string run;
        for (const std::string& before : call.words) run += before + " ";
        if (!parse_run(run + std::string(word)))
            return token == "METHOD" ? "the id of a method" : "a variant of the method, then a number format";
        return call.words.emplace_back(word), std::string{};
    }
    if (token == "RUNG") {
        if (find_rung(word) == nullptr) return "the id of a rung, as `texelscope front` lists them";
        return call.words.emplace_back(word), std::string{};
    }
    const auto number = typed_number(word);
    constexpr std::array<std::string_view, 8> kReal{"FROM", "TO", "V", "E0", "E1", "E2", "OUTSIDE", "INSIDE"};
    const bool real = std::find(kReal.begin(), kReal.end(), token) != kReal.end();
    constexpr double kFarthest = 1e9;
    if (!number || std::abs(*number) > kFarthest) return fmt::format("a number for {}", token);
    if (!real && *number != std::floor(*number)) return fmt::format("a whole number for {}", token);
    return call.numbers.push_back(*number), std::string{};
}

/// inclusive=on, or what was expected.
[[nodiscard]] std::string take_switch(std::string_view word, const Method& method, QuestionCall& call) {
    const std::size_t equals = word.find('=');
    const std::string_view name = word.substr(0, equals), state = equals == word.npos ? "" : word.substr(equals + 1);
    if (!quirk_number(method, name) || (state != "on" && state != "off"))
        return fmt::format("QUIRK=on or QUIRK=off, a quirk of {}", method.id);
    return call.quirks.emplace_back(name, state == "on"), std::string{};
}

}  // namespace

int Asked::shape() const {
    if (step.empty() || drawing.shape_count() == 0) return -1;
    return static_cast<int>(std::clamp<Integer>(step.parts[0].index, 0, drawing.shape_count() - 1));
}

std::span<const Question> questions() { return kQuestions; }

const Question* find_question(std::string_view name) {
    const auto found =
        std::find_if(kQuestions.begin(), kQuestions.end(), [&](const Question& q) { return q.name == name; });
    return found == kQuestions.end() ? nullptr : &*found;
}

int option_count(const Question& question) { return static_cast<int>(divided(question.options, '|').size()); }

Result<QuestionCall> parse_question(std::string_view text, const Method& method) {
    const std::vector<std::string_view> words = divided(text, ' ');
    QuestionCall call{.question = words.empty() ? nullptr : find_question(words[0])};
    if (call.question == nullptr) {
        std::vector<std::string_view> names;
        for (const Question& question : kQuestions) names.push_back(question.name);
        return Error{"", fmt::format("is '{}', expected {}", text, one_of(names))};
    }
    const Question& question = *call.question;
    if (!question.method.empty() && question.method != method.id) {
        return Error{
            "", fmt::format("'{}' is about {}, the lesson's method is {}", question.name, question.method, method.id)};
    }
    const std::vector<std::string_view> form = divided(question.form, ' ');
    std::size_t taken = 0;
    for (std::size_t n = 1; n < words.size(); ++n) {
        const bool more = taken < form.size();
        if (!more && !question.quirks)
            return Error{"", fmt::format("'{}' takes no '{}', expected {} {}", question.name, words[n], question.name,
                                         question.form)};
        std::string_view token = more ? form[taken++] : "";
        if (!token.empty() && token.back() == '?') token.remove_suffix(1);
        const std::string expected =
            more ? take_argument(token, words[n], method, call) : take_switch(words[n], method, call);
        if (!expected.empty()) return Error{"", fmt::format("has '{}', expected {}", words[n], expected)};
    }
    const bool all_or_none =
        taken < form.size() && form[taken].back() == '?' && (taken == 0 || form[taken - 1].back() != '?');
    if (taken < form.size() && !all_or_none)
        return Error{"", fmt::format("is '{}', expected {} {}", text, question.name, question.form)};
    return call;
}

Accepted accepted(const Prediction& asked, const Drawing& drawing, Steps& steps, const Path& step) {
    const auto call = parse_question(asked.answer, *drawing.settings().method);
    if (!call || call->question->kind != asked.kind)
        return {.step = step, .sentence = "This method has no answer to it."};
    Accepted a = call->question->answer({drawing, steps, step, *call});
    if (asked.explain != "auto") a.step = parse_path(asked.explain).value_or(a.step), a.option_steps.clear();
    return a;
}

Grade grade(const Prediction& asked, const Answer& answer, const Accepted& accepted) {
    const auto of = [&](bool right, const Path& step) {
        return Grade{right ? Answer::Verdict::right : Answer::Verdict::wrong, accepted.sentence, right ? Path{} : step};
    };
    const auto open = [](std::string sentence) { return Grade{.sentence = std::move(sentence), .explain = {}}; };
    switch (asked.kind) {
        case Kind::choice: {
            if (answer.chosen.empty()) return open(std::string(kQuestionsChoose));
            const auto& right = accepted.options;
            return of(std::find(right.begin(), right.end(), answer.chosen.front()) != right.end(), accepted.step);
        }
        case Kind::many: {
            const auto chosen = [&](int n) {
                return std::find(answer.chosen.begin(), answer.chosen.end(), n) != answer.chosen.end();
            };
            for (int n = 0; n < static_cast<int>(asked.options.size()); ++n) {
                const bool right =
                    std::find(accepted.options.begin(), accepted.options.end(), n) != accepted.options.end();
                if (chosen(n) == right) continue;
                const auto at = static_cast<std::size_t>(n);
                return of(false, at < accepted.option_steps.size() ? accepted.option_steps[at] : accepted.step);
            }
            return of(true, accepted.step);
        }
        case Kind::number: {
            if (answer.typed.empty()) return accepted.number ? open(std::string(kType)) : of(true, accepted.step);
            const auto number = typed_number(answer.typed);
            if (!number) return open(fmt::format(kNotANumber, answer.typed));
            return of(accepted.number && std::abs(*number - *accepted.number) <= accepted.tolerance, accepted.step);
        }
        case Kind::pixel:
        case Kind::texel:
        case Kind::line: break;
    }
    const auto& right = accepted.places;
    if (answer.places.empty()) return right.empty() ? of(true, accepted.step) : open(std::string(kPlaces));
    if (static_cast<int>(answer.places.size()) < accepted.least) return open(fmt::format(kMore, accepted.least));
    return of(
        std::all_of(answer.places.begin(), answer.places.end(),
                    [&](glm::ivec2 place) { return std::find(right.begin(), right.end(), place) != right.end(); }),
        accepted.step);
}

Grade grade(const Prediction& asked, const Answer& answer, Derived& derived, const State& state) {
    Grade result = grade(asked, answer, accepted(asked, derived.drawing(), derived.steps(), state.cursor.step));
    if (!result.explain.empty()) {
        const auto there = derived.steps().nearest(result.explain, level_of(result.explain));
        result.explain = there.value_or(Path{});
    }
    return result;
}

std::optional<double> typed_number(std::string_view text) {
    constexpr std::string_view kMinusSign = "−";
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    const bool negative = text.substr(0, 1) == "-" || text.substr(0, kMinusSign.size()) == kMinusSign;
    if (negative)
        text.remove_prefix(text.front() == '-' ? 1 : kMinusSign.size());
    else if (text.substr(0, 1) == "+")
        text.remove_prefix(1);
    constexpr int kMostDigits =
        15;  // so that digits and power of ten are both exact and the quotient is the nearest double
    double value = 0, scale = 1;
    int digits = 0;
    bool point = false;
    for (const char c : text) {
        if ((c == '.' || c == ',') && !point) {
            point = true;
            continue;
        }
        if (c < '0' || c > '9' || ++digits > kMostDigits) return std::nullopt;
        value = value * 10 + (c - '0');
        if (point) scale *= 10;
    }
    if (digits == 0) return std::nullopt;
    return (negative ? -1 : 1) * value / scale;
}

}  // namespace texelscope
