// GLFW's keys as ours.
#pragma once

#include "app/ui/input.h"

namespace texelscope {

/// @param glfw_key  GLFW_KEY_...: the key by its place on an American keyboard.
/// @param name      what the person's layout prints on it (glfwGetKeyName); null where it prints nothing.
/// @return          the letter, digit or sign that the layout gives it where we know that one, so that shortcuts are
///                  where their letters are; else the key of its place, which serves Cyrillic and Greek layouts;
///                  Key::none for keys that we do not use.
[[nodiscard]] ui::Key key_from_glfw(int glfw_key, const char* name);

}  // namespace texelscope
