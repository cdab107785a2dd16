// The quirks of subdivided by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/method.h"
#include "core/method/subdivided.h"

namespace texelscope {

inline constexpr std::array kSubdividedFields{
    &SubdividedQuirks::every_8,
    &SubdividedQuirks::every_32,
    &SubdividedQuirks::adaptive,
};

[[nodiscard]] Visit visit_subdivided(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
