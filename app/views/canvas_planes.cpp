// The sides as half-planes with their signs, the bounding box, and the tilt of the u and v planes.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_parts.h"
#include "core/geometry/polygon.h"

namespace texelscope::canvas {
namespace {

using ui::Role;

constexpr std::string_view kSamples = "{} × {} = {} samples", kTilt = "tilt";
constexpr float kCanvasPlanesHatchStep = 11, kHatchAlpha = .30F, kOuterFill = .035F, kLineAlpha = .55F;
constexpr float kLeastRegion = 900;  ///< a region smaller than this has no signs [px^2]
constexpr float kAlongStep = 8;      ///< between the places that a plate at a side tries [px]
constexpr float kTiltWidth = 116, kTiltHeight = 76, kTiltArrow = 34;

/// E = x X + y Y + k over the screen, negative inside.
struct Side {
    double x = 0, y = 0, k = 0;
};

[[nodiscard]] std::optional<Side> side_of(const Derived& derived, int e) {
    const char letter = static_cast<char>('A' + e);
    const auto x = number_of(derived, fmt::format("n_x_{}", letter)),
               y = number_of(derived, fmt::format("n_y_{}", letter));
    const auto k = number_of(derived, fmt::format("k_{}", letter));
    if (!x || !y || !k || (*x == 0 && *y == 0)) return std::nullopt;
    return Side{*x, *y, *k};
}

/// A half-plane in window pixels: dot(normal, p) > offset is the side of positive E. The normal has length 1.
struct Half {
    glm::vec2 normal{0};
    float offset = 0;
};

[[nodiscard]] Half in_window(const CanvasMap& map, const Side& side) {
    // Where E is zero, nearest to the framebuffer's corner.
    const double length = std::hypot(side.x, side.y);
    const glm::dvec2 normal = glm::dvec2(side.x, side.y) / length, corner(map.origin);
    const double far = (-side.k / length - glm::dot(normal, corner)) * map.zoom + glm::dot(normal, map.at);
    return {normal, static_cast<float>(far)};
}

using Ring = std::vector<glm::vec2>;

[[nodiscard]] Ring ring_of(const ui::Area& a) {
    return {{a.x, a.y}, {a.right(), a.y}, {a.right(), a.bottom()}, {a.x, a.bottom()}};
}
[[nodiscard]] Ring cut(const Ring& ring, const Half& half, bool positive) {
    const float sign = positive ? -1.0F : 1.0F;
    return ui::clipped_to_half_plane(ring, half.normal * sign, half.offset * sign);
}
struct Weight {
    float area = 0;
    glm::vec2 centre{0};
};
[[nodiscard]] Weight weight_of(const Ring& ring) {
    Weight w;
    for (std::size_t n = 2; n < ring.size(); ++n) {
        const glm::vec2 a = ring[n - 1] - ring[0], b = ring[n] - ring[0];
        const float area = std::abs(a.x * b.y - a.y * b.x) / 2;
        w.area += area, w.centre += area * (ring[0] + (a + b) / 3.0F);
    }
    if (w.area > 0) w.centre /= w.area;
    return w;
}

void draw_signs(const Sheet& sheet, const ui::Area& place, const std::array<std::optional<bool>, 3>& signs,
                float badge) {
    ui::Ui& ui = sheet.ui();
    ui::fill(sheet.list(), place, ui.theme().canvas, ui::size::kBadgeRadius);
    ui::frame(sheet.list(), place, ui.theme().hairline, 1, ui::size::kBadgeRadius);
    float x = place.x + ui.px(2);
    for (int e = 0; e < 3; ++e) {
        if (!signs[static_cast<std::size_t>(e)]) continue;
        ui::sign_badge(ui, e, *signs[static_cast<std::size_t>(e)], {x, place.y + ui.px(2), badge, badge});
        x += badge + ui.px(2);
    }
}

[[nodiscard]] std::optional<Rect> box_of(const Derived& derived) {
    const auto x0 = number_of(derived, "x_a"), x1 = number_of(derived, "x_b");
    const auto y0 = number_of(derived, "y_a"), y1 = number_of(derived, "y_b");
    if (!x0 || !x1 || !y0 || !y1) return std::nullopt;
    const Rect rect{static_cast<int>(*x0), static_cast<int>(*y0), static_cast<int>(*x1), static_cast<int>(*y1)};
    return rect.empty() ? std::nullopt : std::optional(rect);
}

[[nodiscard]] std::optional<ui::Area> tilt_place(const Sheet& sheet, glm::vec2 size) {
    const ui::Area a = sheet.map.area.inset(sheet.ui().px(12), sheet.ui().px(12));
    const float right = a.right() - size.x, bottom = a.bottom() - size.y;
    for (const glm::vec2 at :
         {glm::vec2(right, a.y), glm::vec2(a.x, a.y), glm::vec2(right, bottom), glm::vec2(a.x, bottom)}) {
        const ui::Area place{at.x, at.y, size.x, size.y};
        if (sheet.labels.is_free(place) && !meets_picture(sheet, place)) return place;
    }
    return std::nullopt;
}

void draw_gradient(const Sheet& sheet, glm::vec2 from, glm::vec2 by, Role role, std::string_view name,
                   const ui::Area& within) {
    ui::Ui& ui = sheet.ui();
    const float width = ui.presenting() ? 3 : 2;
    ui::arrow(sheet.list(), from, from + by, width, sheet.color(role), ui.px(9));
    const ui::MathBox letter =
        ui::set_math(ui::coloured(ui::symbol(name), role), {.fonts = &ui.fonts(), .size = ui::MathSize::row});
    const float length = glm::length(by);
    const glm::vec2 way = length > 0 ? by / length : glm::vec2(1, 0);
    const glm::vec2 middle = from + by + way * ui.px(12);
    const float x = std::clamp(middle.x - letter.width / 2, within.x + 1, within.right() - letter.width - 1);
    const float y =
        std::clamp(middle.y + letter.ascent / 2, within.y + letter.ascent + 1, within.bottom() - letter.descent - 1);
    ui.formula(letter, {x, y});
}

/// Outside the box, at its upper side and else at its lower one: as far right as there is room.
[[nodiscard]] std::optional<ui::Area> place_along(Sheet& sheet, const ui::Area& box, glm::vec2 size) {
    const float gap = sheet.ui().px(5);
    for (const float y : {box.y - size.y - gap, box.bottom() + gap}) {
        for (float x = box.right() - size.x; x >= box.x; x -= kAlongStep) {
            const ui::Area plate{std::round(x), std::round(y), size.x, size.y};
            if (!sheet.labels.is_free(plate)) continue;
            sheet.labels.block(plate);
            return plate;
        }
    }
    return std::nullopt;
}

}  // namespace

void draw_half_planes(const Sheet& sheet) {
    const Ring canvas = ring_of(sheet.map.area);
    for (int e = 0; e < 3; ++e) {
        const auto side = side_of(sheet.ctx.derived, e);
        if (!side) continue;
        const Half half = in_window(sheet.map, *side);
        const Ring outer = cut(canvas, half, true);
        const ui::Color color = sheet.color(ui::edge_role(e));
        ui::fill_convex(sheet.list(), outer, ui::with_alpha(color, kOuterFill));
        ui::draw_hatch(sheet.list(), outer, ui::section_degrees(e), sheet.ui().px(kCanvasPlanesHatchStep), sheet.map.at,
                       1, ui::with_alpha(color, kHatchAlpha));
        const glm::vec2 foot = half.normal * half.offset, way{-half.normal.y, half.normal.x};
        const float reach = sheet.map.area.w + sheet.map.area.h + std::abs(glm::dot(way, sheet.map.area.centre()));
        if (const auto line = ui::clipped({foot - way * reach, foot + way * reach}, canvas)) {
            const std::array<glm::vec2, 2> path{line->from, line->to};
            ui::draw_dashed(sheet.list(), path, ui::edge_pattern(e), 1, ui::with_alpha(color, kLineAlpha));
        }
    }
}

void draw_sign_badges(Sheet& sheet) {
    std::array<std::optional<Half>, 3> halves;
    int known = 0;
    for (int e = 0; e < 3; ++e) {
        if (const auto side = side_of(sheet.ctx.derived, e))
            halves[static_cast<std::size_t>(e)] = in_window(sheet.map, *side), ++known;
    }
    if (known == 0) return;
    const float gap = sheet.ui().px(2), badge = sheet.ui().px(16);
    const auto count = static_cast<float>(known);
    const glm::vec2 size{count * (badge + gap) + gap, badge + 2 * gap};
    for (int mask = 0; mask < 8; ++mask) {
        Ring region = ring_of(sheet.map.area);
        std::array<std::optional<bool>, 3> signs;
        bool possible = true;
        for (std::size_t e = 0; e < 3; ++e) {
            const bool positive = (mask >> e & 1) != 0;
            if (!halves[e])
                possible = possible && !positive;
            else
                region = cut(region, *halves[e], positive), signs[e] = positive;
        }
        const Weight weight = weight_of(region);
        if (!possible || weight.area < kLeastRegion) continue;
        const ui::Area& a = sheet.map.area;
        const glm::vec2 least = glm::vec2(a.x, a.y) + 3.0F, most = glm::vec2(a.right(), a.bottom()) - size - 3.0F;
        const glm::vec2 corner = glm::round(glm::clamp(weight.centre - size / 2.0F, least, glm::max(least, most)));
        const ui::Area middle{corner.x, corner.y, size.x, size.y};
        const bool room = sheet.labels.is_free(middle);
        const auto place = room ? std::optional(middle) : sheet.labels.place(weight.centre, size, {0, -1}, 0);
        if (room) sheet.labels.block(middle);
        if (place) draw_signs(sheet, *place, signs, badge);
    }
}

void draw_box(Sheet& sheet) {
    const auto box = box_of(sheet.ctx.derived);
    if (!box) return;
    ui::Ui& ui = sheet.ui();
    const ui::Area place = sheet.map.place_of(*box);
    ui::frame(sheet.list(), place, sheet.color(Role::text), 1);
    const float half = ui.px(2.5F);
    for (const float x : {place.x, place.right() - 1}) {
        for (const float y : {place.y, place.bottom() - 1})
            ui::fill(sheet.list(), {std::round(x - half), std::round(y - half), 2 * half + 1, 2 * half + 1},
                     sheet.color(Role::text));
    }
    const std::int64_t count = std::int64_t{box->width()} * box->height();
    const std::string text = fmt::format(kSamples, box->width(), box->height(), count);
    const ui::Font& font = ui.font(ui::Face::code_note);
    const glm::vec2 size{std::ceil(ui::text_width(font, text)) + 2 * ui.px(7), std::round(font.em * 1.6F)};
    std::optional<ui::Area> plate = place_along(sheet, place, size);
    if (!plate) plate = sheet.labels.place({place.right(), place.y}, size, {-1, 1}, ui.px(4));
    if (!plate) return;
    ui::fill(sheet.list(), *plate, ui.theme().canvas, ui::size::kBadgeRadius);
    ui::frame(sheet.list(), *plate, ui.theme().hairline, 1, ui::size::kBadgeRadius);
    ui.text_centred(ui::Face::code_note, *plate, Role::text, text);
}

void draw_tilt(Sheet& sheet) {
    const Derived& derived = sheet.ctx.derived;
    if (!is_triangle(derived)) return;
    std::array<double, 4> g{};
    constexpr std::array<std::string_view, 4> kNames{"u_x", "u_y", "v_x", "v_y"};
    for (std::size_t n = 0; n < 4; ++n) {
        const auto value = number_of(derived, kNames[n]);
        if (!value) return;
        g[n] = *value;
    }
    ui::Ui& ui = sheet.ui();
    const float em = ui.font(ui::Face::note).em, longest_arrow = ui.px(kTiltArrow);
    const auto place = tilt_place(sheet, {std::max(ui.px(kTiltWidth), 2 * longest_arrow + 5 * em), ui.px(kTiltHeight)});
    const double longest = std::max(std::hypot(g[0], g[1]), std::hypot(g[2], g[3]));
    if (!place || !(longest > 0)) return;
    sheet.labels.block(*place);
    ui::fill(sheet.list(), *place, ui::with_alpha(ui.theme().canvas, .88F), ui::size::kRadius);
    const auto arrow = [&](std::size_t n) {
        return glm::vec2(glm::dvec2(g[n], g[n + 1]) * (double{longest_arrow} / longest));
    };
    const glm::vec2 u = arrow(0), v = arrow(2), low = glm::min(glm::min(u, v), glm::vec2(0)),
                    high = glm::max(glm::max(u, v), glm::vec2(0));
    // Both arrows about the middle of what the word leaves.
    const ui::Area room{place->x, place->y, place->w - 3 * em, place->h};
    const glm::vec2 from = glm::round(room.centre() - (low + high) / 2.0F);
    draw_gradient(sheet, from, u, Role::u, "u", *place);
    draw_gradient(sheet, from, v, Role::v, "v", *place);
    sheet.list().AddCircleFilled(ui::to_im(from), ui.px(2.5F), sheet.color(Role::text));
    ui.text_right(ui::Face::note, {place->right() - ui.px(8), place->bottom() - ui.px(8)}, Role::muted, kTilt);
}

}  // namespace texelscope::canvas
