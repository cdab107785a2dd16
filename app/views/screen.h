// The whole screen: which panel stands where, and what each shows.
#pragma once

#include <string_view>
#include <vector>

#include "app/views/layout.h"
#include "app/views/view.h"

namespace texelscope {

/// Draws everything that `context.state` says and appends what was done to `context.actions`.
void draw_screen(const ViewContext& context);

/// What the layout depends on besides the window.
[[nodiscard]] ScreenLayout layout_of(const State& state, glm::vec2 window);
/// The views of the side, for the small, the wide and the large place: the beat's, else the lesson's, else the usual.
/// The last of them gives way to the difference where that was asked for.
[[nodiscard]] std::vector<std::string_view> side_views(const State& state);

}  // namespace texelscope
