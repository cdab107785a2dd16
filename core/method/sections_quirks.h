// The quirks of sections by number, shared by the method's two halves.
#pragma once

#include <array>

#include "core/method/method.h"
#include "core/method/sections.h"

namespace texelscope {

inline constexpr std::array kSectionsFields{
    &SectionsQuirks::ghost,
    &SectionsQuirks::end_texel,
    &SectionsQuirks::whole_pixels,
};

[[nodiscard]] Visit visit_sections(NumberFormat format, const Job& job, const Path& path);

}  // namespace texelscope
