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

/// What each name stands for once the tape has come to `last`: one that was given twice, for what it was given last.
[[nodiscard]] std::map<std::string, std::int32_t> latest_by_name(const Tape& tape, std::int32_t last) {
    std::map<std::string, std::int32_t> latest;
    for (std::int32_t n = 0; n <= last; ++n) latest[tape.names[static_cast<std::size_t>(n)].name.text()] = n;
    return latest;
}

[[nodiscard]] const Value& value_of(const Tape& tape, std::int32_t named) {
    return tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(named)].operation)].value;
}

}  // namespace

std::int32_t last_known(const Visit& visit, const Path& step) {
    const std::vector<std::int32_t>& own = visit.unit().expressions;
    const auto all = static_cast<std::int32_t>(visit.tape.names.size());
    if (step.at_expression()) {
        const auto e = static_cast<std::size_t>(step.parts.back().index);
        if (e < own.size()) return own[e];
    }
    std::int32_t last = own.empty() ? -1 : own.back();
    for (std::int32_t n = 0; n < all; ++n) {
        const Named& named = visit.tape.names[static_cast<std::size_t>(n)];
        const std::string name = named.name.text();
        if (named.loop_variable && name.size() == 1 && visit.path.index_of(name[0])) last = std::max(last, n);
    }
    return last >= 0 ? last : all - 1;
}

std::vector<Variable> make_variables(const Visit& visit, const Named* now, const Cursor& cursor, Steps& steps) {
    const Tape& tape = visit.tape;
    const std::vector<std::int32_t> names = names_by_operation(tape);
    const std::int32_t last = last_known(visit, cursor.step);
    const std::map<std::string, std::int32_t> latest = latest_by_name(tape, last);
    std::map<std::string, std::string> before;
    if (const auto previous = steps.previous(cursor.step, cursor.level)) {
        const Visit& earlier = steps.at(*previous);
        for (const auto& [name, n] : latest_by_name(earlier.tape, last_known(earlier, *previous)))
            before[name] = full_text(value_of(earlier.tape, n));
    }

    std::set<std::int32_t> own(visit.unit().expressions.begin(), visit.unit().expressions.end()), used;
    for (const std::int32_t n : own) {
        if (n <= last) mark_used(tape, names, tape.names[static_cast<std::size_t>(n)].operation, true, used);
    }

    std::vector<Variable> variables;
    std::set<std::string> listed;
    const auto list = [&](std::int32_t n) {
        std::string name = tape.names[static_cast<std::size_t>(n)].name.text();
        if (n > last || !listed.insert(name).second) return;
        n = latest.at(name);
        const Value& value = value_of(tape, n);
        const auto old = before.find(name);
        Variable& variable = variables.emplace_back();
        variable.changed = old == before.end() || old->second != full_text(value);
        variable.name = std::move(name), variable.value = value;
        variable.line = tape.names[static_cast<std::size_t>(n)].line;
        variable.own = own.contains(n), variable.named = n;
    };
    const auto is_truth = [&](std::int32_t n) { return std::holds_alternative<bool>(value_of(tape, n)); };
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
