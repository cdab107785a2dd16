// Models in Wavefront OBJ files. obj.cpp is the only user of tinyobjloader.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/result.h"
#include "core/geometry/mesh.h"

namespace texelscope {

inline constexpr std::size_t kMaxObjBytes = std::size_t{64} << 20;  ///< the longest OBJ text

/// Vertices (v), texture corners (vt) and faces (f); polygons stay polygons, all else is passed over, and material
/// files are never opened. OBJ's z points to the viewer and its v up, so both are turned round. A corner without vt has
/// that of a regular polygon (core/geometry/solids.h). Fails  on a text without faces or beyond the bounds here and in
/// core/geometry/mesh.h; on a number or index that is
///        none, is not finite or refers to nothing; on a face that has no area or is not convex. Faces need not be
///        flat.
/// @param name  what the error's place begins with.
Result<Mesh> parse_obj(std::string_view text, std::string_view name);

}  // namespace texelscope
