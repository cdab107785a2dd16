// The parts that formula.h puts together. Not for views.
#pragma once

#include <string_view>
#include <vector>

#include "app/ui/formula.h"

namespace texelscope::ui {

/// Adds `part` at `at`; the box grows to hold it.
void put(MathBox& into, const MathBox& part, glm::vec2 at);
/// Adds `part` at the right end.
void append(MathBox& into, const MathBox& part);
/// Lays a `now` tint with its underline under what lies within `area`.
void put_mark_under(MathBox& box, const Area& area);

/// Builds boxes of one size. Lengths follow the size; rules are whole pixels.
class MathKit {
public:
    explicit MathKit(const MathSetting& setting);

    [[nodiscard]] float em() const { return em_; }

    /// `text` in the upright face.
    [[nodiscard]] MathBox upright(std::string_view text, Role role) const;
    /// `text` in the face of the prose around formulas.
    [[nodiscard]] MathBox word(std::string_view text, Role role) const;
    /// A variable: one letter italic, words upright; indices italic, figures and names of things upright.
    [[nodiscard]] MathBox symbol(std::string_view base, std::string_view subscript, Role role) const;
    [[nodiscard]] MathBox row(std::vector<MathBox> boxes, float gap) const;
    [[nodiscard]] MathBox with_sign(MathBox left, std::string_view sign, float gap, Role role) const;
    [[nodiscard]] MathBox fraction(const MathBox& above, const MathBox& below) const;
    [[nodiscard]] MathBox determinant(int columns, std::vector<MathBox> cells) const;
    /// The same between square brackets.
    [[nodiscard]] MathBox matrix(int columns, std::vector<MathBox> cells) const;
    /// Parentheses as tall as their content.
    [[nodiscard]] MathBox in_parentheses(const MathBox& inner) const;
    [[nodiscard]] MathBox floor(const MathBox& inner) const;
    [[nodiscard]] MathBox marked(MathBox inner) const;

private:
    [[nodiscard]] MathBox text(MathStyle style, std::string_view text, Role role) const;
    [[nodiscard]] MathBox subscript(std::string_view text, Role role) const;
    [[nodiscard]] float px(float at_16) const { return at_16 * em_ / 16; }
    [[nodiscard]] float rule() const;
    /// Height of the line on which fraction bars and minus signs lie.
    [[nodiscard]] float axis() const;

    const Fonts* fonts_;
    MathSize size_;
    float em_;
};

}  // namespace texelscope::ui
