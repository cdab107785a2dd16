// What the canvas and its companions ask of a state: traced values by name, the views in use, what may be dragged.
#pragma once

#include <optional>
#include <string_view>

#include "app/views/view.h"

namespace texelscope::canvas {

/// A traced value as the cursor's step knows it; nothing where it has none yet, or is not a number.
[[nodiscard]] std::optional<double> number_of(const Derived& derived, std::string_view name);
[[nodiscard]] std::optional<bool> truth_of(const Derived& derived, std::string_view name);
/// The row of the variables' table; null where there is none of that name.
[[nodiscard]] const Variable* find_variable(const Derived& derived, std::string_view name);

/// Whether the views of the lesson, as its beats left them, name `view`.
[[nodiscard]] bool shows(const State& state, std::string_view view);
/// The answer so far to the current beat's prediction, where it is of that kind; `asked` says whether there is one.
struct Pointing {
    bool asked = false;  ///< a click answers
    std::vector<glm::ivec2> places;
    Answer::Verdict verdict = Answer::Verdict::open;
};
[[nodiscard]] Pointing pointing(const State& state, Prediction::Kind kind);

/// A pixel is asked for, here or later in the lesson, and the answer is still open: nothing may point at it.
[[nodiscard]] bool pixel_question_ahead(const State& state);

/// A hole, or a row's texels, are asked for, here or later: the picture to come would give them away.
[[nodiscard]] bool future_is_secret(const State& state);

/// Whether the lesson lets corners be moved on the screen, or on the texture. Without a lesson both may.
[[nodiscard]] bool may_drag(const State& state, bool texture);
/// Corners are no subject of the lesson: neither handles nor names are drawn.
[[nodiscard]] bool hides_corners(const State& state);
/// Where in its pixel the method samples, along both axes: in the middle, or under some quirks at the top left [px].
[[nodiscard]] double sample_offset(const State& state, const Derived& derived);
/// The cursor's shape is a triangle with sides A, B and C.
[[nodiscard]] bool is_triangle(const Derived& derived);
/// The name of the cursor's stage; empty where it has none.
[[nodiscard]] std::string_view stage_name(const Derived& derived);

/// Moves a corner, as one entry to undo for each drag.
void move_corner(const ViewContext& ctx, const Handle& handle, glm::vec2 to);
/// Arrow keys while a corner has the focus: 1, with Shift 1/16, with Ctrl 8.
void move_by_keys(const ViewContext& ctx, ui::Id control, const Handle& handle);

/// Says that the mouse is over `what`, or has left the view whose hovering was shown. Only where it is news.
void tell_hover(const ViewContext& ctx, const ui::Area& area, bool hovered, const Selection& what);
/// A click on a pixel or a texel: it answers where such a one is asked for, and is pinned elsewhere.
void point_or_pin(const ViewContext& ctx, const Selection& here);

/// Another number for another picture: what a TextureStore wants as the version.
[[nodiscard]] std::uint64_t version_of(const Grid<Rgba>& pixels);

}  // namespace texelscope::canvas
