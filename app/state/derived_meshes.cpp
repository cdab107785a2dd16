// What follows from a scene's meshes: their faces, what turns, the cut cubes, the frames of textures that move.
#include <algorithm>

#include "app/state/derived_cache.h"
#include "core/image/wrap.h"

namespace texelscope {

const std::vector<PlacedFace>& Derived::faces() const { return cache_->faces; }

Turning Derived::turning() const {
    const Scene& s = scene();
    const auto count = static_cast<int>(s.meshes.size());
    Turning what = cache_->state.turning;
    if (what.mesh < 0 || what.mesh >= count) {
        what = {.mesh = count > 0 ? 0 : -1};
        if (shape() >= 0) {
            const int own = s.polygons[static_cast<std::size_t>(drawing().polygon_of(shape()))].mesh;
            if (own >= 0) what.mesh = own;
        }
    }
    what.small =
        what.small && what.mesh >= 0 && s.meshes[static_cast<std::size_t>(what.mesh)].shape == Shape3d::jelly_cubes;
    return what;
}

const JellyCubes* Derived::jelly() const {
    const int mesh = turning().mesh;
    if (mesh < 0 || scene().meshes[static_cast<std::size_t>(mesh)].shape != Shape3d::jelly_cubes) return nullptr;
    auto& jelly = cache_->jelly;
    if (!jelly || jelly->mesh != mesh)
        jelly = {mesh, jelly_cubes_of(scene().meshes[static_cast<std::size_t>(mesh)], scene().size_twice)};
    return &jelly->cubes;
}

FrameStrip Derived::frames() const {
    for (const Animation& animation : scene().animations) {
        const auto count = static_cast<int>(animation.frames.size());
        if (count == 0) continue;
        return {count, static_cast<int>(euclidean_modulo(cache_->state.work.frame, count)), animation.texture};
    }
    return {};
}

}  // namespace texelscope
