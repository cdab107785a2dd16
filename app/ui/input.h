// What a person did since the last frame, free of any window library: a test writes it by hand.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace texelscope::ui {

// clang-format off
enum class Key : std::uint8_t {
    none, left, right, up, down, page_up, page_down, home, end, enter, backspace, tab, escape, space, del,
    f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
    a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
    n0, n1, n2, n3, n4, n5, n6, n7, n8, n9, comma, period, slash, minus, equal, left_bracket, right_bracket,
};
// clang-format on

struct KeyPress {
    Key key = Key::none;
    bool ctrl = false, shift = false, alt = false;
    bool repeat = false;  ///< the keyboard's auto-repeat, not a new press
    friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

struct Input {
    glm::vec2 mouse{-1e9F};          ///< position [window px]; far outside where there is none
    std::array<bool, 3> down{};      ///< left, right, middle held at the end of the frame
    std::array<bool, 3> pressed{};   ///< went down in this frame
    std::array<bool, 3> released{};  ///< went up in this frame
    bool double_clicked = false;     ///< the left button's second press in this frame
    bool ctrl = false, shift = false, alt = false;
    glm::vec2 wheel{0};                ///< notches, y up
    std::vector<KeyPress> keys;        ///< in order
    std::vector<Key> held;             ///< keys held at the end of the frame (V and I are held with arrows)
    std::string text;                  ///< UTF-8 typed
    std::string pasted;                ///< the clipboard, where Ctrl+V was pressed
    std::vector<std::string> dropped;  ///< files dropped on the window
    glm::vec2 size{1280, 720};         ///< the window [px]
    double time = 0;                   ///< seconds since the start; tests advance it by hand
};

}  // namespace texelscope::ui
