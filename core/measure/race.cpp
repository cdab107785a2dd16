#include "core/measure/race.h"

#include <algorithm>
#include <chrono>

namespace texelscope {
namespace {

[[nodiscard]] double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Draws every shape as if the screen were `frame`.
void draw(const Drawing& drawing, const Rect& frame, Image& picture) {
    const DrawSettings& settings = drawing.settings();
    for (int n = 0; n < drawing.shape_count(); ++n) {
        if (drawing.refusal(n) != Fate::written) continue;
        Job job = drawing.job(n);
        job.frame = frame;
        (void)settings.method->render(settings.format, job, picture);
    }
}

/// The fastest of the rounds that fit into the time.
[[nodiscard]] double fastest(double seconds, auto&& round) {
    const double begin = now();
    double best = 0, last = begin;
    for (int n = 0; n == 0 || last - begin < seconds; ++n) {
        const double start = last;
        round();
        last = now();
        best = n == 0 ? last - start : std::min(best, last - start);
    }
    return best;
}

}  // namespace

Lap lap(const Scene& scene, const DrawSettings& settings, double seconds) {
    const Drawing drawing(scene, settings);
    const Rect frame = scene.framebuffer.rect();
    // One pixel, far from everything: the shapes are set up and then found to lie elsewhere.
    constexpr int kElsewhere = -(1 << 20);
    const Rect elsewhere{kElsewhere, kElsewhere, kElsewhere + 1, kElsewhere + 1};
    Image picture(frame.width(), frame.height(), scene.framebuffer.clear), dot(1, 1);
    Lap result;
    result.method = settings.method;
    result.triangles = drawing.shape_count();
    each_sample(drawing, 0, drawing.shape_count(), {frame, 1},
                [&](int, const Sample& s) { result.pixels += s.fate == Fate::written; });
    result.seconds = fastest(seconds, [&] { draw(drawing, frame, picture); });
    result.set_up = std::min(result.seconds, fastest(seconds / 4, [&] { draw(drawing, elsewhere, dot); }));
    return result;
}

}  // namespace texelscope
