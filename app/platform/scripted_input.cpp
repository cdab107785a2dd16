#include "app/platform/scripted_input.h"

#include <algorithm>

namespace texelscope {
namespace {

[[nodiscard]] ui::Input set_button(const ui::Input& before, int button, bool down) {
    ui::Input input = next_frame(before);
    const auto i = static_cast<std::size_t>(button);
    input.down.at(i) = down;
    (down ? input.pressed : input.released).at(i) = true;
    return input;
}

}  // namespace

ui::Input next_frame(const ui::Input& before) {
    ui::Input input;
    input.mouse = before.mouse;
    input.down = before.down;
    input.held = before.held;
    input.size = before.size;
    input.time = before.time + kScriptedFrame;
    return input;
}

ui::Input move_mouse(const ui::Input& before, glm::vec2 to_px) {
    ui::Input input = next_frame(before);
    input.mouse = to_px;
    return input;
}

ui::Input press_key(const ui::Input& before, ui::KeyPress key) {
    ui::Input input = next_frame(before);
    input.keys = {key};
    input.ctrl = key.ctrl;
    input.shift = key.shift;
    input.alt = key.alt;
    return input;
}

ui::Input type_text(const ui::Input& before, const std::string& utf8) {
    ui::Input input = next_frame(before);
    input.text = utf8;
    return input;
}

ui::Input turn_wheel(const ui::Input& before, glm::vec2 notches) {
    ui::Input input = next_frame(before);
    input.wheel = notches;
    return input;
}

ui::Input hold_key(const ui::Input& before, ui::Key key) {
    ui::Input input = next_frame(before);
    input.keys = {{key}};
    input.held.push_back(key);
    return input;
}

ui::Input release_key(const ui::Input& before, ui::Key key) {
    ui::Input input = next_frame(before);
    input.held.erase(std::remove(input.held.begin(), input.held.end(), key), input.held.end());
    return input;
}

std::vector<ui::Input> click(const ui::Input& before, glm::vec2 at_px, int button) {
    std::vector<ui::Input> frames{move_mouse(before, at_px)};
    frames.push_back(set_button(frames.back(), button, true));
    frames.push_back(set_button(frames.back(), button, false));
    return frames;
}

std::vector<ui::Input> double_click(const ui::Input& before, glm::vec2 at_px) {
    std::vector<ui::Input> frames = click(before, at_px);
    frames.push_back(set_button(frames.back(), 0, true));
    frames.back().double_clicked = true;
    frames.push_back(set_button(frames.back(), 0, false));
    return frames;
}

std::vector<ui::Input> drag(const ui::Input& before, glm::vec2 from_px, glm::vec2 to_px, int steps, int button) {
    std::vector<ui::Input> frames{move_mouse(before, from_px)};
    frames.push_back(set_button(frames.back(), button, true));
    for (int i = 1; i <= steps; ++i) {
        const float part = static_cast<float>(i) / static_cast<float>(steps);
        frames.push_back(move_mouse(frames.back(), from_px + (to_px - from_px) * part));
    }
    frames.push_back(set_button(frames.back(), button, false));
    return frames;
}

}  // namespace texelscope
