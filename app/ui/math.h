// Formulas as trees, ready to be set; and numbers as they are shown.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/theme.h"
#include "core/base/result.h"

namespace texelscope::ui {

inline constexpr std::string_view kMinus = "−";  ///< U+2212

/// A number as it is shown.
struct Number {
    std::string text;   ///< a minus is U+2212
    bool exact = true;  ///< the text is the value, not a rounding of it
    bool negative = false;
};

/// At most `decimals` [0, 16] places; fewer where the value has fewer, all of them where it is rounded. Powers of ten
/// where that would show no figure of the value, or over 9 before the point. NaN and infinities have names.
[[nodiscard]] Number format_number(double value, int decimals = 4);
/// The shortest text that reads back as the same double, for hovering.
[[nodiscard]] std::string format_full(double value);
/// "=" where what stands beside it is the value itself, else "≈".
[[nodiscard]] constexpr std::string_view equals_sign(bool exact) { return exact ? "=" : "≈"; }

/// What a term stands for, chosen by the view that made the formula; 0 is nothing.
using LinkId = std::uint64_t;

enum class Op : std::uint8_t {
    symbol,       ///< text and sub
    number,       ///< text
    word,         ///< text, upright and muted
    sum,          ///< parts; one that is a negation, or a folded negative number, is subtracted
    product,      ///< parts
    quotient,     ///< parts[0] over parts[1]
    slash,        ///< parts[0] / parts[1] in the line
    negation,     ///< parts[0]
    call,         ///< function `text` of parts
    floor,        ///< parts[0]
    determinant,  ///< parts row by row, in `columns`
    matrix,       ///< the same in square brackets
    relation,     ///< parts with one of signs between two
    sequence,     ///< parts beside each other with word spaces
};

struct Expr {
    Op op = Op::word;
    std::string text, sub;
    bool negative = false;  ///< of a number: it stands in parentheses after an operator
    bool marked = false;    ///< the term under work
    Role role = Role::text;
    LinkId link = 0;
    int columns = 0;
    std::vector<std::string> signs;
    std::vector<Expr> parts;
};

/// A variable by its name: u_x, E_A, n_{A,x}, Δ. Names with u or v as letter take that role.
[[nodiscard]] Expr symbol(std::string_view name);
[[nodiscard]] Expr number(const Number& n, Role role = Role::text);
[[nodiscard]] inline Expr number(double value, Role role = Role::text) { return number(format_number(value), role); }
[[nodiscard]] Expr word(std::string_view text);
[[nodiscard]] Expr sum(std::vector<Expr> parts);
[[nodiscard]] Expr difference(Expr a, Expr b);
[[nodiscard]] Expr product(std::vector<Expr> parts);
[[nodiscard]] Expr quotient(Expr above, Expr below);
[[nodiscard]] Expr negation(Expr of);
[[nodiscard]] Expr call(std::string_view function, std::vector<Expr> arguments);
[[nodiscard]] Expr floor_of(Expr of);
[[nodiscard]] Expr determinant(int columns, std::vector<Expr> row_by_row);
[[nodiscard]] Expr matrix(int columns, std::vector<Expr> row_by_row);
[[nodiscard]] Expr relation(Expr left, std::string_view sign, Expr right);
/// left and what it is said to be in turn: u_x = |..| / |..| = … ≈ 0.5348. `signs` has one element less than `parts`.
[[nodiscard]] Expr relation_chain(std::vector<Expr> parts, std::vector<std::string> signs);
[[nodiscard]] Expr sequence(std::vector<Expr> parts);

[[nodiscard]] Expr linked(Expr e, LinkId link);
[[nodiscard]] Expr marked(Expr e);
/// With every symbol and number in it in the role's colour.
[[nodiscard]] Expr coloured(Expr e, Role role);

/// The mathematics between two dollar signs of a lesson: names with subscripts (u_x, n_{A,x}), Greek letters and
/// operators by their TeX names, + - * / ( ) and relations, \frac{a}{b}, \floor{x}, functions f(x), \text{…}.
/// Fails, with the position, on anything else and beyond 1000 characters or 24 levels.
[[nodiscard]] Result<Expr> parse_math(std::string_view text);

}  // namespace texelscope::ui
