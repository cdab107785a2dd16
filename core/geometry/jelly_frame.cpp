#include "core/geometry/jelly_frame.h"

#include <cmath>
#include <cstddef>
#include <glm/matrix.hpp>

#include "core/base/assert.h"

namespace texelscope {

std::array<JellyCorner, 8> jelly_corners(double small_half, const glm::dmat3& big, const glm::dmat3& small, int cube,
                                         bool size_twice) {
    TEXELSCOPE_ASSERT(small_half > 0 && (cube == 0 || cube == 1));
    const double own = cube == 0 ? 1 : small_half, other = cube == 0 ? small_half : 1;
    const glm::dmat3& turn = cube == 0 ? big : small;
    const glm::dmat3 back = glm::transpose(cube == 0 ? small : big);
    std::array<JellyCorner, 8> corners;
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const auto sign = [n](unsigned axis) { return (n >> axis & 1U) != 0 ? -1.0 : 1.0; };
        JellyCorner& corner = corners[n];
        corner.world = turn * (glm::dvec3(sign(0), sign(1), sign(2)) * own);
        corner.turned = back * corner.world / cut_unit(own, other, size_twice);
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::fabs(corner.turned[axis]) > corner.reach)) continue;
            corner.axis = axis, corner.reach = std::fabs(corner.turned[axis]);
        }
        corner.outside = corner.reach > 1;
    }
    return corners;
}

CutWeights cut_weights(double outside, double inside) noexcept {
    const double beyond = outside - 1, short_of = 1 - inside;
    return {beyond, short_of, short_of / (beyond + short_of), beyond / (beyond + short_of)};
}

}  // namespace texelscope
