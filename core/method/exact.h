// Pictures of triangles as the exact triangle decides them, and the method whose steps they are: barycentric weights in
// exact numbers. For the methods `exact` and `fast`, which draw otherwise than they are shown.
#pragma once

#include <array>
#include <cstdint>

#include "core/exact/triangle.h"
#include "core/method/method.h"

namespace texelscope {

/// The sign of the doubled area, exactly; 0 for corners in line. Requires finite corners.
[[nodiscard]] int winding_of(std::span<const Vertex, 3> corners);
/// What becomes of a triangle before its first sample: as the definition has it.
[[nodiscard]] Fate exact_fate(const Job& job);
/// The part of the frame that its samples lie in: [floor(least), floor(greatest) + 1) each way.
[[nodiscard]] Rect exact_box(const Job& job);
/// What a light makes of each value of a channel, exactly: the product has 32 bits.
[[nodiscard]] std::array<std::uint8_t, 256> exactly_lit(const Job& job);

/// A written sample as Layer::put wants it.
struct Painted {
    Rgb texel;
    Fate fate = Fate::written;
};

[[nodiscard]] Fate render_exactly(const Job& job, Image& picture);
[[nodiscard]] Fate paint_exactly(const Job& job, const Window& part, int shape, Layer& layer);

/// As the functions of Method: the steps of the definition, whatever number format is asked for.
Fate samples_by_definition(NumberFormat format, const Job& job, const Window& window, const Put& put);
LineCounts until_by_definition(NumberFormat format, const Job& job, const Window& window, const Path& target,
                               const Put& put);
Visit visit_by_definition(NumberFormat format, const Job& job, const Path& path);

inline constexpr std::string_view kDefinition = "barycentric", kDefinitionListing = "core/method/barycentric.h";
inline constexpr std::array<VariantInfo, 1> kOnlyCorrected{{{"corrected", 0}}};

/// The method, which has its name and how it draws, filled in with what it shows.
[[nodiscard]] constexpr Method shown_by_definition(Method method) {
    method.source = "S4", method.listing = kDefinitionListing, method.variants = kOnlyCorrected;
    method.samples = samples_by_definition, method.until = until_by_definition, method.visit = visit_by_definition;
    return method;
}

}  // namespace texelscope
