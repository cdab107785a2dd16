// The quirks of backward-affine by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/backward_affine.h"
#include "core/method/method.h"

namespace texelscope {

inline constexpr std::array kBackwardAffineFields{
    &BackwardAffineQuirks::add_first,
};

[[nodiscard]] Visit visit_backward_affine(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
