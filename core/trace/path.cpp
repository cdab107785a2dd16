#include "core/trace/path.h"

#include <array>

namespace texelscope {
namespace {

constexpr std::array<std::string_view, kLevels> kLevelIds{"triangle", "stage", "scanline", "pixel", "expression"};
constexpr std::size_t kMaxParts = 8, kMaxDigits = 12;

/// A whole number with at most kMaxDigits digits, moving `text` behind it.
std::optional<Integer> take_integer(std::string_view& text) {
    const bool negative = !text.empty() && text.front() == '-';
    if (negative) text.remove_prefix(1);
    std::size_t digits = 0;
    Integer value = 0;
    for (; digits < text.size() && text[digits] >= '0' && text[digits] <= '9'; ++digits) {
        if (digits == kMaxDigits) return std::nullopt;
        value = value * 10 + (text[digits] - '0');
    }
    if (digits == 0) return std::nullopt;
    text.remove_prefix(digits);
    return negative ? -value : value;
}

}  // namespace

std::string_view id_of(Level level) { return kLevelIds[static_cast<std::size_t>(level)]; }

std::optional<Level> level_from(std::string_view id) {
    for (std::size_t n = 0; n < kLevelIds.size(); ++n) {
        if (kLevelIds[n] == id) return static_cast<Level>(n);
    }
    return std::nullopt;
}

std::string Path::text() const {
    std::string text;
    for (const PathPart& part : parts) {
        if (!text.empty()) text += '/';
        text += part.letter;
        text += std::to_string(part.index);
    }
    return text;
}

std::optional<Path> parse_path(std::string_view text) {
    Path path;
    while (!text.empty() && path.parts.size() < kMaxParts) {
        const char letter = text.front();
        if (letter < 'a' || letter > 'z') return std::nullopt;
        text.remove_prefix(1);
        const std::size_t depth = path.parts.size();
        if ((depth == 0 && letter != 't') || (depth == 1 && letter != 's') || path.at_expression()) return std::nullopt;
        const std::optional<Integer> index = take_integer(text);
        if (!index) return std::nullopt;
        path.parts.push_back({letter, *index});
        if (text.empty()) return path;
        if (text.front() != '/') return std::nullopt;
        text.remove_prefix(1);
    }
    return std::nullopt;
}

}  // namespace texelscope
