// The quirks of two-pass by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/method.h"
#include "core/method/two_pass.h"

namespace texelscope {

inline constexpr std::array kTwoPassFields{
    &TwoPassQuirks::forward,
};

[[nodiscard]] Visit visit_two_pass(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
