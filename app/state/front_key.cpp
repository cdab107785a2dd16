#include "app/state/front_key.h"

#include "app/lesson/random_text.h"

namespace texelscope {

std::string front_key(const Scene& scene, const Work& work) {
    return scene.random && work.edits.empty() ? text_of(*scene.random) : std::string(kOwnFront);
}

}  // namespace texelscope
