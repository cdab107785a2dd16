// What the formula view shows at a step, before it is placed: formulas set as boxes that fit a width.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/ui/formula.h"
#include "app/views/view.h"

namespace texelscope {

struct FormulaBlock {
    ui::MathBox box;
    std::int32_t named = -1;
};

/// One formula: its symbols over their numbers where it is one line, else a chain, broken where it is too wide;
/// smaller where that helps.
[[nodiscard]] FormulaBlock formula_block(const ui::Fonts& fonts, const Tape& tape, std::int32_t named, bool marked,
                                         float width);
/// One line "name = symbols = numbers = value", broken where it is too wide.
[[nodiscard]] FormulaBlock formula_line(const ui::Fonts& fonts, const Tape& tape, std::int32_t named, bool marked,
                                        float width);

/// A line for each name, all in the same size: the largest in which each of them can be set by itself.
[[nodiscard]] std::vector<FormulaBlock> formula_list(const ui::Fonts& fonts, const Tape& tape,
                                                     std::span<const std::int32_t> names, std::int32_t now,
                                                     float width);

/// Whether the step shows a whole list: a stage or a row, where no one expression is under work.
[[nodiscard]] bool shows_list(const Visit& visit, const Cursor& cursor);
/// The computed names of the current unit, in order; one that was given twice stands where it was given last.
[[nodiscard]] std::vector<std::int32_t> listed_names(const Visit& visit);
/// The computed names that `named` was made from, in the order in which its formula has them: those of
/// earlier units first.
[[nodiscard]] std::vector<std::int32_t> setup_names(const Visit& visit, std::int32_t named);
/// "Δ = 446.875 twice the area", "side B, from P_1 to P_2", with mathematics between dollar signs; else empty.
[[nodiscard]] std::string formula_note(const Derived& derived, std::int32_t named);

}  // namespace texelscope
