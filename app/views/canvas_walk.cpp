// Dots where each row so far meets the two sides, the current row's span, and rows that are drawn twice.
#include "app/views/canvas_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/views/canvas_parts.h"

namespace texelscope::canvas {
namespace {

using ui::Role;

constexpr std::string_view kTwice = "row {} is drawn twice";
constexpr float kDot = 3.2F, kSquare = 3, kSpan = 3, kEnd = 7;  ///< [px at 100 %]

/// A round mark at the left side, a square one at the right, over black: they lie on texels of any colour.
void draw_meeting(const Sheet& sheet, glm::vec2 at, bool left, bool current) {
    const float radius = sheet.ui().px((left ? kDot : kSquare) + (current ? 1.2F : 0)), edge = 1.5F;
    const ui::Color color = sheet.color(current ? Role::now : Role::text), black = sheet.ui().theme().outline;
    if (left) {
        sheet.list().AddCircleFilled(ui::to_im(at), radius + edge, black, 16);
        sheet.list().AddCircleFilled(ui::to_im(at), radius, color, 16);
        return;
    }
    const auto square = [&](float half, ui::Color c) {
        ui::fill(sheet.list(), {at.x - half, at.y - half, 2 * half, 2 * half}, c);
    };
    square(radius + edge, black);
    square(radius, color);
}

void draw_span(const Sheet& sheet, glm::vec2 from, glm::vec2 to) {
    const float width = sheet.ui().px(kSpan), end = sheet.ui().px(kEnd);
    const ui::Color black = sheet.ui().theme().outline, now = sheet.color(Role::now);
    ui::line(sheet.list(), from, to, width + 3, black);
    ui::line(sheet.list(), from, to, width, now);
    for (const glm::vec2 at : {from, to}) ui::fill(sheet.list(), {std::round(at.x) - 1, at.y - end, 2, 2 * end}, now);
}

void draw_twice(Sheet& sheet, const WalkedRow& row, glm::vec2 left, glm::vec2 right) {
    ui::Ui& ui = sheet.ui();
    const float height = static_cast<float>(sheet.map.zoom), top = sheet.map.to_window({0, row.y}).y;
    const ui::Area band{std::floor(left.x), top, std::ceil(right.x - left.x), std::max(height, 2.0F)};
    static constexpr std::array<float, 2> kDashes{5, 3};
    for (const float y : {band.y, band.bottom()}) {
        const std::array<glm::vec2, 2> path{glm::vec2(band.x, y), {band.right(), y}};
        ui::line(sheet.list(), path[0], path[1], 4, ui.theme().outline);
        ui::draw_dashed(sheet.list(), path, kDashes, 2, sheet.color(Role::error));
    }
    const std::string text = fmt::format(kTwice, row.y);
    const ui::Font& font = ui.font(ui::Face::code_note);
    const glm::vec2 size{std::ceil(ui::text_width(font, text)) + 2 * ui.px(7), std::round(font.em * 1.6F)};
    const auto off = [&](const ui::Area& place) { return !meets_picture(sheet, place); };
    auto plate = sheet.labels.place({band.right(), band.centre().y}, size, {1, 0}, ui.px(10), off);
    if (!plate) plate = sheet.labels.place({band.right(), band.centre().y}, size, {1, 0}, ui.px(10));
    if (!plate) return;
    ui::fill(sheet.list(), *plate, ui.theme().canvas, ui::size::kBadgeRadius);
    ui::frame(sheet.list(), *plate, sheet.color(Role::error), 1, ui::size::kBadgeRadius);
    ui.text_centred(ui::Face::code_note, *plate, Role::text, text);
}

}  // namespace

std::span<const WalkedRow> rows_so_far(const ViewContext& ctx) {
    const std::vector<WalkedRow>& all = ctx.derived.walked_rows();
    const Path& step = ctx.state.cursor.step;
    const auto stage = step.index_of('s'), y = step.index_of('y');
    if (!stage) return all;  // the whole shape
    const auto ahead = [&](const WalkedRow& row) {
        const auto own = row.path.index_of('s');
        return *own > *stage || (*own == *stage && y && row.y > *y);
    };
    const auto end = std::find_if(all.begin(), all.end(), ahead);
    return {all.data(), static_cast<std::size_t>(end - all.begin())};
}

bool drawn_before(std::span<const WalkedRow> rows, std::size_t n) {
    const auto same = [&](const WalkedRow& row) { return row.y == rows[n].y; };
    return std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(n), same);
}

void draw_walk(Sheet& sheet) {
    const auto rows = rows_so_far(sheet.ctx);
    const auto current = sheet.ctx.derived.row();
    const auto meeting = [&](const WalkedRow& row, double x) {
        return sheet.map.to_window({x, static_cast<double>(row.y) + sheet.sample});
    };
    for (std::size_t n = 0; n < rows.size(); ++n) {
        const WalkedRow& row = rows[n];
        const glm::vec2 left = meeting(row, row.left), right = meeting(row, row.right);
        const bool now = current && n + 1 == rows.size() && row.y == *current;
        if (drawn_before(rows, n)) draw_twice(sheet, row, left, right);
        if (now && !sheet.ctx.state.look.hits) draw_span(sheet, left, right);  // counts are not to be hidden
        draw_meeting(sheet, left, true, now);
        draw_meeting(sheet, right, false, now);
    }
}

}  // namespace texelscope::canvas
