// What the command line asks of the window, and the one function that answers it.
#pragma once

#include <optional>
#include <string>

namespace texelscope {

/// Empty texts and absent numbers: as the application has them of itself.
struct WindowRequest {
    std::string target;           ///< LESSON.md, SCENE.json or a state's line
    std::string lesson;           ///< a lesson's id; never beside a target
    std::string step;             ///< a step's path, of the form that parse_path reads
    bool present = false;         ///< for a projector
    std::optional<double> scale;  ///< of all sizes on the screen [0.5, 4]
    std::string theme;            ///< "dark" or "light"
};

/// Opens the window and runs until it is closed.
/// @return  the exit code; on failure it has said why in one line on stderr.
[[nodiscard]] int open_window(const WindowRequest& request);

}  // namespace texelscope
