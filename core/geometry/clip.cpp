#include "core/geometry/clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

namespace texelscope {
namespace {

/// A fixed order of the ends of a side, that does not depend on the face it is seen from.
bool comes_first(const glm::dvec4& a, const glm::dvec4& b) {
    const std::array left{a.x, a.y, a.z, a.w}, right{b.x, b.y, b.z, b.w};
    return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end());
}

/// The cut on the side between corners `i` and `j`, whose distances have different signs.
ClipVertex cut(const ClipStage& stage, std::size_t i, std::size_t j) {
    const auto& ring = stage.ring;
    if (!comes_first(ring[i].position, ring[j].position)) std::swap(i, j);
    const double at_i = std::fabs(stage.distances[i]), at_j = std::fabs(stage.distances[j]);
    const double share_i = at_j / (at_i + at_j), share_j = at_i / (at_i + at_j);
    return {.position = ring[i].position * share_i + ring[j].position * share_j,
            .uv = ring[i].uv * share_i + ring[j].uv * share_j,
            .from = static_cast<int>(i),
            .to = static_cast<int>(j),
            .from_share = share_i,
            .to_share = share_j};
}

ClipVertex original(const ClipStage& stage, std::size_t i) {
    return {.position = stage.ring[i].position, .uv = stage.ring[i].uv, .from = static_cast<int>(i)};
}

}  // namespace

ClipStage clip(std::span<const ClipVertex> ring, const glm::dvec4& plane, double thickness) {
    ClipStage stage{.ring = {ring.begin(), ring.end()}, .plane = plane};
    bool any_inside = false, any_outside = false;
    for (const ClipVertex& vertex : ring) {
        double distance = glm::dot(plane, vertex.position);
        if (std::fabs(distance) <= thickness) distance = 0;
        any_inside = any_inside || distance > 0;
        any_outside = any_outside || distance < 0 || std::isnan(distance);
        stage.distances.push_back(distance);
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t j = (i + 1) % ring.size();
        const double at_i = stage.distances[i], at_j = stage.distances[j];
        if (at_i >= 0) stage.inside.push_back(original(stage, i));
        if (!(at_i > 0)) stage.outside.push_back(original(stage, i));
        if ((at_i > 0 && at_j < 0) || (at_i < 0 && at_j > 0)) {
            stage.inside.push_back(cut(stage, i, j));
            stage.outside.push_back(stage.inside.back());
        }
    }
    if (any_outside && !any_inside) stage.inside.clear();
    if (!any_outside) stage.outside.clear();
    return stage;
}

std::vector<ClipStage> clip(std::span<const ClipVertex> ring, std::span<const glm::dvec4> planes, double thickness) {
    std::vector<ClipStage> stages;
    for (const glm::dvec4& plane : planes) {
        stages.push_back(
            clip(stages.empty() ? ring : std::span<const ClipVertex>(stages.back().inside), plane, thickness));
        if (stages.back().inside.empty()) break;
    }
    return stages;
}

}  // namespace texelscope
