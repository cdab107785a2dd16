#include "app/views/canvas_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace texelscope::canvas {
namespace {

constexpr std::array<float, 16> kTurns{0, 22, -22, 45, -45, 67, -67, 90, -90, 112, -112, 135, -135, 157, -157, 180};
constexpr std::array<float, 4> kFurther{0, 12, 28, 52};  ///< [px]

[[nodiscard]] glm::vec2 turned(glm::vec2 v, float degrees) {
    const float a = degrees * std::numbers::pi_v<float> / 180;
    return {v.x * std::cos(a) - v.y * std::sin(a), v.x * std::sin(a) + v.y * std::cos(a)};
}

}  // namespace

bool LabelPlaces::is_free(const ui::Area& area) const {
    return bounds_.covers(area) && std::none_of(taken_.begin(), taken_.end(), [&](const ui::Area& other) {
               return !ui::intersection(area, other).empty();
           });
}

std::optional<ui::Area> LabelPlaces::place(glm::vec2 anchor, glm::vec2 size, glm::vec2 away, float gap,
                                           const std::function<bool(const ui::Area&)>& suits) {
    const float length = glm::length(away);
    const glm::vec2 way = length > 0 ? away / length : glm::vec2(0, -1);
    for (const float further : kFurther) {
        for (const float turn : kTurns) {
            const glm::vec2 to = turned(way, turn);
            // The side of the plate that faces the anchor keeps the distance, not its middle.
            const glm::vec2 centre = anchor + to * (gap + further) + to * size / 2.0F;
            const ui::Area area{std::round(centre.x - size.x / 2), std::round(centre.y - size.y / 2), size.x, size.y};
            if (!is_free(area) || (suits && !suits(area))) continue;
            block(area);
            return area;
        }
    }
    return std::nullopt;
}

}  // namespace texelscope::canvas
