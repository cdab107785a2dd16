// Marks on single pixels: ghosts, what is hovered and pinned, answers, the current pixel.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/views/canvas_parts.h"
#include "core/image/image.h"

namespace texelscope::canvas {
namespace {

using ui::Role;

constexpr std::string_view kPixelTip = "pixel **{}, {}**: {}";
constexpr std::string_view kWrites = ", written {}× of {}";
constexpr std::string_view kColour = ", `#{:02x}{:02x}{:02x}`";
constexpr std::string_view kGhostTip = ", a ghost: a stale slot of the row buffer was drawn";
constexpr std::string_view kSampleNote = "row y is sampled at its top edge, pixel x at its left";
constexpr std::string_view kAsPrinted = "as-printed", kPrintedSample = "as printed: {}";
constexpr std::size_t kRinged = 12;         ///< beyond so many, selected pixels have one border around all
constexpr float kCanvasMarksLeastRing = 6;  ///< a ring around a pixel is at least so wide [px]
constexpr float kBordersFrom = 3;           ///< window pixels per pixel: below, marked pixels are only tinted
constexpr float kTint = .12F, kGlow = .7F;

[[nodiscard]] ui::Area ring_place(const Sheet& sheet, glm::ivec2 pixel) {
    return ui::grown_to(sheet.map.place_of(pixel), kCanvasMarksLeastRing);
}

/// The rings of a few pixels: inside each of them, where there is room, so that neighbours' rings do not meet.
void mark_each(const Sheet& sheet, const std::vector<glm::ivec2>& pixels, bool pinned) {
    const ui::Color now = sheet.color(Role::now), outline = sheet.ui().theme().outline;
    for (const glm::ivec2 pixel : pixels) {
        const ui::Area place = sheet.map.place_of(pixel);
        if (ui::intersection(ui::grown_to(place, 1), sheet.map.area).empty()) continue;
        const float width = pinned ? 2 : 1, room = width + 2;
        const bool inside = pixels.size() > 1 && place.w >= 4 * room;
        const ui::Area around = inside ? place.inset(room, room) : ui::grown_to(place, kCanvasMarksLeastRing);
        if (pinned) {
            ui::pixel_ring(sheet.list(), around, now, outline, width + .5F, 1);
        } else {
            ui::frame(sheet.list(), around.inset(-2, -2), outline);
            ui::frame(sheet.list(), around.inset(-1, -1), now);
            ui::frame(sheet.list(), around, outline);
        }
    }
}

/// Many pixels: a weak tint over all, and one border around them, inside their cells.
void mark_region(const Sheet& sheet, const std::vector<glm::ivec2>& pixels, bool pinned) {
    const Rect view = pixels_in_view(sheet.map, sheet.ctx.derived.scene().framebuffer);
    if (view.empty()) return;
    Grid<std::uint8_t> marked(view.width() + 2, view.height() + 2);  // with an empty frame around the view
    for (const glm::ivec2 p : pixels)
        if (view.contains(p.x, p.y)) marked.at(p.x - view.x0 + 1, p.y - view.y0 + 1) = 1;
    const ui::Color now = sheet.color(Role::now), tint = ui::with_alpha(now, kTint);
    const auto each = [&](auto&& draw) {
        for (int y = 0; y < view.height(); ++y)
            for (int x = 0; x < view.width(); ++x)
                if (marked.at(x + 1, y + 1) != 0)
                    draw(x + 1, y + 1, sheet.map.place_of(glm::ivec2(view.x0 + x, view.y0 + y)));
    };
    each([&](int, int, const ui::Area& place) { ui::fill(sheet.list(), ui::grown_to(place, 1), tint); });
    if (sheet.map.zoom < double{kBordersFrom}) return;
    const auto borders = [&](float width, ui::Color color) {
        each([&](int x, int y, const ui::Area& p) {
            if (marked.at(x - 1, y) == 0) ui::fill(sheet.list(), {p.x, p.y, width, p.h}, color);
            if (marked.at(x + 1, y) == 0) ui::fill(sheet.list(), {p.right() - width, p.y, width, p.h}, color);
            if (marked.at(x, y - 1) == 0) ui::fill(sheet.list(), {p.x, p.y, p.w, width}, color);
            if (marked.at(x, y + 1) == 0) ui::fill(sheet.list(), {p.x, p.bottom() - width, p.w, width}, color);
        });
    };
    const float width = pinned ? 2 : 1;
    borders(width + 1, sheet.ui().theme().outline);
    borders(width, now);
}

void mark_pixels(const Sheet& sheet, const std::vector<glm::ivec2>& pixels, bool pinned) {
    if (pixels.size() > kRinged)
        mark_region(sheet, pixels, pinned);
    else
        mark_each(sheet, pixels, pinned);
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
    // A question's answer is not given away.
    if (!sheet.picture.ghosts || pixel_question_ahead(sheet.ctx.state)) return;
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

ui::Area current_place(const Sheet& sheet, glm::ivec2 pixel) {
    return ui::grown_to(sheet.map.place_of(pixel), 12).inset(-6, -6);
}

void draw_current_pixel(const Sheet& sheet) {
    const auto pixel = sheet.ctx.derived.pixel();
    if (!pixel) return;
    ui::Ui& ui = sheet.ui();
    const auto place = static_cast<std::uint64_t>(pixel->y) << 32U | static_cast<std::uint32_t>(pixel->x);
    if (const float glow = ui.glow("canvas/current", place); glow > 0)
        ui::fill(sheet.list(), sheet.map.place_of(*pixel), ui::with_alpha(sheet.color(Role::now), kGlow * glow));
    const float width = ui.presenting() ? 3.5F * ui.fonts().spec().scale : 2.5F;
    ui::pixel_ring(sheet.list(), ring_place(sheet, *pixel), sheet.color(Role::now), ui.theme().outline, width);
    if (sheet.map.zoom < double{kDotsFrom}) return;
    const glm::vec2 at = sheet.sample_place(*pixel);
    sheet.list().AddCircleFilled(ui::to_im(at), ui.px(3.5F), ui.theme().outline);
    sheet.list().AddCircleFilled(ui::to_im(at), ui.px(2.2F), sheet.color(Role::now));
}

void draw_sample_note(Sheet& sheet) {
    const State& state = sheet.ctx.state;
    if (sheet.sample != 0 || sheet.ctx.derived.shape() < 0 || sheet.map.zoom < double{kDotsFrom}) return;
    ui::Ui& ui = sheet.ui();
    const bool printed = state.work.variant == kAsPrinted;
    const std::string text = printed ? fmt::format(kPrintedSample, kSampleNote) : std::string(kSampleNote);
    const ui::Font& font = ui.font(ui::Face::note);
    const glm::vec2 size{std::ceil(ui::text_width(font, text)) + 2 * ui.px(6), std::round(font.em * 1.7F)};
    const ui::Area a = sheet.map.area.inset(ui.px(6), ui.px(6));
    for (const float y : {a.bottom() - size.y, a.y}) {
        for (const float x : {a.right() - size.x, a.x}) {
            const ui::Area place{std::round(x), std::round(y), size.x, size.y};
            if (!sheet.labels.is_free(place) || meets_picture(sheet, place)) continue;
            sheet.labels.block(place);
            const ui::Color plain = ui.ground();
            ui.set_ground(ui.theme().canvas);
            ui::fill(sheet.list(), place, ui.ground(), ui::size::kBadgeRadius);
            ui.text_centred(ui::Face::note, place, Role::muted, text);
            ui.set_ground(plain);
            return;
        }
    }
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
    if (cell->note == Note::ghost && !pixel_question_ahead(sheet.ctx.state)) text += kGhostTip;
    return text;
}

}  // namespace texelscope::canvas
