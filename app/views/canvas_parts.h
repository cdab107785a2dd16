// The canvas is drawn in layers, a file for each few; canvas.cpp puts them together and takes the input.
#pragma once

#include <string>

#include "app/views/canvas_labels.h"
#include "app/views/canvas_map.h"
#include "app/views/canvas_values.h"

namespace texelscope::canvas {

/// What all layers need to know.
struct Sheet {
    const ViewContext& ctx;
    CanvasMap map;
    const CanvasPicture& picture;
    bool planes = false;    ///< the three half-planes in place of the texture's colours
    bool sections = false;  ///< the sections of a convex polygon
    LabelPlaces labels;

    [[nodiscard]] ui::Ui& ui() const { return ctx.ui; }
    [[nodiscard]] ImDrawList& list() const { return ctx.ui.list(); }
    [[nodiscard]] ui::Color color(ui::Role role) const { return ctx.ui.theme()[role]; }
    /// The cell that holds a pixel; null where it is not in the picture.
    [[nodiscard]] const CanvasCell* cell(glm::ivec2 pixel) const;
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
// In canvas_shape.cpp.
void draw_outlines(const Sheet& sheet);
/// Rings of the corners; those that may be dragged are controls.
void draw_corners(Sheet& sheet);
void draw_corner_labels(Sheet& sheet);
void draw_notices(Sheet& sheet);
// In canvas_rulers.cpp.
/// Room that the rulers take at the left and at the top; none while presenting.
[[nodiscard]] glm::vec2 ruler_room(const ui::Ui& ui, const Framebuffer& frame);
void draw_rulers(const Sheet& sheet, const ui::Area& panel);
/// While presenting: the current column and row on plates at the canvas' borders.
void draw_position_badges(Sheet& sheet);

}  // namespace texelscope::canvas
