// The scene's shapes over the pixels: outlines, the sides A, B, C, corners with their handles and labels, notices.
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

constexpr std::string_view kCanvasShapeCornerLabel = "corner {} of polygon {}";
constexpr std::string_view kCanvasShapeCornerTip =
    "$P_{}$ at {}, {}. Drag it, or hold V and press arrows. Shift snaps to pixel centres.";
constexpr std::string_view kCoordinates = "{}, {}", kDepth = ", w {}";
constexpr std::string_view kNotice = "{}: nothing is drawn", kNoticeOf = "shape {}, {}: nothing is drawn";

constexpr std::size_t kMostOutlined = 400;  ///< polygons; more would hide the pixels
constexpr std::size_t kMostHandles = 256;
constexpr std::size_t kMostNotices = 6;
constexpr float kNear = 16;      ///< coordinates stand at most so far from their corner [px at 100 %]
constexpr float kFarOff = 4000;  ///< lines are cut this far outside the canvas [px]

[[nodiscard]] std::array<glm::vec2, 4> square(const ui::Area& a) {
    return {glm::vec2(a.x, a.y), {a.right(), a.y}, {a.right(), a.bottom()}, {a.x, a.bottom()}};
}

void draw_side(const Sheet& sheet, glm::vec2 from, glm::vec2 to, float width, ui::Color color,
               ui::DashPattern pattern = {}) {
    const auto cut = ui::clipped({from, to}, square(sheet.map.area.inset(-kFarOff, -kFarOff)));
    if (!cut) return;
    const std::array<glm::vec2, 2> path{cut->from, cut->to};
    ui::draw_dashed(sheet.list(), path, pattern, width, color);
}

void draw_ring(const Sheet& sheet, std::span<const Vertex> corners, float width, ui::Color color) {
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const Vertex &a = corners[n], &b = corners[(n + 1) % corners.size()];
        if (is_finite(a) && is_finite(b)) draw_side(sheet, sheet.place(a), sheet.place(b), width, color);
    }
}

void draw_triangle(const Sheet& sheet, std::span<const Vertex> corners) {
    const ui::Ui& ui = sheet.ui();
    const float width = ui.presenting() ? ui::size::kEdgePresenting * ui.fonts().spec().scale : ui::size::kEdge;
    // Counts lie under the sides of a hit map, in strong colours: the halo holds a side together there.
    if (sheet.ctx.state.look.hits) draw_ring(sheet, corners, width + 2 * ui::size::kHalo, ui.theme().canvas);
    draw_ring(sheet, corners, width + ui::size::kHalo, ui::with_alpha(ui.theme().canvas, .8F));
    for (int e = 0; e < 3; ++e) {
        const Vertex &a = corners[static_cast<std::size_t>(e)], &b = corners[static_cast<std::size_t>((e + 1) % 3)];
        if (!is_finite(a) || !is_finite(b)) continue;
        const ui::Color color = sheet.color(ui::edge_role(e));
        draw_side(sheet, sheet.place(a), sheet.place(b), width, color, ui::edge_pattern(e));
        const glm::vec2 middle = (sheet.place(a) + sheet.place(b)) / 2.0F;
        ui::edge_mark(sheet.list(), e, middle, ui.px(5), ui.theme().canvas);
        ui::edge_mark(sheet.list(), e, middle, ui.px(4), color);
    }
}

[[nodiscard]] int current_polygon(const Derived& derived) {
    return derived.shape() < 0 ? -1 : derived.drawing().polygon_of(derived.shape());
}

struct Corner {
    Handle handle;
    glm::vec2 at{0};
    bool current = false;  ///< of the cursor's polygon
};

