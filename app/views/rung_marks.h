// What a rung of the front gets wrong: marks on the canvas, and what they mean.
#pragma once

#include "app/views/canvas_parts.h"
#include "core/measure/rungs.h"

namespace texelscope {

/// Counts beside the marks, in one row.
void draw_rung_legend(const ViewContext& context, const ui::Area& row, const Rung& rung);

namespace canvas {
/// On the pixels that the look's rung gets wrong.
void draw_rung_marks(const Sheet& sheet);
}  // namespace canvas

}  // namespace texelscope
