// Everything that can be wrong with a lesson and that a program can find: `texelscope check`, and the lesson tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace texelscope {

struct LessonCheck {
    std::vector<Error> faults;                    ///< each with FILE:LINE
    int beats = 0, predictions = 0, screens = 0;  ///< how much was looked at
};

/// Reads the lesson and its scene; goes through its beats forward and back; steps, pins and quirks exist and do
/// something; each prediction has an answer; every screen fits, in both sizes, both themes and at every text scale.
/// @param screens  whether to draw them, which takes seconds.
[[nodiscard]] LessonCheck check_lesson(const std::filesystem::path& file, bool screens = true);

}  // namespace texelscope
