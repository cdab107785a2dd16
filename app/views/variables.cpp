// Every named value at the cursor's step: what changed last comes first.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/terms.h"

namespace texelscope::variables_view {
namespace {

constexpr std::string_view kTitle = "Variables", kNote = "changed first";
constexpr std::string_view kNothing = "Nothing has a value yet. Step forward.";
constexpr int kMostColumns = 4;

struct Grid {
    int columns = 1, rows = 1;    ///< of a band; bands scroll
    float width = 0, height = 0;  ///< of a cell [px]
};

[[nodiscard]] Grid grid_of(const ui::Ui& ui, const ui::Area& area) {
    const float digit = ui::text_width(ui.font(ui::Face::code), "0");
    const float least = std::ceil(11 * digit) + ui.fonts().math(ui::MathSize::row, ui::MathStyle::upright).em * 3.4F;
    Grid grid;
    grid.columns = std::clamp(static_cast<int>(area.w / least), 1, kMostColumns);
    grid.width = std::floor(area.w / static_cast<float>(grid.columns));
    grid.height = pitch(ui, 23, ui::Face::code);
    grid.rows = std::max(1, static_cast<int>((area.h + 1) / grid.height));
    return grid;
}

class VariablesView {
public:
    VariablesView(const ViewContext& context, const ui::Area& area)
        : context_(context),
          ui_(context.ui),
          tape_(context.derived.visit().tape),
          area_(area),
          grid_(grid_of(ui_, area)),
          now_(current_name(context.derived)) {
        area_.h = std::min(area_.h, static_cast<float>(grid_.rows) * grid_.height);  // whole rows, so that none is cut
    }

    void draw() {
        const std::vector<Variable>& variables = context_.derived.variables();
        const auto count = static_cast<int>(variables.size()), band = grid_.columns * grid_.rows;
        const int last = count % band, bands = count / band;
        const int rows = bands * grid_.rows + (last == 0 ? 0 : std::min(last, grid_.rows));
        foresee(ui_, "variables/scroll", static_cast<float>(rows) * grid_.height);
        const ui::Area inner = ui_.begin_scroll("variables/scroll", area_);
        const float cell_width = std::floor((inner.w - ui_.px(12)) / static_cast<float>(grid_.columns));
        for (int n = 0; n < count; ++n) {
            const int within = n % band, column = within / grid_.rows,
                      row = n / band * grid_.rows + within % grid_.rows;
            const ui::Area cell{inner.x + ui_.px(6) + static_cast<float>(column) * cell_width,
                                inner.y + static_cast<float>(row) * grid_.height, cell_width, grid_.height};
            if (cell.bottom() > area_.y && cell.y < area_.bottom())
                draw_variable(variables[static_cast<std::size_t>(n)], cell);
        }
        ui_.end_scroll(static_cast<float>(rows) * grid_.height);
    }

private:
    void draw_variable(const Variable& variable, const ui::Area& cell) {
        const ui::Area row{cell.x - ui_.px(6), cell.y + 1, cell.w - ui_.px(8), cell.h - ui_.px(2)};
        const ui::Color ground = ui_.ground();
        if (variable.named == now_) {
            ui::current_row(ui_, row);
            ui_.set_ground(ui::over(ui_.theme()[ui::Role::now], ui::alpha::kChosenRow, ground));
        }
        const std::string tip = variable.named < 0 ? std::string() : tip_of(tape_, variable.named);
        const ui::Control control =
            ui_.control({"variables/" + variable.name, row, ui::Kind::link, variable.name, tip});
        act_on_name(context_, control, variable.name);
        if (variable.named != now_ || control.hovered)
            draw_light(ui_, row,
                       control.hovered ? std::max(Light::hovered, light_of_name(context_, variable.name))
                                       : light_of_name(context_, variable.name));
        const float name_end = draw_name(variable.name, cell);
        draw_value(variable, cell, name_end);
        ui_.set_ground(ground);
    }

    /// @return where the name ends.
    float draw_name(const std::string& name, const ui::Area& cell) {
        const ui::MathSetting setting{.fonts = &ui_.fonts(), .size = ui::MathSize::row};
        const ui::Font& font = ui_.fonts().math(ui::MathSize::row, ui::MathStyle::upright);
        const float baseline = ui::baseline_at_middle(font, cell.centre().y) - ui_.px(1), x = cell.x + ui_.px(5);
        const ui::MathBox box = ui::set_math(symbol_of_name(name), setting);
        ui_.formula(box, {x, baseline});
        const int edge = edge_of_name(name);
        if (edge < 0) return x + box.width;
        const float mark = x + std::max(box.width + ui_.px(9), ui_.px(28));
        ui::edge_mark(ui_.list(), edge, {mark, std::round(cell.centre().y) - ui_.px(1)}, ui_.px(3),
                      ui_.theme()[ui::edge_role(edge)]);
        return mark + ui_.px(4);
    }

    void draw_value(const Variable& variable, const ui::Area& cell, float from) {
        const std::string_view fault = fault_of(variable.value);
        const float right = cell.right() - ui_.px(17), room = right - from - ui_.px(6);
        const ui::Font& font = ui_.font(ui::Face::code);
        std::string text = shown_number(variable.value).text;
        if (!fault.empty() && !undefined(variable.value)) {
            const std::string with = text + " " + std::string(fault);
            text = ui::text_width(font, with) <= room ? with : std::string(fault);
        }
        const ui::Role role = !fault.empty()                               ? ui::Role::error
                              : variable.changed || variable.named == now_ ? ui::Role::text
                                                                           : ui::Role::muted;
        ui_.text_right(ui::Face::code, {right, ui::baseline_at_middle(font, cell.centre().y)}, role,
                       ui::elided(font, text, room));
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    const Tape& tape_;
    ui::Area area_;
    Grid grid_;
    std::int32_t now_;
};

void draw(const ViewContext& context, const ui::Area& place) {
    const ui::Area area = begin_view(context, "variables", place, kTitle, kNote);
    if (context.derived.variables().empty())
        draw_empty(context, area, kNothing);
    else
        VariablesView(context, {area.x - context.ui.px(6), area.y, area.w + context.ui.px(12), area.h}).draw();
    context.ui.end_panel();
}

constexpr View kView{"variables", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::variables_view
