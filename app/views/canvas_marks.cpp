// Marks on single pixels: ghosts, what is hovered and pinned, answers, the current pixel.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/views/canvas_parts.h"
#include "core/conventions.h"

namespace texelscope::canvas {
namespace {

using ui::Role;

constexpr std::string_view kPixelTip = "pixel **{}, {}**: {}";
constexpr std::string_view kWrites = ", written {}× of {}";
constexpr std::string_view kColour = ", `#{:02x}{:02x}{:02x}`";
constexpr std::string_view kGhostTip = ", a ghost: a stale slot of the row buffer was drawn";
constexpr std::size_t kFramed = 600;  ///< beyond so many, selected pixels are tinted, not framed
constexpr float kLeastRing = 6;       ///< a ring around a pixel is at least so wide [px]
constexpr float kTint = .45F;

[[nodiscard]] ui::Area ring_place(const Sheet& sheet, glm::ivec2 pixel) {
    return ui::grown_to(sheet.map.place_of(pixel), kLeastRing);
}

void mark_pixels(const Sheet& sheet, const std::vector<glm::ivec2>& pixels, bool pinned) {
    const ui::Color now = sheet.color(Role::now), outline = sheet.ui().theme().outline;
    std::vector<ui::Area> places;
    for (const glm::ivec2 pixel : pixels) {
        const ui::Area place = sheet.map.place_of(pixel);
        if (!ui::intersection(ui::grown_to(place, 1), sheet.map.area).empty()) places.push_back(place);
    }
    for (const ui::Area& place : places) {
        if (places.size() > kFramed) {
            ui::fill(sheet.list(), ui::grown_to(place, 1), ui::with_alpha(now, kTint));
        } else if (pinned) {
            ui::pixel_ring(sheet.list(), ui::grown_to(place, kLeastRing), now, outline, 2.5F);
        } else {
            const ui::Area around = ui::grown_to(place, kLeastRing);
            ui::frame(sheet.list(), around.inset(-2, -2), outline);
            ui::frame(sheet.list(), around.inset(-1, -1), now);
            ui::frame(sheet.list(), around, outline);
        }
    }
}

/// Four corners of a square: a chosen place, told from rings by its shape.
void brackets(const Sheet& sheet, const ui::Area& place, ui::Color color, float width) {
    const float arm = std::max(3.0F, std::round(place.w / 3));
    for (const float x : {place.x, place.right() - arm}) {
        for (const float y : {place.y, place.bottom() - width}) ui::fill(sheet.list(), {x, y, arm, width}, color);
    }
    for (const float x : {place.x, place.right() - width}) {
        for (const float y : {place.y, place.bottom() - arm}) ui::fill(sheet.list(), {x, y, width, arm}, color);
    }
}

}  // namespace

void draw_ghosts(const Sheet& sheet) {
    const Window& window = sheet.picture.window;
    const Grid<CanvasCell>& cells = sheet.picture.cells;
    for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            if (cells.at(x, y).note != Note::ghost) continue;
            const glm::ivec2 pixel(window.rect.x0 + x * window.stride, window.rect.y0 + y * window.stride);
            const ui::Area place = ring_place(sheet, pixel);
            const std::array<glm::vec2, 5> path{glm::vec2(place.x, place.y),
                                                {place.right(), place.y},
                                                {place.right(), place.bottom()},
                                                {place.x, place.bottom()},
                                                {place.x, place.y}};
            static constexpr std::array<float, 2> kDashes{4, 3};
            ui::draw_dashed(sheet.list(), path, {}, 4, sheet.ui().theme().outline);
            ui::draw_dashed(sheet.list(), path, kDashes, 2, sheet.color(Role::error));
            ui::cross(sheet.list(), place.centre(), place.w / 5, 1.6F, sheet.color(Role::error));
        }
    }
}

void draw_selections(const Sheet& sheet) {
    mark_pixels(sheet, sheet.ctx.hover.pixels, false);
    mark_pixels(sheet, sheet.ctx.pinned.pixels, true);
}

void draw_answer(const Sheet& sheet) {
    const Pointing answer = pointing(sheet.ctx.state, Prediction::Kind::pixel);
    const Role role = answer.verdict == Answer::Verdict::wrong ? Role::error : Role::text;
    for (const glm::ivec2 pixel : answer.places) {
        const ui::Area place = ring_place(sheet, pixel).inset(-2, -2);
        brackets(sheet, place.inset(-1, -1), sheet.ui().theme().outline, 5);
        brackets(sheet, place, sheet.color(role), 3);
    }
}

void draw_current_pixel(const Sheet& sheet) {
    const auto pixel = sheet.ctx.derived.pixel();
    if (!pixel) return;
    const ui::Ui& ui = sheet.ui();
    const float width = ui.presenting() ? 3.5F : 2.5F;
    ui::pixel_ring(sheet.list(), ring_place(sheet, *pixel), sheet.color(Role::now), ui.theme().outline, width);
    if (sheet.map.zoom < 8) return;
    // The method says where it samples; a quirk may have it at the corner.
    const double x = number_of(sheet.ctx.derived, "X").value_or(pixel->x + kSample);
    const double y = number_of(sheet.ctx.derived, "Y").value_or(pixel->y + kSample);
    const glm::vec2 at = sheet.map.to_window({x, y});
    sheet.list().AddCircleFilled(ui::to_im(at), ui.px(3.5F), ui.theme().outline);
    sheet.list().AddCircleFilled(ui::to_im(at), ui.px(2.2F), sheet.color(Role::now));
}

std::string describe(const Sheet& sheet, glm::ivec2 pixel) {
    const CanvasCell* cell = sheet.cell(pixel);
    if (cell == nullptr) return {};
    const bool reached = cell->visited || cell->will_be_visited;
    std::string text = fmt::format(kPixelTip, pixel.x, pixel.y, text_of(reached ? cell->fate : Fate::outside_box));
    if (cell->will_be_written) {
        const Derived& derived = sheet.ctx.derived;
        text += fmt::format(kWrites, derived.writers(pixel).size(), derived.writes_in_all(pixel));
    }
    if (cell->written) text += fmt::format(kColour, cell->now.r, cell->now.g, cell->now.b);
    if (cell->note == Note::ghost) text += kGhostTip;
    return text;
}

}  // namespace texelscope::canvas
