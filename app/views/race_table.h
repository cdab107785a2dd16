// The tables of the view `race`: a name, a bar of stages, up to three numbers at the right.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "app/ui/ui.h"

namespace texelscope {

/// Digits in groups of three.
[[nodiscard]] std::string grouped(double number);
/// Three digits, and a letter for thousands or millions.
[[nodiscard]] std::string brief(double number);
/// "6.2 %", "38 %".
[[nodiscard]] std::string percent(double share);

class RaceTable {
public:
    /// @param names  the widest name [px]; it gets at most its share of `width`.
    RaceTable(ui::Ui& ui, float width, float names, std::string_view widest_heading);

    [[nodiscard]] float row_height() const { return row_; }
    [[nodiscard]] float name_width() const { return name_; }
    /// Of all numbers together.
    [[nodiscard]] float numbers_width() const { return number_ * static_cast<float>(columns_); }
    /// Baseline of a line of text in the middle of `row`.
    [[nodiscard]] float baseline(ui::Face face, const ui::Area& row) const;
    [[nodiscard]] ui::Area bar_place(const ui::Area& row) const;

    /// @param column  from the right, 0 to 2; where the bar would be too short, only the first ones are drawn.
    void number(const ui::Area& row, int column, std::string_view text, bool strong) const;
    void heading(const ui::Area& row, int column, std::string_view text) const;
    /// Set-up, rows, pixels, one behind the other; `most` is as long as the place.
    void bar(const ui::Area& row, double most, const std::array<double, 3>& stages) const;
    /// What the parts of a bar are, ending at `right`.
    void legend(const ui::Area& row, float right) const;
    [[nodiscard]] float legend_width() const;

private:
    void part(const ui::Area& place, std::size_t stage) const;
    [[nodiscard]] float entry_width(std::size_t stage) const;

    ui::Ui& ui_;
    float row_, name_, number_;
    int columns_ = 3;
};

}  // namespace texelscope
