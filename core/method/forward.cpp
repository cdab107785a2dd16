#include "core/method/forward.h"

#include "core/method/forward_quirks.h"
#include "core/method/run.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 0> kQuirks{};
constexpr std::array<VariantInfo, 2> kVariants{{{"as-printed", 0}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<Forward, kForwardFields>({
    .id = "forward",
    .title = "Forward: the texture drives",
    .source = "S5",
    .listing = "core/method/forward.h",
    .triangles = false,
    .plane = true,
    .scatters = true,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_forward,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
