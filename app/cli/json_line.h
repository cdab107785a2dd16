// Writes one JSON object, member by member, on one line.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace texelscope {

/// A JSON string, quotes included.
[[nodiscard]] std::string json_text(std::string_view text);
/// A number as text, in quotes where JSON has no such number: "3/7", "nan", "inf".
[[nodiscard]] std::string json_number(std::string_view text);

class JsonLine {
public:
    /// `value` is JSON already: a number, true, a list.
    JsonLine& raw(std::string_view key, std::string_view value);
    JsonLine& text(std::string_view key, std::string_view value) { return raw(key, json_text(value)); }
    JsonLine& number(std::string_view key, std::integral auto value) { return raw(key, std::to_string(value)); }
    /// "{…}", without an end of line.
    [[nodiscard]] std::string line() const { return "{" + members_ + "}"; }

private:
    std::string members_;
};

}  // namespace texelscope
