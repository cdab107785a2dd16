// Which keys do what: a table, so that a configuration can change it, and the pure function that reads it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "app/state/action.h"
#include "app/state/derived.h"
#include "app/state/request.h"
#include "app/ui/input.h"

namespace texelscope {

// clang-format off
enum class Command : std::uint8_t {
    step_forward, step_back, advance, go_back, finer, coarser, step_in, finish_unit, play, slower, faster,
    first_step, last_step, go_to, bookmark, previous_bookmark, next_bookmark,
    next_lesson_in_list, previous_lesson_in_list, lesson_column_right, lesson_column_left, open_chosen_lesson,
    move_vertex, turn_solid, move_texture, inspect_pixel, hits, difference, palette, variant, array_passes, plain_code,
    predict,
    undo, redo, reset, save, open_file, export_picture, copy_link, paste, quit,
    present, blank, larger_text, smaller_text, usual_text, theme, lessons, keys, escape,
};
// clang-format on

/// Where a binding counts.
enum class KeyPlace : std::uint8_t { anywhere, lesson_list, presenting };

struct Chord {
    ui::Key key = ui::Key::none;
    bool ctrl = false, shift = false;
    friend bool operator==(const Chord&, const Chord&) = default;
};

struct Binding {
    Chord chord;
    Command command = Command::escape;
    KeyPlace place = KeyPlace::anywhere;
};

/// A line of the list of keys.
struct KeyHelp {
    std::string_view group, keys, what;
};

/// The bindings that the program starts with; those of a place come before those of anywhere.
[[nodiscard]] std::span<const Binding> default_keymap();
/// What people are told about them, group by group.
[[nodiscard]] std::span<const KeyHelp> key_help();

struct KeyOutcome {
    std::vector<Action> actions;
    std::vector<ShellRequest> requests;
};

/// What the frame's keys ask for.
/// @param unused   key presses that no control has used.
/// @param typing   a field is being edited: keys without Ctrl are text, but for Esc and the function keys.
/// @param lessons  those that exist, for the list's arrows.
[[nodiscard]] KeyOutcome actions_for(const ui::Input& input, std::span<const ui::KeyPress> unused, bool typing,
                                     const State& state, const Derived& derived, std::span<const Lesson> lessons,
                                     std::span<const Binding> keymap = default_keymap());

}  // namespace texelscope
