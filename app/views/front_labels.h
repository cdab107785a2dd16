// Names beside the points of the front's picture: none lies over another, a point or a line; points in one place share
// a label.
#pragma once

#include <span>
#include <vector>

#include "app/views/front_axes.h"

namespace texelscope::front {

/// @param lines  what no label may lie over, such as bars.
void draw_labels(ui::Ui& ui, const Axes& axes, std::span<const FrontPoint* const> points,
                 std::span<const ui::Area> lines);

/// Points so close that their labels would fight for the same place: sets of places of which each is within `reach`
/// of another of its set along both axes. @return for each place the number of its set, counted from 0.
[[nodiscard]] std::vector<int> grouped_places(std::span<const glm::vec2> places, glm::vec2 reach);

}  // namespace texelscope::front
