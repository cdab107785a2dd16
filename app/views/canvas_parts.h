// The canvas is drawn in layers, a file for each few; canvas.cpp puts them together and takes the input.
#pragma once

#include <string>
#include <vector>

#include "app/views/canvas_labels.h"
#include "app/views/canvas_map.h"
#include "app/views/canvas_values.h"

namespace texelscope::canvas {

inline constexpr float kDotsFrom = 6;  ///< window pixels per pixel: from here samples are drawn as dots

/// What all layers need to know.
struct Sheet {
    const ViewContext& ctx;
    CanvasMap map;
    const CanvasPicture& picture;
    bool planes = false;    ///< the three half-planes in place of the texture's colours
    bool sections = false;  ///< the sections of a convex polygon
    bool secret = false;    ///< what is to come is not shown
    double sample = 0;      ///< where in its pixel the method samples, along both axes [px]
    LabelPlaces labels;

    [[nodiscard]] ui::Ui& ui() const { return ctx.ui; }
    [[nodiscard]] ImDrawList& list() const { return ctx.ui.list(); }
    [[nodiscard]] ui::Color color(ui::Role role) const { return ctx.ui.theme()[role]; }
    /// The cell that holds a pixel; null where it is not in the picture.
    [[nodiscard]] const CanvasCell* cell(glm::ivec2 pixel) const;
    /// Where the method samples a pixel, in the window.
    [[nodiscard]] glm::vec2 sample_place(glm::ivec2 pixel) const { return map.to_window(glm::dvec2(pixel) + sample); }
    /// A corner of the scene, in the window, kept within what ImGui draws.
    [[nodiscard]] glm::vec2 place(const Vertex& vertex) const;
};

// In canvas_pixels.cpp, bottom to top.
void draw_picture(const Sheet& sheet);
void draw_grid(const Sheet& sheet);
void draw_row_band(const Sheet& sheet);
void draw_samples(const Sheet& sheet);
void draw_numbers(const Sheet& sheet);
// In canvas_marks.cpp.
void draw_ghosts(const Sheet& sheet);
void draw_selections(const Sheet& sheet);
void draw_answer(const Sheet& sheet);
void draw_current_pixel(const Sheet& sheet);
/// Its ring with some room around: no plate goes there.
[[nodiscard]] ui::Area current_place(const Sheet& sheet, glm::ivec2 pixel);
/// Says where pixels are sampled, where it is not in their middle.
void draw_sample_note(Sheet& sheet);
/// What the pixel's tip says.
[[nodiscard]] std::string describe(const Sheet& sheet, glm::ivec2 pixel);
// In canvas_planes.cpp.
void draw_half_planes(const Sheet& sheet);
void draw_box(Sheet& sheet);
void draw_sign_badges(Sheet& sheet);
void draw_tilt(Sheet& sheet);
// In canvas_sections.cpp.
void draw_sections(const Sheet& sheet);
void draw_section_marks(Sheet& sheet);
// In canvas_walk.cpp.
void draw_walk(Sheet& sheet);
// In canvas_weights.cpp.
/// The three areas between a point and the sides; the point is that of the view `weights`.
void draw_weight_areas(const Sheet& sheet);
void draw_weight_labels(Sheet& sheet);
// In canvas_turn.cpp.
void turn_by_mouse(const Sheet& sheet);
// In canvas_shape.cpp.
void draw_outlines(const Sheet& sheet);
/// Keeps plates off the current shape's corners.
void block_corners(Sheet& sheet);
/// Rings of the corners; those that may be dragged are controls.
void draw_corners(Sheet& sheet);
void draw_corner_labels(Sheet& sheet);
/// Whether `area` lies over the picture, drawn or to come, or over the current shape's outline.
[[nodiscard]] bool meets_picture(const Sheet& sheet, const ui::Area& area);
void draw_notices(Sheet& sheet);
// In canvas_rulers.cpp.
/// Room that the rulers take at the left and at the top; none while presenting.
[[nodiscard]] glm::vec2 ruler_room(const ui::Ui& ui, const Framebuffer& frame);
void draw_rulers(const Sheet& sheet, const ui::Area& panel);
/// While presenting: the current column and row on plates at the canvas' borders, away from the current pixel.
struct PositionBadge {
    ui::Area place;
    std::string text;
};
[[nodiscard]] std::vector<PositionBadge> place_position_badges(Sheet& sheet);
void draw_position_badges(const Sheet& sheet, const std::vector<PositionBadge>& badges);

}  // namespace texelscope::canvas
