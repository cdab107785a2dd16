// What a person asked for that only the shell can do, because it touches files or the clipboard.
#pragma once

#include <cstdint>

namespace texelscope {

struct ShellRequest {
    enum class What : std::uint8_t { open_lesson, open_file, save, export_picture, copy_link, paste, quit };
    What what = What::open_lesson;
    int lesson = 0;  ///< its number, of open_lesson; may be one that this build does not have
    friend bool operator==(const ShellRequest&, const ShellRequest&) = default;
};

}  // namespace texelscope
