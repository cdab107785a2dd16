// The words of the scene file (patterns' in core/image/patterns.h), in the order of their enumerations.
#pragma once

#include <array>
#include <string_view>

#include "core/scene/scene.h"

namespace texelscope {

inline constexpr std::array<std::string_view, 2> kDepthNames{"off", "less"};
inline constexpr std::array<std::string_view, 2> kCullNames{"none", "back"};
inline constexpr std::array<std::string_view, 3> kWrapNames{"repeat", "mask", "clamp"};
inline constexpr std::array<std::string_view, 2> kBlendNames{"none", "half"};  ///< of Polygon::half
/// Of Shape3d but `obj`, which a scene spells by its file.
inline constexpr std::array<std::string_view, 5> kSolidNames{"cube", "dodecahedron", "icosahedron", "torus",
                                                             "jelly-cubes"};

}  // namespace texelscope
