#include "app/state/pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace texelscope {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi, kPoseLeastScale = 1e-3;

struct Middles {
    glm::dvec2 screen{0}, texture{0};
};

[[nodiscard]] Middles middles_of(std::span<const Vertex> corners) {
    Middles sum;
    for (const Vertex& v : corners) sum.screen += glm::dvec2(v.x, v.y), sum.texture += glm::dvec2(v.u, v.v);
    const double count = std::max<double>(1, static_cast<double>(corners.size()));
    return {sum.screen / count, sum.texture / count};
}

[[nodiscard]] double angle(glm::dvec2 way) { return std::atan2(way.y, way.x) * kDegrees; }

}  // namespace

Pose pose_of(std::span<const Vertex> corners) {
    Pose pose{.centre = middles_of(corners).screen};
    if (corners.size() < 2) return pose;
    const Vertex &a = corners[0], &b = corners[1];
    const glm::dvec2 on_screen(double{b.x} - a.x, double{b.y} - a.y), on_texture(double{b.u} - a.u, double{b.v} - a.v);
    const double texels = glm::length(on_texture);
    if (!(texels > 0)) return pose;
    pose.scale = std::max(kPoseLeastScale, glm::length(on_screen) / texels);
    pose.degrees = std::remainder(angle(on_screen) - angle(on_texture), 360.0);
    return pose;
}

std::vector<glm::vec2> posed(std::span<const Vertex> corners, const Pose& pose) {
    const glm::dvec2 middle = middles_of(corners).texture;
    const double c = std::cos(pose.degrees / kDegrees) * pose.scale, s = std::sin(pose.degrees / kDegrees) * pose.scale;
    std::vector<glm::vec2> to;
    to.reserve(corners.size());
    for (const Vertex& v : corners) {
        const glm::dvec2 d = glm::dvec2(v.u, v.v) - middle;
        to.emplace_back(pose.centre + glm::dvec2(c * d.x - s * d.y, s * d.x + c * d.y));
    }
    return to;
}

}  // namespace texelscope
