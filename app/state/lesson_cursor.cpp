#include "app/state/lesson_cursor.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "app/state/compared_run.h"
#include "core/scene/jelly_quirk.h"
#include "core/trace/listing.h"

namespace texelscope {
namespace {

/// "pixel 16,11", "texel 7,9", "name u_x", "line 42", "line quirk.inclusive".
[[nodiscard]] Selection pin_from(const std::string& text, const Method& method) {
    Selection pin;
    const std::size_t space = text.find(' ');
    if (space == std::string::npos) return pin;
    const std::string kind = text.substr(0, space), what = text.substr(space + 1);
    if (kind == "name") pin.kind = Selection::Kind::name, pin.name = what;
    if (kind == "line") {
        pin.kind = Selection::Kind::line;
        const bool digits =
            !what.empty() && what.find_first_not_of("0123456789") == std::string::npos && what.size() < 7;
        pin.line = digits ? std::stoi(what) : find_line(method, load_listing(method.listing), what);
    }
    if (kind == "pixel" || kind == "texel") {
        const char* end = what.data() + what.size();
        const auto [after, bad] = std::from_chars(what.data(), end, pin.at.x);
        if (bad != std::errc() || after == end || std::from_chars(after + 1, end, pin.at.y).ec != std::errc())
            return pin;
        pin.kind = kind == "pixel" ? Selection::Kind::pixel : Selection::Kind::texel;
    }
    return pin;
}

/// Of one beat alone: all of them but those it turns off.
[[nodiscard]] std::uint32_t skips_of(const BeatSettings& set) {
    std::uint32_t skips = kAllSkips;
    for (const auto& [id, on] : set.skips)
        for (const RasterSkipInfo& info : kRasterSkips)
            if (info.id == id && !on) skips &= without(info.skip);
    return skips;
}

void apply(State& state, const BeatSettings& set, std::optional<Path>& step) {
    if (set.method) state.work.method = *set.method;
    const Method& method = *find_method(state.work.method);
    if (set.method || set.variant) {
        state.work.variant = set.variant.value_or(std::string(method.variants.back().id));
        state.work.quirks = quirks_of(method, state.work.variant);
    }
    if (set.number) state.work.format = number_format(*set.number).value_or(state.work.format);
    for (const auto& [id, on] : set.quirks) {
        if (id == kJellyQuirk.field) state.work.size_twice = on;
        const int n = quirk_index(method, id);
        if (n < 0) continue;
        const QuirkSet bit = QuirkSet{1} << n;
        state.work.quirks = on ? state.work.quirks | bit : state.work.quirks & ~bit;
    }
    if (set.level) state.cursor.level = *set.level;
    if (set.step) {
        step = *set.step;
        if (!set.level) state.cursor.level = level_of(*set.step);
    }
    state.pinned = set.pin ? pin_from(*set.pin, method) : Selection{};
    state.playing = set.play.value_or(false);
    state.moving = false;
    if (set.hits) state.look.hits = *set.hits;
    if (set.random) state.work.random = set.random;
    if (set.rung) state.look.rung = *set.rung;
    state.look.skips = skips_of(set);
    if (set.against) {
        if (const auto run = parse_run(*set.against)) state.look.other = *run;
    }
}

}  // namespace

Level level_of(const Path& path) {
    if (path.at_expression()) return Level::expression;
    return static_cast<Level>(std::clamp(path.depth() - 1, 0, static_cast<int>(Level::pixel)));
}

int quirk_index(const Method& method, std::string_view id) {
    for (std::size_t n = 0; n < method.quirks.size(); ++n) {
        if (method.quirks[n].id == id || method.quirks[n].field == id) return static_cast<int>(n);
    }
    return -1;
}

int beat_count(const State& state) {
    return state.document && state.document->lesson ? static_cast<int>(state.document->lesson->beats.size()) : 0;
}

const Prediction* prediction_of(const State& state) {
    if (state.cursor.beat < 0 || state.cursor.beat >= beat_count(state)) return nullptr;
    const auto& prediction = state.document->lesson->beats[static_cast<std::size_t>(state.cursor.beat)].prediction;
    return prediction ? &*prediction : nullptr;
}

Answer& answer_here(State& state) {
    auto& answers = state.work.answers;
    const auto found =
        std::find_if(answers.begin(), answers.end(), [&](const Answer& a) { return a.beat == state.cursor.beat; });
    if (found != answers.end()) return *found;
    answers.push_back({.beat = state.cursor.beat});
    return answers.back();
}

void go_to_beat(State& state, int beat, Derived& derived) {
    const Lesson& lesson = *state.document->lesson;
    state.cursor.beat = std::clamp(beat, 0, std::max(0, beat_count(state) - 1));
    state.work.method = lesson.method;
    state.work.random.reset(), state.work.size_twice.reset();
    state.look.hits = state.look.difference = false;
    state.look.other = {}, state.look.rung.clear();
    BeatSettings start;
    start.variant = lesson.variant;
    start.number = lesson.format;
    std::optional<Path> step;
    state.cursor.level = Level::pixel;
    apply(state, start, step);
    for (int n = 0; n <= state.cursor.beat; ++n) apply(state, lesson.beats[static_cast<std::size_t>(n)].set, step);
    derived.update(state);
    const auto found = derived.steps().nearest(step.value_or(Path{}), state.cursor.level);
    state.cursor.step = found.value_or(Path{});
    if (state.cursor.beat + 1 == beat_count(state) &&
        std::find(state.done.begin(), state.done.end(), lesson.number) == state.done.end()) {
        state.done.push_back(lesson.number);
    }
    derived.update(state);
}

}  // namespace texelscope
