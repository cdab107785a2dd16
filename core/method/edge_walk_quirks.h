// The quirks of edge-walk by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/edge_walk.h"
#include "core/method/method.h"

namespace texelscope {

inline constexpr std::array kEdgeWalkFields{
    &EdgeWalkQuirks::inclusive, &EdgeWalkQuirks::wrong_sign,  &EdgeWalkQuirks::exchanged,
    &EdgeWalkQuirks::apex,      &EdgeWalkQuirks::whole_start,
};

[[nodiscard]] Visit visit_edge_walk(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
