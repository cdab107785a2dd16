// Methods that draw otherwise than they are shown: their steps are those of another method, which they equal.
#pragma once

#include <string_view>

#include "core/method/method.h"

namespace texelscope {

struct Shortcut {
    const Method* method = nullptr;
    std::string_view steps_of;  ///< id of the method whose steps it shows, corrected and in exact numbers
};

/// Null for methods that show what they do.
[[nodiscard]] const Shortcut* shortcut_of(const Method& method);

/// Filled before main; the shortcut must live as long as the program.
struct RegisterShortcut {
    explicit RegisterShortcut(const Shortcut& shortcut);
};

}  // namespace texelscope
