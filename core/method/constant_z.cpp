#include "core/method/constant_z.h"

#include "core/method/constant_z_quirks.h"
#include "core/method/run.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 1> kQuirks{{
    {"other_way", "other_way", "the wrong way",
     "Walls are walked in rows and floors in columns, along which the depth does change.", QuirkKind::other},
}};
constexpr std::array<VariantInfo, 2> kVariants{{{"as-printed", 0}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<ConstantZ, kConstantZFields>({
    .id = "constant-z",
    .title = "Floors and walls",
    .source = "S5",
    .listing = "core/method/constant_z.h",
    .triangles = false,
    .plane = true,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_constant_z,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
