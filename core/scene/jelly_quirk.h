// The quirk of jelly cubes (S2), told as the methods tell theirs. It is one of the geometry, so a scene has it and not
// a method: Scene::size_twice.
#pragma once

#include <string_view>

#include "core/method/method.h"

namespace texelscope {

inline constexpr std::string_view kJellyCubes = "jelly-cubes";  ///< what has the quirk, where methods are listed
inline constexpr std::string_view kJellyListing = "core/geometry/jelly_frame.h";  ///< as embedded
inline constexpr QuirkInfo kJellyQuirk{
    "Q1", "size_twice", "scaled twice",
    "The listing scales by the small cube's size twice; the test against ±1 needs division by the big one's."};

}  // namespace texelscope
