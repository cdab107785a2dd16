// Pixels of the canvas: the picture, the grid, the current row and its samples, numbers in pixels.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/views/canvas_parts.h"

namespace texelscope::canvas {
namespace {

using ui::Role;

constexpr float kGridFrom = 3, kGridFull = 9;  ///< window pixels per pixel: the grid appears, is all there
constexpr float kNumbersFrom = 40;             ///< from here pixels say their colours [px at 100 %]
constexpr float kCoveredFill = .66F, kRejectedFill = .85F, kEarlierFill = .30F, kOnceFill = .40F, kAgainFill = .45F,
                kAgainStep = .12F;

[[nodiscard]] Rgba rgba(ui::Color c, float alpha) {
    const auto byte = [c](int shift) { return static_cast<std::uint8_t>(c >> shift & 0xFFU); };
    return {byte(0), byte(8), byte(16), static_cast<std::uint8_t>(std::lround(255 * std::clamp(alpha, 0.0F, 1.0F)))};
}
[[nodiscard]] Rgba rgba(Rgb c, float alpha) {
    return {c.r, c.g, c.b, static_cast<std::uint8_t>(std::lround(255 * alpha))};
}

/// What a cell shows. A black clear colour lets the canvas through: nothing is there.
[[nodiscard]] Rgba shown(const Sheet& sheet, const CanvasCell& cell, Rgba empty) {
    if (sheet.planes) {
        // What earlier shapes wrote stays, but weaker: the sides are the current shape's.
        if (!cell.visited) return cell.written ? rgba(sheet.color(Role::covered), kEarlierFill) : empty;
        const bool covered = cell.fate == Fate::written;
        return rgba(sheet.color(covered ? Role::covered : Role::rejected), covered ? kCoveredFill : kRejectedFill);
    }
    if (cell.written) return rgba(cell.now, 1);
    if (cell.will_be_written && !sheet.secret) return rgba(cell.later, ui::alpha::kNotYet);
    return empty;
}

[[nodiscard]] Rgba shown_hits(const Sheet& sheet, int hits, Rgba empty) {
    if (hits == 0) return empty;
    if (hits == 1) return rgba(sheet.color(Role::covered), kOnceFill);
    return rgba(sheet.color(Role::error), kAgainFill + kAgainStep * static_cast<float>(hits - 2));
}

[[nodiscard]] int hits_at(const Sheet& sheet, glm::ivec2 pixel) {
    const Window& w = sheet.picture.window;
    return sheet.ctx.derived.hits(w).at((pixel.x - w.rect.x0) / w.stride, (pixel.y - w.rect.y0) / w.stride);
}

[[nodiscard]] Grid<Rgba> shown(const Sheet& sheet, Rgba empty) {
    const Grid<CanvasCell>& cells = sheet.picture.cells;
    Grid<Rgba> pixels(cells.width(), cells.height());
    if (sheet.ctx.state.look.hits) {
        const Grid<std::uint8_t>& hits = sheet.ctx.derived.hits(sheet.picture.window);
        std::transform(hits.data(), hits.data() + hits.size(), pixels.data(),
                       [&](int count) { return shown_hits(sheet, count, empty); });
    } else {
        std::transform(cells.data(), cells.data() + cells.size(), pixels.data(),
                       [&](const CanvasCell& cell) { return shown(sheet, cell, empty); });
    }
    return pixels;
}

/// Another one whenever shown() may give other pixels.
[[nodiscard]] std::uint64_t version_of(const Sheet& sheet, Rgba empty) {
    const Look& look = sheet.ctx.state.look;
    const auto word = [](Rgba c) { return static_cast<std::uint64_t>(c.r | c.g << 8 | c.b << 16) << 8 | c.a; };
    std::uint64_t hash = sheet.picture.version;
    for (const std::uint64_t part :
         {static_cast<std::uint64_t>(sheet.planes) | static_cast<std::uint64_t>(sheet.secret) << 1 |
              static_cast<std::uint64_t>(look.hits) << 2,
          word(empty), std::uint64_t{sheet.color(Role::covered)}, std::uint64_t{sheet.color(Role::rejected)},
          std::uint64_t{sheet.color(Role::error)}})
        hash = hash * 0x9E3779B97F4A7C15ULL + part;
    return hash | 1U;
}

/// A range of columns of one row, in the samples that the current shape visits.
struct Reach {
    int first = 0, last = -1;
};

[[nodiscard]] Reach reach_of(const Sheet& sheet, int row) {
    Reach reach;
    const Rect& rect = sheet.picture.window.rect;
    for (int x = rect.x0; x < rect.x1; x += sheet.picture.window.stride) {
        const CanvasCell* cell = sheet.cell({x, row});
        if (cell == nullptr || !(cell->will_be_visited || cell->visited)) continue;
        if (reach.last < reach.first) reach.first = x;
        reach.last = x;
    }
    return reach;
}

void dot(const Sheet& sheet, glm::vec2 at, float size, ui::Color color) {
    const float half = size / 2;
    if (size < 3)
        ui::fill(sheet.list(), {std::round(at.x - half), std::round(at.y - half), size, size}, color);
    else
        sheet.list().AddCircleFilled(ui::to_im(at), half, color, 8);
}

void draw_sample(const Sheet& sheet, glm::ivec2 pixel, const CanvasCell& cell, bool in_row) {
    const ui::Ui& ui = sheet.ui();
    const glm::vec2 at = sheet.sample_place(pixel);
    const bool rejected = cell.fate != Fate::written;
    if (cell.visited && rejected && in_row && !sheet.planes) {
        ui::cross(sheet.list(), at, ui.px(2.5F), 1.3F, sheet.color(Role::muted));
    } else if (!cell.visited && in_row) {
        dot(sheet, at, ui.px(rejected ? 3.5F : 4.5F), sheet.color(rejected && !sheet.planes ? Role::faint : Role::now));
    } else if (sheet.planes && (rejected || !cell.visited)) {
        dot(sheet, at, ui.px(2), sheet.color(Role::faint));
    }
}

void draw_lines(const Sheet& sheet, const Rect& view, ui::Color color) {
    const CanvasMap& map = sheet.map;
    const ui::Area all = ui::intersection(map.place_of(view), map.area);
    for (int x = view.x0; x <= view.x1; ++x) {
        ui::fill(sheet.list(), {std::round(map.to_window({x, 0}).x), all.y, 1, all.h}, color);
    }
    for (int y = view.y0; y <= view.y1; ++y) {
        ui::fill(sheet.list(), {all.x, std::round(map.to_window({0, y}).y), all.w, 1}, color);
    }
}

/// Lines of a number in a pixel: its writes, its address and bytes, or its three channels.
[[nodiscard]] std::string text_in(const Sheet& sheet, glm::ivec2 pixel, const CanvasCell& cell) {
    if (sheet.ctx.state.look.hits) {
        const int hits = hits_at(sheet, pixel);
        return hits > 0 ? fmt::format("{}", hits) : std::string();
    }
    if (shows(sheet.ctx.state, "bytes"))
        return fmt::format("{}", address_of(sheet.ctx.derived.scene().framebuffer, pixel));
    if (!cell.written || sheet.planes) return {};
    return fmt::format("{}\n{}\n{}", cell.now.r, cell.now.g, cell.now.b);
}

/// Behind letters that neither theme colour makes readable on a pixel: a plate as dark as it has to be.
void draw_plate(const Sheet& sheet, const ui::Area& place) {
    ui::Ui& ui = sheet.ui();
    const ui::Theme& theme = ui.theme();
    const auto readable = [&](ui::Color ground) {
        return std::max(ui::contrast(ground, theme[Role::text]), ui::contrast(ground, theme[Role::on_now])) >=
               theme.text_contrast();
    };
    const bool over_lines = sheet.ctx.state.look.hits;
    if (readable(ui.ground()) && !over_lines) return;
    float strength = 0;
    const ui::Color under = ui.ground();
    while (strength < 1 && !readable(ui::over(theme.canvas, strength, under))) strength += .1F;
    ui.set_ground(ui::over(theme.canvas, std::min(1.0F, strength), under));
    ui::fill(sheet.list(), place, ui.ground(), ui::size::kBadgeRadius);
}

void draw_text_in(const Sheet& sheet, glm::ivec2 pixel, const CanvasCell& cell, const std::string& text) {
    ui::Ui& ui = sheet.ui();
    const ui::Area place = sheet.map.place_of(pixel);
    const float lead = std::round(ui.font(ui::Face::ruler).em * 1.15F);
    const auto lines = static_cast<float>(std::count(text.begin(), text.end(), '\n') + 1);
    const Rgba fill = sheet.ctx.state.look.hits ? shown_hits(sheet, hits_at(sheet, pixel), {0, 0, 0, 0})
                                                : shown(sheet, cell, {0, 0, 0, 0});
    const ui::Color plain = ui.ground(), own = IM_COL32(fill.r, fill.g, fill.b, 255);
    ui.set_ground(ui::over(own, static_cast<float>(fill.a) / 255, ui.theme().canvas));
    float y = std::round(place.centre().y - lead * lines / 2);
    const float width = sheet.ctx.state.look.hits ? lead : place.w - 4;
    draw_plate(sheet, place.inset((place.w - width) / 2, (place.h - lead * lines) / 2 - 1));
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::string_view line = std::string_view(text).substr(from, end - from);
        const bool dark =
            ui::contrast(ui.ground(), ui.theme()[Role::on_now]) > ui::contrast(ui.ground(), ui.theme()[Role::text]);
        ui.text_centred(ui::Face::ruler, {place.x, y, place.w, lead}, dark ? Role::on_now : Role::text, line);
        y += lead, from = end + 1;
    }
    ui.set_ground(plain);
}

}  // namespace

