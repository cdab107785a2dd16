#include "app/ui/text.h"

#include <cmath>

namespace texelscope::ui {
namespace {

const ImFontGlyph* glyph_of(const Font& font, char32_t c) {
    return font.im->FindGlyph(c > 0xFFFF ? ImWchar{0xFFFD} : static_cast<ImWchar>(c));
}

bool is_continuation(unsigned char c) { return (c & 0xC0U) == 0x80U; }

}  // namespace

char32_t next_code_point(std::string_view text, std::size_t& at) {
    static constexpr char32_t kBad = 0xFFFD;
    const auto first = static_cast<unsigned char>(text[at++]);
    if (first < 0x80) return first;
    const int more = first >= 0xF0 && first < 0xF5 ? 3 : first >= 0xE0 ? 2 : first >= 0xC2 ? 1 : 0;
    if (more == 0 || first >= 0xF5 || at + static_cast<std::size_t>(more) > text.size()) return kBad;
    char32_t c = first & (0x3FU >> static_cast<unsigned>(more));
    for (int i = 0; i < more; ++i) {
        const auto byte = static_cast<unsigned char>(text[at + static_cast<std::size_t>(i)]);
        if (!is_continuation(byte)) return kBad;
        c = c << 6U | (byte & 0x3FU);
    }
    at += static_cast<std::size_t>(more);
    const bool overlong = (more == 2 && c < 0x800) || (more == 3 && c < 0x10000);
    return overlong || c > 0x10FFFF || (c >= 0xD800 && c < 0xE000) ? kBad : c;
}

std::size_t previous_code_point(std::string_view text, std::size_t at) {
    if (at == 0) return 0;
    --at;
    while (at > 0 && is_continuation(static_cast<unsigned char>(text[at]))) --at;
    return at;
}

float text_width(const Font& font, std::string_view text) {
    float width = 0;
    for (std::size_t at = 0; at < text.size();) width += glyph_of(font, next_code_point(text, at))->AdvanceX;
    return width;
}

std::string elided(const Font& font, std::string_view text, float width) {
    if (text_width(font, text) <= width) return std::string(text);
    float room = width - text_width(font, kEllipsis);
    if (room < 0) return {};
    std::size_t at = 0, kept = 0;
    while (at < text.size()) {
        room -= glyph_of(font, next_code_point(text, at))->AdvanceX;
        if (room < 0) break;
        kept = at;
    }
    while (kept > 0 && text[kept - 1] == ' ') --kept;
    return std::string(text.substr(0, kept)) + std::string(kEllipsis);
}

std::size_t line_break(const Font& font, std::string_view text, float width) {
    std::size_t at = 0, after_space = 0;
    float used = 0;
    while (at < text.size()) {
        const std::size_t from = at;
        const char32_t c = next_code_point(text, at);
        if (c == '\n') return at;
        if (c == ' ') {
            after_space = at;
        } else if (used + glyph_of(font, c)->AdvanceX > width && from > 0) {
            return after_space > 0 ? after_space : from;
        }
        used += glyph_of(font, c)->AdvanceX;
    }
    return text.size();
}

std::vector<std::string_view> wrapped(const Font& font, std::string_view text, float width) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t n = line_break(font, text, width);
        std::string_view line = text.substr(0, n);
        while (!line.empty() && (line.back() == ' ' || line.back() == '\n')) line.remove_suffix(1);
        lines.push_back(line);
        text.remove_prefix(n);
    }
    return lines;
}

float draw_text(ImDrawList& list, const Font& font, glm::vec2 pen, Color color, std::string_view text) {
    const float top = std::round(pen.y) - font.baseline;
    float x = pen.x;
    for (std::size_t at = 0; at < text.size();) {
        const ImFontGlyph* glyph = glyph_of(font, next_code_point(text, at));
        if (glyph->Visible != 0) {
            list.PrimReserve(6, 4);
            list.PrimRectUV({x + glyph->X0, top + glyph->Y0}, {x + glyph->X1, top + glyph->Y1}, {glyph->U0, glyph->V0},
                            {glyph->U1, glyph->V1}, color);
        }
        x += glyph->AdvanceX;
    }
    return x - pen.x;
}

float baseline_at_middle(const Font& font, float y) { return std::round(y + font.cap / 2); }

}  // namespace texelscope::ui
