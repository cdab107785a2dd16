// Gathers single events, as a window delivers them, into the ui::Input of a frame. Knows no window library.
#pragma once

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
    void key_down(int code, ui::Key key, bool repeat);
    void key_up(int code);
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

    /// The input since the last call.
    [[nodiscard]] ui::Input take(glm::vec2 size_px, double time);

private:
    struct HeldKey {
        int code = 0;
        ui::Key key = ui::Key::none;
    };
    ui::Input input_;
    std::vector<HeldKey> held_;
    double last_press_time_ = -1e9;
    glm::vec2 last_press_{-1e9F};
};

/// `c` in UTF-8; empty where it is a control character, a surrogate or beyond Unicode.
[[nodiscard]] std::string utf8_of(char32_t c);

/// The longest part from the start that has at most `bytes` bytes and does not end within a character.
[[nodiscard]] std::string cut_utf8(std::string text, std::size_t bytes);

}  // namespace texelscope
