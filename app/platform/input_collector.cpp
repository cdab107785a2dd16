#include "app/platform/input_collector.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/geometric.hpp>

namespace texelscope {
namespace {

/// What lasts from a frame to the one after it.
[[nodiscard]] ui::Input next_to(const ui::Input& frame) {
    ui::Input next;
    next.mouse = frame.mouse;
    next.down = frame.down;
    next.ctrl = frame.ctrl;
    next.shift = frame.shift;
    next.alt = frame.alt;
    next.held = frame.held;
    return next;
}

}  // namespace

void InputCollector::key_down(int code, ui::Key key, bool repeat) {
    if (key == ui::Key::none) return;
    const std::vector<ui::KeyPress>& last = frames_.back().keys;
    ui::Input& frame = repeat && !last.empty() && last.back().key == key ? frames_.back() : open_frame();
    frame.keys.push_back({key, frame.ctrl, frame.shift, frame.alt, repeat});
    if (std::any_of(held_.begin(), held_.end(), [&](const HeldKey& h) { return h.code == code; })) return;
    held_.push_back({code, key});
    frame.held.push_back(key);
}

void InputCollector::key_up(int code) {
    const auto of_code = [&](const HeldKey& h) { return h.code == code; };
    if (std::none_of(held_.begin(), held_.end(), of_code)) return;
    held_.erase(std::remove_if(held_.begin(), held_.end(), of_code), held_.end());
    ui::Input& frame = open_frame();
    frame.held.clear();
    for (const HeldKey& h : held_) frame.held.push_back(h.key);
}

void InputCollector::modifiers(bool ctrl, bool shift, bool alt) {
    if (std::array{ctrl, shift, alt} == std::array{frames_.back().ctrl, frames_.back().shift, frames_.back().alt})
        return;
    ui::Input& frame = open_frame();
    frame.ctrl = ctrl;
    frame.shift = shift;
    frame.alt = alt;
}

void InputCollector::button(int index, bool down, double time) {
    if (index < 0 || index >= static_cast<int>(ui::Input{}.down.size())) return;
    const auto i = static_cast<std::size_t>(index);
    if (frames_.back().down[i] == down) return;
    ui::Input& frame = open_frame();
    frame.down[i] = down;
    (down ? frame.pressed : frame.released)[i] = true;
    if (index != 0 || !down) return;
    const bool second =
        time - last_press_time_ <= kDoubleClickTime && glm::distance(frame.mouse, last_press_) <= kDoubleClickDistance;
    frame.double_clicked = second;
    last_press_time_ = second ? -1e9 : time;  // a third press is a first one again
    last_press_ = frame.mouse;
}

void InputCollector::move(glm::vec2 position_px) {
    if (frames_.back().mouse != position_px) open_frame().mouse = position_px;
}

void InputCollector::leave() {
    const auto& down = frames_.back().down;
    if (std::none_of(down.begin(), down.end(), [](bool held) { return held; })) move(ui::Input{}.mouse);
}

void InputCollector::wheel(glm::vec2 notches) { open_frame().wheel += notches; }
// What was typed or pasted by a key belongs to its frame.
void InputCollector::character(char32_t c) { frames_.back().text += utf8_of(c); }
void InputCollector::paste(const std::string& text) { frames_.back().pasted = cut_utf8(text, kMaxPaste); }
void InputCollector::drop(std::string path) { frames_.back().dropped.push_back(std::move(path)); }

ui::Input InputCollector::take(glm::vec2 size_px, double time) {
    if (!waiting()) frames_.push_back(next_to(frames_.front()));
    ui::Input taken = std::move(frames_.front());
    frames_.pop_front();
    taken.size = size_px;
    taken.time = time;
    return taken;
}

/// The frame that the next event belongs to.
ui::Input& InputCollector::open_frame() {
    const ui::Input& last = frames_.back();
    const auto any = [](const auto& turned) { return std::find(turned.begin(), turned.end(), true) != turned.end(); };
    if (!last.keys.empty() || any(last.pressed) || any(last.released)) frames_.push_back(next_to(last));
    return frames_.back();
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