/// Those in view, the current polygon's last: they lie on top.
[[nodiscard]] std::vector<Corner> corners_in_view(const Sheet& sheet) {
    const auto& polygons = sheet.ctx.derived.scene().polygons;
    const int current = current_polygon(sheet.ctx.derived);
    std::vector<Corner> found;
    const auto add = [&](int polygon) {
        if (polygon != current && polygons[static_cast<std::size_t>(polygon)].mesh >= 0) return;  // no handles
        const auto& vertices = polygons[static_cast<std::size_t>(polygon)].vertices;
        for (std::size_t n = 0; n < vertices.size() && found.size() < kMostHandles; ++n) {
            if (!is_finite(vertices[n])) continue;
            const glm::vec2 at = sheet.place(vertices[n]);
            if (sheet.map.area.inset(-4, -4).contains(at))
                found.push_back({{polygon, static_cast<int>(n), false}, at, polygon == current});
        }
    };
    for (int p = 0; p < static_cast<int>(std::min(polygons.size(), kMostOutlined)); ++p)
        if (p != current) add(p);
    if (found.size() >= kMostHandles) found.clear();
    if (current >= 0) add(current);
    return found;
}

[[nodiscard]] float ring_radius(const ui::Ui& ui) {
    return ui.px(ui.presenting() ? ui::size::kVertexRingPresenting : ui::size::kVertexRing);
}

void draw_corner(Sheet& sheet, const Corner& corner, bool may_move) {
    ui::Ui& ui = sheet.ui();
    const float radius = corner.current ? ring_radius(ui) : ui.px(4);
    const float grab = std::max(ui::size::kVertexGrab, ui.px(ui::size::kVertexGrab));
    bool bright = sheet.ctx.state.handle == corner.handle;
    if (may_move) {
        const glm::vec2 value = position_of(sheet.ctx.derived.scene(), corner.handle);
        const std::string name = fmt::format("vertex/{}/{}", corner.handle.polygon, corner.handle.vertex);
        const std::string label = fmt::format(kCanvasShapeCornerLabel, corner.handle.vertex, corner.handle.polygon + 1);
        const std::string tip =
            fmt::format(kCanvasShapeCornerTip, corner.handle.vertex, ui::format_number(double{value.x}).text,
                        ui::format_number(double{value.y}).text);
        const ui::Area area{corner.at.x - grab, corner.at.y - grab, 2 * grab, 2 * grab};
        const ui::Control c = ui.control(
            {.name = name, .area = area, .kind = ui::Kind::handle, .label = label, .tip = tip, .round = true});
        if (c.pressed) ui.set_focus(0, false);
        if (c.dragging)
            move_corner(sheet.ctx, corner.handle, dragged_to(sheet.map, ui.input().mouse, ui.input().shift));
        else if (c.clicked)
            sheet.ctx.act(action::ChooseHandle{bright ? Handle{} : corner.handle});
        if (c.focused) move_by_keys(sheet.ctx, c.id, corner.handle);
        bright = bright || c.hovered || c.held;
    }
    const ui::Color color = sheet.color(bright ? Role::now : corner.current ? Role::text : Role::muted);
    ui::vertex_ring(sheet.list(), corner.at, radius, color, ui.theme().canvas);
}

struct CornerLabel {
    ui::MathBox name;
    std::string coordinates;
    glm::vec2 size{0};
};

[[nodiscard]] CornerLabel corner_label(const Sheet& sheet, int corner, const Vertex& vertex, bool with_coordinates) {
    const ui::Ui& ui = sheet.ui();
    CornerLabel label;
    label.name =
        ui::set_math(ui::symbol(fmt::format("P_{}", corner)), {.fonts = &ui.fonts(), .size = ui::MathSize::row});
    label.size = {std::ceil(label.name.width) + 2 * ui.px(4), std::ceil(label.name.height()) + 2 * ui.px(2)};
    if (!with_coordinates) return label;
    label.coordinates =
        fmt::format(kCoordinates, ui::format_number(double{vertex.x}).text, ui::format_number(double{vertex.y}).text);
    if (vertex.w != 1) label.coordinates += fmt::format(kDepth, ui::format_number(double{vertex.w}, 3).text);
    label.size.x += std::ceil(ui::text_width(ui.font(ui::Face::line_number), label.coordinates)) + ui.px(8);
    return label;
}

