// What numbers of limited length cost along a row: for each pixel, u and v less those of exact arithmetic, as two
// ribbons about zero; and a mark at every pixel that reads another texel for it.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"

namespace texelscope::ribbon_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Error along the row", kTab = "Error", kNote = "{} − exact [texels]";
constexpr std::string_view kNoRow = "Step into a row: the error of its numbers shows here, in texels.";
constexpr std::string_view kEmptyRow = "Nothing is drawn in this row.";
constexpr std::string_view kOthers = "another texel at {} of {} pixels", kNoOthers = "the same texel at all {} pixels";
constexpr std::string_view kShape = "shape: {} of {} texels wrong", kEnd = "at x = {}";
constexpr std::string_view kTip =
    "How far $u$ and $v$ are from those of the same method in exact numbers. A triangle marks a pixel that reads "
    "another texel.";
constexpr double kMostDecimals = 5;  ///< of the scale; smaller numbers have a power of ten
constexpr float kMark = 3.5F;        ///< [px at 100 %]

/// The least of 1, 2 or 5 times a power of ten that is not below `most`.
[[nodiscard]] double rounded_up(double most) {
    if (!(most > 0)) return 1;
    const double unit = std::pow(10.0, std::floor(std::log10(most)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * unit >= most * (1 - 1e-12)) return step * unit;
    }
    return 10 * unit;
}

class RibbonView {
public:
    RibbonView(const ViewContext& context, const ui::Area& area)
        : context_(context), ui_(context.ui), area_(area), row_(context.derived.row_error()) {
        double most = 0;
        for (const RowError::At& at : row_.pixels) {
            for (const double e : {at.u, at.v})
                if (std::isfinite(e)) most = std::max(most, std::abs(e));
        }
        end_ = rounded_up(most), none_ = most == 0;
    }

    void draw() {
        const float line = pitch(ui_, 19, ui::Face::prose), label = pitch(ui_, 17, ui::Face::count);
        const float below = 3 * line + ui_.px(4);
        const float left = area_.x + scale_width() + ui_.px(8);
        plot_ = {left, area_.y + label / 2, std::max(1.0F, area_.right() - left - ui_.px(2)),
                 std::max(ui_.px(24), area_.h - below - label / 2 - ui_.px(2 * kMark + 6))};
        take_input();
        draw_scale();
        draw_ribbon(Role::v, [](const RowError::At& at) { return at.v; });
        draw_ribbon(Role::u, [](const RowError::At& at) { return at.u; });
        draw_marks();
        draw_current();
        draw_words({area_.x, plot_.bottom() + ui_.px(2 * kMark + 6), area_.w, below}, line);
    }

private:
    [[nodiscard]] std::string scale_text(double value) const {
        const double needed = std::max(0.0, -std::floor(std::log10(end_)));
        const int decimals = needed > kMostDecimals ? 0 : static_cast<int>(needed);
        return none_ && value != 0 ? std::string() : ui::format_number(value, decimals).text;
    }
    [[nodiscard]] float scale_width() const {
        const ui::Font& font = ui_.font(ui::Face::count);
        return std::max(ui::text_width(font, scale_text(end_)), ui::text_width(font, scale_text(-end_)));
    }
    /// The window's place of pixel x's left border.
    [[nodiscard]] float x_at(Integer x) const {
        const Integer first = row_.pixels.front().x, count = row_.pixels.back().x - first + 1;
        return plot_.x + plot_.w * static_cast<float>(x - first) / static_cast<float>(count);
    }
    [[nodiscard]] float y_at(double error) const {
        return plot_.centre().y - static_cast<float>(std::clamp(error / end_, -1.0, 1.0)) * plot_.h / 2;
    }

    /// A click goes to the pixel; hovering lights it up everywhere.
    void take_input() {
        const ui::Control control =
            ui_.control({.name = "ribbon/plot", .area = plot_, .kind = ui::Kind::region, .label = kTitle, .tip = kTip});
        const float share = std::clamp((ui_.input().mouse.x - plot_.x) / plot_.w, 0.0F, .9999F);
        const Integer count = row_.pixels.back().x - row_.pixels.front().x + 1;
        const Integer x = row_.pixels.front().x + static_cast<Integer>(share * static_cast<float>(count));
        const auto y = context_.derived.row();
        canvas::tell_hover(context_, plot_, control.hovered, {.kind = Selection::Kind::pixel, .at = {x, *y}});
        if (!control.clicked) return;
        if (const auto path = context_.derived.steps().at_pixel(context_.derived.shape(), x, *y))
            context_.act(action::StepTo{*path});
    }

    void draw_scale() {
        const ui::Font& font = ui_.font(ui::Face::count);
        const float zero = std::round(plot_.centre().y);
        ui::fill(ui_.list(), plot_, ui_.theme().canvas);
        for (const double value : {end_, 0.0, -end_}) {
            const float y = std::round(y_at(value));
            ui::fill(ui_.list(), {plot_.x, y, plot_.w, 1}, ui_.theme()[value == 0 ? Role::muted : Role::faint]);
            ui_.text_right(ui::Face::count, {plot_.x - ui_.px(6), ui::baseline_at_middle(font, y)}, Role::muted,
                           scale_text(value));
        }
        ui::fill(ui_.list(), {plot_.x, zero, plot_.w, 1}, ui_.theme()[Role::muted]);
    }

