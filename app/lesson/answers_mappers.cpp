// Two methods over one scene: where they differ, and why.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"
#include "app/state/compared_run.h"
#include "app/state/comparisons.h"

namespace texelscope::answers {
namespace {

struct Named {
    Cause cause;
    std::string_view name;
};
constexpr std::array<Named, 4> kNamed{{{Cause::coverage, "coverage"},
                                       {Cause::offset, "offset"},
                                       {Cause::rounding, "rounding"},
                                       {Cause::warp, "warp"}}};  // in the order of the options
constexpr int kAnswersMappersNone = 4;
constexpr std::string_view kAnswersMappersSame = "They read the same texel everywhere.",
                           kIn = "{} pixel{} differ{}: {}.";

/// What the question's words say, over the whole frame.
[[nodiscard]] Difference difference_asked(const Asked& asked) {
    std::string words;
    for (const std::string& word : asked.call.words) words += (words.empty() ? "" : " ") + word;
    const DrawSettings& own = asked.drawing.settings();
    const auto run = parse_run(words);
    return compare(asked.drawing, settings_of(run ? *run : ComparedRun{}, own),
                   {asked.drawing.scene().framebuffer.rect()});
}

/// "5 pixels differ: 3 by coverage, 2 by warp."
[[nodiscard]] std::string sentence_of(const Difference& difference) {
    int all = 0;
    std::string parts;
    for (const auto& [cause, name] : kNamed) {
        if (difference.of(cause) == 0) continue;
        all += difference.of(cause);
        parts += fmt::format("{}{} by {}", parts.empty() ? "" : ", ", difference.of(cause), name);
    }
    return all == 0 ? std::string(kAnswersMappersSame)
                    : fmt::format(kIn, all, all == 1 ? "" : "s", all == 1 ? "s" : "", parts);
}

[[nodiscard]] bool is_difference(Cause cause) { return cause != Cause::nothing && cause != Cause::same; }

/// The pixels of a cause that fits, row by row.
[[nodiscard]] std::vector<glm::ivec2> pixels_of(const Difference& difference, auto fits) {
    std::vector<glm::ivec2> found;
    for (int y = 0; y < difference.cells.height(); ++y)
        for (int x = 0; x < difference.cells.width(); ++x)
            if (fits(difference.cells.at(x, y).cause))
                found.emplace_back(x + difference.window.rect.x0, y + difference.window.rect.y0);
    return found;
}

/// The step of a shape at the first of the pixels that any visits; else the cursor's.
[[nodiscard]] Path step_at(const Asked& asked, const std::vector<glm::ivec2>& pixels) {
    for (const glm::ivec2 pixel : pixels)
        for (int shape = 0; shape < asked.drawing.shape_count(); ++shape)
            if (const auto step = pixel_step(asked.steps, shape, pixel.x, pixel.y)) return *step;
    return asked.step;
}

}  // namespace

Accepted differs(const Asked& asked) {
    const Difference difference = difference_asked(asked);
    Accepted a{.places = pixels_of(difference, is_difference), .sentence = sentence_of(difference)};
    a.step = step_at(asked, a.places);
    return a;
}

Accepted cause(const Asked& asked) {
    const Difference difference = difference_asked(asked);
    Accepted a{.step = asked.step, .sentence = sentence_of(difference)};
    int most = 0;
    for (const Named& named : kNamed) most = std::max(most, difference.of(named.cause));
    if (most == 0) return a.options = {kAnswersMappersNone}, a;
    for (std::size_t n = 0; n < kNamed.size(); ++n)
        if (difference.of(kNamed[n].cause) == most) a.options.push_back(static_cast<int>(n));
    const Cause first = kNamed[static_cast<std::size_t>(a.options.front())].cause;
    a.step = step_at(asked, pixels_of(difference, [first](Cause c) { return c == first; }));
    return a;
}

}  // namespace texelscope::answers
