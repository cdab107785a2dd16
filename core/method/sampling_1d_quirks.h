// The quirks of sampling-1d by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/method.h"
#include "core/method/sampling_1d.h"

namespace texelscope {

inline constexpr std::array kSampling1dFields{
    &Sampling1dQuirks::uneven_start,
    &Sampling1dQuirks::rounded,
    &Sampling1dQuirks::start_zero,
    &Sampling1dQuirks::start_ratio,
};

[[nodiscard]] Visit visit_sampling_1d(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
