#include "app/views/code_text.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

namespace texelscope {
namespace {

constexpr std::string_view kOneFold = "{}(), {} lines folded", kTwoFold = "{}(), {}(), {} lines folded";
constexpr std::string_view kManyFold = "{} functions, {} lines folded", kOtherFold = "{} lines folded";
constexpr int kLeastFold = 3;  ///< fewer lines are shown rather than folded
constexpr std::size_t kContinuation = 8;
constexpr std::size_t kDeepest = 16;  ///< columns to which an indented line may have to move left

[[nodiscard]] bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

[[nodiscard]] std::string_view trimmed(std::string_view s) {
    const std::size_t from = s.find_first_not_of(' ');
    return from == std::string_view::npos ? std::string_view{} : s.substr(from);
}

[[nodiscard]] bool begins(std::string_view s, std::string_view with) { return s.substr(0, with.size()) == with; }

/// How many braces the line opens more than it closes.
[[nodiscard]] int brace_balance(std::string_view line) {
    int balance = 0;
    for (const Token& token : tokens_of(line)) {
        if (token.kind == TokenKind::comment || token.kind == TokenKind::string) continue;
        balance += static_cast<int>(std::count(token.text.begin(), token.text.end(), '{'));
        balance -= static_cast<int>(std::count(token.text.begin(), token.text.end(), '}'));
    }
    return balance;
}

constexpr int kMostOfSignature = 4;  ///< lines

/// The name before the first parenthesis of a line that may begin a function; empty where it cannot.
[[nodiscard]] std::string function_name(std::string_view line) {
    const std::string_view text = trimmed(line);
    for (const std::string_view not_one :
         {"//", "#", "namespace", "struct", "enum", "if", "for", "while", "return", "template", "switch"}) {
        if (begins(text, not_one)) return {};
    }
    const std::size_t open = text.find('(');
    if (open == std::string_view::npos || text.find('{', open) == std::string_view::npos) return {};
    std::size_t first = open;
    while (first > 0 && is_word(text[first - 1])) --first;
    const bool declared = first > 0 && (text[first - 1] == ' ' || text[first - 1] == '&' || text[first - 1] == '*');
    return declared ? std::string(text.substr(first, open - first)) : std::string{};
}

[[nodiscard]] bool calls(std::string_view line, std::string_view name) {
    for (std::size_t at = line.find(name); at != std::string_view::npos; at = line.find(name, at + 1)) {
        const bool starts = at == 0 || !is_word(line[at - 1]);
        if (starts && at + name.size() < line.size() && line[at + name.size()] == '(') return true;
    }
    return false;
}

}  // namespace

std::vector<CodeFunction> functions_of(const Listing& listing) {
    std::vector<CodeFunction> functions;
    const int lines = static_cast<int>(listing.lines.size());
    for (int n = 1; n <= lines; ++n) {
        // A signature may go on in the lines below.
        std::string head = listing.lines[static_cast<std::size_t>(n) - 1];
        int last = n;
        while (!head.empty() && head.back() == ',' && last < std::min(lines, n + kMostOfSignature))
            head += ' ' + std::string(trimmed(listing.lines[static_cast<std::size_t>(last++)]));
        std::string name = function_name(head);
        if (name.empty()) continue;
        CodeFunction function{std::move(name), n, last};
        int depth = brace_balance(head);
        while (depth > 0 && function.last < lines)
            depth += brace_balance(listing.lines[static_cast<std::size_t>(function.last++)]);
        const int floor = functions.empty() ? 0 : functions.back().last;
        const auto above = [&] { return trimmed(listing.lines[static_cast<std::size_t>(function.first) - 2]); };
        while (function.first - 1 > floor && function.first > 1 &&
               (begins(above(), "///") || begins(above(), "template")))
            --function.first;
        n = function.last;
        functions.push_back(std::move(function));
    }
    return functions;
}

int function_at(std::span<const CodeFunction> functions, int line) {
    for (std::size_t n = 0; n < functions.size(); ++n) {
        if (functions[n].has(line)) return static_cast<int>(n);
    }
    return -1;
}

std::vector<int> callers_of(const Listing& listing, std::span<const CodeFunction> functions, int callee) {
    std::vector<int> callers;
    if (callee < 0) return callers;
    const std::string& name = functions[static_cast<std::size_t>(callee)].name;
    for (std::size_t n = 0; n < functions.size(); ++n) {
        if (static_cast<int>(n) == callee) continue;
        for (int line = functions[n].first; line <= functions[n].last; ++line) {
            if (!calls(listing.lines[static_cast<std::size_t>(line) - 1], name)) continue;
            callers.push_back(static_cast<int>(n));
            break;
        }
    }
    return callers;
}

std::vector<Token> tokens_of(std::string_view line) {
    static constexpr std::array<std::string_view, 35> kKeywords{
        "auto",     "bool",    "break",     "case",     "char",     "class",    "concept", "const",  "constexpr",
        "continue", "default", "do",        "double",   "else",     "enum",     "false",   "float",  "for",
        "if",       "int",     "namespace", "noexcept", "private",  "requires", "return",  "sizeof", "static",
        "struct",   "switch",  "template",  "true",     "typename", "using",    "void",    "while"};
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at + 1;
        TokenKind kind = TokenKind::plain;
        const char c = line[at];
        if (line.substr(at, 2) == "//") {
            kind = TokenKind::comment, end = line.size();
        } else if (c == '"' || (c == '\'' && (at == 0 || !is_word(line[at - 1])))) {
            kind = TokenKind::string;
            while (end < line.size() && line[end] != c) end += line[end] == '\\' ? 2 : 1;
            end = std::min(end + 1, line.size());
        } else if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
            kind = TokenKind::number;
            while (end < line.size() && (is_word(line[end]) || line[end] == '.' || line[end] == '\'')) ++end;
        } else if (is_word(c)) {
            while (end < line.size() && is_word(line[end])) ++end;
            const std::string_view word = line.substr(at, end - at);
            if (std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end()) kind = TokenKind::keyword;
            if (word == "u") kind = TokenKind::u;
            if (word == "v") kind = TokenKind::v;
        } else {
            while (end < line.size() && !is_word(line[end]) && line[end] != '"' && line[end] != '\'' &&
                   line.substr(end, 2) != "//")
                ++end;
        }
        tokens.push_back({kind, line.substr(at, end - at)});
        at = end;
    }
    return tokens;
}

