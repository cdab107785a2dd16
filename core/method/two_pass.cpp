#include "core/method/two_pass.h"

#include "core/method/run.h"
#include "core/method/two_pass_quirks.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 1> kQuirks{{
    {"Q1", "forward", "each pass writes forward",
     "Both passes are driven by what they read, so whatever they magnify is left with holes."},
}};
constexpr std::array<VariantInfo, 2> kVariants{{{"as-printed", 0b1}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<TwoPass, kTwoPassFields>({
    .id = "two-pass",
    .title = "Two passes",
    .source = "S5",
    .listing = "core/method/two_pass.h",
    .triangles = false,
    .plane = true,
    .strays = 0b1,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_two_pass,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
