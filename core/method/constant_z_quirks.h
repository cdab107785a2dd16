// The quirks of constant-z by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/constant_z.h"
#include "core/method/method.h"

namespace texelscope {

inline constexpr std::array kConstantZFields{
    &ConstantZQuirks::other_way,
};

[[nodiscard]] Visit visit_constant_z(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
