#include "core/fast/paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace texelscope::paint_test {
namespace {

// The definition in core/fast/paint.h, one pixel at a time and with no case treated apart.

struct DefinedCorner {
    long long x, y;
    std::array<long long, 6> value;
};

DefinedCorner defined_corner(const PaintVertex& v, const PaintTexture& texture) {
    const auto texel = [](double u, int size) {
        if (std::isnan(u * size)) return 0LL;
        const double limited = std::fmin(std::fmax(u * size, -2097152.0), 2097152.0);
        return static_cast<long long>(std::floor(limited * 65536.0 + 0.5));
    };
    DefinedCorner c{};
    c.x = static_cast<long long>(std::floor(double{v.x} * 256 + 0.5));
    c.y = static_cast<long long>(std::floor(double{v.y} * 256 + 0.5));
    c.value = {texel(v.u, texture.width), texel(v.v, texture.height)};
    for (unsigned i = 0; i < 4; ++i) c.value[2 + i] = static_cast<long long>(v.rgba >> (8 * i) & 255) * 65536;
    return c;
}

long long edge(const DefinedCorner& a, const DefinedCorner& b, long long x, long long y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

bool inside(const DefinedCorner& a, const DefinedCorner& b, long long x, long long y) {
    const long long e = edge(a, b, x, y);
    const bool left = b.y < a.y, top = b.y == a.y && b.x > a.x;
    return e > 0 || (e == 0 && (left || top));
}

bool covers(const std::array<DefinedCorner, 3>& c, long long x, long long y) {
    const long long area = edge(c[0], c[1], c[2].x, c[2].y);
    if (area > 0) return inside(c[0], c[1], x, y) && inside(c[1], c[2], x, y) && inside(c[2], c[0], x, y);
    if (area < 0) return inside(c[0], c[2], x, y) && inside(c[2], c[1], x, y) && inside(c[1], c[0], x, y);
    return false;
}

long long value_at(const std::array<DefinedCorner, 3>& c, std::size_t i, long long x, long long y) {
    const auto d = [&](long long to, long long from) { return static_cast<double>(to - from); };
    const double b = d(c[1].value[i], c[0].value[i]), e = d(c[2].value[i], c[0].value[i]);
    const double bx = d(c[1].x, c[0].x), by = d(c[1].y, c[0].y), ex = d(c[2].x, c[0].x), ey = d(c[2].y, c[0].y);
    const auto area = static_cast<double>(edge(c[0], c[1], c[2].x, c[2].y));
    const auto gradient = [&](double numerator) {
        const double g = std::floor(std::fmin(std::fmax(numerator / area * 16777216.0, -4e18), 4e18) + 0.5);
        return static_cast<unsigned long long>(static_cast<long long>(g));
    };
    const unsigned long long sum = static_cast<unsigned long long>(c[0].value[i]) * 16777216ULL +
                                   gradient(b * ey - e * by) * static_cast<unsigned long long>(x - c[0].x) +
                                   gradient(e * bx - b * ex) * static_cast<unsigned long long>(y - c[0].y);
    return static_cast<long long>(sum);
}

Rgba defined_source(const std::array<DefinedCorner, 3>& c, const PaintTexture& t, long long x, long long y) {
    Rgba texel{255, 255, 255, 255};
    const long long s = std::clamp(value_at(c, 0, x, y) >> 40, 0LL, std::max(t.width - 1LL, 0LL));
    const long long row = std::clamp(value_at(c, 1, x, y) >> 40, 0LL, std::max(t.height - 1LL, 0LL));
    if (t.alpha != nullptr) texel.a = t.alpha[row * t.width + s];
    if (t.rgba != nullptr) texel = t.rgba[row * t.width + s];
    const auto product = [&](std::uint8_t a, std::size_t i) {
        const long long rounded = value_at(c, i, x, y);
        const long long b = std::clamp(
            static_cast<long long>(static_cast<unsigned long long>(rounded) + (1ULL << 39)) >> 40, 0LL, 255LL);
        return static_cast<std::uint8_t>((a * b + 127) / 255);
    };
    return {product(texel.r, 2), product(texel.g, 3), product(texel.b, 4), product(texel.a, 5)};
}

std::uint8_t defined_mix(int source, int target, int alpha) {
    return static_cast<std::uint8_t>((source * alpha + target * (255 - alpha) + 127) / 255);
}

void defined_over(Rgb& d, const Rgba& s) {
    d = {defined_mix(s.r, d.r, s.a), defined_mix(s.g, d.g, s.a), defined_mix(s.b, d.b, s.a)};
}
void defined_over(Rgba& d, const Rgba& s) {
    d = {defined_mix(s.r, d.r, s.a), defined_mix(s.g, d.g, s.a), defined_mix(s.b, d.b, s.a),
         static_cast<std::uint8_t>(s.a + (d.a * (255 - s.a) + 127) / 255)};
}

template <class Pixel>
void paint_defined(Grid<Pixel>& target, const std::vector<PaintVertex>& vertices,
                   const std::vector<std::uint16_t>& indices, const PaintTexture& texture, const Rect& clip) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        std::array<DefinedCorner, 3> c{};
        bool drawable = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint16_t index = indices[i + k];
            const bool known = index < vertices.size();
            const PaintVertex v = known ? vertices[index] : PaintVertex{};
            drawable = drawable && known && std::fabs(v.x) <= kPaintGuard && std::fabs(v.y) <= kPaintGuard;
            if (drawable) c[k] = defined_corner(v, texture);
        }
        for (int y = 0; drawable && y < target.height(); ++y) {
            for (int x = 0; x < target.width(); ++x) {
                const long long cx = x * 256LL + 128, cy = y * 256LL + 128;
                if (clip.contains(x, y) && covers(c, cx, cy))
                    defined_over(target.at(x, y), defined_source(c, texture, cx, cy));
            }
        }
    }
}

