// What a recorded run leaves behind: every operation with its operands and result, and the names of results.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/number/exact.h"
#include "core/number/fixed.h"
#include "core/trace/name.h"

namespace texelscope {

enum class Op : std::uint8_t {
    input,     ///< a number from outside: a coordinate, a texel's channel, a loop variable
    constant,  ///< a number that stands in the source
    same,      ///< another name for operand a
    add,
    subtract,
    multiply,
    divide,
    negate,
    to_real,  ///< a whole number as a T
    floor,
    trunc,
    ceil,
    round_even,
    single,  ///< to the nearest float32
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    not_equal,
    both,
    either,
    invert,
    choose,  ///< operand a decides between b and c
    lesser,
    greater_of,
    bit_and,
    modulo,  ///< Euclidean
};

/// The value of one operation, in the type that computed it.
using Value = std::variant<bool, Integer, double, float, Fixed16, Fixed8, Exact>;

struct Operation {
    Op op = Op::constant;
    std::int32_t a = -1, b = -1, c = -1;  ///< operands, as indices of operations; -1 where there is none
    Value value;
};

/// One trace("name", value): an expression, the finest step there is.
struct Named {
    std::int32_t operation = -1;  ///< index of the operation that made the value
    Name name;
    int line = 0;                ///< of the listing, from 1
    bool loop_variable = false;  ///< the variable of a loop, not an expression
};

struct Tape {
    std::vector<Operation> operations;
    std::vector<Named> names;

    /// Appends an operation and returns its index.
    std::int32_t push(Op op, Value value, std::int32_t a = -1, std::int32_t b = -1, std::int32_t c = -1);
};

/// The nearest double of any value; true is 1.
[[nodiscard]] double approximate(const Value& value);
/// Every digit that tells the value apart in its type: "0.5", "true", "3/7", "5.25".
[[nodiscard]] std::string full_text(const Value& value);
/// Whether a fixed-point value, or one that it was made from, left its range.
[[nodiscard]] bool overflowed(const Value& value);
/// Whether the value is NaN, or an exact number without a value.
[[nodiscard]] bool undefined(const Value& value);

}  // namespace texelscope
