#include "core/fast/who_decided.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/exact/triangle.h"

namespace texelscope {
namespace {

using Corners = std::array<Vertex, 3>;

constexpr Rect kFrame{0, 0, 64, 48};
constexpr RasterTexture kTexture{.width = 16, .height = 16};

[[nodiscard]] Vertex corner(float x, float y, float u, float v) { return {.x = x, .y = y, .u = u, .v = v}; }

/// Decided are the pixels that the triangle owns, and no others.
void expect_owned(const Decisions& found, const Corners& corners) {
    const ExactTriangle exact(corners);
    for (int y = kFrame.y0; y < kFrame.y1; ++y) {
        const PixelRange row = exact.row(y, kFrame.x0, kFrame.x1);
        for (int x = kFrame.x0; x < kFrame.x1; ++x)
            EXPECT_EQ(found.pixels.at(x, y) != Decision::none, x >= row.x0 && x < row.x1) << x << ", " << y;
    }
}

TEST(WhoDecided, ABlitOnPixelsIsCertified) {
    const Corners corners{corner(4, 4, 0, 0), corner(20, 4, 16, 0), corner(4, 20, 0, 16)};
    const Decisions found = who_decided(corners, kTexture, kFrame);
    expect_owned(found, corners);
    EXPECT_GT(found.of(Decision::certificate), 100U);
    EXPECT_EQ(found.of(Decision::tie) + found.of(Decision::in_double) + found.of(Decision::wide), 0U);
    EXPECT_GT(found.u_bound, 0);
    EXPECT_LT(found.u_bound, 1e-6);
}

TEST(WhoDecided, ABlitBetweenPixelsIsAllTies) {
    const Corners corners{corner(4.5F, 4.5F, 0, 0), corner(20.5F, 4.5F, 16, 0), corner(4.5F, 20.5F, 0, 16)};
    const Decisions found = who_decided(corners, kTexture, kFrame);
    expect_owned(found, corners);
    EXPECT_EQ(found.of(Decision::certificate), 0U) << "u and v are whole at every sample";
    EXPECT_EQ(found.of(Decision::none), 0U) << "pixels outside are not counted";
    EXPECT_GT(found.of(Decision::tie), 100U);
}

TEST(WhoDecided, TiesAreTheSamplesWithWholeCoordinates) {
    // u = 3/8 (x - 44), v = 3/8 (y - 4) at pixel (x, y).
    const Corners corners{corner(44.5F, 4.5F, 0, 0), corner(60.5F, 4.5F, 6, 0), corner(44.5F, 20.5F, 0, 6)};
    const Decisions found = who_decided(corners, kTexture, kFrame);
    expect_owned(found, corners);
    for (int y = 4; y < 20; ++y)
        for (int x = 44; x < 60; ++x) {
            const Decision d = found.pixels.at(x, y);
            if (d == Decision::none) continue;
            const bool whole = (x - 44) % 8 == 0 || (y - 4) % 8 == 0;
            EXPECT_EQ(d == Decision::certificate, !whole) << x << ", " << y;
        }
}

TEST(WhoDecided, NearTiesAreCertainInDouble) {
    // 5/48 texels a pixel: float32 rounds u and v at the corners, so that columns 4 and 52 are ties and near ones.
    const auto moved = [](float px) { return px * 5 / 48; };
    const Corners corners{corner(4.5F, 2.5F, 0, 0), corner(60.5F, 2.5F, moved(56), 0),
                          corner(4.5F, 45.5F, 0, moved(43))};
    const Decisions found = who_decided(corners, kTexture, kFrame);
    expect_owned(found, corners);
    for (int y = 3; y < 40; ++y) EXPECT_EQ(found.pixels.at(4, y), Decision::tie) << y;
    EXPECT_EQ(found.of(Decision::in_double) + found.of(Decision::wide), 0U)
        << "it is drawn finely from the first row on";
    EXPECT_GT(found.of(Decision::certificate), 1000U);
}

TEST(WhoDecided, WhatDoubleDoesNotHoldIsDecidedExactly) {
    const Corners corners{corner(1e-30F, 2, 0, 0), corner(40, 5, 9, 1), corner(7, 30, 2, 8)};
    const Decisions found = who_decided(corners, kTexture, kFrame);
    expect_owned(found, corners);
    EXPECT_EQ(found.of(Decision::certificate), 0U);
    EXPECT_GT(found.of(Decision::wide) + found.of(Decision::exact), 100U);
    EXPECT_EQ(found.u_bound, 0) << "nothing cheap was computed";
}

TEST(WhoDecided, InPerspectiveThereIsNoBoundForAll) {
    Corners corners{corner(4, 4, 0, 0), corner(60, 6, 16, 0), corner(8, 44, 0, 16)};
    corners[1].w = 3;
    const Decisions found = who_decided(corners, kTexture, kFrame);
    expect_owned(found, corners);
    EXPECT_EQ(found.u_bound, 0);
    EXPECT_GT(found.of(Decision::certificate), 500U);
}

TEST(WhoDecided, ATriangleWithoutAreaOwnsNothing) {
    const Corners corners{corner(4, 4, 0, 0), corner(8, 8, 1, 1), corner(12, 12, 2, 2)};
    const Decisions found = who_decided(corners, kTexture, kFrame);
    for (const std::uint64_t count : found.count) EXPECT_EQ(count, 0U);
}

}  // namespace
}  // namespace texelscope
