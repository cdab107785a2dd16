// The words of a lesson file, in the order of their enumerations.
#pragma once

#include <array>
#include <string_view>

#include "app/lesson/lesson.h"

namespace texelscope {

inline constexpr std::array<std::string_view, 6> kKindNames{"choice", "many", "number", "pixel", "texel", "line"};

[[nodiscard]] constexpr std::string_view name_of(Prediction::Kind kind) {
    return kKindNames[static_cast<std::size_t>(kind)];
}

}  // namespace texelscope
