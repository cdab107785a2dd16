#include "app/views/math_of_tape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/trace/expression.h"

namespace texelscope {
namespace {

constexpr std::string_view kNoValue = "no value", kLeft16 = "left 16.16", kLeft8 = "left 8.8";
constexpr std::string_view kYes = "yes", kNo = "no";

[[nodiscard]] std::vector<std::string_view> split(std::string_view name) {
    std::vector<std::string_view> parts;
    for (std::size_t at = 0; at <= name.size();) {
        const std::size_t end = std::min(name.find('_', at), name.size());
        parts.push_back(name.substr(at, end - at));
        at = end + 1;
    }
    return parts;
}

[[nodiscard]] bool is_side(std::string_view part) { return part.size() == 1 && part[0] >= 'A' && part[0] <= 'C'; }

/// Base and subscript as the screen sets them.
[[nodiscard]] std::pair<std::string, std::string> set_name(std::string_view name) {
    std::vector<std::string_view> parts = split(name);
    if (parts.size() > 2 && is_side(parts.back())) std::rotate(parts.begin() + 1, parts.end() - 1, parts.end());
    std::string sub;
    for (std::size_t n = 1; n < parts.size(); ++n) sub += (n > 1 ? "," : "") + std::string(parts[n]);
    return {std::string(parts[0]), sub};
}

using ui::Expr;

[[nodiscard]] bool is_determinant(const Expr& e) { return e.op == ui::Op::determinant; }

[[nodiscard]] bool is_tall(const Expr& e) {
    if (e.op == ui::Op::quotient || is_determinant(e)) return true;
    return std::any_of(e.parts.begin(), e.parts.end(), is_tall);
}

[[nodiscard]] std::string_view relation_sign(Op op) {
    switch (op) {
        case Op::less: return "<";
        case Op::less_equal: return "≤";
        case Op::greater: return ">";
        case Op::greater_equal: return "≥";
        case Op::equal: return "=";
        case Op::not_equal: return "≠";
        case Op::both: return "∧";
        case Op::either: return "∨";
        case Op::bit_and: return "&";
        case Op::modulo: return "mod";
        default: return {};
    }
}

[[nodiscard]] std::string_view function_name(Op op) {
    switch (op) {
        case Op::trunc: return "trunc";
        case Op::ceil: return "ceil";
        case Op::round_even: return "round";
        case Op::single: return "f32";
        case Op::lesser: return "min";
        case Op::greater_of: return "max";
        case Op::invert: return "not";
        default: return {};
    }
}

/// Turns operations into terms; either with names or with the numbers in their place.
class Builder {
public:
    Builder(const Tape& tape, std::int32_t named, bool numbers)
        : tape_(tape), names_(names_by_operation(tape)), target_(named), numbers_(numbers) {
        for (const Named& n : tape.names) texts_.push_back(n.name.text());
    }

    [[nodiscard]] Expr root(std::int32_t operation) { return inner(operation); }
    [[nodiscard]] const std::vector<std::int32_t>& used() const { return used_; }

private:
    [[nodiscard]] const Operation& at(std::int32_t o) const { return tape_.operations[static_cast<std::size_t>(o)]; }
    [[nodiscard]] std::int32_t name_of(std::int32_t o) const { return names_[static_cast<std::size_t>(o)]; }
    [[nodiscard]] const std::string& text_of(std::int32_t named) const {
        return texts_[static_cast<std::size_t>(named)];
    }

    /// A name stands for itself, unless another value has taken it over by the time of the one that is explained.
    [[nodiscard]] bool stands_alone(std::int32_t o) const {
        const std::int32_t named = name_of(o);
        if (named < 0 || named == target_) return false;
        for (std::int32_t later = named + 1; later <= target_; ++later) {
            if (text_of(later) == text_of(named) && tape_.names[static_cast<std::size_t>(later)].operation != o)
                return false;
        }
        return true;
    }

    [[nodiscard]] Expr term_of_name(std::int32_t o) {
        const std::int32_t named = name_of(o);
        if (std::find(used_.begin(), used_.end(), named) == used_.end()) used_.push_back(named);
        const std::string& text = text_of(named);
        Expr e = symbol_of_name(text);
        if (numbers_) {
            const ui::Role role = e.role;
            e = value_term(at(o).value);
            if (e.role == ui::Role::text && corner_of_name(text) >= 0) e.role = role;
        }
        return ui::linked(std::move(e), link_of(named));
    }

