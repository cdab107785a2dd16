// Triangles for measuring as the methods take them: a scene.
#pragma once

#include "core/scene/scene.h"
#include "core/scene/triangles_file.h"

namespace texelscope {

/// What triangles are drawn with where no texture is given, of the size that they were made for: Pattern::address,
/// whose colours tell 256 x 256 texels from each other and from what is not drawn.
[[nodiscard]] Image default_texels(const TrianglesFile& file);

/// One polygon a triangle; u and v become texels of a texture of `texels` that repeats, rounded to float32.
[[nodiscard]] Scene scene_of(const TrianglesFile& file, Image texels);

}  // namespace texelscope
