// The quirks of forward by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/forward.h"
#include "core/method/method.h"

namespace texelscope {

inline constexpr std::array<bool ForwardQuirks::*, 0> kForwardFields{};

[[nodiscard]] Visit visit_forward(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
