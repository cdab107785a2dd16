// What the views that show names and formulas share: meanings, tips, and terms that can be hovered, pinned and dragged.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/views/math_of_tape.h"
#include "app/views/view.h"

namespace texelscope {

/// What a traced name means, with its unit: "u's growth per pixel to the right [texels/px]". Empty where unknown.
[[nodiscard]] std::string meaning_of(std::string_view name);
/// For hovering: the symbol, all digits of the value, the number format, the meaning.
[[nodiscard]] std::string tip_of(const Tape& tape, std::int32_t named);
/// The corner that an input such as x_1 or v_2 is a coordinate of; nothing for results.
[[nodiscard]] std::optional<Handle> handle_of(const Drawing& drawing, int shape, const Tape& tape, std::int32_t named);

/// How much a selection lights up a thing in this frame.
enum class Light : std::uint8_t { none, hovered, pinned };
[[nodiscard]] Light light_of_name(const ViewContext& context, std::string_view name);
/// A thin frame, or a thick one; nothing for none.
void draw_light(ui::Ui& ui, const ui::Area& area, Light light);

/// Hover, click and keys on something that stands for a name.
void act_on_name(const ViewContext& context, const ui::Control& control, std::string_view name);

/// A formula whose terms are links: hovering tells, a click pins, and a coordinate of a corner can be dragged.
/// @param name  unique in the frame.
void draw_terms(const ViewContext& context, std::string_view name, const Tape& tape, const ui::MathBox& box,
                glm::vec2 pen);

/// The panel of a view: no title where the tab says it already. @return the place for content.
[[nodiscard]] ui::Area begin_view(const ViewContext& context, std::string_view name, const ui::Area& place,
                                  std::string_view title, std::string_view note = {});
/// A line that says what to do where there is nothing to show.
void draw_empty(const ViewContext& context, const ui::Area& area, std::string_view text);
/// The distance between rows of text in `face` that are `at_100` apart at 100 % [px]; never too little for the letters.
[[nodiscard]] float pitch(const ui::Ui& ui, float at_100, ui::Face face);

/// Tells a scrolling region the height of what it will hold, so that it is right in this very frame.
void foresee(ui::Ui& ui, std::string_view name, float content_height);
/// Moves the region `name` so that [from, to) of its content is to be seen, once for each new `key`.
/// Comes before begin_scroll.
void follow(ui::Ui& ui, std::string_view name, float region_height, float content_height, float from, float to,
            float key);

/// The number of the value at the cursor's step in the tape's names; -1 where there is none.
[[nodiscard]] std::int32_t current_name(const Derived& derived);
/// The last name with this text, up to `last`; -1 where there is none.
[[nodiscard]] std::int32_t find_name(const Tape& tape, std::string_view text, std::int32_t last);

}  // namespace texelscope
