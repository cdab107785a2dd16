#include "core/method/backward_affine.h"

#include "core/method/backward_affine_quirks.h"
#include "core/method/run.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 1> kQuirks{{
    {"Q1", "add_first", "adds before it samples",
     "The loop adds a and d before it reads the texel: the whole row is one pixel off."},
}};
constexpr std::array<VariantInfo, 2> kVariants{{{"as-printed", 0b1}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<BackwardAffine, kBackwardAffineFields>({
    .id = "backward-affine",
    .title = "Backward: two additions",
    .source = "S5",
    .listing = "core/method/backward_affine.h",
    .triangles = false,
    .plane = true,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_backward_affine,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