const CanvasCell* Sheet::cell(glm::ivec2 pixel) const {
    const Window& w = picture.window;
    if (!w.rect.contains(pixel.x, pixel.y)) return nullptr;
    const int x = (pixel.x - w.rect.x0) / w.stride, y = (pixel.y - w.rect.y0) / w.stride;
    return x < picture.cells.width() && y < picture.cells.height() ? &picture.cells.at(x, y) : nullptr;
}

void draw_picture(const Sheet& sheet) {
    const Grid<CanvasCell>& cells = sheet.picture.cells;
    const Window& window = sheet.picture.window;
    if (cells.empty() || window.rect.empty()) return;
    const Rgb clear = sheet.ctx.derived.scene().framebuffer.clear;
    const Rgba empty = clear == Rgb{} || sheet.planes ? Rgba{0, 0, 0, 0} : rgba(clear, 1);
    const ImTextureID id = sheet.ctx.textures.image(ui::id_of("canvas picture"), version_of(sheet, empty),
                                                    [&] { return shown(sheet, empty); });
    const ui::Area place = sheet.map.place_of(window.rect);
    // The last cell may stand for fewer pixels than the others.
    const float u = static_cast<float>(window.rect.width()) / static_cast<float>(cells.width() * window.stride);
    const float v = static_cast<float>(window.rect.height()) / static_cast<float>(cells.height() * window.stride);
    sheet.list().AddImage(id, {place.x, place.y}, {place.right(), place.bottom()}, {0, 0}, {u, v});
}

