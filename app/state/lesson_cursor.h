// What a lesson's beats ask for.
#pragma once

#include "app/state/derived.h"
#include "app/state/state.h"

namespace texelscope {

/// Puts the state on a beat: the settings of all beats up to it, one after the other, so that it looks the same from
/// whichever side it is reached. Answers and moved corners stay.
void go_to_beat(State& state, int beat, Derived& derived);
[[nodiscard]] int beat_count(const State& state);
/// The beat's prediction; null where it has none.
[[nodiscard]] const Prediction* prediction_of(const State& state);
/// The answer to the current beat's prediction, made where there is none yet.
[[nodiscard]] Answer& answer_here(State& state);
/// The index of the quirk with that id or field; -1 where there is none.
[[nodiscard]] int quirk_index(const Method& method, std::string_view id);
/// The path's own level.
[[nodiscard]] Level level_of(const Path& path);

}  // namespace texelscope
