// Prints the expression behind a name: with names ("X * u_x + u_k"), or with the numbers in their place. Either
// text, parsed and evaluated in the number format, gives the value again, digit for digit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/trace/tape.h"

namespace texelscope {

/// For each operation the index of the name it was given, or -1.
[[nodiscard]] std::vector<std::int32_t> names_by_operation(const Tape& tape);

/// The operation that computes `named`: through other names for the same value only as far as the first.
[[nodiscard]] std::string formula(const Tape& tape, const Named& named);
/// The same with every name replaced by all digits of its value; negative numbers stand in parentheses.
[[nodiscard]] std::string substituted(const Tape& tape, const Named& named);

/// The symbol of a binary operation, or the function's name; empty for leaves.
[[nodiscard]] const char* symbol_of(Op op);
/// Whether `op` is written between its two operands.
[[nodiscard]] bool is_infix(Op op);
/// How tightly `op` binds, as in C; functions and leaves bind tightest.
[[nodiscard]] int precedence_of(Op op);

}  // namespace texelscope
