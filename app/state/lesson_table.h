// The list of lessons: the curriculum's 21, with what the lesson files say where there are some.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/lesson/lesson.h"
#include "app/ui/input.h"

namespace texelscope {

inline constexpr int kCurriculum = 21;

/// A line of the list. Entry n is lesson n + 1 of the curriculum; lessons of other numbers follow.
struct LessonEntry {
    int number = 0;
    std::string title, group, summary;
    const Lesson* lesson = nullptr;  ///< null where this build does not have it
};

/// The lessons must outlive the entries.
[[nodiscard]] std::vector<LessonEntry> lesson_entries(std::span<const Lesson> lessons);

/// The key that opens a lesson once the list is open: 1-9, then a-l. Nothing beyond 21.
[[nodiscard]] std::optional<ui::Key> key_of_lesson(int number);
/// The same for the eye: "1" to "9", "a" to "l", or empty.
[[nodiscard]] std::string key_cap_of_lesson(int number);
[[nodiscard]] std::optional<int> lesson_of_key(ui::Key key);

}  // namespace texelscope
