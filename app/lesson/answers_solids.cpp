#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "app/lesson/facts.h"
#include "core/geometry/jelly_frame.h"
#include "core/scene/place.h"

namespace texelscope::answers {
namespace {

/// The mesh that the cursor's shape was made from, else the scene's first; -1 where there is none.
[[nodiscard]] int mesh_of(const Asked& asked) {
    const Scene& scene = asked.drawing.scene();
    const int shape = asked.shape();
    const int own = shape < 0 ? -1 : scene.polygons[static_cast<std::size_t>(asked.drawing.polygon_of(shape))].mesh;
    return own >= 0 ? own : scene.meshes.empty() ? -1 : 0;
}

}  // namespace

Accepted visible_faces(const Asked& asked) {
    Accepted a{.step = asked.step, .sentence = "There is no solid in this scene."};
    const int mesh = mesh_of(asked);
    if (mesh < 0) return a;
    Scene scene = asked.drawing.scene();
    int all = 0, front = 0;
    for (const PlacedFace& face : place_meshes(scene)) {
        if (face.mesh != mesh) continue;
        ++all;
        front += face.doubled_area > 0 ? 1 : 0;
        const int shape = face.polygon < 0 ? -1 : asked.drawing.first_shape_of(face.polygon);
        if (front == 1 && face.doubled_area > 0 && shape >= 0 && shape < asked.drawing.shape_count())
            a.step = Path{{{'t', shape}}};
    }
    a.number = front;
    a.sentence = fmt::format("{} of {} faces have a positive area on the screen; the others look away.", front, all);
    return a;
}

Accepted cut_corners(const Asked& asked) {
    Accepted a{.step = asked.step, .sentence = "There are no jelly cubes in this scene."};
    const int mesh = mesh_of(asked);
    if (mesh < 0) return a;
    const MeshPlacement& cubes = asked.drawing.scene().meshes[static_cast<std::size_t>(mesh)];
    if (cubes.shape != Shape3d::jelly_cubes || !(cubes.ratio > 0)) return a;
    std::string names;
    const auto corners = jelly_corners(cubes.ratio, rotation(cubes.rotate), rotation(cubes.rotate2), 1,
                                       asked.drawing.scene().size_twice);
    for (std::size_t n = 0; n < corners.size() / 2; ++n) {  // opposite corners, n and 7 - n, reach equally far
        if (!corners[n].outside) continue;
        a.options.push_back(static_cast<int>(n));
        names += fmt::format("{}{} and {} at {:.3f}", names.empty() ? "" : ", ", n, 7 - n, corners[n].reach);
    }
    a.sentence = a.options.empty() ? "No corner of the small cube has a coordinate beyond ±1."
                                   : fmt::format("Beyond ±1 in the big cube's frame: {}.", names);
    return a;
}

Accepted cut_weight(const Asked& asked) {
    const double outside = asked.call.numbers[0], inside = asked.call.numbers[1];
    Accepted a{.step = asked.step, .sentence = "Such an edge is not cut at 1."};
    if (!(outside > 1 && inside <= 1)) return a;
    const CutWeights w = cut_weights(outside, inside);
    a.number = w.of_outside, a.tolerance = 0.01;
    a.sentence = fmt::format("${:.4g} \\cdot {:.4g} + {:.4g} \\cdot {:.4g} = 1$: the nearer end weighs more.",
                             w.of_outside, outside, w.of_inside, inside);
    return a;
}

}  // namespace texelscope::answers
