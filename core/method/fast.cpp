// The production rasterizer (core/fast/raster.h) as a method.
#include "core/method/drawing.h"
#include "core/method/exact.h"
#include "core/method/fast_picture.h"
#include "core/method/shortcut.h"

namespace texelscope {
namespace {

Fate render(NumberFormat, const Job& job, Image& picture);
Fate paint(NumberFormat, const Job& job, const Window& part, int shape, Layer& layer);

constexpr Method kMethod = shown_by_definition({.id = "fast", .title = "Fast", .render = render, .paint = paint});
const RegisterMethod kRegistered(kMethod);
constexpr Shortcut kShortcut{&kMethod, kDefinition};
const RegisterShortcut kRegisteredShortcut(kShortcut);

constexpr DrawSettings kSettings{.method = &kMethod, .format = NumberFormat::exact};

Fate render(NumberFormat, const Job& job, Image& picture) {
    return draws_the_same_as_fast(kSettings, job) ? render_fast(kSettings, job, picture) : render_exactly(job, picture);
}
Fate paint(NumberFormat, const Job& job, const Window& part, int shape, Layer& layer) {
    return draws_the_same_as_fast(kSettings, job) ? paint_fast(kSettings, job, part, shape, layer)
                                                  : paint_exactly(job, part, shape, layer);
}

}  // namespace
}  // namespace texelscope
