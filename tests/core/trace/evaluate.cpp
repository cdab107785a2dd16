#include "tests/core/trace/evaluate.h"

#include "core/image/wrap.h"

namespace texelscope::laws {
namespace {

template <class X>
constexpr bool kWhole = std::same_as<X, Integer>;

[[nodiscard]] Value rounded(Op op, const Value& a) {
    return std::visit(
        [&](const auto& x) -> Value {
            using X = std::decay_t<decltype(x)>;
            if constexpr (!std::same_as<X, bool> && !kWhole<X>) {
                if (op == Op::floor) return floor(x);
                if (op == Op::trunc) return trunc(x);
                if (op == Op::ceil) return ceil(x);
                if (op == Op::single) return X(single(x));
                return round_even(x);
            }
            return false;
        },
        a);
}

template <class T>
[[nodiscard]] Value arithmetic(Op op, const T& x, const T& y) {
    switch (op) {
        case Op::add: return T(x + y);
        case Op::subtract: return T(x - y);
        case Op::multiply: return T(x * y);
        case Op::divide:
            if constexpr (!kWhole<T>) return T(x / y);
            break;
        case Op::less: return x < y;
        case Op::less_equal: return x <= y;
        case Op::greater: return x > y;
        case Op::greater_equal: return x >= y;
        case Op::equal: return x == y;
        case Op::not_equal: return !(x == y);
        case Op::lesser: return y < x ? y : x;
        case Op::greater_of: return x < y ? y : x;
        case Op::bit_and:
            if constexpr (kWhole<T>) return x & y;
            break;
        case Op::modulo:
            if constexpr (kWhole<T>) return (x % y + y) % y;
            break;
        default: break;
    }
    return false;
}

/// A whole number as a T takes on the mode of the T beside it, as operators with whole numbers have it.
template <class T>
[[nodiscard]] T as(Integer whole, const T& beside) {
    if constexpr (requires { beside.mode(); })
        return T(whole, beside.mode());
    else
        return static_cast<T>(whole);
}

[[nodiscard]] Value binary(Op op, const Value& a, const Value& b) {
    return std::visit(
        [&](const auto& x, const auto& y) -> Value {
            using X = std::decay_t<decltype(x)>;
            using Y = std::decay_t<decltype(y)>;
            if constexpr (std::same_as<X, bool> && std::same_as<Y, bool>)
                return op == Op::both ? x && y : x || y;
            else if constexpr (std::same_as<X, bool> || std::same_as<Y, bool>)
                return false;
            else if constexpr (std::same_as<X, Y>)
                return arithmetic(op, x, y);
            else if constexpr (kWhole<X>)
                return arithmetic(op, as(x, y), y);
            else if constexpr (kWhole<Y>)
                return arithmetic(op, x, as(y, x));
            else
                return false;
        },
        a, b);
}

[[nodiscard]] Value negated(const Value& a) {
    return std::visit(
        [](const auto& x) -> Value {
            if constexpr (std::same_as<std::decay_t<decltype(x)>, bool>)
                return !x;
            else
                return std::decay_t<decltype(x)>(-x);
        },
        a);
}

/// A whole number in the type of `real`.
[[nodiscard]] Value real_of(Integer whole, const Value& real) {
    return std::visit(
        [&](const auto& x) -> Value {
            using X = std::decay_t<decltype(x)>;
            if constexpr (std::same_as<X, bool>)
                return false;
            else
                return X(static_cast<Integer>(whole));
        },
        real);
}

/// Recursive descent over the text; each subexpression is evaluated in the type that its place asks for.
class Parser {
public:
    Parser(const Tape& tape, const std::string& text, std::int32_t before, const Value& real, std::string& error)
        : tape_(tape), text_(text), before_(before), real_(real), error_(error) {}

