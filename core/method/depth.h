// The depth test of a scene: z is affine over the screen, and the nearest sample stays (LESS, float32).
#pragma once

#include <span>

#include "core/conventions.h"
#include "core/geometry/vertex.h"
#include "core/image/image.h"
#include "core/number/real.h"

namespace texelscope {

/// z over the screen, based at a corner so that far coordinates cost no digits.
struct DepthPlane {
    double x0 = 0, y0 = 0, z0 = 0, z_x = 0, z_y = 0;

    [[nodiscard]] float at(Integer x, Integer y) const {
        const double dx = static_cast<double>(x) + kSample - x0, dy = static_cast<double>(y) + kSample - y0;
        return static_cast<float>(z0 + z_x * dx + z_y * dy);
    }
};

/// The plane through the first corner and the widest pair of neighbours of a convex shape; level where it has no area.
[[nodiscard]] inline DepthPlane depth_plane(std::span<const Vertex> corners) {
    DepthPlane plane{.x0 = corners[0].x, .y0 = corners[0].y, .z0 = corners[0].z};
    double widest = 0;
    for (std::size_t n = 2; n < corners.size(); ++n) {
        const double ax = corners[n - 1].x - plane.x0, ay = corners[n - 1].y - plane.y0,
                     az = corners[n - 1].z - plane.z0;
        const double bx = corners[n].x - plane.x0, by = corners[n].y - plane.y0, bz = corners[n].z - plane.z0;
        const double area = ax * by - bx * ay;
        if (!(std::abs(area) > widest)) continue;
        widest = std::abs(area);
        plane.z_x = (az * by - bz * ay) / area;
        plane.z_y = (ax * bz - bx * az) / area;
    }
    return plane;
}

}  // namespace texelscope
