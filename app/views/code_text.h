// A listing as text: its functions, the kinds of its words, and lines broken to a width.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/trace/listing.h"

namespace texelscope {

/// A function of the listing, with the comment above it.
struct CodeFunction {
    std::string name;
    int first = 0, last = 0;  ///< lines, from 1, inclusive
    [[nodiscard]] bool has(int line) const { return line >= first && line <= last; }
};
/// Functions with a body, in order; found by their braces and indentation alone.
[[nodiscard]] std::vector<CodeFunction> functions_of(const Listing& listing);
/// The function a line lies in; -1 outside all.
[[nodiscard]] int function_at(std::span<const CodeFunction> functions, int line);
/// Functions whose body calls `callee`, in order.
[[nodiscard]] std::vector<int> callers_of(const Listing& listing, std::span<const CodeFunction> functions, int callee);

enum class TokenKind : std::uint8_t { plain, keyword, comment, string, number, u, v };
struct Token {
    TokenKind kind = TokenKind::plain;
    std::string_view text;
};
/// The words of one line of C++; joined, they are the line.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view line);

/// One row of the screen: a part of a line, or lines folded away.
struct CodeRow {
    int line = 0;            ///< from 1; of a fold, its first
    bool continued = false;  ///< not the first row of its line
    int folded = 0;          ///< how many lines; 0: no fold
    std::string text;        ///< of a fold: what it hides
    bool comment = false;    ///< goes on with a comment that began in a row above
};
/// Breaks a line into rows of at most `columns` characters, before operators where that is possible, in no word unless
/// it is too long; what follows is indented further.
[[nodiscard]] std::vector<std::string> broken(std::string_view line, int columns);

struct CodeRowsSpec {
    std::vector<int> functions;  ///< that are shown, by index
    std::vector<int> unfolded;   ///< first lines of folds that a person opened
    bool plain = true;           ///< trace(…) folded away
    int columns = 69;
};
/// The rows of a listing: functions that are asked for, everything else folded.
[[nodiscard]] std::vector<CodeRow> rows_of(const Listing& listing, std::span<const CodeFunction> functions,
                                           const CodeRowsSpec& spec);

}  // namespace texelscope
