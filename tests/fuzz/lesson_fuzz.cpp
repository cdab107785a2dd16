// Any text is a lesson or an error of one line with a place, and a lesson that was read can be printed and read again.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "app/lesson/lesson.h"
#include "app/lesson/prose.h"
#include "app/lesson/questions.h"

namespace {

void demand(bool law) {
    if (!law) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace texelscope;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    static_cast<void>(typed_number(text));
    static_cast<void>(visible_length(text));
    const auto lesson = parse_lesson(text, "01-fuzz/lesson.md");
    if (!lesson) {
        demand(lesson.error().where.rfind("01-fuzz/lesson.md:", 0) == 0);
        demand(!lesson.error().what.empty() && lesson.error().what.find('\n') == std::string::npos);
        return 0;
    }
    demand(!lesson->beats.empty() && lesson->beats.size() <= kMaxBeats);
    const std::string printed = print_lesson(*lesson);
    const auto again = parse_lesson(printed, "01-fuzz/lesson.md");
    demand(static_cast<bool>(again));
    demand(print_lesson(*again) == printed);
    return 0;
}
