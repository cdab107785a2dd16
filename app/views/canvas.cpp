// The canvas: the picture at the cursor's step, the shapes that make it, and where a person grabs them.
#include "app/views/view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/views/canvas_parts.h"
#include "app/views/canvas_sections.h"
#include "app/views/rung_marks.h"

namespace texelscope::canvas::canvas_view {
namespace {

constexpr std::string_view kLabel = "canvas", kEmpty = "No shape to draw. Ctrl+O opens a scene.";
constexpr float kPresentingMargin = 8, kStill = 4;  ///< a press that moves less than kStill is a click [px]

[[nodiscard]] bool about_sides(const ViewContext& ctx) {
    if (!is_triangle(ctx.derived) || ctx.state.look.hits) return false;
    return shows(ctx.state, "half-planes") || shows(ctx.state, "signs") || stage_name(ctx.derived) == "sides";
}

[[nodiscard]] bool has_sections(const Derived& derived) {
    if (derived.shape() < 0 || derived.method().triangles) return false;
    const std::vector<Stage>& stages = derived.visit().stages;
    return std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.name == "section"; });
}

void click(const ViewContext& ctx, const CanvasMap& map, const ui::Control& region) {
    const glm::ivec2 pixel = map.pixel_at(ctx.ui.input().mouse);
    const Rect frame = ctx.derived.scene().framebuffer.rect();
    if (!frame.contains(pixel.x, pixel.y)) return;
    const bool answers = pointing(ctx.state, Prediction::Kind::pixel).asked;
    if (region.double_clicked && !answers) {
        if (const auto path = ctx.derived.last_write(pixel)) ctx.act(action::StepTo{*path});
    }
    if (!region.clicked || glm::length(region.drag_total) >= kStill) return;
    point_or_pin(ctx, {.kind = Selection::Kind::pixel, .at = pixel});
}

/// Everything the mouse does on the pixels but dragging corners, which are controls of their own.
void take_input(const ViewContext& ctx, const Sheet& sheet) {
    ui::Ui& ui = ctx.ui;
    const ui::Input& input = ui.input();
    const CanvasMap& map = sheet.map;
    const Framebuffer& frame = ctx.derived.scene().framebuffer;
    const bool inside = map.area.contains(input.mouse) && ui.clip().contains(input.mouse);
    const glm::ivec2 pixel = map.pixel_at(input.mouse);
    const bool on_frame = inside && frame.rect().contains(pixel.x, pixel.y);
    const std::string tip =
        on_frame && !input.down[0] && !input.down[1] && !input.down[2] ? describe(sheet, pixel) : std::string();
    const ui::Control region = ui.control({.name = "canvas",
                                           .area = map.area,
                                           .kind = ui::Kind::region,
                                           .label = kLabel,
                                           .tip = tip,
                                           .focusable = false});
    tell_hover(ctx, map.area, on_frame && (region.hovered || ui.memory().hot != 0),
               {.kind = Selection::Kind::pixel, .at = pixel});
    if (region.clicked || region.double_clicked) click(ctx, map, region);
    turn_by_mouse(sheet);
    if (inside && input.wheel.y != 0) {
        ctx.act(action::SetLook{zoomed(ctx.state.look, map, frame, input.mouse, input.wheel.y)});
    } else if (inside && input.down[2] && !input.pressed[2] && input.mouse != ui.memory().mouse) {
        ctx.act(action::SetLook{panned(ctx.state.look, map, input.mouse - ui.memory().mouse)});
    }
}

void draw_layers(Sheet& sheet) {
    draw_picture(sheet);
    draw_grid(sheet);
    if (sheet.sections) draw_sections(sheet);
    draw_row_band(sheet);
    if (sheet.planes) draw_half_planes(sheet);
    draw_samples(sheet);
    if (!sheet.ctx.state.look.hits) draw_numbers(sheet);
    draw_ghosts(sheet);
    if (shows(sheet.ctx.state, "front")) draw_rung_marks(sheet);
    const bool weights = shows(sheet.ctx.state, "weights");
    if (weights) draw_weight_areas(sheet);
    draw_outlines(sheet);
    // Counts are what a hit map is for: the sides must not hide them.
    if (sheet.ctx.state.look.hits) draw_numbers(sheet);
    // First come, first served: the plates that follow make room for these.
    if (const auto pixel = sheet.ctx.derived.pixel()) sheet.labels.block(current_place(sheet, *pixel));
    block_corners(sheet);
    std::vector<PositionBadge> badges;
    if (sheet.ui().presenting()) badges = place_position_badges(sheet);
    if (sheet.planes || stage_name(sheet.ctx.derived) == "box") draw_box(sheet);
    draw_selections(sheet);
    draw_answer(sheet);
    draw_corners(sheet);
    draw_position_badges(sheet, badges);
    draw_corner_labels(sheet);
    if (sheet.sections) draw_section_marks(sheet);
    if (shows(sheet.ctx.state, "walk")) draw_walk(sheet);
    if (weights) draw_weight_labels(sheet);
    if (sheet.planes)
        draw_sign_badges(sheet);
    else
        draw_tilt(sheet);
    draw_sample_note(sheet);
    // Over all marks: nothing may hide where the cursor stands.
    draw_current_pixel(sheet);
    const auto& random = sheet.ctx.derived.scene().random;
    if (!random || random->waste == 0) draw_notices(sheet);  // waste is what they are for
}

/// Not where a picture has room for all of its pixels only without them.
[[nodiscard]] bool has_rulers(const ui::Ui& ui, const ui::Area& place, const Framebuffer& frame) {
    const glm::vec2 room = ruler_room(ui, frame);
    const ui::Area beside{place.x + room.x, place.y + room.y, place.w - room.x, place.h - room.y};
    return fit_zoom(beside, frame) >= 1 || fit_zoom(place, frame) < 1;
}

void draw(const ViewContext& ctx, const ui::Area& place) {
    ui::Ui& ui = ctx.ui;
    const Framebuffer& frame = ctx.derived.scene().framebuffer;
    const ui::Theme& theme = ui.theme();
    ui.begin_panel("canvas", place, {}, {}, theme.canvas);
    const float margin = ui.presenting() ? kPresentingMargin : 0;
    const glm::vec2 room = has_rulers(ui, place, frame) ? ruler_room(ui, frame) : glm::vec2(0);
    const ui::Area area{place.x + room.x + margin, place.y + room.y + margin,
                        std::max(1.0F, place.w - room.x - 2 * margin), std::max(1.0F, place.h - room.y - 2 * margin)};
    const CanvasMap map = make_map(area, frame, ctx.state.look);
    const CanvasPicture& picture = ctx.derived.canvas(window_in_view(map, frame));
    Sheet sheet{ctx,
                map,
                picture,
                about_sides(ctx),
                has_sections(ctx.derived),
                future_is_secret(ctx.state),
                sample_offset(ctx.state, ctx.derived),
                LabelPlaces(area)};

    ui.begin_clip(area);
    take_input(ctx, sheet);
    draw_layers(sheet);
    if (ctx.derived.shape() < 0) ui.text_centred(ui::Face::prose, area, ui::Role::muted, kEmpty);
    ui.end_clip();
    if (ui.presenting())
        ui::frame(ui.list(), area.inset(-1, -1), theme.hairline);
    else if (room.x > 0)
        draw_rulers(sheet, place);
    ui.end_panel();
}

constexpr View kView{"canvas", "Canvas", draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::canvas_view
