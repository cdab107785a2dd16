#include "core/method/edge_walk.h"

#include "core/method/edge_walk_quirks.h"
#include "core/method/run.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 5> kQuirks{{
    {"Q1", "inclusive", "last row and pixel, too",
     "Rows y ≤ y₁ and columns x ≤ x_end are drawn, so neighbours overlap: the middle row is drawn twice."},
    {"Q2", "wrong_sign", "du has the wrong sign", "du is (u_l − u_r)/dx: each row runs backwards through the texture."},
    {"Q3", "exchanged", "u and v exchanged", "The texture is indexed [u][v]: row and column change places."},
    {"Q4", "apex", "0/0 at the apex",
     "Where both sides meet, dx is 0 and du has no value: that pixel gets texel (0, 0)."},
    {"Q5", "whole_start", "whole rows and pixels",
     "Each half starts at the whole row and pixel, with the corner's own u and v: the texture jumps in motion."},
}};
constexpr std::array<VariantInfo, 2> kVariants{{{"as-printed", 0b11111}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<EdgeWalk, kEdgeWalkFields>({
    .id = "edge-walk",
    .title = "Walking the edges",
    .source = "S3",
    .listing = "core/method/edge_walk.h",
    .triangles = true,
    .strays = 0b10001,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_edge_walk,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
