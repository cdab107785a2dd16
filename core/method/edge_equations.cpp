#include "core/method/edge_equations.h"

#include "core/method/edge_equations_quirks.h"
#include "core/method/run.h"

namespace texelscope {
namespace {

constexpr std::array<QuirkInfo, 11> kQuirks{{
    {"Q1", "inclusive", "both own the side",
     "A sample is taken where E ≤ 0, so both triangles draw the samples of a shared side."},
    {"Q2", "one_winding", "one winding only",
     "Inside is E ≤ 0 whatever the winding: the other winding is culled unsaid."},
    {"Q3", "truncate", "truncated texels",
     "The texel is trunc(u) & (size − 1): truncation makes texel 0 two wide across u = 0."},
    {"Q4", "trunc_box", "truncated box",
     "The bounding box truncates toward zero, so left of 0 and above it starts one pixel late."},
    {"Q5", "wrap_light", "light wraps", "A light above 1 is stored modulo 256, so that bright texels turn dark."},
    {"Q6", "corners", "samples at corners", "Pixel (i, j) is sampled at its corner (i, j), not at its centre."},
    {"arrays", "arrays", "array passes",
     "Four passes over arrays, as the source has them, in place of one loop over pixels.", QuirkKind::form},
    {"exclusive", "exclusive", "nobody owns the side",
     "A sample is taken where E < 0, so the samples of a shared side belong to neither triangle.", QuirkKind::other},
    {"float32", "float_pixels", "pixels in float32",
     "As published: the set-up is double, all that is done for each pixel float32, as the arrays hold it.",
     QuirkKind::other},
    {"based", "based", "counted from a corner",
     "u and v are counted from corner 0, not from the screen's origin: large numbers no longer cancel.",
     QuirkKind::other},
    {"additions", "additions", "two additions a pixel",
     "Only a row's first sample is multiplied out; then u grows by u_x and v by v_x, and errors add up.",
     QuirkKind::other},
}};
constexpr std::array<VariantInfo, 3> kVariants{
    {{"as-printed", 0b0111111}, {"as-published", 0b100011111}, {"corrected", 0}}};

constexpr Method kMethod = run::with_functions<EdgeEquations, kEdgeEquationsFields>({
    .id = "edge-equations",
    .title = "Edge equations",
    .source = "S1",
    .listing = "core/method/edge_equations.h",
    .triangles = true,
    .quirks = kQuirks,
    .variants = kVariants,
    .visit = visit_edge_equations,
});
const RegisterMethod kRegistered(kMethod);

}  // namespace
}  // namespace texelscope
