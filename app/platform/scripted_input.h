// Input written by hand, for tests and for pictures made without a window. Each builder continues from the input of
// the frame before, so that a script is a list of frames.
#pragma once

#include <string>
#include <vector>

#include "app/ui/input.h"

namespace texelscope {

inline constexpr double kScriptedFrame = 1.0 / 60;  ///< how much later the next frame is [s]

/// The next frame, in which nothing happens: what is held stays held.
[[nodiscard]] ui::Input next_frame(const ui::Input& before);

[[nodiscard]] ui::Input move_mouse(const ui::Input& before, glm::vec2 to_px);
/// `key`, pressed and let go within the frame; modifiers hold for this frame only.
[[nodiscard]] ui::Input press_key(const ui::Input& before, ui::KeyPress key);
[[nodiscard]] ui::Input type_text(const ui::Input& before, const std::string& utf8);
[[nodiscard]] ui::Input turn_wheel(const ui::Input& before, glm::vec2 notches);
/// A key held from now on, or let go. Holding it also presses it.
[[nodiscard]] ui::Input hold_key(const ui::Input& before, ui::Key key);
[[nodiscard]] ui::Input release_key(const ui::Input& before, ui::Key key);

/// Pointing, pressing and letting go: a frame each.
[[nodiscard]] std::vector<ui::Input> click(const ui::Input& before, glm::vec2 at_px, int button = 0);
/// Two clicks, the second of which is marked as the double click.
[[nodiscard]] std::vector<ui::Input> double_click(const ui::Input& before, glm::vec2 at_px);
/// Pointing at `from_px`, pressing, moving to `to_px` in `steps` >= 1 equal steps, letting go.
[[nodiscard]] std::vector<ui::Input> drag(const ui::Input& before, glm::vec2 from_px, glm::vec2 to_px, int steps = 4,
                                          int button = 0);

}  // namespace texelscope
