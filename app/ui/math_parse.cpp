// The reader of inline mathematics: a recursive descent over one line.
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "app/ui/math.h"

namespace texelscope::ui {
namespace {

constexpr int kDeepest = 24;
constexpr std::size_t kMathParseLongest = 1000;

using Name = std::pair<std::string_view, std::string_view>;
constexpr std::array kLetters{
    Name{"Delta", "Δ"}, Name{"alpha", "α"},   Name{"beta", "β"}, Name{"gamma", "γ"}, Name{"delta", "δ"},
    Name{"eps", "ε"},   Name{"lambda", "λ"},  Name{"mu", "μ"},   Name{"pi", "π"},    Name{"sigma", "σ"},
    Name{"theta", "θ"}, Name{"epsilon", "ε"}, Name{"phi", "φ"},  Name{"omega", "ω"}, Name{"infty", "∞"},
};
constexpr std::array kRelations{
    Name{"le", "≤"}, Name{"leq", "≤"}, Name{"ge", "≥"},     Name{"geq", "≥"},
    Name{"ne", "≠"}, Name{"neq", "≠"}, Name{"approx", "≈"}, Name{"to", "→"},
};
constexpr std::array<std::string_view, 12> kRelationSigns{"<=", ">=", "!=", "=", "<", ">",
                                                          "≤",  "≥",  "≠",  "≈", "→", "&"};

std::optional<std::string_view> find(std::span<const Name> names, std::string_view name) {
    for (const auto& [key, value] : names)
        if (key == name) return value;
    return std::nullopt;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    Result<Expr> read() {
        if (text_.size() > kMathParseLongest) return Error{"", "the formula is longer than 1000 characters"};
        Expr e = chain();
        if (!failed_ && !at_end()) fail("cannot be read");
        if (failed_) return Error{fmt::format("character {}", failed_at_ + 1), failure_};
        return e;
    }

private:
    void fail(std::string_view what) {
        if (failed_) return;
        failed_ = true;
        failed_at_ = at_;
        failure_ = fmt::format("'{}' {}", text_.substr(std::min(at_, text_.size()), 8), what);
        at_ = text_.size();
    }

    void skip_space() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
    }
    bool at_end() {
        skip_space();
        return at_ >= text_.size();
    }
    bool sees(std::string_view token) {
        skip_space();
        return text_.substr(at_, token.size()) == token;
    }
    bool takes(std::string_view token) {
        if (!sees(token)) return false;
        at_ += token.size();
        return true;
    }
    void expect(std::string_view token) {
        if (!takes(token)) fail(fmt::format("found where {} was expected", token));
    }

    /// \name, without moving when `names` does not have it.
    std::optional<std::string_view> takes_command(std::span<const Name> names) {
        const std::size_t from = at_;
        if (takes("\\")) {
            std::size_t end = at_;
            while (end < text_.size() && is_letter(text_[end])) ++end;
            if (const auto found = find(names, text_.substr(at_, end - at_))) {
                at_ = end;
                return found;
            }
        }
        at_ = from;
        return std::nullopt;
    }

    std::string_view takes_relation() {
        if (const auto sign = takes_command(kRelations)) return *sign;
        for (const std::string_view sign : kRelationSigns)
            if (takes(sign)) return sign == "<=" ? "≤" : sign == ">=" ? "≥" : sign == "!=" ? "≠" : sign;
        return {};
    }

    Expr chain() {
        if (++depth_ > kDeepest) fail("is nested too deeply");
        std::vector<Expr> parts{terms()};
        std::vector<std::string> signs;
        for (std::string_view sign = takes_relation(); !sign.empty() && !failed_; sign = takes_relation()) {
            signs.emplace_back(sign);
            parts.push_back(terms());
        }
        --depth_;
        return signs.empty() ? std::move(parts.front()) : relation_chain(std::move(parts), std::move(signs));
    }

