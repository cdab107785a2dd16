// What a lesson's text may hold, and how long it looks.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace texelscope {

/// Why `prose` cannot be shown: mathematics that ui::parse_math does not read. Nothing where all is well.
[[nodiscard]] std::optional<std::string> fault_of_prose(std::string_view prose);
/// The same of what stands between two dollar signs.
[[nodiscard]] std::optional<std::string> fault_of_math(std::string_view math);

/// Letters that are seen: marks are left out, a command such as \Delta is one, subscripts count.
[[nodiscard]] int visible_length(std::string_view prose);

/// The position of the first byte that is neither UTF-8 nor a line break, or a control character; npos if there is
/// none.
[[nodiscard]] std::size_t unreadable_at(std::string_view text);

}  // namespace texelscope
