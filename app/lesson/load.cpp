// Lessons from files.
#include <algorithm>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "app/lesson/lesson.h"
#include "core/base/file.h"

namespace texelscope {

namespace fs = std::filesystem;

Result<Lesson> load_lesson(const fs::path& file, std::span<const std::string_view> view_names) {
    const auto text = read_file(file, kMaxLessonBytes);
    if (!text) return text.error();
    return parse_lesson(*text, file, view_names);
}

std::vector<Lesson> load_lessons(const fs::path& lessons, std::vector<Error>& errors,
                                 std::span<const std::string_view> view_names) {
    std::error_code fault;
    std::set<fs::path> folders;
    fs::directory_iterator at(lessons, fault);
    for (; !fault && at != fs::directory_iterator() && folders.size() < kMaxLessons; at.increment(fault)) {
        if (fs::exists(at->path() / "lesson.md", fault)) folders.insert(at->path());
        fault.clear();
    }
    if (fault) errors.push_back({lessons.string(), "cannot be read: " + fault.message()});
    std::vector<Lesson> found;
    for (const fs::path& folder : folders) {
        auto lesson = load_lesson(folder / "lesson.md", view_names);
        if (lesson)
            found.push_back(*std::move(lesson));
        else
            errors.push_back(lesson.error());
    }
    std::stable_sort(found.begin(), found.end(), [](const Lesson& a, const Lesson& b) {
        const auto key = [](const Lesson& lesson) { return lesson.number == 0 ? 100 : lesson.number; };
        return key(a) < key(b);
    });
    for (std::size_t n = 1; n < found.size();) {
        if (found[n].number == 0 || found[n].number != found[n - 1].number) {
            ++n;
            continue;
        }
        errors.push_back({found[n].file.string() + ":1", fmt::format("has the number of {}", found[n - 1].id)});
        found.erase(found.begin() + static_cast<std::ptrdiff_t>(n));
    }
    return found;
}

}  // namespace texelscope