    /// From zero to the error, pixel by pixel; its rim is solid for u and dotted for v.
    void draw_ribbon(Role role, auto&& error) {
        const ui::Color color = ui_.theme()[role];
        const float zero = plot_.centre().y;
        float before = zero, free = plot_.x;  // a column of the window is filled once
        for (const RowError::At& at : row_.pixels) {
            const double e = error(at);
            if (!std::isfinite(e)) continue;
            const float left = std::max(free, std::round(x_at(at.x))), right = std::round(x_at(at.x + 1));
            if (right <= left) continue;
            free = right;
            const float y = std::round(y_at(e));
            const float top = std::min(y, zero), bottom = std::max(y, zero);
            ui::fill(ui_.list(), {left, top, right - left, bottom - top}, ui::with_alpha(color, .32F));
            const bool gap = role == Role::v && (at.x & 3) == 3;
            if (!gap) ui::fill(ui_.list(), {left, y - 1, right - left, 2}, color);
            if (std::abs(y - before) > 2 && !gap)
                ui::fill(ui_.list(), {left, std::min(y, before), 1, std::abs(y - before)}, color);
            before = y;
        }
        draw_letter(role, before);
    }
    /// u or v at the ribbon's end, on the plot.
    void draw_letter(Role role, float y) {
        const ui::MathBox letter = ui::set_math(ui::coloured(ui::symbol(role == Role::u ? "u" : "v"), role),
                                                {.fonts = &ui_.fonts(), .size = ui::MathSize::row});
        const float side = role == Role::u ? ui_.px(4) + letter.width : 2 * letter.width + ui_.px(14);
        const float up = y - ui_.px(6), low = y + ui_.px(6) + letter.ascent;
        const bool above = up - letter.ascent > plot_.y;
        const glm::vec2 pen{plot_.right() - side, std::round(above ? up : std::min(low, plot_.bottom() - ui_.px(2)))};
        const ui::Area plate{pen.x - 2, pen.y - letter.ascent - 2, letter.width + 4, letter.height() + 4};
        ui::fill(ui_.list(), plate, ui_.theme().canvas, ui::size::kBadgeRadius);
        ui_.formula(letter, pen);
    }

    /// A triangle under each pixel that reads another texel.
    void draw_marks() {
        const float radius = ui_.px(kMark), y = plot_.bottom() + radius + ui_.px(2);
        for (const RowError::At& at : row_.pixels) {
            if (!at.other) continue;
            const float x = (x_at(at.x) + x_at(at.x + 1)) / 2;
            const std::array<glm::vec2, 3> corners{
                {{x, y - radius}, {x + radius, y + radius}, {x - radius, y + radius}}};
            ui::fill_convex(ui_.list(), corners, ui_.theme()[Role::error]);
        }
    }

    void draw_current() {
        const auto pixel = context_.derived.pixel();
        if (!pixel || pixel->x < row_.pixels.front().x || pixel->x > row_.pixels.back().x) return;
        const float left = x_at(pixel->x), width = std::max(2.0F, x_at(pixel->x + 1) - left);
        ui::frame(ui_.list(), {std::round(left), plot_.y, std::round(width), plot_.h}, ui_.theme()[Role::now], 1);
    }

    void draw_words(const ui::Area& area, float line) {
        const RowError::At& last = row_.pixels.back();
        const std::size_t count = row_.pixels.size();
        float y = area.y + line - ui_.px(5);
        const auto number = [](double e) {
            const ui::Number n = ui::format_number(e);
            return fmt::format("{} {}", ui::equals_sign(n.exact), n.text);
        };
        ui_.rich_within(ui::Face::prose, {area.x, y}, area.w, Role::text,
                        fmt::format("{}: $u$ {}, $v$ {}", fmt::format(kEnd, last.x), number(last.u), number(last.v)));
        y += line;
        const float mark = ui_.px(kMark);
        float x = area.x;
        if (row_.others > 0) {
            const glm::vec2 at{x + mark, y - ui_.font(ui::Face::prose).cap / 2};
            ui::edge_mark(ui_.list(), 2, at, mark, ui_.theme()[Role::error]);
            x += 2 * mark + ui_.px(6);
        }
        ui_.text_within(ui::Face::lead, {x, y}, area.right() - x, Role::text,
                        row_.others > 0 ? fmt::format(kOthers, row_.others, count) : fmt::format(kNoOthers, count));
        y += line;
        // Exact numbers for a whole shape are too slow for each frame of a drag.
        if (ui_.memory().active != 0) return;
        if (const auto shape = context_.derived.shape_error())
            ui_.text_within(ui::Face::prose, {area.x, y}, area.w, Role::muted,
                            fmt::format(kShape, shape->others, shape->pixels));
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    ui::Area area_, plot_;
    const RowError& row_;
    double end_ = 1;  ///< the error at the plot's upper border [texels]
    bool none_ = false;
};

void draw(const ViewContext& context, const ui::Area& place) {
    const std::string note = fmt::format(kNote, id_of(context.state.work.format));
    const ui::Area area = begin_view(context, "ribbon", place, kTitle, note);
    if (!context.derived.row() || context.derived.shape() < 0)
        draw_empty(context, area, kNoRow);
    else if (context.derived.row_error().pixels.empty())
        draw_empty(context, area, kEmptyRow);
    else
        RibbonView(context, area).draw();
    context.ui.end_panel();
}

constexpr View kView{"ribbon", kTab, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::ribbon_view
