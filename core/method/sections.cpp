#include "core/method/sections.h"

#include "core/method/run.h"
#include "core/method/sections_quirks.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 3> kQuirks{{
    {"Q1", "ghost", "ghost pixels",
     "Rows of one pixel are skipped yet counted, so a stale slot of the row buffer is drawn."},
    {"Q2", "end_texel", "end texel too early",
     "The last pixel gets the end texel (the divisor is n − 1) though the span excludes the end."},
    {"Q3", "whole_pixels", "whole-pixel corners",
     "Corners are truncated to whole pixels, rows sampled at their top and texels truncated: motion jitters."},
}};
constexpr std::array<VariantInfo, 2> kVariants{{{"as-printed", 0b111}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<Sections, kSectionsFields>({
    .id = "sections",
    .title = "Sections",
    .source = "S2",
    .listing = "core/method/sections.h",
    .triangles = false,
    .strays = 0b001,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_sections,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
