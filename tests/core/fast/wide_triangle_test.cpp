// 128 bits against whole numbers of any size; and the gap between a border and the samples that do not lie on it.
#include "core/fast/wide_triangle.h"

#include <gtest/gtest.h>

#include "core/number/exact.h"
#include "tests/core/method/cases.h"

namespace texelscope::wide_triangle_test {
namespace {

const Rect kFrame{0, 0, 60, 40};

/// Corners on a grid of 1/256 px and simple texture coordinates, as blits and games have.
std::vector<Vertex> simple_triangle(laws::Dice& dice, bool perspective) {
    std::vector<Vertex> corners(3);
    for (Vertex& c : corners) {
        c.x = std::floor(dice.within(0, 60) * 256) / 256, c.y = std::floor(dice.within(0, 40) * 256) / 256;
        c.u = std::floor(dice.within(-4, 4) * 8) / 8, c.v = dice.within(-1, 1);
        if (perspective) c.w = static_cast<float>(dice.whole(1, 8)) / 2;
    }
    return corners;
}

TEST(WideTriangle, TellsTheTexelsOfTheExactTriangle) {
    laws::Dice dice(1);
    int made = 0;
    for (int n = 0; n < 3000; ++n) {
        const auto corners = n % 3 == 0
                                 ? laws::random_corners(dice, static_cast<laws::Family>(n % laws::kFamilies), kFrame, 3)
                                 : simple_triangle(dice, n % 2 == 0);
        const int x0 = dice.whole(-50, 5), y0 = dice.whole(-50, 5);
        const auto wide = WideTriangle::make(std::span(corners).first<3>(), 64, 48, x0, y0);
        if (!wide) continue;
        ++made;
        const ExactTriangle exact{std::span(corners).first<3>(), 64, 48};
        for (int y = 0; y < kFrame.y1; ++y) {
            const PixelRange row = exact.row(y + y0, x0, x0 + kFrame.x1);
            for (Integer x = row.x0; x < row.x1; ++x)
                ASSERT_EQ(wide->texel(static_cast<int>(x) - x0, y), exact.texel(x, y + y0)) << n;
        }
    }
    EXPECT_GT(made, 1800);
}

TEST(WideTriangle, DeclinesWhatItCannotHold) {
    laws::Dice dice(2);
    auto corners = simple_triangle(dice, false);
    corners[0].x = 1e-30F;
    EXPECT_FALSE(WideTriangle::make(std::span(corners).first<3>(), 1, 1, 0, 0));
    corners[0].x = 1e30F;
    EXPECT_FALSE(WideTriangle::make(std::span(corners).first<3>(), 1, 1, 0, 0));
    corners[0] = corners[1];  // no area
    EXPECT_FALSE(WideTriangle::make(std::span(corners).first<3>(), 1, 1, 0, 0));
}

/// |u - nearest whole number| of a sample, by the definition.
Exact distance(std::span<const Vertex> p, int texels, Integer x, Integer y) {
    const auto number = [](double a) { return Exact::from(a); };
    const Exact px = Exact(x) + number(.5), py = Exact(y) + number(.5);
    Exact top(0), bottom(0);
    for (std::size_t n = 0; n < 3; ++n) {
        const Vertex &a = p[(n + 1) % 3], &b = p[(n + 2) % 3];
        const Exact weight =
            ((number(a.x) - px) * (number(b.y) - py) - (number(b.x) - px) * (number(a.y) - py)) / number(p[n].w);
        top = top + weight * number(p[n].u) * Exact(texels), bottom = bottom + weight;
    }
    const Exact u = top / bottom, below = u - Exact(floor(u));
    return lesser(below, Exact(1) - below);
}

TEST(WideTriangle, NoSampleLiesNearerToABorderThanTheGap) {
    laws::Dice dice(3);
    int known = 0, ties = 0;
    for (int n = 0; n < 400; ++n) {
        auto corners = simple_triangle(dice, n % 2 == 0);
        if (n % 4 == 1)  // samples on the borders of texels
            for (Vertex& c : corners) c.u = (c.x - .5F) / 64;
        const auto wide = WideTriangle::make(std::span(corners).first<3>(), 64, 48, 0, 0);
        if (!wide || wide->gaps().u == 0) continue;
        ++known;
        const Exact gap = Exact::from(wide->gaps().u);
        const ExactTriangle exact{std::span(corners).first<3>()};
        for (int y = 0; y < kFrame.y1; y += 3) {
            const PixelRange row = exact.row(y, 0, kFrame.x1);
            for (Integer x = row.x0; x < row.x1; x += 2) {
                const Exact apart = distance(corners, 64, x, y);
                ties += apart == 0 ? 1 : 0;
                ASSERT_TRUE(apart == 0 || apart >= gap) << n;
            }
        }
    }
    EXPECT_GT(known, 100);
    EXPECT_GT(ties, 0);
}

TEST(WideTriangle, GapOfABlitIsAsWideAsItCanBe) {
    std::vector<Vertex> corners(3);  // one texel a pixel, samples at halves of texels; then samples on the borders
    corners[1].x = 48, corners[1].u = 48, corners[2].y = 48, corners[2].v = 48;
    const auto half = WideTriangle::make(std::span(corners).first<3>(), 1, 1, 0, 0)->gaps();
    EXPECT_NEAR(half.u, .5, 1e-9);
    EXPECT_NEAR(half.v, .5, 1e-9);
    for (Vertex& c : corners) c.x += .5F, c.y += .5F;
    const auto whole = WideTriangle::make(std::span(corners).first<3>(), 1, 1, 0, 0)->gaps();
    EXPECT_NEAR(whole.u, 1, 1e-9);
    EXPECT_NEAR(whole.v, 1, 1e-9);
}

}  // namespace
}  // namespace texelscope::wide_triangle_test
