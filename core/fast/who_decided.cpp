#include "core/fast/who_decided.h"

#include <array>
#include <optional>
#include <vector>

#include "core/exact/triangle.h"
#include "core/fast/watch.h"

namespace texelscope {
namespace {

constexpr int kGap = 16;  ///< behind a row [px]

[[nodiscard]] Decision decision_of(std::uint8_t by) {
    switch (static_cast<DecidedBy>(by)) {
        case DecidedBy::certificate: return Decision::certificate;
        case DecidedBy::in_double: return Decision::in_double;
        case DecidedBy::wide: return Decision::wide;
        case DecidedBy::exact: return Decision::exact;
    }
    return Decision::none;
}

/// Whether u or v is a whole number at a sample: then, and only then, floor(-u) = -floor(u).
class Ties {
public:
    explicit Ties(std::span<const Vertex, 3> corners) : corners_(corners), negated_(negated(corners)) {}
    [[nodiscard]] bool at(Integer x, Integer y) const {
        const TexelIndex a = corners_.texel(x, y), b = negated_.texel(x, y);
        return a.u == -b.u || a.v == -b.v;
    }

private:
    [[nodiscard]] static ExactTriangle negated(std::span<const Vertex, 3> corners) {
        std::array<Vertex, 3> turned{corners[0], corners[1], corners[2]};
        for (Vertex& corner : turned) corner.u = -corner.u, corner.v = -corner.v;
        return ExactTriangle(turned);
    }
    ExactTriangle corners_, negated_;
};

}  // namespace

Decisions who_decided(std::span<const Vertex, 3> corners, const RasterTexture& texture, const Rect& frame) {
    const int width = frame.width(), height = frame.height(), pitch = width + kGap;
    const auto size = static_cast<std::size_t>(pitch) * static_cast<std::size_t>(height);
    std::vector<std::uint32_t> pixels(size);
    std::vector<std::uint8_t> deciders(size);
    const std::vector<std::uint32_t> texels(
        static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height), 1);
    RasterTexture marked = texture;
    marked.texels = texels.data(), marked.pitch = 0;
    RasterWatch watch{.deciders = deciders.data()};
    const RasterTarget target{
        .pixels = pixels.data(), .pitch = pitch, .width = width, .height = height, .x0 = frame.x0, .y0 = frame.y0};
    RasterCounters counters;
    draw(target, marked, {.vertices = corners, .perspective = true}, {.watch = &watch}, counters);

    Decisions found{.frame = frame, .pixels = Grid<Decision>(width, height)};
    const bool flat = corners[0].w == corners[1].w && corners[0].w == corners[2].w;
    if (counters.drawn > 0 && counters.slow == 0 && flat) found.u_bound = watch.u_doubt, found.v_bound = watch.v_doubt;
    found.slow = counters.slow > 0;
    std::optional<Ties> ties;
    if (watch.by_gap) ties.emplace(corners);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(pitch) + static_cast<std::size_t>(x);
            if (pixels[at] == 0) continue;
            Decision decision = decision_of(deciders[at]);
            if (decision == Decision::certificate && ties && ties->at(x + frame.x0, y + frame.y0))
                decision = Decision::tie;
            found.pixels.at(x, y) = decision;
            ++found.count[static_cast<std::size_t>(decision)];
        }
    return found;
}

}  // namespace texelscope
