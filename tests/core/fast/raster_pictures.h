// Pictures that the fast rasterizer draws, and what they must be: each pixel says which texel it was given.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/fast/raster.h"
#include "core/fast/raster_texels.h"
#include "core/measure/reference.h"
#include "tests/core/fast/draw_exactly.h"
#include "tests/core/method/cases.h"

namespace texelscope::raster_pictures {

/// Wider than float32 carries u and v in perspective.
inline constexpr int kWidth = 331, kHeight = 52, kPitch = 336;
inline constexpr std::uint32_t kClear = 0xFFFFFFFF;
/// All skips but that of what later triangles cover.
inline constexpr std::uint32_t kDrawAll = ~(1U << static_cast<unsigned>(RasterSkip::overdrawn));

/// Texels that are their own addresses, without an apron and with one.
struct Addresses {
    std::vector<std::uint32_t> texels;
    RasterTexture texture;
    RasterTexels with_apron;
    Addresses(int width, int height, Wrap wrap, int pitch = 0)
        : texels(static_cast<std::size_t>(std::max(width, pitch) * height)) {
        for (std::size_t n = 0; n < texels.size(); ++n) texels[n] = static_cast<std::uint32_t>(n);
        texture = {texels.data(), width, height, wrap, pitch};
        with_apron = RasterTexels(texture);
    }
};

struct Picture {
    std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(std::size_t{kPitch} * kHeight, kClear);
    std::vector<float> depth = std::vector<float>(std::size_t{kPitch} * kHeight, 1.0F);
    friend bool operator==(const Picture&, const Picture&) = default;
};

/// The target's top left.
struct Origin {
    int x = 0, y = 0;
};

inline RasterTarget target_of(Picture& picture, Origin origin) {
    return {picture.pixels.data(), kPitch, kWidth, kHeight, origin.x, origin.y, picture.depth.data()};
}

inline Picture drawn(const RasterTexture& texture, const RasterJob& job, RasterCounters& counters,
                     const RasterSettings& settings = {}, Origin origin = {}) {
    Picture picture;
    draw(target_of(picture, origin), texture, job, settings, counters);
    return picture;
}

inline Picture decided(const RasterTexture& texture, const RasterJob& job, Origin origin = {}) {
    Picture picture;
    draw_exactly(target_of(picture, origin), texture, job);
    return picture;
}

/// In u, v of whole textures; most of them on the screen.
inline std::vector<Vertex> random_triangle(laws::Dice& dice, int n) {
    auto corners =
        laws::random_corners(dice, static_cast<laws::Family>(n % laws::kFamilies), {0, 0, kWidth, kHeight}, 3);
    if (n % 5 == 0)  // ties: on centres, at whole texels
        for (Vertex& c : corners) {
            c.x = std::floor(c.x) + 0.5F, c.y = std::floor(c.y) + 0.5F;
            c.u = std::floor(c.u) / 8, c.v = std::floor(c.v) / 8, c.w = 1;
        }
    if (n % 9 == 0) {  // a side through centres, but for what float32 loses
        const int right = dice.whole(-20, 20), down = dice.whole(-20, 20);
        for (std::size_t k = 0; k < 2; ++k) {
            const float t = dice.within(-2, 2);
            corners[k].x = 30.5F + t * static_cast<float>(right), corners[k].y = 25.5F + t * static_cast<float>(down);
        }
    }
    if (n % 11 == 0)  // 1/w that is exactly 0 in a row below, beside or above
        for (Vertex& c : corners) {
            c.x = std::floor(2 * c.x) / 2, c.y = std::floor(2 * c.y) / 2;
            c.w = std::exp2(static_cast<float>(dice.whole(0, 6)));
        }
    if (n % 13 == 0) corners[0].x = dice.within(-1e-30, 1e-30), corners[1].y = dice.within(-1e-40, 1e-40);
    if (n % 17 == 0) corners[2].x *= 1e8F;
    if (n % 19 == 0) corners[1].w *= 1e6F;
    if (n % 23 == 0) corners[1].u *= 1e9F, corners[2].v *= 1e7F;
    return corners;
}

/// What textures may be.
inline const std::array<Addresses, 6>& textures() {
    static const std::array<Addresses, 6> all{{{64, 16, Wrap::repeat},
                                               {48, 80, Wrap::repeat, 50},
                                               {64, 16, Wrap::clamp},
                                               {37, 1, Wrap::clamp},
                                               {1, 128, Wrap::repeat},
                                               {256, 256, Wrap::mask, 272}}};
    return all;
}

inline RasterJob job_of(std::span<const Vertex> vertices, const RasterTexture& texture) {
    return {.vertices = vertices, .u_texels = texture.width, .v_texels = texture.height};
}

inline void expect_same(const Picture& is, const Picture& expected, const std::string& what) {
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto at = static_cast<std::size_t>(y * kPitch + x);
            ASSERT_EQ(is.pixels[at], expected.pixels[at]) << "at " << x << ", " << y << ": " << what;
            ASSERT_EQ(is.depth[at], expected.depth[at]) << "at " << x << ", " << y << ": " << what;
        }
    ASSERT_EQ(is, expected) << "beside the picture: " << what;
}

