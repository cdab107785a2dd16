#include "core/method/barycentric.h"

#include "core/method/barycentric_quirks.h"
#include "core/method/run.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 5> kQuirks{{
    {"Q1", "inclusive", "both own the side",
     "A sample is drawn where all weights lie in [0, 1], so both triangles draw the samples of a shared side."},
    {"Q2", "corners", "samples at corners", "Pixel (i, j) is sampled at its corner (i, j), not at its centre."},
    {"Q3", "truncate", "truncated texels",
     "The texel is trunc(u) & (size − 1): truncation makes texel 0 two wide across u = 0."},
    {"edges", "edges", "sides tinted",
     "Where a weight is below 0.05 the colour is averaged with green, or with red in every second triangle."},
    {"affine", "affine", "without perspective",
     "Every w is taken as 1: the weights of the corners interpolate u and v themselves.", QuirkKind::other},
}};
constexpr std::array<VariantInfo, 2> kVariants{{{"as-printed", 0b01111}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<Barycentric, kBarycentricFields>({
    .id = "barycentric",
    .title = "Barycentric weights",
    .source = "S4",
    .listing = "core/method/barycentric.h",
    .triangles = true,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_barycentric,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