void draw_grid(const Sheet& sheet) {
    const ui::Theme& theme = sheet.ui().theme();
    const Framebuffer& frame = sheet.ctx.derived.scene().framebuffer;
    const float zoom = static_cast<float>(sheet.map.zoom);
    const float shown_by = std::clamp((zoom - kGridFrom) / (kGridFull - kGridFrom), 0.0F, 1.0F);
    if (shown_by > 0) draw_lines(sheet, pixels_in_view(sheet.map, frame), ui::with_alpha(theme.grid, shown_by));
    ui::frame(sheet.list(), sheet.map.place_of(frame.rect()).inset(-1, -1), theme.hairline);
}

void draw_row_band(const Sheet& sheet) {
    const auto row = sheet.ctx.derived.row();
    const Rect frame = sheet.ctx.derived.scene().framebuffer.rect();
    if (!row || *row < frame.y0 || *row >= frame.y1) return;
    const int y = static_cast<int>(*row);
    const ui::Color now = sheet.color(Role::now);
    const ui::Area whole = sheet.map.place_of(Rect{frame.x0, y, frame.x1, y + 1}), &area = sheet.map.area;
    if (const Reach reach = reach_of(sheet, y); reach.first <= reach.last && !sheet.sections) {
        const Rect band{reach.first, y, std::min(frame.x1, reach.last + sheet.picture.window.stride), y + 1};
        ui::fill(sheet.list(), sheet.map.place_of(band), ui::with_alpha(now, ui::alpha::kRowBand));
    }
    if (sheet.planes) return;
    const ui::Color border = ui::with_alpha(now, ui::alpha::kRowBorder);
    ui::fill(sheet.list(), {area.x, whole.y, area.w, 1}, border);
    ui::fill(sheet.list(), {area.x, std::max(whole.y + 1, whole.bottom()), area.w, 1}, border);
}

void draw_samples(const Sheet& sheet) {
    if (sheet.map.zoom < double{kDotsFrom} || sheet.ctx.state.look.hits) return;
    const auto row = sheet.ctx.derived.row();
    const auto current = sheet.ctx.derived.pixel();  // draw_current_pixel() has its dot
    const Rect view =
        intersection(pixels_in_view(sheet.map, sheet.ctx.derived.scene().framebuffer), sheet.picture.window.rect);
    for (int y = view.y0; y < view.y1; ++y) {
        const bool in_row = row == y;
        if (!in_row && !sheet.planes) continue;
        for (int x = view.x0; x < view.x1; ++x) {
            const CanvasCell* cell = sheet.cell({x, y});
            if (current == glm::ivec2(x, y)) continue;
            if (cell != nullptr && (cell->will_be_visited || cell->visited)) draw_sample(sheet, {x, y}, *cell, in_row);
        }
    }
}

void draw_numbers(const Sheet& sheet) {
    const ui::Ui& ui = sheet.ui();
    const float em = ui.font(ui::Face::ruler).em;
    const bool one_line = sheet.ctx.state.look.hits || shows(sheet.ctx.state, "bytes");
    const float least = one_line ? std::max(em * 1.5F, ui.px(sheet.ctx.state.look.hits ? 16 : 24))
                                 : std::max(ui.px(kNumbersFrom), em * 3.8F);
    if (sheet.map.zoom < double{least}) return;
    const Rect view =
        intersection(pixels_in_view(sheet.map, sheet.ctx.derived.scene().framebuffer), sheet.picture.window.rect);
    for (int y = view.y0; y < view.y1; ++y) {
        for (int x = view.x0; x < view.x1; ++x) {
            const CanvasCell* cell = sheet.cell({x, y});
            // A number that the canvas' border would cut is none.
            if (cell == nullptr || !sheet.map.area.covers(sheet.map.place_of(glm::ivec2(x, y)))) continue;
            const std::string text = text_in(sheet, {x, y}, *cell);
            if (!text.empty()) draw_text_in(sheet, {x, y}, *cell, text);
        }
    }
}

}  // namespace texelscope::canvas
