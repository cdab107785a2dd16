#include "core/measure/stress_methods.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/measure/bounded.h"
#include "core/method/backward_affine.h"
#include "core/method/backward_projective.h"
#include "core/method/barycentric.h"
#include "core/method/constant_z.h"
#include "core/method/edge_equations.h"
#include "core/method/edge_walk.h"
#include "core/method/run.h"
#include "core/method/sections.h"
#include "core/method/shortcut.h"
#include "core/method/subdivided.h"

namespace texelscope {
namespace {

constexpr std::string_view kAffine = "it is affine";
constexpr std::array<StressedMethod, 13> kStressed{{
    {"backward-affine", true, false, kAffine},
    {"backward-projective", true, true, ""},
    {"barycentric", true, true, ""},
    {"constant-z", true, false, "it takes one w for a whole row or column"},
    {"edge-equations", true, false, kAffine},
    {"edge-walk", true, false, kAffine},
    {"exact", true, true, ""},
    {"fast", true, true, ""},
    {"forward", false, false, "it goes by texels and leaves holes"},
    {"sampling-1d", false, false, "it only scales"},
    {"sections", true, false, kAffine},
    {"subdivided", true, false, "it is affine between every 16th sample"},
    {"two-pass", false, false, "it reads the texture twice, by whole texels"},
}};

using Bounds = std::vector<DrawnSample>;

template <template <class, class> class M, class T>
[[nodiscard]] Bounds bounds_in(const Job& job) {
    Bounds all;
    const M<Bounded<T>, NoTrace> method{job.frame, *job.texture, 1, job.cull_back, {}, job.mode, {}};
    (void)method.draw(job.corners, [&](Integer x, Integer y, const auto& pixel) {
        if (pixel.fate != Fate::written) return;
        all.push_back({.x = x,
                       .y = y,
                       .u = approximate(pixel.u),
                       .v = approximate(pixel.v),
                       .u_bound = pixel.u.error(),
                       .v_bound = pixel.v.error()});
    });
    return all;
}
template <template <class, class> class M>
[[nodiscard]] Bounds bounds_of(NumberFormat format, const Job& job) {
    return run::with_type(format, [&](auto type) {
        using T = decltype(type);
        if constexpr (std::same_as<T, Exact>)
            return Bounds{};
        else
            return bounds_in<M, T>(job);
    });
}

struct Bounder {
    std::string_view id;
    Bounds (*bounds)(NumberFormat, const Job&);
};
constexpr std::array<Bounder, 8> kBounders{{
    {"backward-affine", bounds_of<BackwardAffine>},
    {"backward-projective", bounds_of<BackwardProjective>},
    {"barycentric", bounds_of<Barycentric>},
    {"constant-z", bounds_of<ConstantZ>},
    {"edge-equations", bounds_of<EdgeEquations>},
    {"edge-walk", bounds_of<EdgeWalk>},
    {"sections", bounds_of<Sections>},
    {"subdivided", bounds_of<Subdivided>},
}};

[[nodiscard]] bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Exact numbers are printed as doubles, which rounds them once.
void bound_rounding(std::vector<DrawnSample>& samples) {
    for (DrawnSample& s : samples) s.u_bound = std::abs(s.u) * 0x1p-53, s.v_bound = std::abs(s.v) * 0x1p-53;
}

}  // namespace

std::span<const StressedMethod> stressed_methods() { return kStressed; }

std::vector<DrawnSample> drawn_samples(const Method& method, NumberFormat format, const Job& job) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::vector<DrawnSample> samples;
    (void)method.samples(format, job, {job.frame, 1}, [&](const Sample& s) {
        if (s.fate == Fate::written)
            samples.push_back({.x = s.x,
                               .y = s.y,
                               .u = s.u,
                               .v = s.v,
                               .column = s.column,
                               .row = s.row,
                               .u_bound = kNone,
                               .v_bound = kNone});
    });
    if (job.quirks != 0) return samples;
    if (format == NumberFormat::exact || shortcut_of(method) != nullptr) return bound_rounding(samples), samples;
    for (const Bounder& bounder : kBounders) {
        if (bounder.id != method.id) continue;
        const Bounds bounds = bounder.bounds(format, job);
        for (std::size_t n = 0; n < samples.size() && n < bounds.size(); ++n) {
            // Another sample, or other digits: then the bound speaks of another computation, and is broken.
            const bool met = bounds[n].x == samples[n].x && bounds[n].y == samples[n].y &&
                             same(bounds[n].u, samples[n].u) && same(bounds[n].v, samples[n].v);
            samples[n].u_bound = met ? bounds[n].u_bound : 0, samples[n].v_bound = met ? bounds[n].v_bound : 0;
        }
    }
    return samples;
}

}  // namespace texelscope
