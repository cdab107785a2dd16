#include "core/method/decisions.h"

namespace texelscope {

Decisions decisions_of(const Drawing& drawing, int shape) {
    const Rect frame = drawing.scene().framebuffer.rect();
    const bool drawn = shape >= 0 && drawing.refusal(shape) == Fate::written && drawing.corners(shape).size() == 3;
    if (!drawn) return {.frame = frame, .pixels = Grid<Decision>(frame.width(), frame.height())};
    const Texture& texture = *drawing.job(shape).texture;
    const auto power = [](int size) { return (size & (size - 1)) == 0; };
    // `fast` leaves masked textures of odd sizes to exact arithmetic, which masks them: as if they repeated.
    const bool odd = texture.wrap == Wrap::mask && !(power(texture.width()) && power(texture.height()));
    return who_decided(
        drawing.corners(shape).first<3>(),
        {.width = texture.width(), .height = texture.height(), .wrap = odd ? Wrap::repeat : texture.wrap}, frame);
}

}  // namespace texelscope
