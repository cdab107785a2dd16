// The fast rasterizer against the exact triangle, pixel for pixel: each pixel says which texel it was given.
#include "core/fast/raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/fast/raster_texels.h"
#include "core/measure/reference.h"
#include "tests/core/fast/draw_exactly.h"
#include "tests/core/method/cases.h"

namespace texelscope::raster_equals_exact_test {
namespace {

/// Wider than float32 carries u and v in perspective.
constexpr int kWidth = 331, kHeight = 52, kPitch = 336;
constexpr std::uint32_t kClear = 0xFFFFFFFF;

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

RasterTarget target_of(Picture& picture, Origin origin) {
    return {picture.pixels.data(), kPitch, kWidth, kHeight, origin.x, origin.y, picture.depth.data()};
}

Picture drawn(const RasterTexture& texture, const RasterJob& job, RasterCounters& counters,
              const RasterSettings& settings = {}, Origin origin = {}) {
    Picture picture;
    draw(target_of(picture, origin), texture, job, settings, counters);
    return picture;
}

Picture decided(const RasterTexture& texture, const RasterJob& job, Origin origin = {}) {
    Picture picture;
    draw_exactly(target_of(picture, origin), texture, job);
    return picture;
}

/// In u, v of whole textures; most of them on the screen.
std::vector<Vertex> random_triangle(laws::Dice& dice, int n) {
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
const std::array<Addresses, 6>& textures() {
    static const std::array<Addresses, 6> all{{{64, 16, Wrap::repeat},
                                               {48, 80, Wrap::repeat, 50},
                                               {64, 16, Wrap::clamp},
                                               {37, 1, Wrap::clamp},
                                               {1, 128, Wrap::repeat},
                                               {256, 256, Wrap::mask, 272}}};
    return all;
}

RasterJob job_of(std::span<const Vertex> vertices, const RasterTexture& texture) {
    return {.vertices = vertices, .u_texels = texture.width, .v_texels = texture.height};
}

void expect_same(const Picture& is, const Picture& expected, const std::string& what) {
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto at = static_cast<std::size_t>(y * kPitch + x);
            ASSERT_EQ(is.pixels[at], expected.pixels[at]) << "at " << x << ", " << y << ": " << what;
            ASSERT_EQ(is.depth[at], expected.depth[at]) << "at " << x << ", " << y << ": " << what;
        }
    ASSERT_EQ(is, expected) << "beside the picture: " << what;
}

/// Each SIMD level must draw what is decided; with an apron, too.
void expect_exact(const Addresses& texels, const RasterJob& job, RasterCounters& counters, const std::string& what,
                  Origin origin = {}) {
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

TEST(RasterEqualsExact, InEveryPixelOfRandomTriangles) {
    laws::Dice dice(1);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (int n = 0; n < 2400; ++n) {
        const auto corners = random_triangle(dice, n);
        RasterJob job = job_of(corners, texels.texture);
        job.perspective = n % 2 == 0, job.cull_back = n % 7 == 0;
        expect_exact(texels, job, counters, std::to_string(n) + ": " + text_of(corners));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.samples, 1000000U);
    EXPECT_GT(counters.crossings, 0U);
    EXPECT_GT(counters.in_double, 0U);
    EXPECT_GT(counters.in_whole, 0U);
}

/// A triangle as blocks are for: its texture laid over the screen, turned, about `density` texels a pixel. Ties:
/// samples on borders of texels, or as near as float32 rounds thirds, and on sides.
std::array<Vertex, 3> laid_triangle(laws::Dice& dice, const RasterTexture& texture, float density, bool ties) {
    const float angle = dice.within(0, 6.3F);
    float along = density * std::cos(angle), across = density * std::sin(angle);
    const float part = dice.often(.7) ? 4 : 3;
    if (ties)
        along = static_cast<float>(dice.whole(-8, 8)) / part, across = static_cast<float>(dice.whole(-4, 4)) / part;
    const float middle_x = dice.within(-20, kWidth + 20), middle_y = dice.within(-10, kHeight + 10);
    const float size = dice.often(.5) ? 20 : 200, from = dice.often(.5) ? 3000 : 0;
    std::array<Vertex, 3> corners{};
    for (Vertex& c : corners) {
        c = {middle_x + dice.within(-size, size), middle_y + dice.within(-size, size), 0, 1};
        if (ties) c.x = std::floor(2 * c.x) / 2, c.y = std::floor(2 * c.y) / 2;
        c.u = (along * c.x - across * c.y + from) / static_cast<float>(texture.width);
        c.v = (across * c.x + along * c.y - from) / static_cast<float>(texture.height);
    }
    return corners;
}

/// Moves u and v of the first corner so that one sample comes within some 2^-15 of a texel to a border, in u and v: so
/// near that it is for the bounds of float32 to say that they cannot tell.
void bring_to_border(laws::Dice& dice, const RasterTexture& texture, std::array<Vertex, 3>& c) {
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

/// Textures that repeat, small ones within a triangle and large ones.
const std::array<Addresses, 5>& repeating_textures() {
    static const std::array<Addresses, 5> all{{{256, 256, Wrap::repeat},
                                               {16, 16, Wrap::mask},
                                               {64, 16, Wrap::repeat},
                                               {16, 512, Wrap::mask},
                                               {8, 8, Wrap::repeat}}};
    return all;
}

/// Scenes of such triangles, which `made` makes for a texture.
void expect_exact_by_blocks(unsigned seed, bool perspective,
                            const std::function<std::array<Vertex, 3>(laws::Dice&, const RasterTexture&)>& made) {
    laws::Dice dice(seed);
    RasterCounters counters;
    for (int n = 0; n < 1500; ++n) {
        const Addresses& texels = repeating_textures()[static_cast<std::size_t>(n % 5)];
        std::vector<Vertex> vertices;
        for (int k = dice.whole(1, 10); k-- > 0;) {
            const auto corners = made(dice, texels.texture);
            vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
        RasterJob job = job_of(vertices, texels.texture);
        job.perspective = perspective, job.cull_back = n % 7 == 0;
        expect_exact(texels, job, counters, std::to_string(n));
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_TRUE(!is_supported(SimdLevel::avx512) || counters.by_blocks > 2000U) << counters.by_blocks;
    EXPECT_GT(counters.in_double, 1000U);
}

/// From magnified to somewhat more than a texel a pixel.
TEST(RasterEqualsExact, ByBlocks) {
    expect_exact_by_blocks(11, false, [](laws::Dice& dice, const RasterTexture& texture) {
        const float density = dice.within(.05F, 1.9F);
        return laid_triangle(dice, texture, density, dice.often(.3));
    });
}

/// Some blocks' texels lie within a patch, others not, and others are too far apart or too steep for float32; w is
/// equal at two or three corners, too.
TEST(RasterEqualsExact, ByBlocksInPerspective) {
    expect_exact_by_blocks(12, true, [](laws::Dice& dice, const RasterTexture& texture) {
        const bool ties = dice.often(.3);
        const float density = dice.often(.8) ? dice.within(.05F, 1.9F) : dice.within(1, 8),
                    steep = dice.often(.7) ? 4 : std::exp2(dice.within(2, 10));
        auto corners = laid_triangle(dice, texture, density, ties);
        for (Vertex& c : corners) c.w = ties ? static_cast<float>(1 << dice.whole(0, 2)) : dice.within(1, steep);
        if (dice.often(.2)) corners[1].w = corners[0].w, corners[1].y = corners[0].y;
        if (ties && dice.often(.3))
            for (Vertex& c : corners) c.u *= 4, c.v *= 4;
        if (!ties && dice.often(.7)) bring_to_border(dice, texture, corners);
        return corners;
    });
}

TEST(RasterEqualsExact, WithTexturesOfAnySizeAndWrap) {
    laws::Dice dice(2);
    RasterCounters counters;
    for (int n = 0; n < 3000; ++n) {
        const auto corners = random_triangle(dice, n);
        const Addresses& texels = textures()[static_cast<std::size_t>(dice.whole(1, 5))];
        RasterJob job = job_of(corners, texels.texture);
        job.perspective = n % 2 == 0;
        if (n % 3 == 0) job.u_texels = job.v_texels = dice.whole(1, 40);
        expect_exact(texels, job, counters, std::to_string(n) + ": " + text_of(corners));
        if (HasFatalFailure()) return;
    }
}

TEST(RasterEqualsExact, WithDepthAndLight) {
    laws::Dice dice(3);
    ChannelTable light{};
    for (std::uint32_t n = 0; n < light.size(); ++n) light[n] = n * 7 / 10;
    RasterCounters counters;
    for (int n = 0; n < 600; ++n) {
        std::vector<Vertex> vertices;
        for (int k = dice.whole(1, 12); k-- > 0;) {
            auto corners = random_triangle(dice, dice.whole(0, 1000));
            if (dice.often(.3))  // level, and equal to others
                for (Vertex& c : corners) c.z = .5F;
            if (dice.often(.3))  // near halves between floats
                for (Vertex& c : corners) c.z = .5F + static_cast<float>(dice.whole(0, 7)) * 0x1p-24F;
            vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
        const Addresses& texels = textures()[static_cast<std::size_t>(n % 6)];
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = n % 4 != 0, job.perspective = n % 2 == 0, job.cull_back = n % 5 == 0;
        if (n % 3 == 0) job.light = &light;
        expect_exact(texels, job, counters, std::to_string(n));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.of(RasterSkip::hidden), 0U);
}

/// Up to 8 px wide, near (x, y).
std::array<Vertex, 3> small_triangle(laws::Dice& dice, int n, float x, float y) {
    const float size = dice.often(.3) ? 4 : 7.9F;
    x += dice.within(-5, 5), y += dice.within(-5, 5);
    const float grid = n % 3 == 0 ? 2 : 256, density = dice.within(.2F, 3), level = dice.within(0, .9F);
    std::array<Vertex, 3> corners{};
    for (Vertex& c : corners) {
        c = {x + dice.within(0, size), y + dice.within(0, size), n % 2 == 0 ? level : dice.within(0, .9F), 1};
        if (n % 4 != 0) c.x = std::round(c.x * grid) / grid, c.y = std::round(c.y * grid) / grid;
        c.u = density * c.x / 64 + dice.within(-.02F, .02F), c.v = density * c.y / 16 + dice.within(-.02F, .02F);
        if (n % 7 == 0) c.u = std::floor(c.u * 64) / 64, c.v = std::floor(c.v * 16) / 16;
    }
    if (n % 5 == 0) {  // a side through centres, but for what float32 loses
        const auto right = static_cast<float>(dice.whole(-3, 3)), down = static_cast<float>(dice.whole(-3, 3));
        for (std::size_t k = 0; k < 2; ++k) {
            const float t = k == 0 ? dice.within(-1.3F, 0) : dice.within(0, 1.3F);
            corners[k].x = std::floor(x) + 4.5F + t * right, corners[k].y = std::floor(y) + 4.5F + t * down;
        }
    }
    return corners;
}

TEST(RasterEqualsExact, InEveryPixelOfSmallTriangles) {
    laws::Dice dice(14);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (int n = 0; n < 1500; ++n) {
        std::vector<Vertex> vertices;
        const float x = dice.within(-4, kWidth + 2), y = dice.within(-4, kHeight + 2);  // its ends, too
        for (int k = 0; k < 9; ++k) {
            auto corners = small_triangle(dice, n + 8 * k, x, y);
            if (n % 2 == 0) bring_to_border(dice, texels.texture, corners);
            vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = n % 3 != 0, job.cull_back = n % 4 == 0;
        const std::string what = std::to_string(n);
        expect_exact(texels, job, counters, what);
        if (HasFatalFailure()) return;
        const std::uint32_t late = ~(1U << static_cast<unsigned>(RasterSkip::early_z));
        expect_same(drawn(texels.texture, job, counters, {.skips = late}), decided(texels.texture, job),
                    "late: " + what);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.samples, 100000U);
    EXPECT_GT(counters.in_double, 100U);
    EXPECT_GT(counters.of(RasterSkip::early_z), 100U);
}

/// Wide slopes through and behind each other: what a tile of them hides is as near as it is said to be.
TEST(RasterEqualsExact, WhereTilesHideWideTriangles) {
    laws::Dice dice(15);
    RasterCounters counters;
    for (int n = 0; n < 300; ++n) {
        const Addresses& texels = textures()[static_cast<std::size_t>(n % 6)];
        const Origin origin{n % 3 == 0 ? dice.whole(-3000, 3000) : 0, n % 3 == 0 ? dice.whole(-3000, 3000) : 0};
        std::vector<Vertex> vertices;
        for (int k = 0; k < 14; ++k) {
            const float z = dice.within(.1F, .9F), slope = k % 3 == 0 ? 0 : dice.within(0, .1F);
            for (int corner = 0; corner < 3; ++corner)
                vertices.push_back({dice.within(-250, kWidth + 250) + static_cast<float>(origin.x),
                                    dice.within(-200, kHeight + 200) + static_cast<float>(origin.y),
                                    z + slope * dice.within(-1, 1), 1, dice.within(-2, 2), dice.within(-2, 2)});
        }
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = true;
        expect_exact(texels, job, counters, std::to_string(n), origin);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.of(RasterSkip::hidden_tile), 1000U);
    EXPECT_GT(counters.of(RasterSkip::early_z), 1000U);
}

/// Corners on a line of centres but for what float32 loses: their order's sense, which float32 does not tell, decides
/// whether these are drawn.
TEST(RasterEqualsExact, WhereFloat32DoesNotTellTheFront) {
    laws::Dice dice(16);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (int n = 0; n < 4000; ++n) {
        const auto right = static_cast<float>(dice.whole(-9, 9)), down = static_cast<float>(dice.whole(-3, 3));
        const float x = static_cast<float>(dice.whole(50, 280)) + .5F, y = static_cast<float>(dice.whole(0, 51)) + .5F;
        std::array<Vertex, 3> corners{};
        for (int k = 0; k < 3; ++k) {
            const float t = k < 2 ? static_cast<float>(dice.whole(-30, 30)) : dice.within(-40, 40);
            corners[static_cast<std::size_t>(k)] = {x + t * right, y + t * down, 0, 1, .5F, t / 30};
        }
        RasterJob job = job_of(corners, texels.texture);
        job.cull_back = true;
        expect_exact(texels, job, counters, std::to_string(n) + ": " + text_of(corners));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.samples, 10000U);
}

/// Double rounds the corners' differences: the area's sign is not known before the exact triangle is made.
TEST(RasterEqualsExact, WhereDoubleDoesNotTellTheFront) {
    const Addresses& texels = textures()[0];
    for (const auto& [x, y] : {std::pair{0x1p-60F, 0.0F}, {0.0F, -0x1p-60F}, {-0x1p-60F, 0.0F}, {0.0F, 0x1p-60F}}) {
        RasterCounters counters;
        const std::array<Vertex, 3> corners{{{x, y, 0, 1, 0, 0}, {40, 40, 0, 1, 1, 0}, {20, 20, 0, 1, 0, 1}}};
        RasterJob job = job_of(corners, texels.texture);
        job.cull_back = true;
        expect_exact(texels, job, counters, text_of(corners));
        if (HasFatalFailure()) return;
        EXPECT_EQ(counters.samples > 0, x > 0 || y < 0) << "of the two that show their front";
    }
}

/// One row of a steep triangle, nearer by an ulp than what stands there: its tile's other rows lie far outside of it.
TEST(RasterEqualsExact, WhereADepthIsAsNearAsItsTile) {
    const Addresses& texels = textures()[0];
    struct Case {
        float before;
        std::array<Vertex, 3> corners;
    };
    const std::array<Case, 2> cases{{{0x1.e1ad54p-15F,
                                      {{{0x1.8ad0f2p+7F, 0x1.f00012p+3F, -0x1.3f2fd4p-2F, 1, 0, 0},
                                        {0x1.1d3f16p+7F, 0x1.effff6p+3F, 0x1.6316b6p-3F, 1, 1, 0},
                                        {0x1.f738e4p+7F, 0x1.effff6p+3F, 0x1.627b6ep-3F, 1, 0, 1}}}},
                                     {-0x1.136452p-18F,
                                      {{{0x1.6342dap+7F, 0x1.f00038p+3F, -0x1.e8782ap-3F, 1, 0, 0},
                                        {0x1.da14ecp+6F, 0x1.efff9p+3F, 0x1.e8b60ap-2F, 1, 1, 0},
                                        {0x1.dbd8e6p+7F, 0x1.efff9p+3F, 0x1.e868dcp-2F, 1, 0, 1}}}}}};
    for (const Case& c : cases) {
        std::vector<Vertex> vertices{
            {-400, -400, c.before, 1, 0, 0}, {2000, -400, c.before, 1, 1, 0}, {-400, 2000, c.before, 1, 0, 1}};
        vertices.insert(vertices.end(), c.corners.begin(), c.corners.end());
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = true;
        RasterCounters counters;
        expect_exact(texels, job, counters, text_of(c.corners));
        if (HasFatalFailure()) return;
    }
}

/// From an origin below 0 float32 does not hold where a corner is: one next to a centre is not beyond it.
TEST(RasterEqualsExact, NextToACentreFarFromTheOrigin) {
    laws::Dice dice(17);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (int n = 0; n < 400; ++n) {
        const Origin origin{-dice.whole(10, 300), -dice.whole(10, 50)};
        const float past = .5F + static_cast<float>(dice.whole(1, 3)) * 0x1p-24F, before = 1 - past;
        const float x = n % 2 == 0 ? past : before;
        std::array<Vertex, 3> corners{
            {{x, .1F, 0, 1, 0, 0}, {x, .9F, 0, 1, 1, 0}, {n % 2 == 0 ? .2F : .8F, .5F, 0, 1, 0, 1}}};
        if (n % 4 < 2)
            for (Vertex& c : corners) std::swap(c.x, c.y);
        const RasterJob job = job_of(corners, texels.texture);
        expect_exact(texels, job, counters, std::to_string(n), origin);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(counters.samples, 400U);
}

TEST(RasterEqualsExact, FarFromTheOrigin) {
    laws::Dice dice(4);
    RasterCounters counters;
    for (int n = 0; n < 1500; ++n) {
        const int far = 1 << dice.whole(3, 27);
        const Origin origin{dice.often(.5) ? far : -far, dice.whole(-5000, 5000)};
        auto corners = random_triangle(dice, n);
        for (Vertex& c : corners) c.x += static_cast<float>(origin.x), c.y += static_cast<float>(origin.y);
        const Addresses& texels = textures()[static_cast<std::size_t>(n % 6)];
        RasterJob job = job_of(corners, texels.texture);
        job.perspective = n % 2 == 0;
        expect_exact(texels, job, counters, std::to_string(n) + ": " + text_of(corners), origin);
        if (HasFatalFailure()) return;
    }
}

TEST(RasterEqualsExact, WhereManyTrianglesAreDrawnAtOnce) {
    laws::Dice dice(5);
    const Addresses& texels = textures()[0];
    RasterCounters counters;
    for (const int count : {1, 2, 7, 8, 9, 31, 500})
        for (const bool perspective : {false, true}) {
            std::vector<Vertex> vertices;
            for (int n = 0; n < count; ++n) {
                const auto corners = random_triangle(dice, n);
                vertices.insert(vertices.end(), corners.begin(), corners.end());
            }
            RasterJob job = job_of(vertices, texels.texture);
            job.perspective = perspective;
            expect_exact(texels, job, counters, std::to_string(count));
            if (HasFatalFailure()) return;
        }
}

TEST(RasterRefuses, WhatIsNotFiniteOrBehindTheEye) {
    laws::Dice dice(8);
    const RasterTexture& texture = textures()[0].texture;
    const auto spoilt = [&](Vertex& c, int which, bool perspective) {
        const float wrong = std::array{NAN, INFINITY, -INFINITY}[static_cast<std::size_t>(dice.whole(0, 2))];
        const std::array<float*, 6> fields{&c.x, &c.y, &c.z, &c.w, &c.u, &c.v};
        *fields[static_cast<std::size_t>(which)] =
            which == 3 && perspective && dice.often(.5) ? -dice.within(0, 1) : wrong;
    };
    for (int n = 0; n < 3000; ++n) {
        auto corners =
            laws::random_corners(dice, static_cast<laws::Family>(n % laws::kFamilies), {0, 0, kWidth, kHeight}, 3);
        RasterJob job = job_of(corners, texture);
        job.perspective = dice.often(.5), job.depth = dice.often(.5), job.cull_back = dice.often(.5);
        spoilt(corners[static_cast<std::size_t>(n % 3)], n % 6, job.perspective);
        RasterCounters counters;
        ASSERT_EQ(drawn(texture, job, counters), Picture{}) << text_of(corners);
    }
}

TEST(RasterThreads, DrawTheSamePicture) {
    laws::Dice dice(7);
    const RasterTexture texture = textures()[0].with_apron.texture();
    std::vector<Vertex> vertices;
    for (int n = 0; n < 400; ++n) {
        const auto corners = random_triangle(dice, n);
        vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    for (const bool depth : {false, true}) {
        RasterJob job = job_of(vertices, texture);
        job.depth = depth, job.perspective = true;
        RasterCounters one;
        const Picture expected = drawn(texture, job, one);
        for (const int threads : {2, 3, 4, 7, kMaxRasterThreads}) {
            RasterCounters counters;
            ASSERT_EQ(drawn(texture, job, counters, {.threads = threads}), expected) << threads;
            // With depth, tiles hide what they do within a band.
            EXPECT_TRUE(depth || counters.samples == one.samples) << threads;
        }
    }
}

/// What is dropped or refused before bands are drawn counts once, whatever the number of threads.
TEST(RasterThreads, LookAtEachTriangleOnce) {
    laws::Dice dice(9);
    const RasterTexture texture = textures()[0].with_apron.texture();
    std::vector<Vertex> vertices;
    for (int n = 0; n < 5000; ++n) {  // more than a thread takes at once
        auto corners = random_triangle(dice, n);
        if (n % 7 == 0) corners[2] = corners[1];
        if (n % 11 == 0) corners[0].y = n % 2 == 0 ? NAN : INFINITY;
        if (n % 13 == 0) corners[1].x = 1e30F, corners[2].y = -1e30F;
        if (n % 17 == 0)
            for (Vertex& c : corners) c.y += 3 * kHeight;
        vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    RasterJob job = job_of(vertices, texture);
    job.cull_back = true;
    RasterCounters one;
    const Picture expected = drawn(texture, job, one);
    EXPECT_GT(one.refused, 100U);
    EXPECT_GT(one.slow, 50U);
    for (const int threads : {2, 3, kMaxRasterThreads}) {
        RasterCounters counters;
        ASSERT_EQ(drawn(texture, job, counters, {.threads = threads}), expected) << threads;
        EXPECT_EQ(counters.triangles, 5000U);
        EXPECT_EQ(counters.refused, one.refused) << threads;
        EXPECT_EQ(counters.samples, one.samples) << threads;
        for (const RasterSkip skip :
             {RasterSkip::off_screen, RasterSkip::no_sample, RasterSkip::zero_area, RasterSkip::back_face}) {
            EXPECT_GT(one.of(skip), 10U) << static_cast<int>(skip);
            EXPECT_EQ(counters.of(skip), one.of(skip)) << static_cast<int>(skip) << ", " << threads << " threads";
        }
    }
}

/// Any subset of the skips leaves the picture as it is.
TEST(RasterSkips, ChangeNoPixel) {
    laws::Dice dice(6);
    const Addresses& texels = textures()[0];
    std::uint64_t level = 0, single = 0, floors = 0, flat = 0, deep = 0, tiles = 0, early = 0;
    for (int n = 0; n < 40; ++n) {
        std::vector<Vertex> vertices;
        for (int k = 0; k < 60; ++k) {
            auto corners = random_triangle(dice, k);
            if (k % 3 == 0)
                for (Vertex& c : corners) c.w = 2, c.z = .3F;
            if (k % 4 == 0) corners[2] = corners[1];
            if (k % 5 == 0)  // rows of one texel, in a triangle as wide as the picture
                for (Vertex& c : corners) c.x *= 2, c.u = .02F * c.y, c.v = .3F - .01F * c.y;
            if (k % 7 == 0)
                for (Vertex& c : corners) c.u = .3F + 1e-6F * c.u, c.v = .7F;
            if (k % 11 == 0) corners[1].y = corners[0].y, corners[1].w = corners[0].w;  // a floor's
            vertices.insert(vertices.end(), corners.begin(), corners.end());
        }
        const RasterTexture texture = n % 3 == 0 ? texels.texture : texels.with_apron.texture();
        RasterJob job = job_of(vertices, texture);
        job.depth = n % 2 == 0, job.perspective = n % 4 < 2, job.cull_back = true;
        RasterCounters with, without, by_rows;
        const Picture expected = decided(texture, job);
        ASSERT_EQ(drawn(texture, job, with), expected);
        ASSERT_EQ(drawn(texels.texture, job, by_rows), expected);
        for (const RasterSkip skip : {RasterSkip::equal_w, RasterSkip::level_w})
            EXPECT_EQ(with.of(skip), by_rows.of(skip)) << "by blocks and by rows: " << static_cast<int>(skip);
        flat += with.of(RasterSkip::equal_w);
        for (const RasterSkipInfo& skip : kRasterSkips) {
            const std::uint32_t others = ~(1U << static_cast<unsigned>(skip.skip));
            RasterCounters counters;
            ASSERT_EQ(drawn(texture, job, counters, {.skips = others}), expected) << skip.id;
            EXPECT_EQ(counters.of(skip.skip), 0U) << skip.id;
        }
        ASSERT_EQ(drawn(texture, job, without, {.skips = 0}), expected);
        for (const RasterSkip skip : {RasterSkip::off_screen, RasterSkip::zero_area, RasterSkip::back_face})
            EXPECT_GT(with.of(skip), 0U) << static_cast<int>(skip);
        level += with.of(RasterSkip::zero_gradient), single += with.of(RasterSkip::one_texel),
            floors += with.of(RasterSkip::level_w), deep += with.of(RasterSkip::level_z);
        tiles += with.of(RasterSkip::hidden_tile), early += with.of(RasterSkip::early_z);
        EXPECT_TRUE(job.depth || with.of(RasterSkip::level_z) == 0);
    }
    EXPECT_GT(single, 0U);
    EXPECT_GT(floors, 0U);
    EXPECT_GT(flat, 0U);
    EXPECT_GT(deep, 0U);
    EXPECT_GT(tiles, 0U);
    EXPECT_GT(early, 0U);
    EXPECT_GT(level, 0U) << "of wide triangles only, without depth";
}

void add_square(std::vector<Vertex>& to, float x, float y, float size, float z) {
    const auto corner = [&](float right, float down) {
        return Vertex{x + right * size, y + down * size, z, 1, right / 4, down / 4};
    };
    for (const Vertex& c : {corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 0), corner(1, 1), corner(0, 1)})
        to.push_back(c);
}

/// Three of the four tiles that a small square meets are covered by something nearer: what lies in the fourth is seen.
TEST(RasterSkips, HideNothingThatOneOfFourTilesShows) {
    const Addresses& texels = textures()[0];
    for (int open = 0; open < 4; ++open) {
        std::vector<Vertex> vertices;
        const auto tile = [&](int n, float inset, float size, float z) {
            add_square(vertices, static_cast<float>(16 + 16 * (n % 2)) + inset,
                       static_cast<float>(16 * (n / 2)) + inset, size, z);
        };
        for (int round = 0; round < 16; ++round)  // until it is asked again how far each tile's depths are
            for (int n = 0; n < 4; ++n) {
                if (n != open) tile(n, 0, 16, .3F - .01F * static_cast<float>(round));
                tile(n, 2, 4, n == open ? .1F : .7F);
            }
        for (int round = 0; round < 8; ++round) add_square(vertices, 24, 8, 16, .5F);
        RasterJob job = job_of(vertices, texels.texture);
        job.depth = true;
        RasterCounters counters;
        const Picture is = drawn(texels.texture, job, counters);
        EXPECT_EQ(is, decided(texels.texture, job)) << "tile " << open;
        EXPECT_GE(counters.of(RasterSkip::hidden), 30U);
    }
}

}  // namespace
}  // namespace texelscope::raster_equals_exact_test
