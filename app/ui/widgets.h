// The controls that views are made of. Each is drawn in its place and reports what was done to it in this frame.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/ui/ui.h"

namespace texelscope::ui {

struct ButtonStyle {
    Face face = Face::title;
    bool chosen = false;  ///< filled with `now`
    bool enabled = true;
    bool quiet = false;  ///< no ground or border until hovered
    Kind kind = Kind::button;
};

/// @param label  one line; may hold $mathematics$.
Control button(Ui& ui, std::string_view name, const Area& area, std::string_view label, std::string_view tip = {},
               const ButtonStyle& style = {});
Control icon_button(Ui& ui, std::string_view name, const Area& area, Icon icon, std::string_view label,
                    std::string_view tip = {}, const ButtonStyle& style = {});
/// A button that stays down; clicked means: turn it over.
Control toggle(Ui& ui, std::string_view name, const Area& area, std::string_view label, bool on,
               std::string_view tip = {}, bool enabled = true);
/// Width that a button's label asks for.
[[nodiscard]] float button_width(const Ui& ui, std::string_view label, Face face = Face::title);

/// One of several, side by side in one frame; equally wide. Each is the control "name/index".
/// @return the index that was chosen in this frame.
std::optional<int> segments(Ui& ui, std::string_view name, const Area& area, std::span<const std::string_view> labels,
                            int chosen, std::span<const std::string_view> tips = {}, Face face = Face::code_note);
/// A strip of tabs over a hairline, the chosen one underlined; as wide as their labels, or equally where short of room.
std::optional<int> tabs(Ui& ui, std::string_view name, const Area& area, std::span<const std::string_view> labels,
                        int chosen);

struct SliderRange {
    double low = 0, high = 1, step = 0.01;  ///< Left and Right move a step, with Shift 1/16, with Ctrl ten
};
/// @return the new value, where it changed.
std::optional<double> slider(Ui& ui, std::string_view name, const Area& area, double value, const SliderRange& range,
                             std::string_view label, std::string_view tip = {});

struct FieldResult {
    bool editing = false;
    bool committed = false;  ///< by Enter; by Tab or a click elsewhere where `text` differs from `value`
    bool cancelled = false;  ///< Esc
    std::string text;        ///< what stands in the field now
};
/// One line of text. Editing begins with the focus; Left, Right, Home, End, Backspace, Delete and paste work.
FieldResult field(Ui& ui, std::string_view name, const Area& area, std::string_view value, std::string_view hint = {},
                  std::string_view tip = {}, Face face = Face::code);

enum class BadgeLook : std::uint8_t {
    plate,     ///< on the raise colour, bordered: coordinates, keys
    filled,    ///< on `now`
    outlined,  ///< `now` border
};
/// Text on a small plate; `left_middle` is the middle of its left side. @return its place.
Area badge(Ui& ui, Face face, glm::vec2 left_middle, std::string_view s, BadgeLook look = BadgeLook::plate);
/// A row's bar and tint: the current line of code, the changed variable, the open lesson.
void current_row(Ui& ui, const Area& area);
void hairline(Ui& ui, glm::vec2 from, float length, bool vertical = false);
/// Outlined minus, or filled plus, in an edge's colour.
void sign_badge(Ui& ui, int edge, bool positive, const Area& area);

}  // namespace texelscope::ui
