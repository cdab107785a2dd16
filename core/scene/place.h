// Makes polygons of a scene's meshes: transform, cut at the near plane, project, light, sort.
// Source: S1, as published (projection, light, order of faces).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/geometry/camera.h"
#include "core/geometry/jelly_cubes.h"
#include "core/scene/scene.h"

namespace texelscope {

inline constexpr std::size_t kMaxMeshes = 4096;                 ///< of one scene
inline constexpr std::size_t kMaxMeshPolygons = kMaxMeshFaces;  ///< made from all meshes of a scene; more are left out

/// A face of a placed mesh, whether or not a polygon was made from it.
struct PlacedFace {
    int mesh = 0;      ///< index into Scene::meshes
    int face = 0;      ///< of that mesh; for jelly cubes the index of the piece
    int polygon = -1;  ///< index into Scene::polygons; -1: none was made
    double doubled_area =
        0;           ///< on the screen [px^2], positive for a front face; 0 if wholly nearer than the near plane
    double n_z = 0;  ///< z of the unit normal: -1 looks straight at the viewer's plane, 1 away from it
    float light = 1;
    double depth = 0;  ///< mean z of its corners, before the cut; of a torus, as its source has it, z of the first
};

/// The camera of a scene: its focal length, else the framebuffer's width; its near plane, else a 16th of the
/// distance along z of the nearest mesh in front of the eye (a 16th of 1 where there is none). The view axis meets the
/// screen at (width / 2, height / 2), wherever the framebuffer's origin is.
[[nodiscard]] Viewpoint view_of(const Scene& scene);

/// The two cubes before they are scaled and moved: half-sizes 1 and `ratio`, each turned.
[[nodiscard]] JellyCubes jelly_cubes_of(const MeshPlacement& placement, bool size_twice);

/// The angles of a mesh that is turned further about one of the world's axes [0, 2], in the sense of rotation():
/// rounded to hundredths of a degree, so that they are short in writing and ten thousand turns still add no shear.
/// Requires finite angles.
[[nodiscard]] glm::vec3 turned_angles(const glm::vec3& degrees, int axis, double by);

/// Replaces all polygons of the scene that were made from meshes. They come after its own; the farthest of all meshes
/// first where the depth test is off, else in the order of the meshes. Where back faces are culled only front faces
/// become polygons. A mesh with a number that is not finite has no faces; a face whose texture is not there becomes
/// none.
/// @return  every face, in the order of the meshes.
std::vector<PlacedFace> place_meshes(Scene& scene);

}  // namespace texelscope
