// The table of variables: what the current expression made, what its unit made, what these were made from, the rest.
#include <algorithm>
#include <map>
#include <set>

#include "app/state/derived_cache.h"
#include "core/trace/expression.h"

namespace texelscope {
namespace {

/// Marks the names that `operation` was computed from, through operations that have no name of their own.
void mark_used(const Tape& tape, const std::vector<std::int32_t>& names, std::int32_t operation, bool root,
               std::set<std::int32_t>& used) {
    if (operation < 0) return;
    const std::int32_t name = names[static_cast<std::size_t>(operation)];
    if (name >= 0 && !root) {
        used.insert(name);
        return;
    }
    const Operation& o = tape.operations[static_cast<std::size_t>(operation)];
    for (const std::int32_t operand : {o.a, o.b, o.c}) mark_used(tape, names, operand, false, used);
}

[[nodiscard]] std::map<std::string, Value> values_by_name(const Visit& visit) {
    std::map<std::string, Value> values;
    for (const Named& named : visit.tape.names) {
        values[named.name.text()] = visit.tape.operations[static_cast<std::size_t>(named.operation)].value;
    }
    return values;
}

}  // namespace

std::vector<Variable> make_variables(const Visit& visit, const Named* now, const Cursor& cursor, Steps& steps) {
    const Tape& tape = visit.tape;
    const std::vector<std::int32_t> names = names_by_operation(tape);
    std::map<std::string, Value> before;
    if (const auto previous = steps.previous(cursor.step, cursor.level)) before = values_by_name(steps.at(*previous));

    std::set<std::int32_t> own(visit.unit().expressions.begin(), visit.unit().expressions.end()), used;
    std::int32_t last = static_cast<std::int32_t>(tape.names.size()) - 1;
    if (cursor.step.at_expression() && now != nullptr) last = static_cast<std::int32_t>(now - tape.names.data());
    for (const std::int32_t n : own) {
        if (n <= last) mark_used(tape, names, tape.names[static_cast<std::size_t>(n)].operation, true, used);
    }

    std::vector<Variable> variables;
    std::set<std::string> listed;
    const auto list = [&](std::int32_t n) {
        const Named& named = tape.names[static_cast<std::size_t>(n)];
        std::string name = named.name.text();
        if (n > last || !listed.insert(name).second) return;
        const Value& value = tape.operations[static_cast<std::size_t>(named.operation)].value;
        const auto old = before.find(name);
        const bool changed = old == before.end() || full_text(old->second) != full_text(value);
        Variable& variable = variables.emplace_back();
        variable.name = std::move(name), variable.value = value, variable.line = named.line;
        variable.changed = changed, variable.own = own.contains(n), variable.named = n;
    };
    const auto is_truth = [&](std::int32_t n) {
        return std::holds_alternative<bool>(
            tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(n)].operation)].value);
    };
    // A name that was given twice stands for its last value, so lists run backwards where that matters.
    const auto list_all = [&](const auto& set, bool truths) {
        for (const std::int32_t n : set) {
            if (is_truth(n) == truths) list(n);
        }
    };
    if (now != nullptr) list(static_cast<std::int32_t>(now - tape.names.data()));
    list_all(own, false);
    list_all(used, false);
    list_all(own, true);
    for (std::int32_t n = last; n >= 0; --n) list(n);
    return variables;
}

}  // namespace texelscope