    Expr terms() {
        std::vector<Expr> parts{factors()};
        while (!failed_) {
            if (takes("+")) {
                parts.push_back(factors());
            } else if (takes("-") || takes(kMinus)) {
                parts.push_back(negation(factors()));
            } else {
                break;
            }
        }
        return parts.size() == 1 ? std::move(parts.front()) : sum(std::move(parts));
    }

    bool starts_atom() {
        if (at_end() || sees("\\le") || sees("\\ge") || sees("\\ne") || sees("\\approx") || sees("\\to")) return false;
        const char c = text_[at_];
        return is_letter(c) || is_digit(c) || c == '(' || c == '\\' || c == '[';
    }

    Expr factors() {
        if (takes("-") || takes(kMinus)) return negation(factors());
        std::vector<Expr> parts{atom()};
        while (!failed_) {
            if (takes("/")) {
                Expr e;
                e.op = Op::slash;
                e.parts.push_back(parts.size() == 1 ? std::move(parts.front()) : product(std::move(parts)));
                e.parts.push_back(atom());
                parts.clear();
                parts.push_back(std::move(e));
                continue;
            }
            const bool times = takes("*") || takes("\\cdot") || takes("·") || takes("\\times") || takes("×");
            if (!times && !starts_atom()) break;
            parts.push_back(atom());
        }
        return parts.size() == 1 ? std::move(parts.front()) : product(std::move(parts));
    }

    Expr braced() {
        expect("{");
        Expr e = chain();
        expect("}");
        return e;
    }

    std::string_view raw_braced() {
        expect("{");
        const std::size_t from = at_, end = std::min(text_.find('}', at_), text_.size());
        at_ = end;
        expect("}");
        return failed_ ? std::string_view{} : text_.substr(from, end - from);
    }

    Expr with_subscript(std::string_view name) {
        std::string whole(name);
        if (at_ < text_.size() && text_[at_] == '_') {
            ++at_;
            if (sees("{")) {
                whole += "_{" + std::string(raw_braced()) + "}";
            } else if (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) {
                const std::size_t from = at_;
                while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
                whole += "_" + std::string(text_.substr(from, at_ - from));
            } else {
                fail("is no subscript");
            }
        }
        return symbol(whole);
    }

    Expr atom() {
        if (at_end()) return fail("ends where a term was expected"), Expr{};
        const char c = text_[at_];
        if (is_digit(c)) {
            const std::size_t from = at_;
            while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
            return number(Number{std::string(text_.substr(from, at_ - from)), true, false});
        }
        if (takes("(")) {
            Expr inner = chain();
            expect(")");
            return call("", {std::move(inner)});
        }
        if (takes("\\frac")) {
            Expr above = braced();
            return quotient(std::move(above), braced());
        }
        if (takes("\\floor")) return floor_of(braced());
        if (takes("\\text")) return word(raw_braced());
        if (const auto letter = takes_command(kLetters)) return with_subscript(*letter);
        if (!is_letter(c) && static_cast<unsigned char>(c) < 0x80) return fail("cannot be read"), Expr{};
        return name_or_call();
    }

    Expr name_or_call() {
        const std::size_t from = at_;
        while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
        if (at_ == from) {
            for (const std::string_view greek : {"Δ", "α", "β", "γ", "δ", "ε", "λ", "μ", "π", "σ", "θ", "φ", "∞"})
                if (takes(greek)) return with_subscript(greek);
            return fail("cannot be read"), Expr{};
        }
        const std::string_view name = text_.substr(from, at_ - from);
        if (name.size() > 1 && at_ < text_.size() && text_[at_] == '(') {
            ++at_;
            std::vector<Expr> arguments{chain()};
            while (takes(",")) arguments.push_back(chain());
            expect(")");
            return call(name, std::move(arguments));
        }
        return with_subscript(name);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool failed_ = false;
    std::size_t failed_at_ = 0;
    std::string failure_;
};

}  // namespace

Result<Expr> parse_math(std::string_view text) { return Reader(text).read(); }

}  // namespace texelscope::ui
