// Two cubes about one middle, each turned on its own, and each cut by the other's six planes. Whatever pokes out is
// found by general convex clipping, so that no case is special, nor does it matter which cube is the larger.
// Source: S2 (jelly cubes).
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <vector>

#include "core/geometry/clip.h"

namespace texelscope {

/// A part of a face that lies wholly inside the other cube, or wholly outside.
struct JellyPiece {
    int cube = 0;  ///< 0 the big one, 1 the small one
    int face = 0;  ///< of that cube, numbered as cube()'s in core/geometry/solids.h
    bool inside = false;
    int plane = -1;  ///< the face of the other cube whose plane cut it off; -1 where inside
    ClipRing ring;   ///< positions in the world (w = 1); origins are those in its stage of `cuts`
};

struct JellyCubes {
    /// For each face of each cube, its cuts by planes 0, 1, ... of the other cube until nothing is left inside.
    /// Distances are in half-sizes of the cutting cube: a corner at 1.1 has -0.1, one at 0.7 has 0.3.
    std::array<std::array<std::vector<ClipStage>, 6>, 2> cuts;
    std::vector<JellyPiece> pieces;  ///< face by face, those outside first
};

/// Faces of the two cubes that share a plane: the big cube's count as inside, the small one's as outside. What is
/// nearer to a plane than 1e-12 half-sizes counts as on it, and corners nearer than 1e-9 of the larger half-size are
/// made one, so that pieces which meet have corners of the same bits.
/// Requires half-sizes above 0, and rotations.
/// @param size_twice  quirk of core/geometry/jelly_frame.h: the smaller one is cut where the source's listing cuts it,
///                    so that its pieces are neither inside nor outside of the other cube.
[[nodiscard]] JellyCubes jelly_cubes(double big_half, double small_half, const glm::dmat3& big, const glm::dmat3& small,
                                     bool size_twice = false);

/// The volume of what the cubes have in common, whose surface is the pieces inside (divergence theorem).
[[nodiscard]] double common_volume(const JellyCubes& cubes);

}  // namespace texelscope
