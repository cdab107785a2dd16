#include "core/trace/expression.h"

namespace texelscope {
namespace {

constexpr int kTightest = 100;

class Printer {
public:
    Printer(const Tape& tape, bool numbers) : tape_(tape), numbers_(numbers), names_(names_by_operation(tape)) {}

    [[nodiscard]] std::string root(std::int32_t operation) const { return inner(operation); }

private:
    [[nodiscard]] const Operation& at(std::int32_t operation) const {
        return tape_.operations[static_cast<std::size_t>(operation)];
    }

    [[nodiscard]] std::string number(const Value& value) const {
        std::string text = full_text(value);
        const bool plain = text.find_first_of("-/") == std::string::npos;
        return plain ? text : "(" + text + ")";
    }
    /// An operand: its name or number if it has a name, else its own expression.
    [[nodiscard]] std::string operand(std::int32_t operation, int around, bool right) const {
        const Operation& o = at(operation);
        const std::int32_t name = names_[static_cast<std::size_t>(operation)];
        if (name >= 0) return numbers_ ? number(o.value) : tape_.names[static_cast<std::size_t>(name)].name.text();
        if (o.op == Op::to_real) return operand(o.a, around, right);
        const std::string text = inner(operation);
        const int own = precedence_of(o.op);
        return own < around || (own == around && right) ? "(" + text + ")" : text;
    }
    [[nodiscard]] std::string inner(std::int32_t operation) const {
        const Operation& o = at(operation);
        const int own = precedence_of(o.op);
        switch (o.op) {
            case Op::input:
            case Op::constant: return number(o.value);
            case Op::same:
            case Op::to_real: return operand(o.a, 0, false);
            case Op::negate:
            case Op::invert: return symbol_of(o.op) + operand(o.a, own, true);
            default: break;
        }
        if (is_infix(o.op)) return operand(o.a, own, false) + " " + symbol_of(o.op) + " " + operand(o.b, own, true);
        std::string text = std::string(symbol_of(o.op)) + "(" + operand(o.a, 0, false);
        if (o.b >= 0) text += ", " + operand(o.b, 0, false);
        if (o.c >= 0) text += ", " + operand(o.c, 0, false);
        return text + ")";
    }

    const Tape& tape_;
    bool numbers_;
    std::vector<std::int32_t> names_;
};

}  // namespace

std::vector<std::int32_t> names_by_operation(const Tape& tape) {
    std::vector<std::int32_t> names(tape.operations.size(), -1);
    for (std::size_t n = 0; n < tape.names.size(); ++n) {
        names[static_cast<std::size_t>(tape.names[n].operation)] = static_cast<std::int32_t>(n);
    }
    return names;
}

std::string formula(const Tape& tape, const Named& named) { return Printer(tape, false).root(named.operation); }
std::string substituted(const Tape& tape, const Named& named) { return Printer(tape, true).root(named.operation); }

const char* symbol_of(Op op) {
    switch (op) {
        case Op::add: return "+";
        case Op::subtract:
        case Op::negate: return "-";
        case Op::multiply: return "*";
        case Op::divide: return "/";
        case Op::floor: return "floor";
        case Op::trunc: return "trunc";
        case Op::ceil: return "ceil";
        case Op::round_even: return "round_even";
        case Op::single: return "single";
        case Op::less: return "<";
        case Op::less_equal: return "<=";
        case Op::greater: return ">";
        case Op::greater_equal: return ">=";
        case Op::equal: return "==";
        case Op::not_equal: return "!=";
        case Op::both: return "&&";
        case Op::either: return "||";
        case Op::invert: return "!";
        case Op::choose: return "choose";
        case Op::lesser: return "lesser";
        case Op::greater_of: return "greater";
        case Op::bit_and: return "&";
        case Op::modulo: return "modulo";
        case Op::input:
        case Op::constant:
        case Op::same:
        case Op::to_real: break;
    }
    return "";
}

bool is_infix(Op op) {
    switch (op) {
        case Op::add:
        case Op::subtract:
        case Op::multiply:
        case Op::divide:
        case Op::less:
        case Op::less_equal:
        case Op::greater:
        case Op::greater_equal:
        case Op::equal:
        case Op::not_equal:
        case Op::both:
        case Op::either:
        case Op::bit_and: return true;
        default: return false;
    }
}

int precedence_of(Op op) {
    switch (op) {
        case Op::either: return 1;
        case Op::both: return 2;
        case Op::bit_and: return 3;
        case Op::equal:
        case Op::not_equal: return 4;
        case Op::less:
        case Op::less_equal:
        case Op::greater:
        case Op::greater_equal: return 5;
        case Op::add:
        case Op::subtract: return 6;
        case Op::multiply:
        case Op::divide: return 7;
        case Op::negate:
        case Op::invert: return 8;
        default: return kTightest;
    }
}

}  // namespace texelscope
