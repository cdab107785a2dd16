// The words of a lesson file, in the order of their enumerations.
#pragma once

#include <array>
#include <string_view>

#include "app/lesson/lesson.h"

namespace texelscope {

inline constexpr std::array<std::string_view, 6> kKindNames{"choice", "many", "number", "pixel", "texel", "line"};

/// The drawings in the list of lessons: one for each lesson of the curriculum, in its order.
inline constexpr std::array<std::string_view, 21> kIconNames{
    "array", "ratio", "forward", "two-passes", "half-planes", "owner",   "edges",
    "span",  "plane", "steps",   "weights",    "seam",        "inverse", "sections",
    "solid", "jelly", "race",    "mappers",    "accuracy",    "bounds",  "skips"};

[[nodiscard]] constexpr std::string_view name_of(Prediction::Kind kind) {
    return kKindNames[static_cast<std::size_t>(kind)];
}

}  // namespace texelscope
