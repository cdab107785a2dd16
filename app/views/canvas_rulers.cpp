// The rulers of the canvas, and the plates that stand for them while presenting.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/views/canvas_parts.h"

namespace texelscope::canvas {
namespace {

using ui::Role;

constexpr float kRuler = 16, kColumnLabels = 56, kRowLabels = 32;  ///< [px at 100 %]

struct Tick {
    ui::Area place;
    std::string text;
};

[[nodiscard]] Tick tick(const ui::Ui& ui, ui::Face face, glm::vec2 centre, int value, float pad) {
    std::string text = fmt::format("{}", value);
    const float w = ui::text_width(ui.font(face), text) + 2 * pad, h = std::round(ui.font(face).em * 1.4F);
    return {{std::round(centre.x - w / 2), std::round(centre.y - h / 2), std::ceil(w), h}, std::move(text)};
}

void draw_plate(ui::Ui& ui, const ui::Area& place, const std::string& text, ui::Face face) {
    const ui::Color plain = ui.ground();
    ui.set_ground(ui.theme()[Role::now]);
    ui::fill(ui.list(), place, ui.ground(), ui::size::kBadgeRadius);
    ui.text_centred(face, place, Role::on_now, text);
    ui.set_ground(plain);
}

/// Labels along one ruler: those that fit, then the plate of the current number over them.
class Ruler {
public:
    Ruler(const Sheet& sheet, const ui::Area& area, bool columns) : sheet_(sheet), area_(area), columns_(columns) {}

    void draw(int first, int last, int step, std::optional<int> now) const {
        ui::Ui& ui = sheet_.ui();
        ui.begin_clip(area_);
        std::optional<Tick> plate;
        if (now && *now >= first && *now < last)
            plate = kept(tick(ui, ui::Face::ruler_strong, centre(*now), *now, ui.px(3)));
        const int origin = columns_ ? sheet_.map.origin.x : sheet_.map.origin.y;
        const int start = first + ((origin - first) % step + step) % step;
        for (int n = start; n < last; n += step) {
            const Tick label = tick(ui, ui::Face::ruler, centre(n), n, 0);
            const bool covered = plate && !ui::intersection(plate->place.inset(-2, -2), label.place).empty();
            if (!covered && area_.covers(label.place))
                ui.text_centred(ui::Face::ruler, label.place.inset(-1, 0), Role::muted, label.text);
        }
        if (plate) draw_plate(ui, plate->place, plate->text, ui::Face::ruler_strong);
        ui.end_clip();
    }

private:
    [[nodiscard]] glm::vec2 centre(int n) const {
        const glm::vec2 at = sheet_.map.to_window(glm::dvec2(n) + 0.5);
        return columns_ ? glm::vec2(at.x, area_.centre().y) : glm::vec2(area_.centre().x, at.y);
    }
    /// Wholly inside the ruler, however near its end the number stands.
    [[nodiscard]] Tick kept(Tick t) const {
        t.place.w = std::min(t.place.w, area_.w), t.place.h = std::min(t.place.h, area_.h);
        t.place.x = std::clamp(t.place.x, area_.x, area_.right() - t.place.w);
        t.place.y = std::clamp(t.place.y, area_.y, area_.bottom() - t.place.h);
        return t;
    }

    const Sheet& sheet_;
    ui::Area area_;
    bool columns_;
};

[[nodiscard]] std::optional<int> current_column(const Sheet& sheet) {
    const auto pixel = sheet.ctx.derived.pixel();
    return pixel ? std::optional(pixel->x) : std::nullopt;
}
[[nodiscard]] std::optional<int> current_row(const Sheet& sheet) {
    const auto row = sheet.ctx.derived.row();
    return row ? std::optional(static_cast<int>(*row)) : std::nullopt;
}

}  // namespace

glm::vec2 ruler_room(const ui::Ui& ui, const Framebuffer& frame) {
    if (ui.presenting()) return {0, 0};
    const ui::Font& font = ui.font(ui::Face::ruler_strong);
    const auto width = [&](int n) { return ui::text_width(font, fmt::format("{}", n)); };
    const float widest = std::max(width(frame.origin_y), width(frame.origin_y + frame.height - 1));
    return {std::max(ui.px(kRuler), std::ceil(widest) + 2), std::max(ui.px(kRuler), std::ceil(font.em * 1.4F))};
}

void draw_rulers(const Sheet& sheet, const ui::Area& panel) {
    const ui::Ui& ui = sheet.ui();
    const ui::Area& at = sheet.map.area;
    if (at.x <= panel.x || at.y <= panel.y) return;
    const Rect view = pixels_in_view(sheet.map, sheet.ctx.derived.scene().framebuffer);
    const int across = label_step(sheet.map.zoom, ui.px(kColumnLabels)),
              down = label_step(sheet.map.zoom, ui.px(kRowLabels));
    Ruler(sheet, {at.x - ui.px(4), panel.y + 1, panel.right() - at.x + ui.px(4), at.y - panel.y - 1}, true)
        .draw(view.x0, view.x1, across, current_column(sheet));
    Ruler(sheet, {panel.x, at.y, at.x - panel.x, at.h}, false).draw(view.y0, view.y1, down, current_row(sheet));
}

std::vector<PositionBadge> place_position_badges(Sheet& sheet) {
    const ui::Ui& ui = sheet.ui();
    const ui::Area& area = sheet.map.area;
    const auto pixel = sheet.ctx.derived.pixel();
    std::vector<PositionBadge> badges;
    const auto add = [&](glm::dvec2 scene, int value, bool column) {
        Tick badge = tick(ui, ui::Face::ruler_strong, sheet.map.to_window(scene + 0.5), value, ui.px(4));
        ui::Area& at = badge.place;
        at.x = column ? std::clamp(at.x, area.x, area.right() - at.w) : area.x + 1;
        at.y = column ? area.y + 1 : std::clamp(at.y, area.y, area.bottom() - at.h);
        if (pixel && !ui::intersection(at, current_place(sheet, *pixel)).empty()) {
            if (column)
                at.y = area.bottom() - at.h - 1;
            else
                at.x = area.right() - at.w - 1;
        }
        sheet.labels.block(at);
        badges.push_back({at, std::move(badge.text)});
    };
    const auto column = current_column(sheet), row = current_row(sheet);
    if (column) add({*column, sheet.map.origin.y}, *column, true);
    if (row) add({sheet.map.origin.x, *row}, *row, false);
    return badges;
}

void draw_position_badges(const Sheet& sheet, const std::vector<PositionBadge>& badges) {
    for (const PositionBadge& badge : badges) draw_plate(sheet.ui(), badge.place, badge.text, ui::Face::ruler_strong);
}

}  // namespace texelscope::canvas
