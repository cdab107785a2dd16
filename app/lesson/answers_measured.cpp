#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"
#include "core/measure/front.h"
#include "core/measure/skip_bill.h"
#include "core/method/decisions.h"

namespace texelscope::answers {
namespace {

constexpr double kEitherWay = 0.1;  ///< of the right number

/// The greatest error of each rung over the scene's triangles.
[[nodiscard]] std::vector<FrontPoint> errors_of(const Scene& scene, const std::vector<std::string>& rungs) {
    FrontOptions options;
    options.own.emplace("own", front_scene_of(scene));
    options.rounds = 0;
    for (const std::string& id : rungs) options.rungs.push_back(find_rung(id));
    FrontRun run(std::move(options));
    while (!run.step()) continue;
    return run.points();
}

}  // namespace

Accepted error_place(const Asked& asked) {
    Accepted a{.options = {1}, .step = asked.step.prefix(1), .sentence = "Nothing is drawn here: nobody errs."};
    const std::vector<FrontPoint> points = errors_of(asked.drawing.scene(), asked.call.words);
    if (points.size() != 3) return a;
    const double own = points[0].max_error;
    const auto [low, high] = std::minmax(points[1].max_error, points[2].max_error);
    a.options = {own < low ? 0 : own <= high ? 1 : 2};
    a.sentence = fmt::format("{}: {:.2g} texels; the others: {:.2g} and {:.2g}.", points[0].label, own,
                             points[1].max_error, points[2].max_error);
    return a;
}

Accepted needed(const Asked& asked) {
    Accepted a{.step = asked.step.prefix(1), .sentence = "Nothing is drawn here."};
    SkipScene scene(asked.drawing.scene());
    if (scene.triangles() == 0) return a;
    scene.clear();
    const RasterCounters counters = scene.draw(kAllSkips);
    const double share = static_cast<double>(counters.drawn) / static_cast<double>(counters.triangles);
    a.number = std::round(share * asked.call.numbers[0]);
    a.tolerance = kEitherWay * *a.number;
    a.sentence =
        fmt::format("{} of {} are set up and drawn: {:.1f} percent.", counters.drawn, counters.triangles, 100 * share);
    return a;
}

Accepted uncertain(const Asked& asked) {
    Accepted a{.step = asked.step.prefix(1), .sentence = "Nothing is drawn here."};
    const Decisions found = decisions_of(asked.drawing, asked.shape());
    Integer drawn = 0;
    for (int y = found.frame.y0; y < found.frame.y1; ++y)
        for (int x = found.frame.x0; x < found.frame.x1; ++x) {
            const Decision decision = found.pixels.at(x - found.frame.x0, y - found.frame.y0);
            drawn += decision != Decision::none;
            if (decision != Decision::none && decision != Decision::certificate) a.places.push_back({x, y});
        }
    if (drawn == 0) return a;
    a.sentence = fmt::format("{} of {} pixels lie as near to a border as the bound, or on it.", a.places.size(), drawn);
    if (!a.places.empty())
        if (const auto step = pixel_step(asked.steps, asked.shape(), a.places[0].x, a.places[0].y)) a.step = *step;
    return a;
}

}  // namespace texelscope::answers
