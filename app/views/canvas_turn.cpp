// Turning a solid with the mouse: the right button on the canvas, as if the hand lay on the solid's front.
#include "app/views/canvas_parts.h"

namespace texelscope::canvas {
namespace {

constexpr double kDegrees = 0.5;           ///< for each pixel of the window
constexpr int kFirstGesture = -1'000'000;  ///< drags of the right button count down from here, apart from the left's

/// The mesh whose polygon is seen at a pixel of the finished picture, else the one that was turned before.
[[nodiscard]] Turning solid_at(const Derived& derived, glm::ivec2 pixel) {
    const Drawing& drawing = derived.drawing();
    const Layer seen = layer_of(drawing, drawing.shape_count(), {{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, 1});
    const Turning before = derived.turning();
    const int shape = seen.cells().at(0, 0).shape;
    if (shape < 0) return before;
    const int mesh = derived.scene().polygons[static_cast<std::size_t>(drawing.polygon_of(shape))].mesh;
    return mesh < 0 || mesh == before.mesh ? before : Turning{mesh};
}

}  // namespace

void turn_by_mouse(const Sheet& sheet) {
    const ViewContext& ctx = sheet.ctx;
    const ui::Input& input = ctx.ui.input();
    const ui::UiMemory& memory = ctx.ui.memory();
    const Turning what = ctx.derived.turning();
    if (what.mesh < 0 || !input.down[1] || !sheet.map.area.contains(memory.right_press)) return;
    if (input.pressed[1]) {
        const glm::ivec2 pixel = sheet.map.pixel_at(input.mouse);
        if (ctx.derived.scene().framebuffer.rect().contains(pixel.x, pixel.y))
            ctx.act(action::ChooseTurning{solid_at(ctx.derived, pixel)});
        return;
    }
    const glm::vec2 moved = input.mouse - memory.mouse;
    const int gesture = kFirstGesture - memory.right_presses;
    if (moved.x != 0) ctx.act(action::Turn{what, 1, -kDegrees * double{moved.x}, gesture});
    if (moved.y != 0) ctx.act(action::Turn{what, 0, kDegrees * double{moved.y}, gesture});
}

}  // namespace texelscope::canvas
