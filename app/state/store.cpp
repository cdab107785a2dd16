#include "app/state/store.h"

#include "app/state/lesson_cursor.h"

namespace texelscope {
namespace {

constexpr std::size_t kMostEntries = 1000;

/// Whether undo takes this action back.
[[nodiscard]] bool is_edit(const Action& a) {
    return std::holds_alternative<action::MoveVertex>(a) || std::holds_alternative<action::MoveShape>(a) ||
           std::holds_alternative<action::SetDepth>(a) || std::holds_alternative<action::TurnRing>(a) ||
           std::holds_alternative<action::SetQuirks>(a) || std::holds_alternative<action::Turn>(a) ||
           std::holds_alternative<action::SetRatio>(a) || std::holds_alternative<action::SetFocal>(a) ||
           std::holds_alternative<action::SetSizeTwice>(a) || std::holds_alternative<action::SetFrame>(a) ||
           std::holds_alternative<action::SetRandom>(a) || std::holds_alternative<action::SetFormat>(a) ||
           std::holds_alternative<action::SetMode>(a) || std::holds_alternative<action::SetVariant>(a) ||
           std::holds_alternative<action::SetQuirk>(a) || std::holds_alternative<action::SetMethod>(a) ||
           std::holds_alternative<action::SetTexture>(a) || std::holds_alternative<action::Reset>(a) ||
           std::holds_alternative<action::Restore>(a);
}

/// The drag that the action belongs to; 0 for none.
[[nodiscard]] int gesture_of(const Action& action) {
    return std::visit(
        [](const auto& a) {
            if constexpr (requires { a.gesture; })
                return a.gesture;
            else
                return 0;
        },
        action);
}

}  // namespace

void Store::dispatch(const Action& action) {
    if (std::holds_alternative<action::Undo>(action)) return undo(past_, future_);
    if (std::holds_alternative<action::Redo>(action)) return undo(future_, past_);
    if (std::holds_alternative<action::Open>(action)) past_.clear(), future_.clear();

    const int gesture = gesture_of(action);
    Entry before{state_.work, state_.cursor, gesture};
    state_ = reduce(state_, action, derived_);
    if (!is_edit(action) || (before.work == state_.work && before.cursor == state_.cursor)) return;
    future_.clear();
    if (gesture != 0 && !past_.empty() && past_.back().gesture == gesture) return;
    past_.push_back(std::move(before));
    if (past_.size() > kMostEntries) past_.erase(past_.begin());
}

void Store::undo(std::vector<Entry>& from, std::vector<Entry>& to) {
    if (from.empty()) return;
    to.push_back({state_.work, state_.cursor, 0});
    state_.work = std::move(from.back().work);
    state_.cursor = std::move(from.back().cursor);
    state_.message = {};
    if (!same_race(to.back().work, state_.work)) state_.race = {};
    measure_again(state_, to.back().work);
    state_.moving = false;  // or the next frame would be an edit, and there were nothing left to redo
    from.pop_back();
    derived_.update(state_);
}

State opened(std::shared_ptr<const Document> document, const State& before) {
    State state;
    state.look = before.look;
    state.look.hits = state.look.palette = state.look.difference = false;
    state.look.other = {}, state.look.rung.clear(), state.look.skips = kAllSkips;
    state.look.zoom = 0;
    state.done = before.done;
    state.chosen_lesson = before.chosen_lesson;
    state.document = std::move(document);
    Derived derived;
    if (state.document->lesson) {
        go_to_beat(state, 0, derived);
        return state;
    }
    const Method& method = default_method();
    state.work.method = method.id;
    state.work.variant = method.variants.back().id;
    state.work.quirks = method.variants.back().quirks;
    derived.update(state);
    state.cursor.step = derived.steps().first(state.cursor.level).value_or(Path{});
    return state;
}

}  // namespace texelscope