void draw_label(const Sheet& sheet, const CornerLabel& label, const ui::Area& place) {
    ui::Ui& ui = sheet.ui();
    ui::fill(sheet.list(), place, ui.theme().canvas, ui::size::kBadgeRadius);
    const float baseline = std::round(place.y + ui.px(2) + label.name.ascent);
    ui.formula(label.name, {place.x + ui.px(4), baseline});
    if (!label.coordinates.empty())
        ui.text(ui::Face::line_number, {place.x + ui.px(12) + label.name.width, baseline - 1}, Role::muted,
                label.coordinates);
}

[[nodiscard]] glm::vec2 middle_of(const Sheet& sheet, std::span<const Vertex> corners) {
    glm::vec2 sum(0);
    float count = 0;
    for (const Vertex& v : corners) {
        if (is_finite(v)) sum += sheet.place(v), ++count;
    }
    return count > 0 ? sum / count : glm::vec2(sheet.map.area.centre());
}

}  // namespace

glm::vec2 Sheet::place(const Vertex& vertex) const {
    constexpr double kBound = 1e6;
    return glm::clamp(glm::dvec2(map.to_window({vertex.x, vertex.y})), -kBound, kBound);
}

void draw_outlines(const Sheet& sheet) {
    const Derived& derived = sheet.ctx.derived;
    const auto& polygons = derived.scene().polygons;
    const int current = current_polygon(derived);
    const ui::Color faint = ui::with_alpha(sheet.color(Role::muted), .6F);
    for (int p = 0; p < static_cast<int>(std::min(polygons.size(), kMostOutlined)); ++p) {
        const Polygon& polygon = polygons[static_cast<std::size_t>(p)];
        if (p != current && polygon.random) continue;  // hundreds would hide each other's texels
        if (p != current || is_triangle(derived)) draw_ring(sheet, polygon.vertices, 1, faint);
    }
    if (current < 0) return;
    const std::span<const Vertex> corners = derived.drawing().corners(derived.shape());
    if (is_triangle(derived)) return draw_triangle(sheet, corners);
    const ui::Ui& ui = sheet.ui();
    const float width = ui.presenting() ? ui::size::kEdgePresenting * ui.fonts().spec().scale : 1.8F;
    draw_ring(sheet, corners, width + ui::size::kHalo, ui::with_alpha(sheet.ui().theme().canvas, .8F));
    draw_ring(sheet, corners, width, sheet.color(Role::text));
}

void block_corners(Sheet& sheet) {
    if (hides_corners(sheet.ctx.state)) return;
    const float radius = ring_radius(sheet.ui());
    for (const Corner& corner : corners_in_view(sheet)) {
        const glm::vec2 at = corner.at - radius;
        if (corner.current) sheet.labels.block({at.x, at.y, 2 * radius, 2 * radius});
    }
}

void draw_corners(Sheet& sheet) {
    if (hides_corners(sheet.ctx.state)) return;
    const bool may_move = may_drag(sheet.ctx.state, false);
    const auto& polygons = sheet.ctx.derived.scene().polygons;
    for (const Corner& corner : corners_in_view(sheet)) {
        const bool own = polygons[static_cast<std::size_t>(corner.handle.polygon)].mesh < 0;
        if (corner.current || may_move) draw_corner(sheet, corner, may_move && own);
    }
}

void draw_corner_labels(Sheet& sheet) {
    const Derived& derived = sheet.ctx.derived;
    if (derived.shape() < 0 || hides_corners(sheet.ctx.state)) return;
    const std::span<const Vertex> corners = derived.drawing().corners(derived.shape());
    const glm::vec2 middle = middle_of(sheet, corners);
    const float ring = ring_radius(sheet.ui());
    const float near = ring + sheet.ui().px(kNear);
    constexpr std::size_t kMostLabels = 24;
    for (std::size_t n = 0; n < std::min(corners.size(), kMostLabels); ++n) {
        if (!is_finite(corners[n])) continue;
        const glm::vec2 at = sheet.place(corners[n]);
        if (!sheet.map.area.contains(at)) continue;
        const bool plain = sheet.ui().presenting() || sheet.planes || sheet.sections;
        const Handle handle{current_polygon(derived), derived.drawing().vertex_of(derived.shape(), static_cast<int>(n)),
                            false};
        const bool with_coordinates = !plain || sheet.ctx.state.handle == handle;
        // A name that is all to be read may stand further off than coordinates.
        const auto beside = [&](const ui::Area& area, bool full) {
            const glm::vec2 to = glm::clamp(at, {area.x, area.y}, {area.right(), area.bottom()}) - at;
            return (!full || glm::length(to) <= near) && !meets_picture(sheet, area);
        };
        const auto draw = [&](bool full, bool anywhere) {
            const CornerLabel label = corner_label(sheet, static_cast<int>(n), corners[n], full);
            const auto suits = [&](const ui::Area& area) { return anywhere || beside(area, full); };
            const auto place = sheet.labels.place(at, label.size, at - middle, ring + 2, suits);
            if (place) draw_label(sheet, label, *place);
            return place.has_value();
        };
        // Coordinates never cost a look at the picture; the name does where there is no other place.
        const bool done = (with_coordinates && draw(true, false)) || draw(false, false);
        if (!done) static_cast<void>(draw(false, true));
    }
}

