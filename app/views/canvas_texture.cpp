#include "app/views/canvas_texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/views/canvas_values.h"
#include "core/geometry/polygon.h"
#include "core/image/wrap.h"

namespace texelscope::canvas {
namespace {

using ui::Role;

constexpr std::string_view kNote = "{} × {}, {}", kLabel = "texture";
constexpr std::string_view kTexelTip = "texel **{}, {}**: `#{:02x}{:02x}{:02x}`", kReadBy = ", read by {} {}";
constexpr std::string_view kPixel = "pixel", kPixels = "pixels";
constexpr std::string_view kCanvasTextureCornerLabel = "u and v of corner {} of polygon {}";
constexpr std::string_view kCanvasTextureCornerTip =
    "$P_{}$ takes its texel at $u$ = {}, $v$ = {}. Drag it; Shift snaps to texel centres.";
constexpr std::uint8_t kRepeated = 80;  ///< alpha of texels outside the texture
constexpr int kMostRepeats = 2;         ///< textures in view on each side
constexpr float kCanvasTextureLeastRing = 6, kStill = 4;
constexpr double kCanvasTextureSteps = 16;  ///< of a dragged (u, v), to a texel

[[nodiscard]] std::string_view id_of_wrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::mask: return "mask";
        case Wrap::clamp: return "clamp";
        case Wrap::repeat: break;
    }
    return "repeat";
}

[[nodiscard]] int kept(float value, int low, int high) {
    return static_cast<int>(
        std::clamp(static_cast<double>(value), static_cast<double>(low), static_cast<double>(high)));
}

/// The texture, and around it as much as the corners reach.
[[nodiscard]] Rect range_of(const Texture& texture, std::span<const Vertex> corners) {
    const int w = texture.width(), h = texture.height();
    Rect range{0, 0, w, h};
    for (const Vertex& v : corners) {
        if (!is_finite(v)) continue;
        range.x0 = std::min(range.x0, kept(std::floor(v.u), -kMostRepeats * w, w)),
        range.x1 = std::max(range.x1, kept(std::ceil(v.u), 0, (kMostRepeats + 1) * w));
        range.y0 = std::min(range.y0, kept(std::floor(v.v), -kMostRepeats * h, h)),
        range.y1 = std::max(range.y1, kept(std::ceil(v.v), 0, (kMostRepeats + 1) * h));
    }
    return range;
}

[[nodiscard]] glm::ivec2 wrapped_texel(const Texture& texture, glm::ivec2 at) {
    return {wrap_index(at.x, texture.width(), texture.wrap), wrap_index(at.y, texture.height(), texture.wrap)};
}

[[nodiscard]] glm::vec2 place(const TexelMap& map, const Vertex& v) {
    constexpr double kBound = 1e5;
    return glm::clamp(glm::dvec2(map.to_window({v.u, v.v})), -kBound, kBound);
}

void draw_side(ImDrawList& list, const TexelMap& map, const Vertex& a, const Vertex& b, float width, ui::Color color,
               ui::DashPattern pattern = {}) {
    if (!is_finite(a) || !is_finite(b)) return;
    const std::array<glm::vec2, 2> path{place(map, a), place(map, b)};
    ui::draw_dashed(list, path, pattern, width, color);
}

void ring(const ViewContext& ctx, const TexelMap& map, glm::ivec2 texel, float width) {
    const ui::Theme& theme = ctx.ui.theme();
    ui::pixel_ring(ctx.ui.list(), ui::grown_to(map.place_of(texel), kCanvasTextureLeastRing), theme[Role::now],
                   theme.outline, width);
}

void draw_corner(const ViewContext& ctx, const TexelMap& map, const Vertex& vertex, const Handle& handle,
                 bool may_move) {
    ui::Ui& ui = ctx.ui;
    const glm::vec2 at = place(map, vertex);
    bool bright = ctx.state.handle == handle;
    if (may_move && map.area.contains(at)) {
        const float grab = std::max(ui::size::kVertexGrab, ui.px(ui::size::kVertexGrab));
        const std::string name = fmt::format("texel-vertex/{}/{}", handle.polygon, handle.vertex);
        const std::string label = fmt::format(kCanvasTextureCornerLabel, handle.vertex, handle.polygon + 1);
        const std::string tip =
            fmt::format(kCanvasTextureCornerTip, handle.vertex, ui::format_number(double{vertex.u}).text,
                        ui::format_number(double{vertex.v}).text);
        const ui::Area area{at.x - grab, at.y - grab, 2 * grab, 2 * grab};
        const ui::Control c = ui.control(
            {.name = name, .area = area, .kind = ui::Kind::handle, .label = label, .tip = tip, .round = true});
        if (c.pressed) ui.set_focus(0, false);
        if (c.dragging) {
            const glm::vec2 low(map.at), high = map.to_window({map.range.x1, map.range.y1});
            const glm::dvec2 uv = map.to_texel(glm::clamp(ui.input().mouse, low, high));
            const glm::dvec2 to = ui.input().shift ? glm::floor(uv) + 0.5
                                                   : glm::floor(uv * kCanvasTextureSteps + 0.5) / kCanvasTextureSteps;
            move_corner(ctx, handle, to);
        } else if (c.clicked) {
            ctx.act(action::ChooseHandle{bright ? Handle{} : handle});
        }
        if (c.focused) move_by_keys(ctx, c.id, handle);
        bright = bright || c.hovered || c.held;
    }
    ui.list().AddCircleFilled(ui::to_im(at), ui.px(5.5F), ui.theme().outline);
    ui.list().AddCircleFilled(ui::to_im(at), ui.px(4), bright ? ui.theme()[Role::now] : IM_COL32(255, 255, 255, 255));
    ui.list().AddCircleFilled(ui::to_im(at), ui.px(2.5F), ui.theme().outline);
}

}  // namespace