// Random drawings.

struct Drawing {
    std::vector<PaintVertex> vertices;
    std::vector<std::uint16_t> indices;
    Rect clip;
};

class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    float within(float low, float high) {
        return low + (high - low) * static_cast<float>(engine_() % 65537) / 65536.0F;
    }
    std::uint32_t colour() {
        const std::uint32_t alpha = std::array{0U, 255U, 255U, static_cast<unsigned>(below(256))}[below(4)];
        return (static_cast<std::uint32_t>(engine_()) & 0xFFFFFFU) | alpha << 24;
    }
    float coordinate() {
        switch (below(8)) {
            case 0: return static_cast<float>(below(48) - 8);
            case 1: return static_cast<float>(below(96)) / 2;
            case 2: return within(-1000, 1000);
            case 3: return within(-kPaintGuard, kPaintGuard);
            default: return within(-4, 36);
        }
    }

private:
    std::mt19937 engine_;
};

void add_rectangle(Drawing& d, Dice& dice) {
    const auto first = static_cast<std::uint16_t>(d.vertices.size());
    const float x0 = dice.coordinate(), y0 = dice.coordinate();
    const float x1 = dice.below(2) != 0 ? x0 + static_cast<float>(dice.below(20)) : dice.coordinate();
    const float y1 = dice.below(2) != 0 ? y0 + static_cast<float>(dice.below(20)) : dice.coordinate();
    const bool glyph = dice.below(3) != 0;
    const float u0 = dice.within(-0.2F, 1.2F), v0 = dice.within(0, 1);
    const float u1 = glyph ? u0 + (x1 - x0) / 16 : dice.within(0, 1),
                v1 = glyph ? v0 + (y1 - y0) / 8 : dice.within(0, 1);
    const std::uint32_t a = dice.colour(), b = dice.below(3) == 0 ? dice.colour() : a;
    const bool across = dice.below(2) != 0;
    d.vertices.push_back({x0, y0, u0, v0, a});
    d.vertices.push_back({x1, y0, u1, v0, across ? b : a});
    d.vertices.push_back({x1, y1, u1, v1, b});
    d.vertices.push_back({x0, y1, u0, v1, across ? a : b});
    // One rectangle in four breaks the plane that the two triangles would share.
    PaintVertex& odd = d.vertices[first + static_cast<std::size_t>(dice.below(4))];
    switch (dice.below(12)) {
        case 0: odd.rgba = dice.colour(); break;
        case 1: odd.u = dice.within(0, 1); break;
        case 2: odd.x += dice.within(-1, 1); break;
        default: break;
    }
    for (const int i : {0, 1, 2, 0, 2, 3}) d.indices.push_back(static_cast<std::uint16_t>(first + i));
}

void add_triangle(Drawing& d, Dice& dice) {
    const std::uint32_t colour = dice.colour();
    const bool flat = dice.below(2) != 0, untextured = dice.below(2) != 0;
    for (int k = 0; k < 3; ++k) {
        d.indices.push_back(static_cast<std::uint16_t>(d.vertices.size()));
        d.vertices.push_back({dice.coordinate(), dice.coordinate(), untextured ? 0.3F : dice.within(-1, 2),
                              untextured ? 0.3F : dice.within(-1, 2), flat ? colour : dice.colour()});
    }
}

