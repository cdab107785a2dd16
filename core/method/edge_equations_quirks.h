// The quirks of edge-equations by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/edge_equations.h"
#include "core/method/method.h"

namespace texelscope {

inline constexpr std::array kEdgeEquationsFields{
    &EdgeEquationsQuirks::inclusive, &EdgeEquationsQuirks::one_winding, &EdgeEquationsQuirks::truncate,
    &EdgeEquationsQuirks::trunc_box, &EdgeEquationsQuirks::wrap_light,  &EdgeEquationsQuirks::corners,
    &EdgeEquationsQuirks::arrays,    &EdgeEquationsQuirks::exclusive,   &EdgeEquationsQuirks::float_pixels,
    &EdgeEquationsQuirks::based,     &EdgeEquationsQuirks::additions,
};

[[nodiscard]] Visit visit_edge_equations(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
