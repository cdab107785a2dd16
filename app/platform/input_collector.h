// Gathers single events, as a window delivers them, into the ui::Input of a frame. Knows no window library.
// A frame has one turn at most, a key or a button going down or up, and ends with it: what follows belongs to the next
// frame, so that however slow a frame is, a press acts where and on what it was made.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/ui/input.h"

namespace texelscope {

class InputCollector {
public:
    static constexpr double kDoubleClickTime = 0.4;      ///< between the two presses, at most [s]
    static constexpr float kDoubleClickDistance = 6;     ///< [px]
    static constexpr std::size_t kMaxPaste = 1U << 20U;  ///< longer clipboards are cut, at a character [byte]

    /// A key went down, or repeats itself, or went up. `code` is the physical key's number: a key that was pressed as
    /// one letter is let go as the same one, whatever the layout has become. `key` is ignored where it goes up.
    /// Repeats of one key share a frame.
    void key_down(int code, ui::Key key, bool repeat);
    void key_up(int code);
    /// Those of the events that follow.
    void modifiers(bool ctrl, bool shift, bool alt);
    /// @param index  0 left, 1 right, 2 middle; others are ignored.
    /// @param time   seconds, of the same clock as Input::time.
    void button(int index, bool down, double time);
    void move(glm::vec2 position_px);
    /// The pointer left the window. A drag that goes on outside keeps its last position.
    void leave();
    void wheel(glm::vec2 notches);
    /// One code point that was typed; what is no character is ignored.
    void character(char32_t c);
    void paste(const std::string& text);
    void drop(std::string path);

    /// The next frame's input.
    [[nodiscard]] ui::Input take(glm::vec2 size_px, double time);
    /// Whether events are left for frames after the next.
    [[nodiscard]] bool waiting() const { return frames_.size() > 1; }

private:
    struct HeldKey {
        int code = 0;
        ui::Key key = ui::Key::none;
    };
    [[nodiscard]] ui::Input& open_frame();

    std::deque<ui::Input> frames_{ui::Input{}};  ///< never empty; the last one is still open
    std::vector<HeldKey> held_;
    double last_press_time_ = -1e9;
    glm::vec2 last_press_{-1e9F};
};

/// `c` in UTF-8; empty where it is a control character, a surrogate or beyond Unicode.
[[nodiscard]] std::string utf8_of(char32_t c);

/// The longest part from the start that has at most `bytes` bytes and does not end within a character.
[[nodiscard]] std::string cut_utf8(std::string text, std::size_t bytes);

}  // namespace texelscope
