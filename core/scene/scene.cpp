#include "core/scene/scene.h"

#include <cstddef>

namespace texelscope {

void show_frame(Scene& scene, int n) {
    for (const Animation& animation : scene.animations) {
        if (animation.frames.empty()) continue;
        const auto frame = euclidean_modulo(n, static_cast<std::int64_t>(animation.frames.size()));
        scene.textures[static_cast<std::size_t>(animation.texture)] = animation.frames[static_cast<std::size_t>(frame)];
    }
}

}  // namespace texelscope
