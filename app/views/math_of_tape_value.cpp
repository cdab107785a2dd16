// Evaluates terms: the check that what is shown is what was computed.
#include <cmath>
#include <cstdlib>

#include "app/views/math_of_tape.h"

namespace texelscope {
namespace {

using Maybe = std::optional<double>;

[[nodiscard]] Maybe number_of(std::string text) {
    const bool negative = text.rfind(ui::kMinus, 0) == 0;
    if (negative) text.erase(0, ui::kMinus.size());
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0') return std::nullopt;
    return negative ? -value : value;
}

[[nodiscard]] Maybe joined(double a, std::string_view sign, double b) {
    if (sign == "=" || sign == "≈") return a == b;
    if (sign == "≠") return a != b;
    if (sign == "<") return a < b;
    if (sign == "≤") return a <= b;
    if (sign == ">") return a > b;
    if (sign == "≥") return a >= b;
    if (sign == "∧") return a != 0 && b != 0;
    if (sign == "∨") return a != 0 || b != 0;
    if (std::abs(a) > 9e15 || std::abs(b) > 9e15) return std::nullopt;
    const auto x = static_cast<std::int64_t>(a), y = static_cast<std::int64_t>(b);
    if (sign == "&") return static_cast<double>(x & y);
    if (sign == "mod" && y > 0) return static_cast<double>((x % y + y) % y);
    return std::nullopt;
}

[[nodiscard]] Maybe called(std::string_view function, const std::vector<double>& x) {
    if (x.empty()) return std::nullopt;
    double result = x.front();
    for (const double argument : x) {
        if (function == "min") result = argument < result ? argument : result;
        if (function == "max") result = result < argument ? argument : result;
    }
    if (function == "min" || function == "max") return result;
    if (function.empty()) return x.front();
    if (function == "trunc") return std::trunc(x.front());
    if (function == "f32") return static_cast<double>(static_cast<float>(x.front()));
    if (function == "ceil") return std::ceil(x.front());
    if (function == "round") return std::nearbyint(x.front());
    if (function == "not") return x.front() == 0;
    return std::nullopt;
}

[[nodiscard]] Maybe combined(const ui::Expr& e, const std::vector<double>& x) {
    double result = x.empty() ? 0 : x.front();
    switch (e.op) {
        case ui::Op::sum:
            for (std::size_t n = 1; n < x.size(); ++n) result += x[n];
            return result;
        case ui::Op::product:
            for (std::size_t n = 1; n < x.size(); ++n) result *= x[n];
            return result;
        case ui::Op::quotient:
        case ui::Op::slash: return x[0] / x[1];
        case ui::Op::negation: return -x[0];
        case ui::Op::floor: return std::floor(x[0]);
        case ui::Op::call: return called(e.text, x);
        case ui::Op::determinant:
            if (x.size() != 4) return std::nullopt;
            return x[0] * x[3] - x[2] * x[1];
        case ui::Op::relation: {
            Maybe joint = result;
            for (std::size_t n = 1; n < x.size() && joint; ++n) joint = joined(*joint, e.signs[n - 1], x[n]);
            return joint;
        }
        case ui::Op::sequence:  // a if c else b
            if (x.size() != 3) return std::nullopt;
            return x[1] != 0 ? x[0] : x[2];
        default: return std::nullopt;
    }
}

}  // namespace

std::optional<double> evaluated(const ui::Expr& e, const SymbolValue& value_of) {
    if (e.op == ui::Op::symbol) return value_of(e);
    if (e.op == ui::Op::number) return number_of(e.text);
    if (e.op == ui::Op::word) return e.text == "yes" ? Maybe(1.0) : e.text == "no" ? Maybe(0.0) : std::nullopt;
    std::vector<double> parts;
    for (const ui::Expr& part : e.parts) {
        if (e.op == ui::Op::sequence && part.op == ui::Op::word && (part.text == "if" || part.text == "else")) continue;
        const auto value = evaluated(part, value_of);
        if (!value) return std::nullopt;
        parts.push_back(*value);
    }
    return combined(e, parts);
}

}  // namespace texelscope
