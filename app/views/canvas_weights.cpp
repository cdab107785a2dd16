// A point of a triangle and the three areas that it makes with the sides, each in the style of its side.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/views/canvas_parts.h"
#include "app/views/weights.h"

namespace texelscope::canvas {
namespace {

constexpr float kCanvasWeightsHatchStep = 9, kFill = .30F, kLine = 2;

[[nodiscard]] std::array<glm::vec2, 3> area_of(const Sheet& sheet, const WeightedPoint& point, int n) {
    const auto corners = sheet.ctx.derived.drawing().corners(sheet.ctx.derived.shape());
    const auto corner = [&](int k) { return sheet.place(corners[static_cast<std::size_t>((n + k) % 3)]); };
    return {corner(1), corner(2), sheet.sample_place(point.pixel)};
}

}  // namespace

void draw_weight_areas(const Sheet& sheet) {
    const auto point = weighted_point(sheet.ctx);
    if (!point) return;
    for (int n = 0; n < 3; ++n) {
        const auto area = area_of(sheet, *point, n);
        const ui::Color color = sheet.color(ui::edge_role(side_across(n)));
        if (point->inside) {
            ui::fill_convex(sheet.list(), area, ui::with_alpha(sheet.ui().theme().canvas, .55F));
            ui::fill_convex(sheet.list(), area, ui::with_alpha(color, kFill));
            ui::draw_hatch(sheet.list(), area, ui::section_degrees(side_across(n)),
                           sheet.ui().px(kCanvasWeightsHatchStep), sheet.map.at, 1.5F, color);
        }
        ui::line(sheet.list(), area[0], area[2], kLine + 2, sheet.ui().theme().outline);
        ui::line(sheet.list(), area[0], area[2], kLine, sheet.color(ui::Role::text));
    }
}

void draw_weight_labels(Sheet& sheet) {
    const auto point = weighted_point(sheet.ctx);
    if (!point || !point->inside) return;
    ui::Ui& ui = sheet.ui();
    sheet.labels.block(ui::grown_to(sheet.map.place_of(point->pixel), 12));
    for (int n = 0; n < 3; ++n) {
        const auto area = area_of(sheet, *point, n);
        const ui::Number number = ui::format_number(*point->e[static_cast<std::size_t>(n)], 2);
        const ui::MathBox label = ui::set_math(
            ui::relation(ui::symbol(fmt::format("e_{}", n)), ui::equals_sign(number.exact), ui::number(number)),
            {.fonts = &ui.fonts(), .size = ui::MathSize::row});
        const glm::vec2 middle = (area[0] + area[1] + area[2]) / 3.0F, room{ui.px(6), ui.px(3)};
        const glm::vec2 size{std::ceil(label.width + 2 * room.x), std::ceil(label.height() + 2 * room.y)};
        ui::Area plate{std::round(middle.x - size.x / 2), std::round(middle.y - size.y / 2), size.x, size.y};
        if (!sheet.labels.is_free(plate)) {
            const auto beside = sheet.labels.place(middle, size, middle - area[2], ui.px(6));
            if (!beside) continue;
            plate = *beside;
        }
        sheet.labels.block(plate);
        ui::fill(sheet.list(), plate, ui.theme().canvas, ui::size::kBadgeRadius);
        ui::frame(sheet.list(), plate, sheet.color(ui::edge_role(side_across(n))), 1, ui::size::kBadgeRadius);
        const ui::Color ground = ui.ground();
        ui.set_ground(ui.theme().canvas);
        ui.formula(label, {plate.x + room.x, plate.y + room.y + label.ascent});
        ui.set_ground(ground);
    }
}

}  // namespace texelscope::canvas
