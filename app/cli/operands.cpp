#include "app/cli/operands.h"

#include "app/cli/json_line.h"
#include "core/trace/expression.h"

namespace texelscope {
namespace {

/// Walks an expression as the printer of core/trace/expression.cpp does: down to named values, through what is not
/// printed.
class Collector {
public:
    explicit Collector(const Tape& tape) : tape_(tape), names_(names_by_operation(tape)) {}

    void inside(std::int32_t operation, bool as_real) {
        const Operation& o = tape_.operations[static_cast<std::size_t>(operation)];
        if (o.op == Op::input || o.op == Op::constant) return leaf(o, -1, as_real);
        for (const std::int32_t operand : {o.a, o.b, o.c}) {
            if (operand >= 0) at(operand, o.op == Op::to_real || (o.op == Op::same && as_real));
        }
    }
    [[nodiscard]] std::string list() const { return "[" + list_ + "]"; }

private:
    void at(std::int32_t operation, bool as_real) {
        const Operation& o = tape_.operations[static_cast<std::size_t>(operation)];
        const std::int32_t name = names_[static_cast<std::size_t>(operation)];
        if (name >= 0)
            leaf(o, name, as_real);
        else if (o.op == Op::to_real)
            at(o.a, true);
        else
            inside(operation, as_real);
    }
    void leaf(const Operation& o, std::int32_t name, bool as_real) {
        JsonLine line;
        if (name >= 0) line.text("name", tape_.names[static_cast<std::size_t>(name)].name.text());
        line.raw("value", value_json(o.value));
        line.text("type", as_real ? "real" : type_name(o.value));
        if (!list_.empty()) list_ += ',';
        list_ += line.line();
    }

    const Tape& tape_;
    std::vector<std::int32_t> names_;
    std::string list_;
};

}  // namespace

std::string_view type_name(const Value& value) {
    if (std::holds_alternative<bool>(value)) return "truth";
    return std::holds_alternative<Integer>(value) ? "integer" : "real";
}

std::string value_json(const Value& value) {
    return std::holds_alternative<bool>(value) ? full_text(value) : json_number(full_text(value));
}

std::string operands_json(const Tape& tape, const Named& named) {
    Collector collector(tape);
    collector.inside(named.operation, false);
    return collector.list();
}

}  // namespace texelscope
