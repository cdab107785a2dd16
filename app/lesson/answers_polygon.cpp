#include <array>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"

namespace texelscope::answers {
namespace {

constexpr Integer kRowsLookedAt = 512;  ///< of a section, for the row that draws a ghost

[[nodiscard]] Path stage_path(int shape, Integer stage) { return Path{{{'t', shape}, {'s', stage}}}; }

/// How many sections the shape has: its stages without the ring.
[[nodiscard]] Integer section_count(Steps& steps, int shape) {
    if (shape < 0) return 0;
    const auto stages = static_cast<Integer>(steps.at(Path{{{'t', shape}}}).stages.size());
    return stages > 0 ? stages - 1 : 0;
}

/// The row that draws a stale slot: it has a fate of its own and no pixels to loop over.
[[nodiscard]] std::optional<Path> ghost_row(Steps& steps, int shape) {
    for (Integer n = 1; n <= section_count(steps, shape); ++n) {
        const Path stage = stage_path(shape, n);
        const auto loop = steps.at(stage).unit().loop;
        if (!loop) continue;
        for (Integer y = loop->first; y < std::min(loop->last, loop->first + kRowsLookedAt); ++y) {
            const Path row = stage.child('y', y);
            const Unit& unit = steps.at(row).unit();
            if (unit.fate == Fate::written && !unit.loop) return row;
        }
    }
    return std::nullopt;
}

}  // namespace

Accepted sections(const Asked& asked) {
    const int shape = asked.shape();
    const Integer count = section_count(asked.steps, shape);
    Accepted a{.number = static_cast<double>(count), .step = asked.step, .sentence = "It draws nothing."};
    if (count == 0) return a;
    const auto corners = static_cast<Integer>(asked.drawing.corners(shape).size());
    a.step = stage_path(shape, count);
    a.sentence = count == corners - 1
                     ? fmt::format("{} corners, and each but the top one ends a section.", corners)
                     : fmt::format("{} of at most {}: the rest would begin at the bottom.", count, corners - 1);
    return a;
}

Accepted next_pointer(const Asked& asked) {
    constexpr std::array<std::string_view, 3> kSays{
        "Left's next corner lies at $y = {}$, right's at $y = {}$: left arrives first.",
        "Left's next corner lies at $y = {}$, right's at $y = {}$: right arrives first.",
        "Both next corners lie at $y = {1}$: the polygon, or a level side, ends both."};
    Accepted a{.options = {2}, .step = asked.step, .sentence = "There is no section here."};
    const int shape = asked.shape();
    if (section_count(asked.steps, shape) == 0) return a;
    const Integer stage =
        std::clamp<Integer>(asked.step.index_of('s').value_or(1), 1, section_count(asked.steps, shape));
    const Visit section = asked.steps.at(stage_path(shape, stage));
    const auto corners = static_cast<Integer>(asked.drawing.corners(shape).size());
    const auto next_y = [&](const char* pointer, Integer onward) {
        const auto at = value_named(section, pointer);
        const Integer n = at ? (std::get<Integer>(*at) + onward + corners) % corners : 0;
        return value_named(section, fmt::format("y_{}", n)).value_or(Value{0.0});
    };
    const double left = approximate(next_y("left", -1)), right = approximate(next_y("right", 1));
    const int option = right < left ? 1 : left < right ? 0 : 2;
    a.options = {option};
    a.sentence = fmt::format(fmt::runtime(kSays[static_cast<std::size_t>(option)]), left, right);
    a.step = stage_path(shape, stage);
    const Visit& visit = asked.steps.at(a.step);
    const auto& own = visit.unit().expressions;
    for (std::size_t e = 0; e < own.size(); ++e) {
        if (visit.tape.names[static_cast<std::size_t>(own[e])].name.text() != "y_end") continue;
        return a.step = a.step.child('e', static_cast<Integer>(e)), a;
    }
    return a;
}

Accepted ghost(const Asked& asked) {
    Accepted a{.step = asked.step, .sentence = "There is none now: no row is one pixel long."};
    int haunted = -1;
    const Window all{asked.drawing.scene().framebuffer.rect()};
    each_sample(asked.drawing, 0, asked.drawing.shape_count(), all, [&](int shape, const Sample& sample) {
        if (sample.note != Note::ghost || sample.fate != Fate::written) return;
        if (haunted < 0) haunted = shape;
        const glm::ivec2 place(sample.x, sample.y);
        if (a.places.empty() || a.places.back() != place) a.places.push_back(place);
    });
    if (a.places.empty()) return a;
    const auto row = ghost_row(asked.steps, haunted);
    if (row) a.step = *row;
    a.sentence =
        row ? fmt::format("Row {} is one pixel long, so a slot of the buffer stays as it was.", row->parts.back().index)
            : "A row is one pixel long, so a slot of the buffer stays as it was.";
    return a;
}

}  // namespace texelscope::answers