    [[nodiscard]] Value whole_text(const Value& like) {
        whole_ = std::holds_alternative<Integer>(like);
        const Term term = expression(0);
        skip();
        if (at_ != text_.size()) fail("unread text");
        return settled(term, std::holds_alternative<Integer>(like));
    }

private:
    /// A value, or a literal whose type its neighbour decides.
    struct Term {
        Value value;
        std::string literal;
    };
    struct Symbol {
        const char* text;
        int precedence;
        Op op;
    };
    static constexpr Symbol kSymbols[] = {
        {"||", 1, Op::either},    {"&&", 2, Op::both},       {"&", 3, Op::bit_and},        {"==", 4, Op::equal},
        {"!=", 4, Op::not_equal}, {"<=", 5, Op::less_equal}, {">=", 5, Op::greater_equal}, {"<", 5, Op::less},
        {">", 5, Op::greater},    {"+", 6, Op::add},         {"-", 6, Op::subtract},       {"*", 7, Op::multiply},
        {"/", 7, Op::divide}};
    static constexpr int kUnary = 8;

    void fail(const std::string& why) {
        if (error_.empty()) error_ = why + " at " + std::to_string(at_) + " of '" + text_ + "'";
        at_ = text_.size();
    }
    void skip() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }
    bool take(std::string_view what) {
        skip();
        if (text_.compare(at_, what.size(), what) != 0) return false;
        at_ += what.size();
        return true;
    }

    [[nodiscard]] Value settled(const Term& term, bool whole) {
        if (!term.literal.empty()) return whole ? Value(Integer{std::stoll(term.literal)}) : number(term.literal);
        const auto* integer = std::get_if<Integer>(&term.value);
        return !whole && integer != nullptr ? real_of(*integer, real_) : term.value;
    }
    [[nodiscard]] static bool is_whole(const Term& t) {
        return t.literal.empty() && std::holds_alternative<Integer>(t.value);
    }
    [[nodiscard]] static bool is_real(const Term& t) {
        if (!t.literal.empty()) return t.literal.find_first_of(".en") != std::string::npos;  // 0.5, 1e+30, nan
        return !std::holds_alternative<Integer>(t.value) && !std::holds_alternative<bool>(t.value);
    }
    /// Two operands: whole numbers among themselves stay whole, a real one makes both real.
    [[nodiscard]] Term combined(Op op, const Term& a, const Term& b) {
        if (op == Op::both || op == Op::either) return {binary(op, a.value, b.value), ""};
        const bool asked = whole_ || is_whole(a) || is_whole(b) || op == Op::bit_and || op == Op::modulo;
        const bool whole = asked && op != Op::divide && !is_real(a) && !is_real(b);
        return {binary(op, settled(a, whole), settled(b, whole)), ""};
    }

