#include "app/views/canvas_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "app/state/lesson_cursor.h"
#include "core/conventions.h"

namespace texelscope::canvas {

const Variable* find_variable(const Derived& derived, std::string_view name) {
    const std::vector<Variable>& all = derived.variables();
    const auto at = std::find_if(all.begin(), all.end(), [name](const Variable& v) { return v.name == name; });
    return at == all.end() ? nullptr : &*at;
}

std::optional<double> number_of(const Derived& derived, std::string_view name) {
    const Variable* found = find_variable(derived, name);
    if (found == nullptr || undefined(found->value)) return std::nullopt;
    const double value = approximate(found->value);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<bool> truth_of(const Derived& derived, std::string_view name) {
    const Variable* found = find_variable(derived, name);
    const bool* truth = found != nullptr ? std::get_if<bool>(&found->value) : nullptr;
    return truth != nullptr ? std::optional(*truth) : std::nullopt;
}

bool shows(const State& state, std::string_view view) {
    if (!state.document || !state.document->lesson) return false;
    const Lesson& lesson = *state.document->lesson;
    const std::vector<std::string>* views = &lesson.views;
    for (int n = 0; n <= state.cursor.beat && n < static_cast<int>(lesson.beats.size()); ++n) {
        const auto& set = lesson.beats[static_cast<std::size_t>(n)].set.views;
        if (!set.empty()) views = &set;
    }
    return std::find(views->begin(), views->end(), view) != views->end();
}

Pointing pointing(const State& state, Prediction::Kind kind) {
    Pointing found;
    const Prediction* asked = prediction_of(state);
    if (asked == nullptr || asked->kind != kind) return found;
    found.asked = true;
    for (const Answer& answer : state.work.answers) {
        if (answer.beat == state.cursor.beat) found.places = answer.places, found.verdict = answer.verdict;
    }
    found.asked = found.verdict == Answer::Verdict::open || found.verdict == Answer::Verdict::wrong;
    return found;
}

namespace {

/// Whether a prediction that `is` so is still open, in this beat or a later one.
[[nodiscard]] bool open_ahead(const State& state, auto&& is) {
    if (!state.document || !state.document->lesson) return false;
    const std::vector<Beat>& beats = state.document->lesson->beats;
    const auto settled = [&](int beat) {
        return std::any_of(state.work.answers.begin(), state.work.answers.end(), [&](const Answer& answer) {
            const bool done = answer.verdict == Answer::Verdict::right || answer.verdict == Answer::Verdict::skipped;
            return answer.beat == beat && done;
        });
    };
    for (int n = state.cursor.beat; n < static_cast<int>(beats.size()); ++n) {
        const auto& asked = beats[static_cast<std::size_t>(n)].prediction;
        if (asked && is(*asked) && !settled(n)) return true;
    }
    return false;
}

}  // namespace

bool pixel_question_ahead(const State& state) {
    return open_ahead(state, [](const Prediction& asked) { return asked.kind == Prediction::Kind::pixel; });
}

bool future_is_secret(const State& state) {
    return open_ahead(state, [](const Prediction& asked) {
        return asked.answer.rfind("hole", 0) == 0 || asked.answer.rfind("indices", 0) == 0;
    });
}

bool may_drag(const State& state, bool texture) {
    if (!state.document || !state.document->lesson) return true;
    const std::string& drag = state.document->lesson->drag;
    return drag.empty() || drag == "vertices" || drag == (texture ? "texture" : "screen");
}

bool hides_corners(const State& state) {
    return state.document && state.document->lesson && state.document->lesson->drag == "none";
}

double sample_offset(const State& state, const Derived& derived) {
    static constexpr std::array<std::string_view, 3> kAtTheCorner{"corners", "whole_pixels", "whole_start"};
    const bool at_corner = std::any_of(kAtTheCorner.begin(), kAtTheCorner.end(), [&](std::string_view id) {
        const int quirk = quirk_index(derived.method(), id);
        return quirk >= 0 && (state.work.quirks >> quirk & 1U) != 0;
    });
    return at_corner ? 0 : kSample;
}

bool is_triangle(const Derived& derived) {
    const int shape = derived.shape();
    return shape >= 0 && derived.method().triangles && derived.drawing().corners(shape).size() == 3;
}

std::string_view stage_name(const Derived& derived) {
    if (derived.shape() < 0) return {};
    const Visit& visit = derived.visit();
    if (visit.path.parts.size() < 2 || visit.path.parts[1].letter != 's') return {};
    const auto index = static_cast<std::size_t>(visit.path.parts[1].index);
    return index < visit.stages.size() ? std::string_view(visit.stages[index].name) : std::string_view{};
}

void move_corner(const ViewContext& ctx, const Handle& handle, glm::vec2 to) {
    if (to != position_of(ctx.derived.scene(), handle))
        ctx.act(action::MoveVertex{handle, to, ctx.ui.memory().presses});
}

void move_by_keys(const ViewContext& ctx, ui::Id control, const Handle& handle) {
    struct Arrow {
        ui::Key key;
        glm::vec2 way;
    };
    static constexpr Arrow kArrows[] = {
        {ui::Key::left, {-1, 0}}, {ui::Key::right, {1, 0}}, {ui::Key::up, {0, -1}}, {ui::Key::down, {0, 1}}};
    // With the mouse's focus the arrows go on stepping.
    if (!ctx.ui.memory().ring) return;
    glm::vec2 to = position_of(ctx.derived.scene(), handle);
    ui::KeyPress press;
    for (const Arrow& arrow : kArrows) {
        while (ctx.ui.take_key(control, arrow.key, &press))
            to += arrow.way * (press.ctrl ? 8.0F : press.shift ? 1.0F / 16 : 1.0F);
    }
    if (to != position_of(ctx.derived.scene(), handle)) ctx.act(action::MoveVertex{handle, to});
}

void tell_hover(const ViewContext& ctx, const ui::Area& area, bool hovered, const Selection& what) {
    if (hovered) {
        if (ctx.state.hover != what) ctx.act(action::Hover{what});
        return;
    }
    // Views drawn earlier in this frame may have said where the mouse is now; leaving comes before.
    const bool left = area.contains(ctx.ui.memory().mouse) && ctx.state.hover.kind == what.kind;
    if (left && what.kind != Selection::Kind::none) ctx.actions.insert(ctx.actions.begin(), action::Hover{});
}

void point_or_pin(const ViewContext& ctx, const Selection& here) {
    const bool pixel = here.kind == Selection::Kind::pixel;
    if (pointing(ctx.state, pixel ? Prediction::Kind::pixel : Prediction::Kind::texel).asked)
        ctx.act(action::Point{here.at});
    else
        ctx.act(action::Pin{here});
}

std::uint64_t version_of(const Grid<Rgba>& pixels) {
    std::uint64_t hash = 0xCBF29CE484222325ULL ^ static_cast<std::uint64_t>(pixels.width());
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        std::uint32_t word = 0;
        std::memcpy(&word, pixels.data() + n, sizeof word);
        hash = (hash ^ word) * 0x100000001B3ULL;
    }
    return hash | 1U;
}

}  // namespace texelscope::canvas
