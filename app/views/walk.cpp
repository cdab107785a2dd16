// The walk down a shape's two sides as a ladder: what a row adds, and where each row so far meets the sides.
#include "app/views/canvas_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"

namespace texelscope::walk_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Walk", kNote = "x at the sides";
constexpr std::string_view kNoRows = "This method does not walk along the sides, or has too many rows to list.";
constexpr std::string_view kNotYet = "Step into a row: here each row so far shows where it meets the two sides.";
constexpr std::string_view kRow = "row", kLeft = "left", kRight = "right", kTwice = "2×";
constexpr std::string_view kEachRow = "a row adds";
constexpr std::string_view kGoTip = "Click to go to row {}.";
constexpr std::array<std::string_view, 2> kSteps{"dx_long", "dx_short"};

class WalkView {
public:
    WalkView(const ViewContext& context, const ui::Area& area)
        : context_(context), ui_(context.ui), area_(area), rows_(canvas::rows_so_far(context)) {}

    void draw() {
        const float line = pitch(ui_, 20, ui::Face::code);
        float y = draw_steps({area_.x, area_.y, area_.w, line});
        ui::hairline(ui_, {area_.x, y}, area_.w);
        draw_head(y + line);
        y = std::round(y + line * 1.3F);
        draw_ladder({area_.x, y, area_.w, std::max(0.0F, area_.bottom() - y)}, line);
    }

private:
    /// Columns: the row's number, x at the left, x at the right, a word.
    [[nodiscard]] float end_of(int column) const {
        constexpr std::array<float, 3> kEnds{.17F, .5F, .83F};
        return std::floor(area_.x + area_.w * kEnds[static_cast<std::size_t>(column)]);
    }

    /// What the two sides add to x in every row, as far as the step knows it. @return where it ends.
    float draw_steps(const ui::Area& first) {
        const ui::Font& font = ui_.font(ui::Face::title);
        float x = first.x, y = first.y;
        ui_.text_within(ui::Face::title, {x, ui::baseline_at_middle(font, first.centre().y)}, area_.w, Role::muted,
                        kEachRow);
        y += first.h;
        for (const std::string_view name : kSteps) {
            const auto value = canvas::number_of(context_.derived, name);
            if (!value) continue;
            const ui::Number number = ui::format_number(*value);
            const ui::MathBox box =
                ui::set_math(ui::relation(ui::symbol(name), ui::equals_sign(number.exact), ui::number(number)),
                             {.fonts = &ui_.fonts(), .size = ui::MathSize::row});
            const float height = std::max(first.h, box.height() + ui_.px(2));
            ui_.formula(box, {x + ui_.px(4), std::round(y + (height + box.ascent - box.descent) / 2)});
            y += height;
        }
        return std::round(y + ui_.px(3));
    }

    void draw_head(float baseline) {
        const auto head = [&](int column, std::string_view text) {
            ui_.text_right(ui::Face::title, {end_of(column), baseline}, Role::muted, text);
        };
        head(0, kRow), head(1, kLeft), head(2, kRight);
    }

    /// The last rows at the bottom, as many as fit; the current one is the last.
    void draw_ladder(const ui::Area& area, float line) {
        foresee(ui_, "walk/scroll", static_cast<float>(rows_.size()) * line);
        const float height = static_cast<float>(rows_.size()) * line;
        follow(ui_, "walk/scroll", area.h, height, height - line, height, height);
        const ui::Area inner = ui_.begin_scroll("walk/scroll", area);
        for (std::size_t n = 0; n < rows_.size(); ++n)
            draw_row(n, {inner.x, inner.y + static_cast<float>(n) * line, inner.w, line});
        ui_.end_scroll(height);
    }

    void draw_row(std::size_t n, const ui::Area& place) {
        const WalkedRow& row = rows_[n];
        const std::string label = fmt::format("row {}", row.y);
        const ui::Control control = ui_.control(
            {fmt::format("walk/{}", row.path.text()), place, ui::Kind::link, label, fmt::format(kGoTip, row.y)});
        if (control.clicked) context_.act(action::StepTo{row.path});
        if (context_.derived.row() && n + 1 == rows_.size()) ui::current_row(ui_, place);
        if (control.hovered) ui::frame(ui_.list(), place, ui_.theme()[Role::now], 1, ui::size::kRadius);
        const ui::Font& font = ui_.font(ui::Face::code);
        const float baseline = ui::baseline_at_middle(font, place.centre().y);
        ui_.text_right(ui::Face::code, {end_of(0), baseline}, Role::text, std::to_string(row.y));
        draw_x(1, row.left, baseline);
        draw_x(2, row.right, baseline);
        if (canvas::drawn_before(rows_, n))
            ui_.text_within(ui::Face::title, {end_of(2) + ui_.px(6), baseline}, area_.right() - end_of(2) - ui_.px(6),
                            Role::text, kTwice);
    }

    void draw_x(int column, double x, float baseline) {
        const float width = end_of(column) - end_of(column - 1) - ui_.px(8);
        for (const int decimals : {3, 2, 1, 0}) {
            const std::string text = ui::format_number(x, decimals).text;
            if (decimals > 0 && ui::text_width(ui_.font(ui::Face::code), text) > width) continue;
            ui_.text_right(ui::Face::code, {end_of(column), baseline}, Role::text,
                           ui::elided(ui_.font(ui::Face::code), text, width));
            return;
        }
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    ui::Area area_;
    std::span<const WalkedRow> rows_;
};

void draw(const ViewContext& context, const ui::Area& place) {
    const ui::Area area = begin_view(context, "walk", place, kTitle, kNote);
    if (context.derived.walked_rows().empty())
        draw_empty(context, area, kNoRows);
    else if (canvas::rows_so_far(context).empty())
        draw_empty(context, area, kNotYet);
    else
        WalkView(context, area).draw();
    context.ui.end_panel();
}

constexpr View kView{"walk", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::walk_view
