#include "core/measure/reference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include "core/geometry/polygon.h"

namespace texelscope {
namespace {

constexpr int kTexelBits = 30;  ///< of the scale that the exact triangle takes as an int

/// So many bits behind the point that the largest coordinate keeps below 2^61.
[[nodiscard]] int bits_for(std::span<const Vertex, 3> corners, float Vertex::*a) {
    float most = 0;
    for (const Vertex& v : corners) most = std::max(most, std::abs(v.*a));
    return most == 0 ? 0 : std::max(0, 60 - std::ilogb(most));
}
[[nodiscard]] std::array<Vertex, 3> scaled(std::span<const Vertex, 3> corners, const std::array<int, 2>& bits) {
    std::array<Vertex, 3> all{corners[0], corners[1], corners[2]};
    for (Vertex& v : all) {
        v.u = std::ldexp(v.u, bits[0] - std::min(bits[0], kTexelBits));
        v.v = std::ldexp(v.v, bits[1] - std::min(bits[1], kTexelBits));
    }
    return all;
}
[[nodiscard]] ExactTriangle in_units(std::span<const Vertex, 3> corners, const std::array<int, 2>& bits) {
    const std::array<Vertex, 3> all = scaled(corners, bits);
    return ExactTriangle(all, 1 << std::min(bits[0], kTexelBits), 1 << std::min(bits[1], kTexelBits));
}

}  // namespace

std::vector<DecidedSample> decided_samples(std::span<const Vertex, 3> corners, const Rect& frame) {
    std::vector<DecidedSample> samples;
    if (!std::all_of(corners.begin(), corners.end(), [](const Vertex& v) { return is_drawable(v); })) return samples;
    const ExactTriangle triangle(corners);
    if (triangle.winding() == 0) return samples;
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const auto within = [&](double y) { return static_cast<int>(std::clamp<double>(y, frame.y0, frame.y1)); };
    for (int y = within(std::floor(low)); y < within(std::floor(high) + 1); ++y) {
        const PixelRange row = triangle.row(y, frame.x0, frame.x1);
        for (Integer x = row.x0; x < row.x1; ++x) samples.push_back({x, y, triangle.texel(x, y)});
    }
    return samples;
}

ExactCoordinates::ExactCoordinates(std::span<const Vertex, 3> corners)
    : bits_{bits_for(corners, &Vertex::u), bits_for(corners, &Vertex::v)}, triangle_(in_units(corners, bits_)) {}

std::array<double, 2> ExactCoordinates::distance(const TexelIndex& at, double u, double v) const {
    // From the unit's middle, less half of it: within the unit nobody knows.
    const auto off = [](Integer n, int bits, double a) {
        if (!std::isfinite(a)) return std::numeric_limits<double>::infinity();
        const long double middle = std::ldexp(static_cast<long double>(n) + .5L, -bits);
        const long double half = std::ldexp(.5L, -bits);
        return static_cast<double>(std::max(0.0L, std::abs(middle - static_cast<long double>(a)) - half));
    };
    return {off(at.u, bits_[0], u), off(at.v, bits_[1], v)};
}

std::string text_of(std::span<const Vertex> corners) {
    std::string text;
    for (const Vertex& c : corners) {
        if (!text.empty()) text += ", ";
        std::array<char, 200> corner{};
        std::snprintf(corner.data(), corner.size(), "{.x = %aF, .y = %aF, .w = %aF, .u = %aF, .v = %aF}", double{c.x},
                      double{c.y}, double{c.w}, double{c.u}, double{c.v});
        text += corner.data();
    }
    return text;
}

}  // namespace texelscope
