#include "core/trace/listing.h"

#include <algorithm>
#include <cctype>

namespace texelscope {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Where the bracket that opens at `open` closes; npos where it does not.
std::size_t closing(std::string_view text, std::size_t open) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t at = open; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (text.substr(at, 2) == "//") at = std::min(text.find('\n', at), text.size());
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

/// The lines before `at`, without their comments, up to the last letter of code; empty where there is none.
std::string_view code_before(std::string_view text, std::size_t at) {
    while (at > 0) {
        const std::size_t newline = text.rfind('\n', at - 1),
                          begin = newline == std::string_view::npos ? 0 : newline + 1;
        std::string_view line = text.substr(begin, at - begin);
        line = line.substr(0, line.find("//"));
        const std::size_t last = line.find_last_not_of(' ');
        if (last != std::string_view::npos) return text.substr(0, begin + last + 1);
        at = begin == 0 ? 0 : begin - 1;
    }
    return {};
}

bool in_comment(std::string_view text, std::size_t at) {
    const std::size_t newline = text.rfind('\n', at), begin = newline == std::string_view::npos ? 0 : newline + 1;
    return text.substr(begin, at - begin).find("//") != std::string_view::npos;
}

/// What is assigned to just before `at`, as in "s.y = "; empty where nothing is.
std::string_view assigned(std::string_view text, std::size_t at) {
    std::string_view code = code_before(text, at);
    if (code.empty() || code.back() != '=') return {};
    code.remove_suffix(1);
    while (!code.empty() && code.back() == ' ') code.remove_suffix(1);
    std::size_t first = code.size();
    while (first > 0 && (is_word(code[first - 1]) || code[first - 1] == '.')) --first;
    return code.substr(first);
}

/// Later lines of an argument were aligned with its first: they move with it.
std::string moved_left(std::string_view argument, std::size_t by) {
    std::string text(argument);
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
        text.erase(at + 1, std::min(by, std::min(text.find_first_not_of(' ', at + 1), text.size()) - at - 1));
    return text;
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

std::string code_at(const Listing& listing, int line) {
    const std::string& code = listing.lines[static_cast<std::size_t>(line) - 1];
    return code.substr(std::min(code.find_first_not_of(' '), code.size()));
}

int line_with(const Listing& listing, std::string_view text) {
    for (std::size_t n = 0; n < listing.lines.size(); ++n) {
        if (listing.lines[n].find(text) != std::string::npos) return static_cast<int>(n) + 1;
    }
    return 0;
}

std::string without_trace(std::string_view source) {
    std::string text(source);
    constexpr std::string_view kCall = "trace(";
    for (std::size_t at = text.find(kCall); at != std::string::npos; at = text.find(kCall, at)) {
        if ((at > 0 && is_word(text[at - 1])) || in_comment(text, at)) {
            ++at;
            continue;
        }
        const std::size_t open = at + kCall.size() - 1, close = closing(text, open);
        const std::size_t comma = close == std::string::npos ? close : first_comma(text, open, close);
        if (comma == std::string::npos) break;
        const std::size_t first = text.find_first_not_of(' ', comma + 1);
        std::string value = text.substr(first, close - first), name;
        if (text[open + 1] == '"') name = text.substr(open + 2, comma - open - 3);
        const std::string_view before = code_before(text, at), target = assigned(text, at);
        // A value that is only named, or assigned to itself, would be thrown away or say nothing: its name stays.
        const bool alone = before.empty() || std::string_view(";{})").find(before.back()) != std::string_view::npos;
        const bool ends = text.substr(close + 1, 1) == ";";
        std::size_t begin = at;
        if (ends && !name.empty() && (alone || target == value)) {
            if (alone && name == value) {
                at = close;
                continue;
            }
            if (!alone) begin = static_cast<std::size_t>(target.data() - text.data());
            value.insert(0, name + " = ");
        }
        text.replace(begin, close + 1 - begin, moved_left(value, first - at));
        at = begin;
    }
    return text;
}

Listing without_trace(const Listing& listing) {
    std::string text;
    for (const std::string& line : listing.lines) text += line + '\n';
    text = without_trace(text);
    Listing plain{listing.path, {}};
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        plain.lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return plain;
}

}  // namespace texelscope
