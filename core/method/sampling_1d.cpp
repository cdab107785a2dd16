#include "core/method/sampling_1d.h"

#include "core/method/run.h"
#include "core/method/sampling_1d_quirks.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 4> kQuirks{{
    {"Q1", "uneven_start", "two starts",
     "The list that shrinks starts at 0, the one that grows at one ratio; by the second rule the first would read past "
     "its end."},
    {"Q2", "rounded", "rounded ratio", "The ratio is rounded to two decimals: 8/14 is 0.57."},
    {"start_zero", "start_zero", "starts at 0", "The first pixel takes the texel at 0.", QuirkKind::other},
    {"start_ratio", "start_ratio", "starts at one ratio", "The first pixel takes the texel at one ratio.",
     QuirkKind::other},
}};
constexpr std::array<VariantInfo, 2> kVariants{{{"as-printed", 0b0011}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<Sampling1d, kSampling1dFields>({
    .id = "sampling-1d",
    .title = "Sampling in one dimension",
    .source = "S3",
    .listing = "core/method/sampling_1d.h",
    .triangles = false,
    .plane = true,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_sampling_1d,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
