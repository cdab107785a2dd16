// The exact triangle against the definition: barycentric weights run with rational numbers, sample for sample.
#include "core/exact/triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "core/measure/reference.h"
#include "core/number/exact.h"
#include "tests/core/method/cases.h"

namespace texelscope::triangle_test {
namespace {

const Rect kFrame{-6, -5, 11, 9};
constexpr int kTriangles = 700;

using Texels = std::map<std::pair<Integer, Integer>, std::pair<int, int>>;

Texels by_definition(std::span<const Vertex> corners, const Texture& texture) {
    Texels texels;
    const Job job{.corners = corners, .texture = &texture, .frame = kFrame};
    find_method("barycentric")->samples(NumberFormat::exact, job, {kFrame, 1}, [&](const Sample& s) {
        if (s.fate == Fate::written) texels[{s.y, s.x}] = {s.column, s.row};
    });
    return texels;
}

Texels by_triangle(std::span<const Vertex> corners, const Texture& texture) {
    Texels texels;
    const ExactTriangle triangle(corners.first<3>());
    for (Integer y = kFrame.y0; y < kFrame.y1; ++y) {
        const PixelRange row = triangle.row(y, kFrame.x0, kFrame.x1);
        for (Integer x = row.x0; x < row.x1; ++x) {
            const TexelIndex texel = triangle.texel(x, y);
            texels[{y, x}] = {wrap_index(texel.u, texture.width(), texture.wrap),
                              wrap_index(texel.v, texture.height(), texture.wrap)};
        }
    }
    return texels;
}

std::vector<Vertex> random_triangle(laws::Dice& dice, int n) {
    auto corners = laws::random_corners(dice, static_cast<laws::Family>(n % laws::kFamilies), kFrame, 3);
    if (n % 5 == 0)  // ties: on centres, at whole texels
        for (Vertex& c : corners) {
            c.x = std::floor(c.x) + 0.5F, c.y = std::floor(c.y) + 0.5F;
            c.u = std::floor(c.u), c.v = std::floor(c.v), c.w = 1;
        }
    if (n % 11 == 0)  // far apart in size
        corners[0].x = dice.within(-1e-30, 1e-30), corners[1].y = dice.within(-1e-40, 1e-40), corners[2].x *= 1e8F;
    return corners;
}

TEST(ExactTriangle, DrawsTheSamplesAndTexelsOfRationalWeights) {
    laws::Dice dice(1);
    const auto texture = laws::texture_of(96, 40, Wrap::repeat);
    std::size_t samples = 0;
    for (int n = 0; n < kTriangles; ++n) {
        const auto corners = random_triangle(dice, n);
        const Texels expected = by_definition(corners, *texture);
        samples += expected.size();
        ASSERT_EQ(by_triangle(corners, *texture), expected) << text_of(corners);
    }
    EXPECT_GT(samples, 10000U);
}

TEST(ExactTriangle, IsTheSameForEveryOrderOfItsCorners) {
    laws::Dice dice(2);
    const auto texture = laws::texture_of(96, 40, Wrap::repeat);
    for (int n = 0; n < kTriangles; ++n) {
        auto corners = random_triangle(dice, n);
        const Texels expected = by_triangle(corners, *texture);
        for (int turn = 0; turn < 2; ++turn) {
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
            ASSERT_EQ(by_triangle(corners, *texture), expected) << text_of(corners);
            std::swap(corners[0], corners[1]);
            ASSERT_EQ(by_triangle(corners, *texture), expected) << text_of(corners);
        }
    }
}

/// z at the sample, by the weights' definition.
Exact depth_by_weights(std::span<const Vertex> p, Integer x, Integer y) {
    const auto number = [](float a) { return Exact::from(static_cast<double>(a)); };
    const Exact px = Exact(x) + Exact::from(0.5), py = Exact(y) + Exact::from(0.5);
    const auto twice = [&](const Exact& ax, const Exact& ay, const Exact& bx, const Exact& by) {
        return (ax - px) * (by - py) - (bx - px) * (ay - py);
    };
    Exact sum(0), area(0);
    for (std::size_t n = 0; n < 3; ++n) {
        const Vertex &a = p[(n + 1) % 3], &b = p[(n + 2) % 3];
        const Exact part = twice(number(a.x), number(a.y), number(b.x), number(b.y));
        sum = sum + part * number(p[n].z), area = area + part;
    }
    return sum / area;
}

TEST(ExactTriangle, RoundsDepthToTheNearestFloat) {
    laws::Dice dice(3);
    std::size_t samples = 0;
    for (int n = 0; n < kTriangles; ++n) {
        auto corners = random_triangle(dice, n);
        if (n % 3 == 0)  // halves between floats are met
            for (Vertex& c : corners) c.z = 1 + static_cast<float>(dice.whole(0, 7)) * 0x1p-23F;
        const ExactTriangle triangle{std::span(corners).first<3>()};
        for (Integer y = kFrame.y0; y < kFrame.y1; ++y) {
            const PixelRange row = triangle.row(y, kFrame.x0, kFrame.x1);
            for (Integer x = row.x0; x < row.x1; ++x, ++samples) {
                const float z = triangle.depth(x, y);
                const Exact is = depth_by_weights(corners, x, y), got = Exact::from(static_cast<double>(z));
                const Exact off = is < got ? got - is : is - got;
                for (const float next : {std::nextafter(z, INFINITY), std::nextafter(z, -INFINITY)}) {
                    const Exact other = Exact::from(static_cast<double>(next));
                    const Exact apart = is < other ? other - is : is - other;
                    ASSERT_TRUE(off <= apart) << text_of(corners);
                    if (off == apart) {
                        std::uint32_t bits = 0;
                        std::memcpy(&bits, &z, sizeof bits);
                        ASSERT_EQ(bits & 1U, 0U) << "a half goes to the even one: " << text_of(corners);
                    }
                }
            }
        }
    }
    EXPECT_GT(samples, 10000U);
}

TEST(ExactTriangle, HasNoSamplesWithoutArea) {
    std::vector<Vertex> corners(3);
    corners[1].x = 8, corners[1].y = 4, corners[2].x = 4, corners[2].y = 2;
    const ExactTriangle triangle{std::span(corners).first<3>()};
    EXPECT_EQ(triangle.winding(), 0);
    EXPECT_TRUE(triangle.row(1, -10, 10).empty());
    corners[2].y = std::nextafter(2.0F, 3.0F);  // one ulp off the line is a triangle
    EXPECT_EQ(ExactTriangle{std::span(corners).first<3>()}.winding(), 1);
}

}  // namespace
}  // namespace texelscope::triangle_test
