// The parts that draw_screen puts together; each draws into its place and pushes actions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/state/lesson_table.h"
#include "app/views/layout.h"
#include "app/views/view.h"

namespace texelscope {

/// Number, title, where the cursor stands, levels, number format, variant, and the buttons for the look.
void draw_header(const ViewContext& context, const ui::Area& place);
/// The lists that the header's buttons open, over what lies below. Drawn after the panels.
void draw_header_list(const ViewContext& context, const ScreenLayout& layout);
/// Where the button of a number format, or of the variant, stands: its list opens below it.
[[nodiscard]] ui::Area header_button(const ui::Ui& ui, const ui::Area& header, Overlay of);

/// An id for people: "as-printed" is "as printed".
[[nodiscard]] std::string spaced(std::string_view id);

/// One part of the way to the cursor: "row", "11".
struct Crumb {
    std::string what, value;
    Path path;  ///< of the unit
};
[[nodiscard]] std::vector<Crumb> crumbs(const State& state, const Derived& derived);

void draw_timeline(const ViewContext& context, const ui::Area& place);
/// "pixel of the box" and "284 of 540".
struct Position {
    std::string unit, count;
};
[[nodiscard]] Position position_of_cursor(const State& state, const Derived& derived);

void draw_lesson_panel(const ViewContext& context, const ui::Area& place);
void draw_lesson_list(const ViewContext& context, const ui::Area& place, std::span<const LessonEntry> entries);
/// What the lesson chosen in the list is about.
void draw_lesson_summary(const ViewContext& context, const ui::Area& place, std::span<const LessonEntry> entries);
/// A small drawing for a lesson of the curriculum; other numbers have a plain square.
void draw_lesson_icon(ui::Ui& ui, int number, const ui::Area& place, bool muted);
void draw_keys_panel(const ViewContext& context, const ui::Area& place);

void draw_presenter_header(const ViewContext& context, const ui::Area& place);
void draw_caption(const ViewContext& context, const ui::Area& place);
void draw_presenter_timeline(const ViewContext& context, const ui::Area& place);

/// One line over the canvas' lower border; nothing where there is no message.
void draw_message(const ViewContext& context, const ui::Area& canvas);

/// The five lanes alone, as one target: press and drag step to the child under the mouse.
struct LaneStyle {
    bool labels = true;
    float pitch = 17;
};
void draw_lanes(const ViewContext& context, const ui::Area& place, const LaneStyle& style);
/// Where lane `n` of `place` stands.
[[nodiscard]] ui::Area lane_place(const ui::Area& place, float pitch, int n);

}  // namespace texelscope
