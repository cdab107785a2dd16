#include "app/platform/glfw_keys.h"

#include <GLFW/glfw3.h>

namespace texelscope {
namespace {

using ui::Key;

[[nodiscard]] Key nth(Key first, int n) { return static_cast<Key>(static_cast<int>(first) + n); }

[[nodiscard]] Key key_of_sign(char sign) {
    if (sign >= 'a' && sign <= 'z') return nth(Key::a, sign - 'a');
    if (sign >= 'A' && sign <= 'Z') return nth(Key::a, sign - 'A');
    if (sign >= '0' && sign <= '9') return nth(Key::n0, sign - '0');
    switch (sign) {
        case ',': return Key::comma;
        case '.': return Key::period;
        case '/': return Key::slash;
        case '-': return Key::minus;
        case '=':
        case '+': return Key::equal;
        case '[': return Key::left_bracket;
        case ']': return Key::right_bracket;
        default: return Key::none;
    }
}

/// Keys that print nothing, and those of the number pad.
[[nodiscard]] Key key_of_function(int key) {
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return nth(Key::f1, key - GLFW_KEY_F1);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return nth(Key::n0, key - GLFW_KEY_KP_0);
    switch (key) {
        case GLFW_KEY_LEFT: return Key::left;
        case GLFW_KEY_RIGHT: return Key::right;
        case GLFW_KEY_UP: return Key::up;
        case GLFW_KEY_DOWN: return Key::down;
        case GLFW_KEY_PAGE_UP: return Key::page_up;
        case GLFW_KEY_PAGE_DOWN: return Key::page_down;
        case GLFW_KEY_HOME: return Key::home;
        case GLFW_KEY_END: return Key::end;
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER: return Key::enter;
        case GLFW_KEY_BACKSPACE: return Key::backspace;
        case GLFW_KEY_TAB: return Key::tab;
        case GLFW_KEY_ESCAPE: return Key::escape;
        case GLFW_KEY_SPACE: return Key::space;
        case GLFW_KEY_DELETE: return Key::del;
        case GLFW_KEY_KP_ADD: return Key::equal;
        case GLFW_KEY_KP_SUBTRACT: return Key::minus;
        default: return Key::none;
    }
}

}  // namespace

Key key_from_glfw(int glfw_key, const char* name) {
    if (const Key key = key_of_function(glfw_key); key != Key::none) return key;
    if (name != nullptr && name[0] != '\0' && name[1] == '\0') {
        if (const Key key = key_of_sign(name[0]); key != Key::none) return key;
    }
    // GLFW numbers the printing keys by their ASCII capitals.
    return glfw_key > 0 && glfw_key < 128 ? key_of_sign(static_cast<char>(glfw_key)) : Key::none;
}

}  // namespace texelscope