ui::Area TexelMap::place_of(const Rect& texels) const {
    const glm::vec2 a = glm::round(to_window({texels.x0, texels.y0})),
                    b = glm::round(to_window({texels.x1, texels.y1}));
    return {a.x, a.y, b.x - a.x, b.y - a.y};
}

TexelMap make_texel_map(const ui::Ui& ui, const ui::Area& area, const Texture& texture,
                        std::span<const Vertex> corners) {
    TexelMap map{
        .area = area, .range = range_of(texture, corners), .texture = {0, 0, texture.width(), texture.height()}};
    const float em = ui.font(ui::Face::title).em, left = std::round(1.5F * em), top = std::round(em), low = ui.px(12);
    const ui::Area room{area.x + left, area.y + top, std::max(1.0F, area.w - left), std::max(1.0F, area.h - top - low)};
    const double zoom =
        std::min(double{room.w} / std::max(1, map.range.width()), double{room.h} / std::max(1, map.range.height()));
    map.zoom = zoom >= 1 ? std::floor(zoom) : zoom;
    map.at = {room.x, room.y};
    return map;
}

std::span<const Vertex> corners_of(const Derived& derived) {
    return derived.shape() < 0 ? std::span<const Vertex>{} : derived.drawing().corners(derived.shape());
}

std::string texture_note(const Texture& texture) {
    return fmt::format(kNote, texture.width(), texture.height(), id_of_wrap(texture.wrap));
}

void draw_texture(const ViewContext& ctx, const TexelMap& map, std::string_view key) {
    const Texture& texture = ctx.derived.texture();
    if (texture.texels.empty() || map.range.empty()) return;
    // No more texels than the window has pixels for.
    const int step = map.zoom >= 1 ? 1 : static_cast<int>(std::ceil(1 / map.zoom));
    const auto count = [step](int length) { return (length + step - 1) / step; };
    Grid<Rgba> pixels(count(map.range.width()), count(map.range.height()));
    for (int y = 0; y < pixels.height(); ++y) {
        for (int x = 0; x < pixels.width(); ++x) {
            const glm::ivec2 at(map.range.x0 + x * step, map.range.y0 + y * step), texel = wrapped_texel(texture, at);
            const Rgb c = texture.texels.at(texel.x, texel.y);
            pixels.at(x, y) = {c.r, c.g, c.b, map.texture.contains(at.x, at.y) ? std::uint8_t{255} : kRepeated};
        }
    }
    const ImTextureID id = ctx.textures.image(ui::id_of(key), version_of(pixels), pixels);
    const Rect whole{map.range.x0, map.range.y0, map.range.x0 + pixels.width() * step,
                     map.range.y0 + pixels.height() * step};
    const ui::Area drawn = map.place_of(map.range), grid = map.place_of(whole);
    ctx.ui.list().AddImage(id, {drawn.x, drawn.y}, {drawn.right(), drawn.bottom()}, {0, 0},
                           {drawn.w / grid.w, drawn.h / grid.h});
    if (map.range != map.texture) ui::frame(ctx.ui.list(), map.place_of(map.texture), ctx.ui.theme()[Role::text]);
}

void draw_uv_arrows(const ViewContext& ctx, const TexelMap& map) {
    ui::Ui& ui = ctx.ui;
    const ui::Area texture = map.place_of(map.texture);
    const float em = ui.font(ui::Face::title).em, off = std::round(.55F * em), width = ui.presenting() ? 2.5F : 1.6F;
    const float length = std::min(ui.px(38), std::min(texture.w, texture.h) * .4F), x = map.at.x - off,
                y = map.at.y - off;
    const glm::vec2 u_from(texture.x, y), v_from(x, texture.y);
    ui::arrow(ui.list(), u_from, u_from + glm::vec2(length, 0), width, ui.theme()[Role::u], ui.px(8));
    ui::arrow(ui.list(), v_from, v_from + glm::vec2(0, length), width, ui.theme()[Role::v], ui.px(8));
    const auto letter = [&](std::string_view name, Role role) {
        return ui::set_math(ui::coloured(ui::symbol(name), role), {.fonts = &ui.fonts(), .size = ui::MathSize::prose});
    };
    const ui::MathBox u = letter("u", Role::u), v = letter("v", Role::v);
    ui.formula(u, {u_from.x + length + ui.px(6), y + .25F * em});
    ui.formula(v, {std::max(map.area.x, x - v.width / 2), v_from.y + length + ui.px(4) + v.ascent});
}

