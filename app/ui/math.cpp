#include "app/ui/math.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

namespace texelscope::ui {
namespace {

Expr make(Op op, std::vector<Expr> parts) {
    Expr e;
    e.op = op;
    e.parts = std::move(parts);
    return e;
}

std::string with_minus(std::string digits, bool negative) { return negative ? std::string(kMinus) + digits : digits; }

/// figures · 10^n, with the exponent in raised figures.
std::string in_powers_of_ten(double magnitude, int decimals) {
    const std::string e = fmt::format("{:.{}e}", magnitude, decimals);
    const std::size_t at = e.find('e');
    static constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out = e.substr(0, at) + "·10";
    int power = std::atoi(e.c_str() + at + 1);
    if (power < 0) out += "⁻";
    for (const char c : std::to_string(std::abs(power))) out += kRaised[static_cast<std::size_t>(c - '0')];
    return out;
}

}  // namespace

Number format_number(double value, int decimals) {
    if (std::isnan(value)) return {"NaN", true, false};
    const bool negative = std::signbit(value);
    if (std::isinf(value)) return {with_minus("∞", negative), true, negative};
    const double magnitude = std::abs(value);
    // A binary fraction has as many decimals as its denominator has factors of two.
    const double scaled = std::ldexp(magnitude, decimals);
    const bool exact = scaled == std::floor(scaled);
    if (magnitude >= 1e9 || (magnitude > 0 && magnitude < 0.5 * std::pow(10.0, -decimals))) {
        const std::string text = in_powers_of_ten(magnitude, decimals);
        return {with_minus(text, negative), false, negative};
    }
    std::string digits = fmt::format("{:.{}f}", magnitude, decimals);
    if (exact && decimals > 0) {
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.back() == '.') digits.pop_back();
    }
    return {with_minus(digits, negative && magnitude > 0), exact, negative && magnitude > 0};
}

std::string format_full(double value) {
    if (!std::isfinite(value)) return format_number(value).text;
    return with_minus(fmt::format("{}", std::abs(value)), std::signbit(value));
}

Expr symbol(std::string_view name) {
    Expr e;
    e.op = Op::symbol;
    const std::size_t at = name.find('_');
    e.text = std::string(name.substr(0, at));
    if (at != std::string_view::npos) {
        std::string_view sub = name.substr(at + 1);
        if (sub.size() > 1 && sub.front() == '{' && sub.back() == '}') sub = sub.substr(1, sub.size() - 2);
        e.sub = std::string(sub);
    }
    if (e.text == "u") e.role = Role::u;
    if (e.text == "v") e.role = Role::v;
    return e;
}

Expr number(const Number& n, Role role) {
    Expr e;
    e.op = Op::number;
    e.text = n.text;
    e.negative = n.negative;
    e.role = role;
    return e;
}

Expr word(std::string_view text) {
    Expr e;
    e.text = std::string(text);
    e.role = Role::muted;
    return e;
}

Expr sum(std::vector<Expr> parts) { return make(Op::sum, std::move(parts)); }
Expr difference(Expr a, Expr b) { return sum({std::move(a), negation(std::move(b))}); }
Expr product(std::vector<Expr> parts) { return make(Op::product, std::move(parts)); }
Expr quotient(Expr above, Expr below) { return make(Op::quotient, {std::move(above), std::move(below)}); }
Expr negation(Expr of) { return make(Op::negation, {std::move(of)}); }
Expr floor_of(Expr of) { return make(Op::floor, {std::move(of)}); }
Expr sequence(std::vector<Expr> parts) { return make(Op::sequence, std::move(parts)); }

Expr call(std::string_view function, std::vector<Expr> arguments) {
    Expr e = make(Op::call, std::move(arguments));
    e.text = std::string(function);
    return e;
}

Expr determinant(int columns, std::vector<Expr> row_by_row) {
    Expr e = make(Op::determinant, std::move(row_by_row));
    e.columns = columns;
    return e;
}

Expr matrix(int columns, std::vector<Expr> row_by_row) {
    Expr e = make(Op::matrix, std::move(row_by_row));
    e.columns = columns;
    return e;
}

Expr relation(Expr left, std::string_view sign, Expr right) {
    return relation_chain({std::move(left), std::move(right)}, {std::string(sign)});
}

Expr relation_chain(std::vector<Expr> parts, std::vector<std::string> signs) {
    Expr e = make(Op::relation, std::move(parts));
    e.signs = std::move(signs);
    return e;
}

Expr linked(Expr e, LinkId link) {
    e.link = link;
    return e;
}

Expr marked(Expr e) {
    e.marked = true;
    return e;
}

Expr coloured(Expr e, Role role) {
    e.role = role;
    for (Expr& part : e.parts) part = coloured(std::move(part), role);
    return e;
}

}  // namespace texelscope::ui
