#include "app/lesson/prose.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "app/ui/math.h"
#include "app/ui/prose.h"

namespace texelscope {
namespace {

[[nodiscard]] bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
[[nodiscard]] bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

[[nodiscard]] int length_of_math(std::string_view math) {
    int length = 0;
    for (std::size_t at = 0; at < math.size();) {
        const char c = math[at++];
        if (c == '\\') {
            while (at < math.size() && is_letter(math[at])) ++at;
            ++length;
        } else if (std::string_view(" _{}").find(c) == std::string_view::npos && !continues(c)) {
            ++length;
        }
    }
    return length;
}

/// Bytes of the UTF-8 character at `at`, 0 where there is none.
[[nodiscard]] std::size_t character_at(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t n) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + n]));
    };
    const std::uint32_t first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t size = first >= 0xF0 && first < 0xF5   ? 4
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xC2 && first < 0xE0 ? 2
                                                             : 0;
    if (size == 0 || at + size > text.size()) return 0;
    std::uint32_t point = first & (0x7FU >> size);
    for (std::size_t n = 1; n < size; ++n) {
        if (!continues(text[at + n])) return 0;
        point = point << 6 | (byte(n) & 0x3FU);
    }
    const bool shortest = point >= (size == 4 ? 0x10000U : size == 3 ? 0x800U : 0x80U);
    return shortest && point <= 0x10FFFF && (point < 0xD800 || point > 0xDFFF) && point >= 0xA0 ? size : 0;
}

}  // namespace

std::optional<std::string> fault_of_math(std::string_view math) {
    const auto read = ui::parse_math(math);
    if (read) return std::nullopt;
    return fmt::format("the mathematics ${}$ cannot be read: {}", math, read.error().text());
}

std::optional<std::string> fault_of_prose(std::string_view prose) {
    std::ptrdiff_t dollars = 0, escaped = 0;
    for (const ui::Span& span : ui::spans_of(prose)) {
        if (span.kind == ui::Span::Kind::text) dollars += std::count(span.text.begin(), span.text.end(), '$');
        if (span.kind != ui::Span::Kind::math) continue;
        if (auto fault = fault_of_math(span.text)) return fault;
    }
    for (std::size_t at = prose.find("\\$"); at != prose.npos; at = prose.find("\\$", at + 2)) ++escaped;
    if (dollars > escaped) return "a $ without its partner; \\$ is the character itself";
    return std::nullopt;
}

int visible_length(std::string_view prose) {
    int length = 0;
    for (const ui::Span& span : ui::spans_of(prose)) {
        if (span.kind == ui::Span::Kind::math) {
            length += length_of_math(span.text);
            continue;
        }
        for (const char c : span.text) length += !continues(c);
    }
    return length;
}

std::size_t unreadable_at(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const auto c = static_cast<unsigned char>(text[at]);
        const std::size_t size = (c < 0x20 && c != '\n' && c != '\t') || c == 0x7F ? 0 : character_at(text, at);
        if (size == 0) return at;
        at += size;
    }
    return std::string_view::npos;
}

}  // namespace texelscope
