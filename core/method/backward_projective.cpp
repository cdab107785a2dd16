#include "core/method/backward_projective.h"

#include "core/method/backward_projective_quirks.h"
#include "core/method/run.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 2> kQuirks{{
    {"Q1", "wrong_slope", "b in place of d",
     "The numerator of v advances by b, which is u's step down, where it must advance by d."},
    {"reciprocal", "reciprocal", "one division", "One reciprocal and two products in place of two divisions.",
     QuirkKind::other},
}};
constexpr std::array<VariantInfo, 2> kVariants{{{"as-printed", 0b01}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<BackwardProjective, kBackwardProjectiveFields>({
    .id = "backward-projective",
    .title = "Backward in perspective",
    .source = "S5",
    .listing = "core/method/backward_projective.h",
    .triangles = false,
    .plane = true,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_backward_projective,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