    [[nodiscard]] Expr operand(std::int32_t o) { return stands_alone(o) ? term_of_name(o) : inner(o); }

    [[nodiscard]] bool constant(std::int32_t o) const {
        const Operation& op = at(o);
        if (name_of(o) >= 0) return false;
        if (op.op == Op::input || op.op == Op::constant) return true;
        for (const std::int32_t x : {op.a, op.b, op.c}) {
            if (x >= 0 && !constant(x)) return false;
        }
        return true;
    }

    /// Whether `o` is an unnamed (a)(b) − (c)(d).
    [[nodiscard]] bool crosses(std::int32_t o) const {
        const Operation& op = at(o);
        const auto product = [&](std::int32_t x) { return at(x).op == Op::multiply && !stands_alone(x); };
        return op.op == Op::subtract && product(op.a) && product(op.b);
    }

    [[nodiscard]] Expr determinant(const Operation& op) {
        const Operation &ab = at(op.a), &cd = at(op.b);
        Expr a = operand(ab.a), d = operand(cd.b), c = operand(cd.a), b = operand(ab.b);
        if (numbers_) {
            a = difference_as_number(ab.a, std::move(a)), d = difference_as_number(cd.b, std::move(d));
            c = difference_as_number(cd.a, std::move(c)), b = difference_as_number(ab.b, std::move(b));
        }
        return ui::determinant(2, {std::move(a), std::move(d), std::move(c), std::move(b)});
    }
    /// In a determinant of numbers an entry is one number.
    [[nodiscard]] Expr difference_as_number(std::int32_t o, Expr e) const {
        if (stands_alone(o) || constant(o)) return e;
        const ui::Role role = !e.parts.empty() ? e.parts.front().role : e.role;
        e = value_term(at(o).value);
        if (e.role == ui::Role::text) e.role = role;
        return e;
    }

    void add_terms(std::int32_t o, std::vector<Expr>& terms) {
        const Operation& op = at(o);
        const bool is_sum = op.op == Op::add || op.op == Op::subtract;
        if (!is_sum || stands_alone(o) || crosses(o) || constant(o)) {
            terms.push_back(operand(o));
            return;
        }
        const bool from_zero = op.op == Op::add && constant(op.a) && approximate(at(op.a).value) == 0;
        if (!from_zero) add_terms(op.a, terms);
        Expr right = operand(op.b);
        if (right.op == ui::Op::product && right.parts.front().negative) {  // + (−7.75) · 11.5
            right.parts.front() = ui::call("", {right.parts.front()});
        }
        terms.push_back(op.op == Op::subtract ? ui::negation(std::move(right)) : std::move(right));
    }

    void add_factors(std::int32_t o, std::vector<Expr>& factors) {
        const Operation& op = at(o);
        if (op.op == Op::multiply && !stands_alone(o) && !constant(o)) {
            add_factors(op.a, factors);
            factors.push_back(operand(op.b));
            return;
        }
        factors.push_back(operand(o));
    }

    void add_arguments(Op function, std::int32_t o, std::vector<Expr>& arguments) {
        const Operation& op = at(o);
        if (op.op != function || stands_alone(o)) {
            arguments.push_back(operand(o));
            return;
        }
        add_arguments(function, op.a, arguments);
        add_arguments(function, op.b, arguments);
    }

    /// Below a determinant over a named one, that one is written out: the quotient of two determinants.
    [[nodiscard]] Expr divisor(const Expr& above, std::int32_t o) {
        if (!is_determinant(above) || !stands_alone(o) || !crosses(o)) return operand(o);
        static_cast<void>(term_of_name(o));
        return ui::linked(determinant(at(o)), link_of(name_of(o)));
    }