/// Each SIMD level must draw what is decided; with an apron, too.
inline void expect_exact(const Addresses& texels, const RasterJob& job, RasterCounters& counters,
                         const std::string& what, Origin origin = {}) {
    const Picture expected = decided(texels.texture, job, origin);
    for (const SimdLevelInfo& level : kSimdLevels) {
        if (!is_supported(level.level)) continue;
        const RasterSettings settings{.level = level.level};
        const std::string id(level.id);
        expect_same(drawn(texels.texture, job, counters, settings, origin), expected, id + ": " + what);
        if (testing::Test::HasFatalFailure()) return;
        expect_same(drawn(texels.with_apron.texture(), job, counters, settings, origin), expected,
                    id + " with an apron: " + what);
        if (testing::Test::HasFatalFailure()) return;
    }
}

/// Moves u and v of the first corner so that one sample comes within some 2^-15 of a texel to a border, in u and v: so
/// near that it is for the bounds of float32 to say that they cannot tell.
inline void bring_to_border(laws::Dice& dice, const RasterTexture& texture, std::array<Vertex, 3>& c) {
    const float first = dice.within(.05F, .3F), second = dice.within(0, 1 - first), third = 1 - first - second;
    const double x = std::floor(first * c[0].x + second * c[1].x + third * c[2].x) + .5,
                 y = std::floor(first * c[0].y + second * c[1].y + third * c[2].y) + .5;
    // How much each corner counts at the sample.
    const auto part = [&](const Vertex& a, const Vertex& b, float w) {
        return ((double{a.x} - x) * (double{b.y} - y) - (double{b.x} - x) * (double{a.y} - y)) / double{w};
    };
    const std::array<double, 3> parts{part(c[1], c[2], c[0].w), part(c[2], c[0], c[1].w), part(c[0], c[1], c[2].w)};
    const double sum = parts[0] + parts[1] + parts[2];
    if (!(parts[0] / sum > .02) || parts[1] / sum < 0 || parts[2] / sum < 0) return;  // the sample is outside
    const auto move = [&](float Vertex::*u, int texels) {
        const float turns = std::floor(c[0].*u);
        for (Vertex& corner : c) corner.*u -= turns;
        const double at = (parts[0] * c[0].*u + parts[1] * c[1].*u + parts[2] * c[2].*u) / sum * texels;
        const double to = std::round(at) + std::ldexp(double{dice.within(-1, 1)}, -dice.whole(15, 20));
        c[0].*u = static_cast<float>(double{c[0].*u} + (to - at) / texels * sum / parts[0]);
    };
    move(&Vertex::u, texture.width), move(&Vertex::v, texture.height);
}

}  // namespace texelscope::raster_pictures
