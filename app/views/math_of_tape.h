// From what a run left on its tape to mathematics: each operation becomes a term, each name a symbol. No formula is
// written here or in a view: whatever the method computed is what is set.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/math.h"
#include "core/trace/tape.h"

namespace texelscope {

/// A traced name as a symbol: u_x, n_x_A as n_{A,x}, "first_row" upright; u and v in their roles.
[[nodiscard]] ui::Expr symbol_of_name(std::string_view name);
/// The same for text with mathematics: "$n_{A,x}$".
[[nodiscard]] std::string markup_of_name(std::string_view name);
/// 0, 1, 2 for names that belong to side A, B, C of a triangle; -1 for others.
[[nodiscard]] int edge_of_name(std::string_view name);
/// The corner n of names like "x_0" and "v_2"; -1 for others.
[[nodiscard]] int corner_of_name(std::string_view name);

/// A value as it is shown: at most four decimals, "no value" for NaN, `exact` where the text is the value itself.
[[nodiscard]] ui::Number shown_number(const Value& value, int decimals = 4);
/// The same as a term: truths are words, what has no value is in `error`.
[[nodiscard]] ui::Expr value_term(const Value& value);
/// What is wrong with a value: "no value", "left 16.16"; empty where nothing is.
[[nodiscard]] std::string_view fault_of(const Value& value);
/// All digits, with U+2212.
[[nodiscard]] std::string all_digits(const Value& value);

/// Terms link to the name they stand for: index in Tape::names + 1.
[[nodiscard]] constexpr ui::LinkId link_of(std::int32_t named) { return static_cast<ui::LinkId>(named) + 1; }
/// -1 where the link is none.
[[nodiscard]] constexpr std::int32_t named_of(ui::LinkId link) { return static_cast<std::int32_t>(link) - 1; }

/// How one name was computed. `symbols` and `numbers` have the same shape where no name was looked into.
struct TapeMath {
    ui::Expr name;     ///< its symbol
    ui::Expr symbols;  ///< what it was computed from, by name
    ui::Expr numbers;  ///< the same with the numbers in their place
    ui::Expr value;
    std::string_view fault;  ///< as fault_of says
    bool leaf = false;       ///< an input or a constant: nothing to compute, symbols and numbers are the value
    bool tall = false;       ///< has a fraction or a determinant: symbols cannot stand over their numbers
    bool exact = true;       ///< the numbers, as shown, give the value as shown
};
[[nodiscard]] TapeMath math_of(const Tape& tape, std::int32_t named);
[[nodiscard]] TapeMath math_of(const Tape& tape, const Named& named);

/// The names that `named` was computed from, in the order in which its formula has them; once each.
[[nodiscard]] std::vector<std::int32_t> operands_of(const Tape& tape, std::int32_t named);

/// name = symbols = numbers = value, without what would be said twice. `marked` puts the name under work.
[[nodiscard]] ui::Expr chain_of(const TapeMath& math, bool marked);

/// The value of a term, in double. A symbol's is asked of `value_of`.
/// @return nothing where a part has no value or is no mathematics.
using SymbolValue = std::function<std::optional<double>(const ui::Expr&)>;
[[nodiscard]] std::optional<double> evaluated(const ui::Expr& e, const SymbolValue& value_of);

}  // namespace texelscope
