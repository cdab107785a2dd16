#include "app/ui/sfnt.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace texelscope::ui {
namespace {

using Bytes = std::span<const unsigned char>;

int u16(Bytes b, std::size_t at) { return at + 2 <= b.size() ? b[at] << 8 | b[at + 1] : 0; }
int i16(Bytes b, std::size_t at) { return static_cast<std::int16_t>(u16(b, at)); }
std::size_t u32(Bytes b, std::size_t at) {
    return static_cast<std::size_t>(u16(b, at)) << 16U | static_cast<std::size_t>(u16(b, at + 2));
}

/// The table called `tag`; empty where there is none within the file.
Bytes table(Bytes file, std::string_view tag) {
    const auto count = static_cast<std::size_t>(u16(file, 4));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t entry = 12 + 16 * i;
        if (entry + 16 > file.size()) return {};
        if (std::string_view(reinterpret_cast<const char*>(&file[entry]), 4) != tag) continue;
        const std::size_t from = u32(file, entry + 8), length = u32(file, entry + 12);
        return from <= file.size() && length <= file.size() - from ? file.subspan(from, length) : Bytes{};
    }
    return {};
}

}  // namespace

Result<FontMetrics> read_font_metrics(Bytes file) {
    const std::size_t version = u32(file, 0);
    if (version != 0x00010000 && version != 0x4F54544F) return Error{"", "not a TrueType or OpenType font"};
    const Bytes head = table(file, "head"), hhea = table(file, "hhea"), os2 = table(file, "OS/2");
    const auto em = static_cast<float>(u16(head, 18));
    const auto ascent = static_cast<float>(i16(hhea, 4)), descent = static_cast<float>(-i16(hhea, 6));
    const bool has_outlines = !table(file, "CFF ").empty() || !table(file, "glyf").empty();
    if (em < 16 || ascent + descent <= 0 || table(file, "cmap").empty() || !has_outlines)
        return Error{"", "the font has no outlines or no metrics"};
    const auto or_else = [em](int units, float fallback) {
        return units > 0 ? static_cast<float>(units) / em : fallback;
    };
    return FontMetrics{ascent / em, descent / em, or_else(i16(os2, 88), 0.70F), or_else(i16(os2, 86), 0.48F)};
}

}  // namespace texelscope::ui