    [[nodiscard]] Expr inner(std::int32_t o) {
        const Operation& op = at(o);
        if (constant(o)) return value_term(op.value);
        switch (op.op) {
            case Op::input:
            case Op::constant: return value_term(op.value);
            case Op::same:
            case Op::to_real: return operand(op.a);
            case Op::add:
            case Op::subtract: {
                if (crosses(o)) return determinant(op);
                std::vector<Expr> terms;
                add_terms(o, terms);
                return terms.size() == 1 ? std::move(terms.front()) : ui::sum(std::move(terms));
            }
            case Op::multiply: return product(o);
            case Op::divide: {
                Expr above = operand(op.a);
                Expr below = divisor(above, op.b);
                return ui::quotient(std::move(above), std::move(below));
            }
            case Op::negate: {
                Expr e = operand(op.a);
                return e.op == ui::Op::negation ? Expr(e.parts.front()) : ui::negation(std::move(e));
            }
            case Op::floor: return ui::floor_of(operand(op.a));
            case Op::choose: return choice(op);
            case Op::lesser:
            case Op::greater_of: {
                std::vector<Expr> arguments;
                add_arguments(op.op, op.a, arguments);
                add_arguments(op.op, op.b, arguments);
                return ui::call(function_name(op.op), std::move(arguments));
            }
            case Op::trunc:
            case Op::ceil:
            case Op::round_even:
            case Op::single:
            case Op::invert: return ui::call(function_name(op.op), {operand(op.a)});
            default: break;
        }
        Expr left = side(op.op, op.a);
        return ui::relation(std::move(left), relation_sign(op.op), side(op.op, op.b));
    }

    /// A side of a relation; another relation in it stands in parentheses, but for comparisons joined by ∧ and ∨.
    [[nodiscard]] Expr side(Op around, std::int32_t o) {
        Expr e = operand(o);
        const bool sum_beside_bits = e.op == ui::Op::sum && (around == Op::bit_and || around == Op::modulo);
        const bool joins = e.op == ui::Op::relation && (e.signs.front() == "∧" || e.signs.front() == "∨");
        const bool compares = around == Op::both || around == Op::either;
        if (!sum_beside_bits && (e.op != ui::Op::relation || (compares && !joins))) return e;
        return ui::call("", {std::move(e)});
    }

    /// A coefficient, which has a subscript, stands before the coordinate, which has none: u_x X.
    [[nodiscard]] Expr product(std::int32_t o) {
        const Operation& op = at(o);
        std::vector<Expr> factors;
        add_factors(o, factors);
        if (factors.size() == 2 && bare(op.a) && subscripted(op.b)) std::swap(factors[0], factors[1]);
        return ui::product(std::move(factors));
    }
    [[nodiscard]] bool bare(std::int32_t o) const {
        return stands_alone(o) && text_of(name_of(o)).find('_') == std::string::npos;
    }
    [[nodiscard]] bool subscripted(std::int32_t o) const {
        return stands_alone(o) && text_of(name_of(o)).find('_') != std::string::npos;
    }

    /// choose(a < b, a, b) is the lesser of the two; anything else is said in words.
    [[nodiscard]] Expr choice(const Operation& op) {
        const Operation& test = at(op.a);
        if (test.op == Op::less && test.a == op.b && test.b == op.c)
            return ui::call("min", {operand(op.b), operand(op.c)});
        Expr condition = operand(op.a), then = operand(op.b);
        return ui::sequence({std::move(then), ui::word("if"), std::move(condition), ui::word("else"), operand(op.c)});
    }

    const Tape& tape_;
    std::vector<std::int32_t> names_, used_;
    std::vector<std::string> texts_;
    std::int32_t target_;
    bool numbers_;
};

[[nodiscard]] const Operation& operation_of(const Tape& tape, std::int32_t named) {
    return tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(named)].operation)];
}

/// Whether every number in it is written in full.
[[nodiscard]] bool all_written(const Tape& tape, const std::vector<std::int32_t>& named) {
    return std::all_of(named.begin(), named.end(),
                       [&](std::int32_t n) { return shown_number(operation_of(tape, n).value).exact; });
}

}  // namespace

ui::Expr symbol_of_name(std::string_view name) {
    const auto [base, sub] = set_name(name);
    return ui::symbol(sub.empty() ? base : base + "_{" + sub + "}");
}

std::string markup_of_name(std::string_view name) {
    const auto [base, sub] = set_name(name);
    return sub.empty() ? "$" + base + "$" : "$" + base + "_{" + sub + "}$";
}

int edge_of_name(std::string_view name) {
    const auto parts = split(name);
    return parts.size() > 1 && is_side(parts.back()) ? parts.back()[0] - 'A' : -1;
}

int corner_of_name(std::string_view name) {
    const auto parts = split(name);
    if (parts.size() != 2 || parts[1].empty() || parts[1].size() > 3) return -1;
    int corner = 0;
    for (const char c : parts[1]) {
        if (c < '0' || c > '9') return -1;
        corner = corner * 10 + (c - '0');
    }
    return corner;
}

std::string_view fault_of(const Value& value) {
    if (undefined(value)) return kNoValue;
    if (!overflowed(value)) return {};
    return std::holds_alternative<Fixed8>(value) ? kLeft8 : kLeft16;
}

