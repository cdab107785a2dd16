#include "core/scene/scene_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace texelscope {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hex_digit(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

template <class Is>
std::size_t skip(std::string_view& text, Is is) {
    std::size_t count = 0;
    while (count < text.size() && is(text[count])) ++count;
    text.remove_prefix(count);
    return count;
}

bool skip_one(std::string_view& text, std::string_view of) {
    const bool found = !text.empty() && of.find(text.front()) != of.npos;
    if (found) text.remove_prefix(1);
    return found;
}

/// [sign] 0x digits [. digits] [p [sign] digits]
bool is_hexadecimal(std::string_view text) {
    skip_one(text, "+-");
    if (!skip_one(text, "0") || !skip_one(text, "xX")) return false;
    std::size_t digits = skip(text, is_hex_digit);
    if (skip_one(text, ".")) digits += skip(text, is_hex_digit);
    if (digits == 0) return false;
    if (skip_one(text, "pP")) {
        skip_one(text, "+-");
        if (skip(text, is_digit) == 0) return false;
    }
    return text.empty();
}

/// The value as a message shows it.
std::string shown(const JsonValue& value) {
    if (value.kind() == JsonKind::text) return in_quotes(value.text());
    if (value.kind() == JsonKind::number) return fmt::format("{}", value.number());
    if (value.kind() == JsonKind::boolean) return value.boolean() ? "true" : "false";
    if (value.kind() == JsonKind::array) return fmt::format("a list of {}", value.size());
    return std::string(json_kind_name(value.kind()));
}

}  // namespace

std::optional<float> number_of_text(std::string_view text) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    if (text == "nan") return std::numeric_limits<float>::quiet_NaN();
    if (text == "inf") return kInfinity;
    if (text == "-inf") return -kInfinity;
    if (!is_hexadecimal(text)) return std::nullopt;
    return std::strtof(std::string(text).c_str(), nullptr);
}

void ValueReader::wrong(const JsonValue& value, std::string_view what, std::string_view expected) {
    fail(value.line(), fmt::format("{} is {}, expected {}", what, shown(value), expected));
}

int ValueReader::whole(const JsonValue& value, std::string_view what, int low, int high) {
    if (value.kind() == JsonKind::number) {
        const double number = value.number();
        if (number >= low && number <= high && number == std::floor(number)) return static_cast<int>(number);
    }
    wrong(value, what, fmt::format("a whole number from {} to {}", low, high));
    return low;
}

float ValueReader::number(const JsonValue& value, std::string_view what) {
    if (value.kind() == JsonKind::number) return static_cast<float>(value.number());
    if (value.kind() == JsonKind::text)
        if (const std::optional<float> number = number_of_text(value.text())) return *number;
    wrong(value, what, "a number, a text such as \"0x1.8p+1\", or \"inf\", \"-inf\", \"nan\"");
    return 0;
}

float ValueReader::number_within(const JsonValue& value, std::string_view what, float low, float high) {
    const float read = number(value, what);
    if (read >= low && read <= high) return read;
    wrong(value, what, fmt::format("a number from {:g} to {:g}", low, high));
    return low;
}

std::string_view ValueReader::text(const JsonValue& value, std::string_view what) {
    if (value.kind() == JsonKind::text) return value.text();
    wrong(value, what, "a text");
    return {};
}

}  // namespace texelscope
