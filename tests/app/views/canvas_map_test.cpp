#include "app/views/canvas_map.h"

#include <cmath>

#include <gtest/gtest.h>

namespace texelscope::canvas {
namespace {

constexpr ui::Area kArea{16, 56, 640, 480};

Framebuffer frame(int width, int height, int x = 0, int y = 0) {
    Framebuffer f;
    f.width = width, f.height = height, f.origin_x = x, f.origin_y = y;
    return f;
}

TEST(CanvasMap, FitIsTheReferenceAtTheReferenceSize) {
    const CanvasMap map = make_map(kArea, frame(32, 24), {});
    EXPECT_EQ(map.zoom, 20);
    EXPECT_EQ(map.place_of(glm::ivec2(0, 0)), (ui::Area{16, 56, 20, 20}));
    EXPECT_EQ(map.place_of(glm::ivec2(31, 23)), (ui::Area{636, 516, 20, 20}));
}

TEST(CanvasMap, FitShowsTheWholeFramebuffer) {
    for (const auto& [w, h] : {std::pair(1, 1), {7, 300}, {640, 480}, {641, 480}, {4096, 4096}, {16384, 2}}) {
        const Framebuffer f = frame(w, h, -5, 900);
        const CanvasMap map = make_map(kArea, f, {});
        EXPECT_TRUE(kArea.covers(map.place_of(f.rect()), 1)) << w << " x " << h;
        EXPECT_EQ(pixels_in_view(map, f), f.rect()) << w << " x " << h;
    }
}

TEST(CanvasMap, PixelsLieOnWholeWindowPixels) {
    Look look;
    look.centre = {11.37F, 7.91F};
    for (const float zoom : {1.0F, 2.4F, 7.7F, 33.0F, 500.0F}) {
        look.zoom = zoom;
        const CanvasMap map = make_map(kArea, frame(32, 24), look);
        EXPECT_EQ(map.zoom, std::floor(map.zoom));
        const glm::vec2 at = map.to_window({3, 4});
        EXPECT_EQ(at.x, std::round(at.x));
        EXPECT_EQ(at.y, std::round(at.y));
    }
}

TEST(CanvasMap, ToSceneUndoesToWindowFarFromTheOrigin) {
    const CanvasMap map = make_map(kArea, frame(32, 24, 500'000, -50'000), {});
    const glm::dvec2 p{500'011.25, -49'990.5};
    const glm::dvec2 back = map.to_scene(map.to_window(p));
    EXPECT_NEAR(back.x, p.x, 1e-4);
    EXPECT_NEAR(back.y, p.y, 1e-4);
    EXPECT_EQ(map.pixel_at(map.to_window(p)), glm::ivec2(500'011, -49'991));
}

TEST(CanvasMap, ZoomingKeepsThePointUnderTheMouse) {
    const Framebuffer f = frame(32, 24);
    const glm::vec2 mouse{201, 377};
    Look look;
    for (const float notches : {1.0F, 1.0F, 2.0F, -1.0F, 0.3F, -6.0F}) {
        const CanvasMap before = make_map(kArea, f, look);
        const glm::dvec2 fixed = before.to_scene(mouse);
        look = zoomed(look, before, f, mouse, notches);
        const CanvasMap after = make_map(kArea, f, look);
        // One window pixel: borders of pixels are kept whole.
        EXPECT_NEAR(after.to_window(fixed).x, mouse.x, 1);
        EXPECT_NEAR(after.to_window(fixed).y, mouse.y, 1);
    }
}

TEST(CanvasMap, AWholeNotchAlwaysShowsUntilTheEnd) {
    const Framebuffer f = frame(32, 24);
    Look look;
    double zoom = make_map(kArea, f, look).zoom;
    while (zoom < 128) {
        look = zoomed(look, make_map(kArea, f, look), f, {300, 300}, 1);
        const double next = make_map(kArea, f, look).zoom;
        ASSERT_GT(next, zoom);
        zoom = next;
    }
}

TEST(CanvasMap, PanningMovesBySoManyWindowPixels) {
    const Framebuffer f = frame(32, 24);
    const CanvasMap before = make_map(kArea, f, {});
    const CanvasMap after = make_map(kArea, f, panned({}, before, {37, -12}));
    EXPECT_EQ(after.zoom, before.zoom);
    EXPECT_EQ(after.at, before.at + glm::dvec2(37, -12));
}

TEST(CanvasMap, OnlyThePartInViewOfALargeSceneIsAskedFor) {
    const Framebuffer f = frame(4096, 4096);
    const Window whole = window_in_view(make_map(kArea, f, {}), f);
    EXPECT_EQ(whole.rect, f.rect());
    EXPECT_EQ(whole.stride, 9);
    Look look;
    look.zoom = 8, look.centre = {2000, 3000};
    const Window part = window_in_view(make_map(kArea, f, look), f);
    EXPECT_EQ(part.stride, 1);
    EXPECT_LE(part.rect.width(), 640 / 8 + 2);
    EXPECT_LE(part.rect.height(), 480 / 8 + 2);
    EXPECT_TRUE(part.rect.contains(2000, 3000));
}

TEST(CanvasMap, PanningAStridedWindowStaysOnItsGrid) {
    const Framebuffer f = frame(4096, 4096, 3, 5);
    Look look;
    look.zoom = .25F;
    for (const float x : {1500.0F, 1501.0F, 1777.0F}) {
        look.centre = {x, 2000};
        const Window window = window_in_view(make_map(kArea, f, look), f);
        EXPECT_EQ((window.rect.x0 - 3) % window.stride, 0);
        EXPECT_EQ((window.rect.y0 - 5) % window.stride, 0);
    }
}

TEST(CanvasMap, SmallFramebuffersAreAskedForWholeHoweverNear) {
    Look look;
    look.zoom = 96, look.centre = {5, 5};
    const Window window = window_in_view(make_map(kArea, frame(32, 24), look), frame(32, 24));
    EXPECT_EQ(window.rect, (Rect{0, 0, 32, 24}));
}

TEST(CanvasMap, LabelStepsArePowersOfTwoAtLeastSoWide) {
    EXPECT_EQ(label_step(20, 56), 4);
    EXPECT_EQ(label_step(20, 32), 2);
    EXPECT_EQ(label_step(64, 56), 1);
    EXPECT_EQ(label_step(1.0 / 9, 56), 512);
}

TEST(CanvasMap, AddressCountsRowAfterRow) {
    EXPECT_EQ(address_of(frame(640, 480), {13, 4}), 4 * 640 + 13);
    EXPECT_EQ(address_of(frame(32, 24, -8, 100), {-8, 100}), 0);
    EXPECT_EQ(address_of(frame(16384, 16384), {16383, 16383}), 16384LL * 16384 - 1);
}

TEST(CanvasMap, DraggedCornersSnapAndStayInView) {
    const CanvasMap map = make_map(kArea, frame(32, 24), {});
    const glm::vec2 mouse = map.to_window({7.33, 4.91});
    EXPECT_EQ(dragged_to(map, mouse, false), glm::vec2(7.3125F, 4.9375F));
    EXPECT_EQ(dragged_to(map, mouse, true), glm::vec2(7.5F, 4.5F));
    const glm::vec2 far = dragged_to(map, {-9000, 9000}, false);
    EXPECT_EQ(far, glm::vec2(0, 24));
}

}  // namespace
}  // namespace texelscope::canvas