Drawing random_drawing(Dice& dice) {
    Drawing d;
    for (int i = dice.below(6) + 1; i > 0; --i) dice.below(2) != 0 ? add_rectangle(d, dice) : add_triangle(d, dice);
    d.clip = {dice.below(8) - 2, dice.below(8) - 2, 40 - dice.below(20), 30 - dice.below(20)};
    return d;
}

struct Textures {
    std::vector<std::uint8_t> alpha;
    std::vector<Rgba> rgba;
    explicit Textures(Dice& dice) {
        for (int i = 0; i < 16 * 8; ++i) {
            alpha.push_back(static_cast<std::uint8_t>(std::array{0, 255, dice.below(256)}[dice.below(3)]));
            const std::uint32_t c = i / 16 % 2 != 0 ? dice.colour() : dice.colour() | 0xFF000000U;
            rgba.push_back({static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(c >> 8),
                            static_cast<std::uint8_t>(c >> 16), static_cast<std::uint8_t>(c >> 24)});
        }
    }
    PaintTexture pick(int which) const {
        if (which == 0) return {16, 8, alpha.data(), nullptr};
        if (which == 1) return {16, 8, nullptr, rgba.data()};
        return {};
    }
};

template <class Pixel>
void expect_equals_definition(unsigned seeds) {
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        Dice dice(seed);
        const Textures textures(dice);
        const PaintTexture texture = textures.pick(dice.below(3));
        const Drawing d = random_drawing(dice);
        Grid<Pixel> painted(32, 24, Pixel{40, 90, 160}), defined = painted;
        paint(painted, d.vertices, d.indices, texture, d.clip);
        paint_defined(defined, d.vertices, d.indices, texture, d.clip);
        ASSERT_EQ(painted, defined) << "seed " << seed;
    }
}

TEST(Paint, EqualsItsDefinitionOnColoursWithAlpha) { expect_equals_definition<Rgba>(6000); }

TEST(Paint, EqualsItsDefinitionOnOpaquePictures) { expect_equals_definition<Rgb>(6000); }

TEST(Paint, RectanglesWiderThanTheColumnsHeldAtOnceEqualTheirDefinition) {
    constexpr Rect kAll{0, 0, 1250, 12};
    for (unsigned seed = 1; seed <= 60; ++seed) {
        Dice dice(seed);
        const Textures textures(dice);
        const PaintTexture texture = textures.pick(dice.below(2));
        Drawing d;
        add_rectangle(d, dice);
        d.vertices[0].x = d.vertices[3].x = dice.within(0, 3);
        d.vertices[1].x = d.vertices[2].x = 1200 + dice.within(0, 90);
        Image painted(kAll.width(), kAll.height()), defined = painted;
        paint(painted, d.vertices, d.indices, texture, kAll);
        paint_defined(defined, d.vertices, d.indices, texture, kAll);
        ASSERT_EQ(painted, defined) << "seed " << seed;
    }
}

/// A fan of triangles around `centre` that fills the whole target, each blended once with the same half-transparent
/// white: a pixel covered twice, or not at all, differs from the rest.
TEST(Paint, TrianglesThatShareSidesCoverEachPixelOnce) {
    for (unsigned seed = 1; seed <= 500; ++seed) {
        Dice dice(seed);
        std::vector<PaintVertex> v{{dice.within(2, 30), dice.within(2, 22), 0, 0, 0x80FFFFFFU}};
        const auto corner = [&](float x, float y) { v.push_back({x, y, 0, 0, 0x80FFFFFFU}); };
        corner(-1, -1), corner(dice.within(0, 32), -1), corner(33, -1), corner(33, dice.within(0, 24)), corner(33, 25);
        corner(dice.within(0, 32), 25), corner(-1, 25), corner(-1, dice.within(0, 24));
        std::vector<std::uint16_t> indices;
        for (std::uint16_t k = 1; k <= 8; ++k) {
            indices.insert(indices.end(), {0, k, static_cast<std::uint16_t>(k % 8 + 1)});
        }
        Image target(32, 24);
        paint(target, v, indices, {}, {0, 0, 32, 24});
        ASSERT_EQ(target, Image(32, 24, Rgb{128, 128, 128})) << "seed " << seed;
    }
}