    Term expression(int least) {
        Term left = unary();
        while (true) {
            skip();
            const Symbol* found = nullptr;
            for (const Symbol& s : kSymbols) {
                if (found == nullptr && text_.compare(at_, std::string_view(s.text).size(), s.text) == 0) found = &s;
            }
            if (found == nullptr || found->precedence <= least) return left;
            at_ += std::string_view(found->text).size();
            left = combined(found->op, left, expression(found->precedence));
        }
    }
    Term unary() {
        if (take("!")) return {negated(unary().value), ""};
        if (take("-")) {
            const Term t = expression(kUnary);
            if (!t.literal.empty()) return {false, t.literal[0] == '-' ? t.literal.substr(1) : "-" + t.literal};
            return {negated(t.value), ""};
        }
        if (take("(")) {
            Term inner = expression(0);
            if (!take(")")) fail("')' expected");
            return inner;
        }
        return leaf();
    }
    Term leaf() {
        skip();
        const std::size_t start = at_;
        if (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') {
            while (at_ < text_.size() &&
                   (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.' ||
                    ((text_[at_] == '+' || text_[at_] == '-') && text_[at_ - 1] == 'e')))
                ++at_;
            return {false, text_.substr(start, at_ - start)};
        }
        while (at_ < text_.size() && std::string_view(" ()+-*/<>=!&|,").find(text_[at_]) == std::string_view::npos)
            ++at_;
        const std::string word = text_.substr(start, at_ - start);
        if (take("(")) return call(word);
        if (word == "nan" || word == "inf") return {false, word};
        if (word == "true" || word == "false") return {word == "true", ""};
        return {named(word), ""};
    }
    Term call(const std::string& word) {
        const bool around = whole_;
        whole_ = around && (word == "modulo" || word == "lesser" || word == "greater" || word == "choose");
        std::vector<Term> terms{expression(0)};
        while (take(",")) terms.push_back(expression(0));
        whole_ = around;
        if (!take(")")) fail("')' expected");
        const Value first = terms[0].literal.empty() ? terms[0].value : Value(false);
        if (word == "choose" && terms.size() == 3) return std::get<bool>(first) ? terms[1] : terms[2];
        if (terms.size() == 2 && word == "modulo") return combined(Op::modulo, terms[0], terms[1]);
        if (terms.size() == 2 && word == "lesser") return combined(Op::lesser, terms[0], terms[1]);
        if (terms.size() == 2 && word == "greater") return combined(Op::greater_of, terms[0], terms[1]);
        const Value real = settled(terms[0], false);
        if (word == "floor") return {rounded(Op::floor, real), ""};
        if (word == "trunc") return {rounded(Op::trunc, real), ""};
        if (word == "ceil") return {rounded(Op::ceil, real), ""};
        if (word == "round_even") return {rounded(Op::round_even, real), ""};
        if (word == "single") return {rounded(Op::single, real), ""};
        fail("no function " + word);
        return {};
    }
    [[nodiscard]] Value named(const std::string& word) {
        const Named* best = nullptr;
        for (const Named& n : tape_.names) {
            if (n.operation < before_ && n.name.text() == word && (best == nullptr || n.operation >= best->operation))
                best = &n;
        }
        if (best == nullptr) return fail("no name '" + word + "'"), Value(false);
        return tape_.operations[static_cast<std::size_t>(best->operation)].value;
    }
    /// A literal in the number type, every digit of it.
    [[nodiscard]] Value number(const std::string& word) {
        return std::visit(
            [&](const auto& x) -> Value {
                using X = std::decay_t<decltype(x)>;
                if constexpr (std::same_as<X, double>)
                    return std::strtod(word.c_str(), nullptr);
                else if constexpr (std::same_as<X, float>)
                    return std::strtof(word.c_str(), nullptr);
                else if constexpr (std::same_as<X, Exact>)
                    return word.find("nan") != std::string::npos ? X::undefined() : X(typename X::Rational(word));
                else if constexpr (requires { x.raw(); })
                    return X::from_raw(raw(word, X::kFractionBits), false, {});
                else
                    return false;
            },
            real_);
    }
    [[nodiscard]] static std::int64_t raw(const std::string& word, int bits) {
        if (word[0] == '-') return -raw(word.substr(1), bits);
        const std::size_t point = word.find('.');
        const std::int64_t whole = std::stoll(word.substr(0, point)) << bits;
        if (point == std::string::npos) return whole;
        return whole + static_cast<std::int64_t>(std::ldexp(std::stod("0" + word.substr(point)), bits));
    }

    const Tape& tape_;
    const std::string& text_;
    std::int32_t before_;
    const Value& real_;
    std::string& error_;
    bool whole_ = false;  ///< literals without a neighbour are whole numbers here
    std::size_t at_ = 0;
};

}  // namespace

Value evaluated(const Tape& tape, const Operation& o) {
    const auto operand = [&](std::int32_t n) -> const Value& {
        return tape.operations.at(static_cast<std::size_t>(n)).value;
    };
    switch (o.op) {
        case Op::input:
        case Op::constant: return o.value;
        case Op::same: return operand(o.a);
        case Op::to_real: return real_of(std::get<Integer>(operand(o.a)), o.value);
        case Op::negate:
        case Op::invert: return negated(operand(o.a));
        case Op::floor:
        case Op::trunc:
        case Op::ceil:
        case Op::single:
        case Op::round_even: return rounded(o.op, operand(o.a));
        case Op::choose: return std::get<bool>(operand(o.a)) ? operand(o.b) : operand(o.c);
        default: return binary(o.op, operand(o.a), operand(o.b));
    }
}

Value evaluated_text(const Tape& tape, const std::string& text, std::int32_t before, const Value& like,
                     const Value& real, std::string& error) {
    return Parser(tape, text, before, real, error).whole_text(like);
}

bool same_value(const Value& a, const Value& b) {
    if (a.index() != b.index()) return false;
    if (undefined(a) || undefined(b)) return undefined(a) && undefined(b);
    return std::visit([&](const auto& x) { return x == std::get<std::decay_t<decltype(x)>>(b); }, a);
}

}  // namespace texelscope::laws
