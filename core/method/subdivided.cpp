#include "core/method/subdivided.h"

#include "core/method/run.h"
#include "core/method/subdivided_quirks.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 3> kQuirks{{
    {"every_8", "every_8", "every 8 pixels", "A division every 8 pixels.", QuirkKind::other},
    {"every_32", "every_32", "every 32 pixels", "A division every 32 pixels.", QuirkKind::other},
    {"adaptive", "adaptive", "as often as needed", "The longest spans whose error stays within 1/16 texel.",
     QuirkKind::other},
}};
constexpr std::array<VariantInfo, 1> kVariants{{{"corrected", 0}}};

constexpr Method kMethod = run::with_functions<Subdivided, kSubdividedFields>({
    .id = "subdivided",
    .title = "Perspective every n pixels",
    .source = "Quake",
    .listing = "core/method/subdivided.h",
    .triangles = false,
    .plane = true,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_subdivided,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
