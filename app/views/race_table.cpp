#include "app/views/race_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/views/terms.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::array<std::string_view, 3> kStages{"set-up", "rows", "pixels"};
constexpr std::array<Role, 3> kStageRoles{Role::section_2, Role::section_5, Role::section_1};
constexpr std::string_view kWidestNumber = "88.8 M";
constexpr float kMostNames = .42F, kLeastBar = .25F;  ///< of the width

}  // namespace

std::string grouped(double number) {
    std::string digits = fmt::format("{:.0f}", number);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

std::string brief(double number) {
    const auto three = [](double x) { return fmt::format("{:.{}f}", x, x < 9.995 ? 2 : x < 99.95 ? 1 : 0); };
    if (number >= 999.5e3) return three(number / 1e6) + " M";
    if (number >= 9999.5) return fmt::format("{:.0f} k", number / 1e3);
    return three(number);
}

std::string percent(double share) { return fmt::format("{:.{}f} %", 100 * share, share < .0995 ? 1 : 0); }

RaceTable::RaceTable(ui::Ui& ui, float width, float names, std::string_view widest_heading)
    : ui_(ui),
      row_(pitch(ui, 20, Face::code)),
      name_(std::min(names + ui.px(20), width * kMostNames)),
      number_(std::max(ui::text_width(ui.font(Face::code), kWidestNumber),
                       ui::text_width(ui.font(Face::title), widest_heading)) +
              ui.px(12)) {
    while (columns_ > 1 && width - name_ - numbers_width() < width * kLeastBar) --columns_;
}

float RaceTable::baseline(Face face, const Area& row) const {
    return ui::baseline_at_middle(ui_.font(face), row.y + row.h / 2);
}

Area RaceTable::bar_place(const Area& row) const {
    const float x = row.x + name_, right = row.right() - numbers_width();
    return {x, row.y + std::round(row.h * .2F), std::max(0.0F, right - x), std::round(row.h * .6F)};
}

void RaceTable::number(const Area& row, int column, std::string_view text, bool strong) const {
    if (column >= columns_) return;
    const float right = row.right() - number_ * static_cast<float>(column) - ui_.px(4);
    ui_.text_right(strong ? Face::code_strong : Face::code, {right, baseline(Face::code, row)},
                   strong ? Role::text : Role::muted, text);
}

void RaceTable::heading(const Area& row, int column, std::string_view text) const {
    if (column >= columns_) return;
    const float right = row.right() - number_ * static_cast<float>(column) - ui_.px(4);
    ui_.text_right(Face::title, {right, baseline(Face::title, row)}, Role::muted, text);
}

/// Set-up is hatched, so that it is told apart without colours, too.
void RaceTable::part(const Area& place, std::size_t stage) const {
    if (place.w <= 0) return;
    const ui::Color color = ui_.theme()[kStageRoles[stage]];
    ui::fill(ui_.list(), place, ui::with_alpha(color, stage == 0 ? .45F : .9F));
    if (stage != 0 || place.w < 3) return;
    const std::array<glm::vec2, 4> corners{
        {{place.x, place.y}, {place.right(), place.y}, {place.right(), place.bottom()}, {place.x, place.bottom()}}};
    ui::draw_hatch(ui_.list(), corners, 45, ui_.px(5), {place.x, place.y}, 1.2F, color);
}

void RaceTable::bar(const Area& row, double most, const std::array<double, 3>& stages) const {
    const Area whole = bar_place(row);
    const auto at = [&](double value) {
        return most > 0 ? std::round(whole.w * static_cast<float>(value / most)) : 0.0F;
    };
    double before = 0;
    for (std::size_t n = 0; n < stages.size(); ++n) {
        const float from = at(before);
        before += stages[n];
        part({whole.x + from, whole.y, at(before) - from, whole.h}, n);
    }
}

/// Of a stage in the legend: its mark, its name, the space behind it.
float RaceTable::entry_width(std::size_t stage) const {
    return std::round(row_ * .5F) + ui_.px(5) + ui::text_width(ui_.font(Face::title), kStages[stage]) + ui_.px(12);
}

float RaceTable::legend_width() const {
    float all = 0;
    for (std::size_t n = 0; n < kStages.size(); ++n) all += entry_width(n);
    return all;
}

void RaceTable::legend(const Area& row, float right) const {
    const float side = std::round(row_ * .5F);
    float x = right - legend_width();
    for (std::size_t n = 0; n < kStages.size(); ++n) {
        part({x, std::round(row.y + (row.h - side) / 2), side, side}, n);
        ui_.text(Face::title, {x + side + ui_.px(5), baseline(Face::title, row)}, Role::muted, kStages[n]);
        x += entry_width(n);
    }
}

}  // namespace texelscope
