#include "app/platform/input_collector.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace texelscope {

void InputCollector::key_down(int code, ui::Key key, bool repeat) {
    if (key == ui::Key::none) return;
    input_.keys.push_back({key, input_.ctrl, input_.shift, input_.alt, repeat});
    if (std::none_of(held_.begin(), held_.end(), [&](const HeldKey& h) { return h.code == code; })) {
        held_.push_back({code, key});
    }
}

void InputCollector::key_up(int code) {
    held_.erase(std::remove_if(held_.begin(), held_.end(), [&](const HeldKey& h) { return h.code == code; }),
                held_.end());
}

void InputCollector::modifiers(bool ctrl, bool shift, bool alt) {
    input_.ctrl = ctrl;
    input_.shift = shift;
    input_.alt = alt;
}

void InputCollector::button(int index, bool down, double time) {
    if (index < 0 || index >= static_cast<int>(input_.down.size())) return;
    const auto i = static_cast<std::size_t>(index);
    if (input_.down[i] == down) return;
    input_.down[i] = down;
    (down ? input_.pressed : input_.released)[i] = true;
    if (index != 0 || !down) return;
    const bool second =
        time - last_press_time_ <= kDoubleClickTime && glm::distance(input_.mouse, last_press_) <= kDoubleClickDistance;
    input_.double_clicked |= second;
    last_press_time_ = second ? -1e9 : time;  // a third press is a first one again
    last_press_ = input_.mouse;
}

void InputCollector::move(glm::vec2 position_px) { input_.mouse = position_px; }

void InputCollector::leave() {
    const bool dragging = std::any_of(input_.down.begin(), input_.down.end(), [](bool down) { return down; });
    if (!dragging) input_.mouse = ui::Input{}.mouse;
}

void InputCollector::wheel(glm::vec2 notches) { input_.wheel += notches; }
void InputCollector::character(char32_t c) { input_.text += utf8_of(c); }
void InputCollector::paste(const std::string& text) { input_.pasted = cut_utf8(text, kMaxPaste); }
void InputCollector::drop(std::string path) { input_.dropped.push_back(std::move(path)); }

ui::Input InputCollector::take(glm::vec2 size_px, double time) {
    ui::Input taken = input_;
    for (const HeldKey& h : held_) taken.held.push_back(h.key);
    taken.size = size_px;
    taken.time = time;
    ui::Input kept;
    kept.mouse = input_.mouse;
    kept.down = input_.down;
    kept.ctrl = input_.ctrl;
    kept.shift = input_.shift;
    kept.alt = input_.alt;
    input_ = std::move(kept);
    return taken;
}

std::string utf8_of(char32_t c) {
    const auto byte = [](char32_t b) { return static_cast<char>(static_cast<unsigned char>(b)); };
    const auto tail = [&](int shift) { return byte(0x80U | ((std::uint32_t{c} >> shift) & 0x3FU)); };
    const auto n = std::uint32_t{c};
    if (n < 0x20 || (n >= 0x7F && n < 0xA0) || (n >= 0xD800 && n < 0xE000) || n > 0x10FFFF) return {};
    if (n < 0x80) return {byte(n)};
    if (n < 0x800) return {byte(0xC0U | n >> 6U), tail(0)};
    if (n < 0x10000) return {byte(0xE0U | n >> 12U), tail(6), tail(0)};
    return {byte(0xF0U | n >> 18U), tail(12), tail(6), tail(0)};
}

std::string cut_utf8(std::string text, std::size_t bytes) {
    if (text.size() <= bytes) return text;
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) --bytes;
    text.resize(bytes);
    return text;
}

}  // namespace texelscope
