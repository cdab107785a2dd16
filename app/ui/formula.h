// Formulas as boxes: measured, then drawn at a pen on the baseline. Every linked term keeps its rectangle.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/ui/fonts.h"
#include "app/ui/geometry.h"
#include "app/ui/math.h"
#include "app/ui/theme.h"

namespace texelscope::ui {

/// Positions are from the box's origin: the left end of its baseline, y down.
struct MathText {
    glm::vec2 at{0};
    const Font* font = nullptr;
    Role role = Role::text;
    bool subscript = false, on_mark = false;
    std::string text;
};
enum class MathShape : std::uint8_t { rule, left_parenthesis, right_parenthesis, mark };
struct MathInk {
    Area area;
    MathShape shape = MathShape::rule;
    Role role = Role::text;
    bool on_mark = false;
};
struct MathLink {
    Area area;
    LinkId id = 0;
};

/// A formula, set. The fonts it was set with must outlive it.
struct MathBox {
    float width = 0, ascent = 0, descent = 0;
    std::vector<MathText> texts;
    std::vector<MathInk> inks;
    std::vector<MathLink> links;

    [[nodiscard]] float height() const { return ascent + descent; }
};

struct MathSetting {
    const Fonts* fonts = nullptr;
    MathSize size = MathSize::row;
    bool fold_signs = false;  ///< a + (−b) as a − b, where width is short
    bool dots = false;        ///< products of symbols with a dot; of numbers always
};

[[nodiscard]] MathBox set_math(const Expr& e, const MathSetting& setting);

/// The largest of `sizes` (tried in order) in which `e` is at most `width` wide; the last where none fits.
[[nodiscard]] MathBox set_math_to_fit(const Expr& e, MathSetting setting, float width, std::span<const MathSize> sizes);

/// A chain of relations, broken before a sign wherever a line would exceed `width`; signs stand under each other.
[[nodiscard]] MathBox set_math_broken(const Expr& e, const MathSetting& setting, float width);

/// `symbols` over `numbers`, each number centred under its symbol, the lower signs muted. A marked first term of
/// `symbols` marks both. Where the two differ in shape they stand one over the other, left-aligned.
[[nodiscard]] MathBox set_substitution(const Expr& symbols, const Expr& numbers, const MathSetting& setting);

/// Below each other with `gap` between, left-aligned; the baseline is the first's.
[[nodiscard]] MathBox stacked(std::span<const MathBox> boxes, float gap);

/// @param pen     baseline's left end; y is rounded to a whole pixel.
/// @param ground  what lies under it, for the letters' contrast on marks.
void draw_math(ImDrawList& list, const Theme& theme, const MathBox& box, glm::vec2 pen, Color ground);

}  // namespace texelscope::ui