bool meets_picture(const Sheet& sheet, const ui::Area& area) {
    const Derived& derived = sheet.ctx.derived;
    const Window& window = sheet.picture.window;
    const glm::ivec2 a = sheet.map.pixel_at({area.x, area.y}), b = sheet.map.pixel_at({area.right(), area.bottom()});
    const Rect under = intersection({a.x, a.y, b.x + 1, b.y + 1}, window.rect);
    for (int y = under.y0; y < under.y1; y += window.stride) {
        for (int x = under.x0; x < under.x1; x += window.stride) {
            const CanvasCell* cell = sheet.cell({x, y});
            if (cell != nullptr && (cell->written || cell->will_be_written)) return true;
        }
    }
    if (derived.shape() < 0) return false;
    const std::span<const Vertex> corners = derived.drawing().corners(derived.shape());
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const ui::Segment side{sheet.place(corners[n]), sheet.place(corners[(n + 1) % corners.size()])};
        if (ui::clipped(side, square(area))) return true;
    }
    return false;
}

void draw_notices(Sheet& sheet) {
    ui::Ui& ui = sheet.ui();
    const Derived& derived = sheet.ctx.derived;
    std::size_t shown = 0;
    for (const Notice& notice : derived.notices()) {
        if (notice.shape >= derived.drawing().shape_count() || shown++ >= kMostNotices) break;
        const std::string text = derived.drawing().shape_count() > 1
                                     ? fmt::format(kNoticeOf, notice.shape + 1, notice.text)
                                     : fmt::format(kNotice, notice.text);
        const float mark = ui.px(14), most = sheet.map.area.w - ui.px(16);
        const float width =
            std::min(most, std::ceil(ui::text_width(ui.font(ui::Face::title), text)) + mark + 2 * ui.px(6));
        const glm::vec2 size{width, std::round(ui.font(ui::Face::title).em * 1.9F)}, half = size / 2.0F;
        const ui::Area& a = sheet.map.area;
        const glm::vec2 wanted = middle_of(sheet, derived.drawing().corners(notice.shape));
        const glm::vec2 anchor =
            glm::clamp(wanted, glm::vec2(a.x, a.y) + half + 2.0F, glm::vec2(a.right(), a.bottom()) - half - 2.0F);
        const auto place = sheet.labels.place(anchor, size, {0, -1}, 0);
        if (!place) continue;
        const ui::Color plain = ui.ground();
        ui.set_ground(ui.theme().raise);
        ui::fill(sheet.list(), *place, ui.ground(), ui::size::kBadgeRadius);
        ui::frame(sheet.list(), *place, sheet.color(Role::error), 1, ui::size::kBadgeRadius);
        ui::cross(sheet.list(), {place->x + ui.px(6) + mark / 3, place->centre().y}, mark / 4, 1.6F,
                  sheet.color(Role::error));
        ui.text_within(
            ui::Face::title,
            {place->x + ui.px(6) + mark, ui::baseline_at_middle(ui.font(ui::Face::title), place->centre().y)},
            width - mark - 2 * ui.px(6), Role::text, text);
        ui.set_ground(plain);
    }
}

}  // namespace texelscope::canvas
