// Under which name the points of a front are kept, so that those of another scene are never shown for it.
#pragma once

#include <string>

#include "app/state/state.h"

namespace texelscope {

/// The random triangles of the scene as text; with a corner moved, or without random triangles, "own".
[[nodiscard]] std::string front_key(const Scene& scene, const Work& work);
inline constexpr std::string_view kOwnFront = "own";

}  // namespace texelscope
