#include "app/cli/json_line.h"

#include <fmt/format.h>

namespace texelscope {

std::string json_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += '\\', out += c;
        else if (static_cast<unsigned char>(c) < ' ')
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out + '"';
}

std::string json_number(std::string_view text) {
    const bool plain = !text.empty() && text.find_first_not_of("0123456789+-.e") == text.npos;
    return plain ? std::string(text) : json_text(text);
}

JsonLine& JsonLine::raw(std::string_view key, std::string_view value) {
    if (!members_.empty()) members_ += ',';
    members_ += json_text(key);
    members_ += ':';
    members_ += value;
    return *this;
}

}  // namespace texelscope
