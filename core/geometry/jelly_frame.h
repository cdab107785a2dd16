// The jelly cubes as their source thinks of them: one cube's corners, turned back into the other's frame, where a cut
// by a face is one comparison with 1. What is drawn comes from core/geometry/jelly_cubes.h, which needs no cases.
// Source: S2 (jelly cubes).
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace texelscope {

/// Sizes of the small cube over the big one above which, at some rotation, its corners stick out (1 / sqrt 3: they are
/// that much farther from the middle than faces are), whole edges do (1 / sqrt 2), and it is the larger one.
inline constexpr double kCornersOut = 0.57735026918962576, kEdgesOut = 0.70710678118654752, kRolesSwap = 1;

/// What a place is divided by before it is compared with 1: the half-size of the cube that cuts.
/// @param own         half-size of the cube that is cut.
/// @param size_twice  quirk: as the source's listing has it, which multiplies by `own` a second time instead.
[[nodiscard]] constexpr double cut_unit(double own, double other, bool size_twice) noexcept {
    return size_twice ? 1 / own : other;  // Q1
}

/// A corner of one cube.
struct JellyCorner {
    glm::dvec3 world{0};   ///< turned by its own rotation [half-sizes of the big cube]
    glm::dvec3 turned{0};  ///< then back by the other's inverse [cut_unit(), half-sizes of the other cube]
    int axis = 0;          ///< along which `turned` reaches farthest
    double reach = 0;      ///< its absolute value there
    bool outside = false;  ///< reach > 1
};

/// Corner n lies at (bit 0 of n, bit 1, bit 2) of its cube, a bit that is set at the negative end.
/// @param small_half  over the big one's, above 0.
/// @param cube        whose corners: 0 the big one's, 1 the small one's.
/// @param size_twice  as of cut_unit().
[[nodiscard]] std::array<JellyCorner, 8> jelly_corners(double small_half, const glm::dmat3& big,
                                                       const glm::dmat3& small, int cube, bool size_twice = false);

/// An edge cut at 1: the average of its ends, weighted by the lengths on each side, each by that of the other end.
struct CutWeights {
    double beyond = 0, short_of = 0;       ///< lengths from the cut to the end outside and to the end inside
    double of_outside = 1, of_inside = 0;  ///< weights; their sum is 1
};
/// Requires outside > 1 >= inside, as coordinates.
[[nodiscard]] CutWeights cut_weights(double outside, double inside) noexcept;

}  // namespace texelscope
