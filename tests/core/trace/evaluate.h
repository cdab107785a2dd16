// An independent evaluator for the laws of the tape: single operations, and printed formulas.
#pragma once

#include <string>

#include "core/trace/tape.h"

namespace texelscope::laws {

/// The value of an operation from the values of its operands.
[[nodiscard]] Value evaluated(const Tape& tape, const Operation& operation);

/// Parses the text of a formula and evaluates it. Names stand for the latest value of that name before operation
/// `before`; the result has the type of `like`. Where the text cannot be read, returns false and says why in `error`.
[[nodiscard]] Value evaluated_text(const Tape& tape, const std::string& text, std::int32_t before, const Value& like,
                                   const Value& real, std::string& error);

/// Equal in type and digits, or both without a value.
[[nodiscard]] bool same_value(const Value& a, const Value& b);

}  // namespace texelscope::laws
