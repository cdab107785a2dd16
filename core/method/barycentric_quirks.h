// The quirks of barycentric by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/barycentric.h"
#include "core/method/method.h"

namespace texelscope {

inline constexpr std::array kBarycentricFields{
    &BarycentricQuirks::inclusive, &BarycentricQuirks::corners, &BarycentricQuirks::truncate,
    &BarycentricQuirks::edges,     &BarycentricQuirks::affine,
};

[[nodiscard]] Visit visit_barycentric(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
