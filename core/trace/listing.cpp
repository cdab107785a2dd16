#include "core/trace/listing.h"

namespace texelscope {
namespace {

/// Where the bracket that opens at `open` closes; npos where it does not.
std::size_t closing(std::string_view text, std::size_t open) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t at = open; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '(' || c == '{') ++depth;
        if ((c == ')' || c == '}') && --depth == 0) return at;
    }
    return std::string_view::npos;
}

/// Where the first argument of the call that opens at `open` ends: its comma.
std::size_t first_comma(std::string_view text, std::size_t open, std::size_t close) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t at = open; at < close; ++at) {
        const char c = text[at];
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '(' || c == '{') ++depth;
        if (c == ')' || c == '}') --depth;
        if (c == ',' && depth == 1) return at;
    }
    return std::string_view::npos;
}

}  // namespace

Listing load_listing(std::string_view path) {
    Listing listing;
    for (const EmbeddedFile& file : embedded_files()) {
        if (file.path != path) continue;
        listing.path = path;
        std::string_view text = file.text;
        while (!text.empty()) {
            const std::size_t end = text.find('\n');
            listing.lines.emplace_back(text.substr(0, end));
            text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        }
    }
    return listing;
}

int line_with(const Listing& listing, std::string_view text) {
    for (std::size_t n = 0; n < listing.lines.size(); ++n) {
        if (listing.lines[n].find(text) != std::string::npos) return static_cast<int>(n) + 1;
    }
    return 0;
}

std::string without_trace(std::string_view line) {
    std::string text(line);
    constexpr std::string_view kCall = "trace(";
    for (std::size_t at = text.find(kCall); at != std::string::npos; at = text.find(kCall, at)) {
        const std::size_t open = at + kCall.size() - 1, close = closing(text, open);
        const std::size_t comma = close == std::string::npos ? close : first_comma(text, open, close);
        if (comma == std::string::npos) break;
        const std::size_t value = text.find_first_not_of(' ', comma + 1);
        text = text.substr(0, at) + text.substr(value, close - value) + text.substr(close + 1);
    }
    return text;
}

}  // namespace texelscope