ui::Number shown_number(const Value& value, int decimals) {
    if (const bool* truth = std::get_if<bool>(&value)) return {std::string(*truth ? kYes : kNo)};
    if (undefined(value)) return {std::string(kNoValue)};
    ui::Number number = ui::format_number(approximate(value), decimals);
    if (const Integer* whole = std::get_if<Integer>(&value)) {
        const std::string digits = std::to_string(*whole);
        number = *whole < 0 ? ui::Number{std::string(ui::kMinus) + digits.substr(1), true, true} : ui::Number{digits};
    } else if (const Exact* ratio = std::get_if<Exact>(&value)) {
        const Exact scaled = *ratio * Exact(static_cast<Integer>(std::pow(10.0, decimals)));
        number.exact = scaled == Exact(floor(scaled)) && std::abs(approximate(*ratio)) < 1e9;
        if (number.exact && number.text.find('.') != std::string::npos && number.text.find("10") == std::string::npos) {
            number.text.erase(number.text.find_last_not_of('0') + 1);
            if (number.text.back() == '.') number.text.pop_back();
        }
    }
    return number;
}

ui::Expr value_term(const Value& value) {
    if (undefined(value)) return ui::coloured(ui::word(kNoValue), ui::Role::error);
    if (const bool* truth = std::get_if<bool>(&value))
        return ui::coloured(ui::word(*truth ? kYes : kNo), ui::Role::text);
    return ui::number(shown_number(value), fault_of(value).empty() ? ui::Role::text : ui::Role::error);
}

std::string all_digits(const Value& value) {
    if (std::holds_alternative<bool>(value) || undefined(value)) return shown_number(value).text;
    std::string text = full_text(value);
    for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at))
        text.replace(at, 1, ui::kMinus);
    return text;
}

TapeMath math_of(const Tape& tape, std::int32_t named) {
    const std::int32_t operation = tape.names[static_cast<std::size_t>(named)].operation;
    const Operation& op = tape.operations[static_cast<std::size_t>(operation)];
    const std::string name = tape.names[static_cast<std::size_t>(named)].name.text();
    TapeMath math;
    math.name = ui::linked(symbol_of_name(name), link_of(named));
    math.value = ui::linked(value_term(op.value), link_of(named));
    Builder symbols(tape, named, false), numbers(tape, named, true);
    math.symbols = symbols.root(operation);
    math.numbers = numbers.root(operation);
    math.leaf = symbols.used().empty();
    math.tall = is_tall(math.symbols);
    math.fault = fault_of(op.value);
    math.exact = shown_number(op.value).exact;
    if (!math.exact || math.leaf || !fault_of(op.value).empty()) return math;
    // Equal only where what is written gives it: numbers may be shortened, and the format may have rounded.
    const auto written = evaluated(math.numbers, [](const ui::Expr&) { return std::nullopt; });
    math.exact = written ? *written == approximate(op.value) : all_written(tape, symbols.used());
    return math;
}

TapeMath math_of(const Tape& tape, const Named& named) {
    return math_of(tape, static_cast<std::int32_t>(&named - tape.names.data()));
}

std::vector<std::int32_t> operands_of(const Tape& tape, std::int32_t named) {
    Builder builder(tape, named, false);
    static_cast<void>(builder.root(tape.names[static_cast<std::size_t>(named)].operation));
    return builder.used();
}

ui::Expr chain_of(const TapeMath& math, bool marked) {
    std::vector<ui::Expr> parts{marked ? ui::marked(math.name) : math.name};
    std::vector<std::string> signs;
    const auto say = [&](const ui::Expr& e, std::string_view sign) {
        parts.push_back(e);
        signs.emplace_back(sign);
    };
    const bool truth = math.symbols.op == ui::Op::relation && math.value.op == ui::Op::word;
    if (!math.leaf) say(math.symbols, truth ? ":" : "=");
    const bool alias = math.symbols.op == ui::Op::symbol || math.numbers.op == ui::Op::number;
    if (!math.leaf && !alias && !truth) say(math.numbers, "=");
    // NaN's term says by itself that there is no value.
    const bool said = math.fault.empty() || math.value.op == ui::Op::word;
    say(said ? math.value : ui::sequence({math.value, ui::coloured(ui::word(math.fault), ui::Role::error)}),
        truth ? "⇒" : ui::equals_sign(math.exact));
    return ui::relation_chain(std::move(parts), std::move(signs));
}

}  // namespace texelscope