namespace {

constexpr int kBeforeComment = 8;

/// How good a break before `line[at]` is, 0: none. Best is before a comment, then before an operator or between
/// statements, then after a comma, before "=", at any space, and last after a bracket or before a member.
[[nodiscard]] int break_quality(std::string_view line, std::size_t at) {
    if (at == 0 || at >= line.size()) return 0;
    const char before = line[at - 1];
    if (line[at] != ' ') {
        const bool bracket = before == '(' && line[at] != ')';
        const bool member = line[at] == '.' && is_word(before) && at + 1 < line.size() && is_word(line[at + 1]) &&
                            std::isdigit(static_cast<unsigned char>(line[at + 1])) == 0;
        return bracket ? 2 : member ? 1 : 0;
    }
    const std::string_view next = line.substr(at + 1, 3);
    if (next.substr(0, 2) == "//") return kBeforeComment;
    const bool sign = next.size() == 3 && (next[1] == ' ' || next[2] == ' ') &&
                      std::string_view("+-*/|&?:<>!=").find(next[0]) != std::string_view::npos;
    if (sign && next[1] == ' ' && next[0] == '=') return 4;
    if (sign && next[1] == ' ' && (next[0] == '*' || next[0] == '/')) return 6;  // a sum breaks between its terms
    return sign || before == ';' ? 7 : before == ',' ? 5 : 3;
}

/// Where to break a line that has room for `room` letters: inside of as few brackets as may be, then where it is
/// best, then as late as possible. 0 where there is no place.
[[nodiscard]] std::size_t best_break(std::string_view line, std::size_t least, std::size_t room) {
    constexpr int kNever = -1000, kBracket = 10;
    std::size_t best = 0;
    int quality = kNever, depth = 0;
    const std::size_t comment = std::min(line.find("//"), line.size());
    for (std::size_t at = 0; at <= room && at < line.size(); ++at) {
        const int good = at > least ? break_quality(line, at) : 0;
        const bool anywhere = good == kBeforeComment || at > comment;
        const int here = good == 0 ? kNever : anywhere ? good : good - kBracket * depth;
        if (here > kNever && here >= quality) quality = here, best = at;
        if (line[at] == '(' || line[at] == '{') ++depth;
        if (line[at] == ')' || line[at] == '}') --depth;
    }
    return best;
}

}  // namespace