void draw_texture_outline(const ViewContext& ctx, const TexelMap& map) {
    const std::span<const Vertex> corners = corners_of(ctx.derived);
    const bool triangle = is_triangle(ctx.derived);
    const ui::Theme& theme = ctx.ui.theme();
    const float width = ctx.ui.presenting() ? ui::size::kEdgePresenting * ctx.ui.fonts().spec().scale
                        : triangle          ? ui::size::kEdge
                                            : 1.8F;
    // The sides have the canvas' colours; under dark ones the halo is light.
    const bool dark_sides = triangle && theme.name == ui::ThemeName::light;
    const ui::Color under = dark_sides ? IM_COL32(255, 255, 255, 255) : IM_COL32(0, 0, 0, 255);
    for (const bool halo : {true, false}) {
        for (std::size_t n = 0; n < corners.size(); ++n) {
            const Vertex &a = corners[n], &b = corners[(n + 1) % corners.size()];
            const int e = static_cast<int>(n);
            if (halo)
                draw_side(ctx.ui.list(), map, a, b, width + ui::size::kHalo, under);
            else if (triangle)
                draw_side(ctx.ui.list(), map, a, b, width, theme[ui::edge_role(e)], ui::edge_pattern(e));
            else
                draw_side(ctx.ui.list(), map, a, b, width, IM_COL32(255, 255, 255, 255));
        }
    }
}

void draw_texture_corners(const ViewContext& ctx, const TexelMap& map) {
    if (hides_corners(ctx.state)) return;
    const std::span<const Vertex> corners = corners_of(ctx.derived);
    const int shape = ctx.derived.shape();
    const bool own =
        shape >= 0 &&
        ctx.derived.scene().polygons[static_cast<std::size_t>(ctx.derived.drawing().polygon_of(shape))].mesh < 0;
    const bool may_move = own && may_drag(ctx.state, true);
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const Handle handle{ctx.derived.drawing().polygon_of(shape),
                            ctx.derived.drawing().vertex_of(shape, static_cast<int>(n)), true};
        if (is_finite(corners[n])) draw_corner(ctx, map, corners[n], handle, may_move);
    }
}

void draw_texel_marks(const ViewContext& ctx, const TexelMap& map) {
    const ui::Theme& theme = ctx.ui.theme();
    for (const glm::ivec2 texel : ctx.hover.texels) {
        const ui::Area place = ui::grown_to(map.place_of(texel), kCanvasTextureLeastRing);
        ui::frame(ctx.ui.list(), place.inset(-2, -2), theme.outline);
        ui::frame(ctx.ui.list(), place.inset(-1, -1), theme[Role::now]);
        ui::frame(ctx.ui.list(), place, theme.outline);
    }
    for (const glm::ivec2 texel : ctx.pinned.texels) ring(ctx, map, texel, 2.5F);
    for (const glm::ivec2 texel : pointing(ctx.state, Prediction::Kind::texel).places) {
        const ui::Area place = ui::grown_to(map.place_of(texel), kCanvasTextureLeastRing);
        ui::frame(ctx.ui.list(), place.inset(-2, -2), theme.outline, 4);
        ui::frame(ctx.ui.list(), place.inset(-1, -1), IM_COL32(255, 255, 255, 255), 2);
    }
    if (const auto texel = ctx.derived.texel()) ring(ctx, map, *texel, ctx.ui.presenting() ? 3.5F : 2.5F);
}

void take_texel_input(const ViewContext& ctx, const TexelMap& map, std::string_view name) {
    ui::Ui& ui = ctx.ui;
    const Texture& texture = ctx.derived.texture();
    const ui::Area all = map.place_of(map.range), shown = ui::intersection(all, map.area);
    const bool inside = shown.contains(ui.input().mouse) && ui.clip().contains(ui.input().mouse);
    const glm::ivec2 texel =
        inside ? wrapped_texel(texture, glm::floor(map.to_texel(ui.input().mouse))) : glm::ivec2(0);
    const Selection here{.kind = Selection::Kind::texel, .at = texel};
    std::string tip;
    if (inside && !ui.input().down[0]) {
        const Rgb c = texture.texels.at(texel.x, texel.y);
        tip = fmt::format(kTexelTip, texel.x, texel.y, c.r, c.g, c.b);
        const std::size_t readers = ctx.hover.pixels.size();
        if (ctx.state.hover == here && readers > 0)
            tip += fmt::format(kReadBy, readers, readers == 1 ? kPixel : kPixels);
    }
    const ui::Control region = ui.control(
        {.name = name, .area = shown, .kind = ui::Kind::region, .label = kLabel, .tip = tip, .focusable = false});
    tell_hover(ctx, shown, inside && ui.memory().hot != 0, here);
    if (!inside || !region.clicked || glm::length(region.drag_total) >= kStill) return;
    point_or_pin(ctx, here);
}

}  // namespace texelscope::canvas
