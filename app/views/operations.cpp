// How many additions, multiplications and divisions a method needs: for one pixel, for its line, for the whole face;
// beside the other methods that draw through one matrix.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/terms.h"

namespace texelscope::operations_view {
namespace {

constexpr std::string_view kTitle = "Operations, counted as they ran", kTab = "Operations";
constexpr std::string_view kNothing = "Nothing is counted here: the shape draws no pixel, or too many.";
constexpr std::string_view kByRows = "{}", kByColumns = "{}, by columns";
constexpr std::string_view kPixel = "a pixel", kRow = "its row", kWhole = "the face";
constexpr std::string_view kTip =
    "{}: {} for a pixel; {} before a line's {} pixels; {} before all {} lines. Reading the texel is not counted.";
constexpr std::array<std::string_view, 3> kSigns{"+", "×", "÷"};
constexpr std::array<std::string_view, 3> kGroups{kPixel, kRow, kWhole};

[[nodiscard]] std::array<Integer, 3> numbers(const OperationCount& n) {
    return {n.additions, n.multiplications, n.divisions};
}
[[nodiscard]] std::string in_words(const OperationCount& n) {
    return fmt::format("{} + {} × {} ÷", n.additions, n.multiplications, n.divisions);
}
[[nodiscard]] std::string name_of(const MethodCost& cost) {
    return fmt::format(fmt::runtime(cost.columns ? kByColumns : kByRows), cost.method->title);
}
[[nodiscard]] OperationCount of_group(const MethodCost& cost, std::size_t group) {
    return group == 0 ? cost.pixel : group == 1 ? cost.whole_line() : cost.whole();
}
/// "its row of 21", where all methods go by rows.
[[nodiscard]] std::string heading(const std::vector<MethodCost>& costs, std::size_t group) {
    if (group == 0) return std::string(kPixel);
    const auto current = std::find_if(costs.begin(), costs.end(), [](const MethodCost& c) { return c.current; });
    const MethodCost& c = current != costs.end() ? *current : costs.front();
    if (group == 1) return fmt::format("{} of {}", c.columns ? "its column" : "its row", c.line_pixels);
    return fmt::format("{} of {}", kWhole, c.pixels);
}

/// A table: a method a row, three numbers a group. Groups that do not fit beside the first stand below it.
class OperationsView {
public:
    OperationsView(const ViewContext& context, const ui::Area& area, const std::vector<MethodCost>& costs)
        : ui_(context.ui), costs_(costs), area_(area), row_(pitch(context.ui, 24, ui::Face::code)) {
        // Numbers decide the columns, so that a drag moves none of them while their digits stay as many.
        const ui::Font& font = ui_.font(ui::Face::code);
        for (std::size_t group = 0; group < kGroups.size(); ++group) {
            std::size_t digits = 2;
            for (const MethodCost& cost : costs_)
                for (const Integer n : numbers(of_group(cost, group)))
                    digits = std::max(digits, std::to_string(n).size());
            cell_[group] = ui::text_width(font, std::string(digits, '0')) + ui_.px(14);
        }
        for (const MethodCost& cost : costs_)
            name_ = std::max(name_, ui::text_width(ui_.font(ui::Face::title), name_of(cost)));
        name_ += ui_.px(20);
    }

    void draw() {
        const float gap = ui_.px(14);
        float all = name_;
        for (const float w : cell_) all += 3 * w + gap;
        const bool beside = all <= area_.w;
        if (!beside) cell_.fill(*std::max_element(cell_.begin(), cell_.end()));  // one below the other
        const float block = row_ * static_cast<float>(costs_.size()) + 2 * pitch(ui_, 18, ui::Face::title) + ui_.px(6);
        const float content = beside ? block : block * static_cast<float>(kGroups.size());
        foresee(ui_, "operations/scroll", content);
        const ui::Area inner = ui_.begin_scroll("operations/scroll", area_);
        name_ = std::min(name_, std::max(0.0F, inner.w - 3 * *std::max_element(cell_.begin(), cell_.end())));
        float x = inner.x + name_, y = inner.y;
        for (std::size_t group = 0; group < kGroups.size(); ++group) {
            const bool named = !beside || group == 0;
            draw_group({inner.x, y, inner.w, block}, x, group, named, beside);
            if (beside)
                x += 3 * cell_[group] + gap;
            else
                y += block;
        }
        ui_.end_scroll(content);
    }

private:
    void draw_group(const ui::Area& area, float x, std::size_t group, bool named, bool beside) {
        const float head = pitch(ui_, 18, ui::Face::title);
        const float width = 3 * cell_[group], left = beside ? x : area.x;
        const auto middle = [&](float top, float height, ui::Face face) {
            return ui::baseline_at_middle(ui_.font(face), top + height / 2);
        };
        ui_.text_within(ui::Face::title, {left, middle(area.y, head, ui::Face::title)}, beside ? width : area.w,
                        ui::Role::muted, heading(costs_, group));
        for (std::size_t n = 0; n < kSigns.size(); ++n)
            ui_.text_right(
                ui::Face::code,
                {x + static_cast<float>(n + 1) * cell_[group] - ui_.px(6), middle(area.y + head, head, ui::Face::code)},
                ui::Role::muted, kSigns[n]);
        float y = area.y + 2 * head;
        if (named) ui::hairline(ui_, {area.x, y}, area.w);
        y += ui_.px(2);
        for (std::size_t k = 0; k < costs_.size(); ++k, y += row_) {
            const MethodCost& cost = costs_[k];
            if (named) draw_name(cost, {area.x, y, area.w, row_}, fmt::format("operations/{}/{}", group, k));
            const auto values = numbers(of_group(cost, group));
            for (std::size_t n = 0; n < values.size(); ++n) {
                const bool division = n == 2 && values[n] > 0;
                ui_.text_right(
                    cost.current ? ui::Face::code_strong : ui::Face::code,
                    {x + static_cast<float>(n + 1) * cell_[group] - ui_.px(6), middle(y, row_, ui::Face::code)},
                    division || cost.current ? ui::Role::text : ui::Role::muted, std::to_string(values[n]));
            }
        }
    }
    void draw_name(const MethodCost& cost, const ui::Area& row, const std::string& name) {
        const std::string tip = fmt::format(kTip, cost.method->title, in_words(cost.pixel), in_words(cost.line),
                                            cost.line_pixels, in_words(cost.setup), cost.lines);
        const ui::Control control = ui_.control({name, row, ui::Kind::link, cost.method->title, tip});
        if (cost.current) ui::current_row(ui_, row);
        if (control.hovered) ui::frame(ui_.list(), row, ui_.theme()[ui::Role::now], 1, ui::size::kRadius);
        ui_.text_within(ui::Face::title,
                        {row.x + ui_.px(8), ui::baseline_at_middle(ui_.font(ui::Face::title), row.centre().y)},
                        name_ - ui_.px(12), cost.current ? ui::Role::text : ui::Role::muted, name_of(cost));
    }

    ui::Ui& ui_;
    const std::vector<MethodCost>& costs_;
    ui::Area area_;
    float row_, name_ = 0;
    std::array<float, 3> cell_{};
};

void draw(const ViewContext& context, const ui::Area& place) {
    const ui::Area area = begin_view(context, "operations", place, kTitle);
    const std::vector<MethodCost>& costs = context.derived.costs();
    if (costs.empty())
        draw_empty(context, area, kNothing);
    else
        OperationsView(context, area, costs).draw();
    context.ui.end_panel();
}

constexpr View kView{"operations", kTab, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::operations_view
