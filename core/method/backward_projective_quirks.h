// The quirks of backward-projective by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/backward_projective.h"
#include "core/method/method.h"

namespace texelscope {

inline constexpr std::array kBackwardProjectiveFields{
    &BackwardProjectiveQuirks::wrong_slope,
    &BackwardProjectiveQuirks::reciprocal,
};

[[nodiscard]] Visit visit_backward_projective(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
