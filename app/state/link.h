// A state as one line that people copy and paste: "texelscope:1:…", printable, with a check sum.
#pragma once

#include <string>
#include <string_view>

#include "app/state/state.h"
#include "core/base/result.h"

namespace texelscope {

/// What a line says, before the document it names is opened.
struct Link {
    std::string document;
    Work work;  ///< the texture's file, not its texels
    Cursor cursor;
    ComparedRun other;
    bool difference = false;  ///< as of Look
    std::string rung;         ///< the same
    std::uint32_t skips = kAllSkips;
};

/// The lesson, the step, and what the person changed. At most 400 characters for a built-in lesson.
[[nodiscard]] std::string print_link(const State& state);
/// Reads what print_link wrote. Damaged text is an error that says so in one line.
Result<Link> parse_link(std::string_view text);
[[nodiscard]] bool looks_like_link(std::string_view text);
/// A whole line out of its fields: the beginning and the check sum put around them.
[[nodiscard]] std::string with_checksum(std::string_view fields);

}  // namespace texelscope