TEST(Paint, ATurnedQuadOfTwoTrianglesCoversEachPixelAtMostOnce) {
    for (unsigned seed = 1; seed <= 500; ++seed) {
        Dice dice(seed);
        const float x = dice.within(8, 24), y = dice.within(8, 16), a = dice.within(-9, 9), b = dice.within(-9, 9);
        const std::vector<PaintVertex> v{{x + a, y + b, 0, 0, 0x40FFFFFFU},
                                         {x - b, y + a, 0, 0, 0x40FFFFFFU},
                                         {x - a, y - b, 0, 0, 0x40FFFFFFU},
                                         {x + b, y - a, 0, 0, 0x40FFFFFFU}};
        Image target(32, 24);
        paint(target, v, std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, {}, {0, 0, 32, 24});
        for (std::size_t i = 0; i < target.size(); ++i) {
            ASSERT_TRUE(target.data()[i] == Rgb{} || (target.data()[i] == Rgb{64, 64, 64})) << "seed " << seed;
        }
    }
}

TEST(Paint, NothingIsDrawnOutsideTheClip) {
    const Rect clip{3, 5, 20, 11};
    for (unsigned seed = 1; seed <= 300; ++seed) {
        Dice dice(seed);
        const Drawing d = random_drawing(dice);
        Image target(32, 24, Rgb{1, 2, 3});
        paint(target, d.vertices, d.indices, {}, clip);
        for (int y = 0; y < 24; ++y) {
            for (int x = 0; x < 32; ++x) {
                if (!clip.contains(x, y)) {
                    ASSERT_EQ(target.at(x, y), (Rgb{1, 2, 3}));
                }
            }
        }
    }
}

TEST(Paint, AClipBeyondTheTargetIsCutToIt) {
    const std::vector<PaintVertex> v{
        {-50, -50, 0, 0, ~0U}, {50, -50, 0, 0, ~0U}, {50, 50, 0, 0, ~0U}, {-50, 50, 0, 0, ~0U}};
    Image target(4, 3);
    paint(target, v, std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, {},
          {-2000000000, -2000000000, 2000000000, 2000000000});
    EXPECT_EQ(target, Image(4, 3, Rgb{255, 255, 255}));
    Image empty;
    paint(empty, v, std::vector<std::uint16_t>{0, 1, 2}, {}, {0, 0, 10, 10});
    EXPECT_TRUE(empty.empty());
}

TEST(Paint, CoordinatesThatAreNotFiniteOrTooLargeDrawNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, inf, -inf, 3e38F, -1048577.0F}) {
        const std::vector<PaintVertex> v{
            {0, 0, 0, 0, ~0U}, {bad, 0, 0, 0, ~0U}, {9, 9, 0, 0, ~0U}, {0, bad, 0, 0, ~0U}};
        Image target(8, 8);
        paint(target, v, std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, {}, {0, 0, 8, 8});
        EXPECT_EQ(target, Image(8, 8)) << bad;
    }
}

TEST(Paint, TextureCoordinatesOfAnySizeStayInTheTexture) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::vector<Rgba> red(4, Rgba{255, 0, 0, 255});
    for (const float bad : {nan, inf, -inf, 3e38F, -3e38F}) {
        const std::vector<PaintVertex> v{
            {0, 0, bad, 0, ~0U}, {8, 0, 1, bad, ~0U}, {8, 8, -bad, 1, ~0U}, {0, 8, 0, 1, ~0U}};
        Image target(8, 8);
        paint(target, v, std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, {2, 2, nullptr, red.data()}, {0, 0, 8, 8});
        EXPECT_EQ(target, Image(8, 8, Rgb{255, 0, 0})) << bad;
    }
}

TEST(Paint, IndicesOutsideTheVerticesDrawNothing) {
    const std::vector<PaintVertex> v{{0, 0, 0, 0, ~0U}, {8, 0, 0, 0, ~0U}, {8, 8, 0, 0, ~0U}};
    Image target(8, 8);
    paint(target, v, std::vector<std::uint16_t>{0, 1, 3, 0, 3, 9, 1, 2}, {}, {0, 0, 8, 8});
    EXPECT_EQ(target, Image(8, 8));
}

TEST(Paint, AGlyphAtItsOwnSizeIsCopiedTexelForTexel) {
    const std::vector<std::uint8_t> glyph{0, 10, 20, 30, 255, 40, 50, 60, 0, 70, 80, 90};
    const std::vector<PaintVertex> v{{2, 1, 0, 0, ~0U}, {6, 1, 1, 0, ~0U}, {6, 4, 1, 1, ~0U}, {2, 4, 0, 1, ~0U}};
    Image target(8, 6);
    paint(target, v, std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, {4, 3, glyph.data(), nullptr}, {0, 0, 8, 6});
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) EXPECT_EQ(target.at(x + 2, y + 1).g, glyph[static_cast<std::size_t>(y * 4 + x)]);
    }
}

}  // namespace
}  // namespace texelscope::paint_test