std::vector<std::string> broken(std::string_view line, int columns) {
    std::vector<std::string> rows;
    const auto most = static_cast<std::size_t>(std::max(16, columns));
    std::size_t first = std::min(line.find_first_not_of(' '), line.size());
    // What is far to the right is aligned with a line above; rather than being broken there it moves left.
    if (line.size() > most && first > kDeepest) {
        const std::size_t spare = std::min(first - kDeepest, line.size() - most);
        line.remove_prefix(spare), first -= spare;
    }
    std::size_t indent = 0;
    while (line.size() + indent > most) {
        const std::size_t room = most - indent, start = indent == 0 ? first + 1 : 1;
        std::size_t best = best_break(line, std::max(room / 2, start), room);
        if (best == 0) best = best_break(line, start, room);
        if (best == 0) best = room;
        rows.push_back(std::string(indent, ' ') + std::string(line.substr(0, best)));
        line.remove_prefix(best);
        line = trimmed(line);
        indent = std::min(first + kContinuation, most / 2);
    }
    rows.push_back(std::string(indent, ' ') + std::string(line));
    return rows;
}

std::vector<CodeRow> rows_of(const Listing& listing, std::span<const CodeFunction> functions,
                             const CodeRowsSpec& spec) {
    std::vector<CodeRow> rows;
    const Listing source = spec.plain ? without_trace(listing) : listing;
    const int lines = static_cast<int>(listing.lines.size());
    const auto contains = [](const std::vector<int>& all, int x) {
        return std::find(all.begin(), all.end(), x) != all.end();
    };
    const auto shown = [&](int line) {
        const int function = function_at(functions, line);
        return function >= 0 && contains(spec.functions, function);
    };
    std::size_t dedent = 64;
    for (const CodeFunction& f : functions)
        dedent = std::min(dedent, listing.lines[static_cast<std::size_t>(f.first) - 1].find_first_not_of(' '));
    const auto add_line = [&](int line) {
        std::string text = source.lines[static_cast<std::size_t>(line) - 1];
        text.erase(0, std::min(std::min(dedent, text.find_first_not_of(' ')), text.size()));
        bool continued = false, comment = false;
        for (std::string& part : broken(text, spec.columns)) {
            rows.push_back({line, continued, 0, std::move(part), comment});
            const std::vector<Token> tokens = tokens_of(rows.back().text);
            comment |= !tokens.empty() && tokens.back().kind == TokenKind::comment;
            continued = true;
        }
    };
    for (int line = 1; line <= lines;) {
        if (shown(line)) {
            add_line(line++);
            continue;
        }
        int end = line;
        std::vector<std::string_view> hidden;
        for (; end <= lines && !shown(end); ++end) {
            const int function = function_at(functions, end);
            if (function >= 0 && functions[static_cast<std::size_t>(function)].last == end)
                hidden.push_back(functions[static_cast<std::size_t>(function)].name);
        }
        const int count = end - line;
        if (contains(spec.unfolded, line) || (count < kLeastFold && !rows.empty() && end <= lines)) {
            for (; line < end; ++line) add_line(line);
            continue;
        }
        CodeRow fold{line, false, count, {}};
        if (hidden.size() == 1)
            fold.text = fmt::format(kOneFold, hidden[0], count);
        else if (hidden.size() == 2)
            fold.text = fmt::format(kTwoFold, hidden[0], hidden[1], count);
        else
            fold.text = hidden.empty() ? fmt::format(kOtherFold, count) : fmt::format(kManyFold, hidden.size(), count);
        rows.push_back(std::move(fold));
        line = end;
    }
    return rows;
}

}  // namespace texelscope
