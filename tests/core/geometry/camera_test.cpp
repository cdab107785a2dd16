#include "core/geometry/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <random>

namespace texelscope {
namespace {

double distance(const glm::dmat3& a, const glm::dmat3& b) {
    double most = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) most = std::max(most, std::fabs(a[column][row] - b[column][row]));
    return most;
}

double from_orthonormal(const glm::dmat3& m) { return distance(glm::transpose(m) * m, glm::dmat3(1)); }

TEST(Rotation, IsThePublishedOne) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-200, 200);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 degrees(number(random), number(random), number(random));
        double x = number(random), y = number(random), z = number(random);
        const glm::dvec3 turned = rotation(degrees) * glm::dvec3(x, y, z);
        const auto turn = [](double& p, double& q, double angle) {
            const double c = std::cos(glm::radians(angle)), s = std::sin(glm::radians(angle));
            const double p1 = p * c + q * s;
            q = q * c - p * s, p = p1;
        };
        turn(x, y, degrees.z), turn(x, z, degrees.y), turn(y, z, degrees.x);
        ASSERT_NEAR(glm::length(turned - glm::dvec3(x, y, z)), 0, 1e-12);
    }
}

TEST(Rotation, AnglesOfItGiveItBack) {
    std::mt19937 random(2);
    for (int i = 0; i < 20000; ++i) {
        const auto angle = [&] {
            return i % 2 == 0 ? static_cast<int>(random() % 9) * 45.0 - 180 : static_cast<double>(random()) * 1e-7;
        };
        const double x = angle(), y = angle();
        const glm::dmat3 m = rotation({x, y, angle()});
        const glm::dvec3 angles = angles_of(m);
        ASSERT_LT(distance(rotation(angles), m), 1e-8) << x << ", " << y;
        ASSERT_LE(std::fabs(angles.y), 90);
    }
}

TEST(Turned, IsTheRotationAboutTheSameAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 degrees(0);
        degrees[axis] = 17;
        EXPECT_LT(distance(turned(glm::dmat3(1), axis, 17), rotation(degrees)), 1e-15);
        const glm::dmat3 before = rotation({10, 20, 30});
        EXPECT_LT(distance(turned(before, axis, 17), rotation(degrees) * before), 1e-15);
    }
}

TEST(Turned, StaysOrthonormalOverAHundredThousandSteps) {
    std::mt19937 random(3);
    glm::dmat3 m(1);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        m = turned(m, static_cast<int>(random() % 3), static_cast<double>(random()) * 1e-8 - 20);
        worst = std::max(worst, from_orthonormal(m));
    }
    EXPECT_LT(worst, 2e-15);
    EXPECT_NEAR(glm::determinant(m), 1, 1e-15);
}

TEST(Projection, IsThePublishedOne) {
    const Viewpoint view{.middle_x = 960, .middle_y = 540, .focal = 1920, .near = 0.5};
    const Vertex v = to_screen(view, to_clip(view, {1.25, 0.75, 6.5}));
    EXPECT_EQ(v.x, static_cast<float>(960 + 1.25 * 1920 / 6.5));
    EXPECT_EQ(v.y, static_cast<float>(540 - 0.75 * 1920 / 6.5));
    EXPECT_EQ(v.w, 6.5F);
    EXPECT_EQ(v.z, static_cast<float>(1 - 0.5 / 6.5));
}

/// The depth at the middle between two corners on the screen is the mean of theirs: a plane stays a plane.
TEST(Projection, DepthIsAffineOverTheScreen) {
    const Viewpoint view{.middle_x = 100, .middle_y = 100, .focal = 300, .near = 0.25};
    const glm::dvec3 p(-3, 1, 4), q(5, -2, 19);
    const auto depth = [&](const glm::dvec3& point) {
        const glm::dvec4 c = to_clip(view, point);
        return glm::dvec3(c) / c.w;
    };
    const glm::dvec3 on_screen = (depth(p) + depth(q)) / 2.0;
    const double t = 4.0 / (4.0 + 19.0);  // where the middle of the screen lies on the line
    EXPECT_NEAR(glm::length(depth(p + (q - p) * t) - on_screen), 0, 1e-13);
}

TEST(NearPlane, CutsBeforeDividing) {
    std::mt19937 random(4);
    for (int i = 0; i < 20000; ++i) {
        const double size = std::pow(10.0, static_cast<int>(random() % 16));
        const Viewpoint view{.focal = 300, .near = std::pow(10.0, static_cast<int>(random() % 9) - 6)};
        ClipRing ring;
        for (int corner = 0; corner < 3; ++corner) {
            const auto number = [&] { return (static_cast<double>(random()) / 2147483648.0 - 1) * size; };
            const double x = number(), y = number();
            ring.push_back(clip_vertex(to_clip(view, {x, y, number()}), {x, y}));
        }
        if (i % 7 == 0) ring[0].position = to_clip(view, {1, 1, view.near});
        for (const ClipVertex& vertex : clip_near(view, ring).inside) {
            ASSERT_GE(vertex.position.w, view.near);
            const Vertex corner = to_screen(view, vertex.position);
            ASSERT_TRUE(std::isfinite(corner.x) && std::isfinite(corner.y));
            ASSERT_GT(corner.w, 0);
            ASSERT_TRUE(corner.z >= 0 && corner.z <= 1);
        }
    }
}

}  // namespace
}  // namespace texelscope
