// Rows of controls that change the scene: a name, a slider, its value.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/ui/widgets.h"
#include "app/views/view.h"

namespace texelscope {

/// Height of a row at the text's scale [px]; a target of at least 24.
[[nodiscard]] float tuning_height(const ui::Ui& ui);

struct Tuning {
    std::string_view name;   ///< of the control
    std::string_view label;  ///< may hold $mathematics$
    std::string value;       ///< as text
    std::string_view tip = {};
};
/// @return the new value, where it changed.
std::optional<double> draw_tuning(ui::Ui& ui, const ui::Area& row, const Tuning& what, double value,
                                  const ui::SliderRange& range);

/// Sliders for the turn of the cursor's shape and, with `scale`, its size, side by side in `row`. They move all of its
/// corners at once, as one entry to undo for each drag. Nothing where the lesson lets no corner be moved.
void draw_pose_tuning(const ViewContext& context, const ui::Area& row, bool scale);
[[nodiscard]] bool has_pose_tuning(const ViewContext& context);

/// A slider for the depth of the chosen corner, or else the first one of the cursor's polygon, and a button that cuts
/// the polygon along another diagonal. Nothing where the lesson lets no corner be moved, or it is a solid's.
void draw_depth_tuning(const ViewContext& context, const ui::Area& row);
[[nodiscard]] bool has_depth_tuning(const ViewContext& context);

}  // namespace texelscope
