#include "core/measure/rung_picture.h"

#include <gtest/gtest.h>

#include "core/scene/scene.h"

namespace texelscope {
namespace {

[[nodiscard]] FrontScene some_triangles(RandomKind kind, int origin) {
    Scene scene;
    scene.framebuffer = {96, 72, origin, origin, {}};
    scene.random = RandomTriangles{16, 64, 7};
    scene.random->kind = kind;
    place_random(scene);
    for (Polygon& polygon : scene.polygons)
        for (Vertex& vertex : polygon.vertices) vertex.u *= 4, vertex.v *= 4;
    return front_scene_of(scene);
}
[[nodiscard]] RungPicture picture_of(const char* rung, RandomKind kind = RandomKind::plain, int origin = 0) {
    return rung_picture(some_triangles(kind, origin), *find_rung(rung));
}

TEST(RungPicture, ExactOnesAreRight) {
    for (const char* rung : {"fast", "exact"}) {
        const RungPicture picture = picture_of(rung, RandomKind::steep);
        EXPECT_GT(picture.right, 1000) << rung;
        EXPECT_EQ(picture.wrong + picture.missing + picture.extra, 0) << rung;
    }
}

TEST(RungPicture, CountsAreThoseOfThePixels) {
    const RungPicture picture = picture_of("edge-equations:fx8.8");
    Integer wrong = 0, missing = 0, extra = 0;
    for (std::size_t n = 0; n < picture.pixels.size(); ++n) {
        const PixelVerdict verdict = picture.pixels.data()[n];
        wrong += verdict == PixelVerdict::wrong, missing += verdict == PixelVerdict::missing;
        extra += verdict == PixelVerdict::extra;
    }
    EXPECT_GT(picture.wrong, 100) << "eight bits behind the point are few";
    EXPECT_EQ(picture.wrong, wrong);
    EXPECT_EQ(picture.missing, missing);
    EXPECT_EQ(picture.extra, extra);
}

TEST(RungPicture, PlainFloatLosesItsTexelsFarFromTheOrigin) {
    const Integer near = picture_of("edge-equations:f32").wrong,
                  far = picture_of("edge-equations:f32", RandomKind::plain, 1 << 16).wrong;
    EXPECT_GT(far, 10 * near + 100);
}

TEST(RungPicture, SlowOnesDrawTheFirstTrianglesOnly) {
    const RungPicture picture = picture_of("barycentric:exact");
    EXPECT_LT(picture.triangles, 16U);
    EXPECT_EQ(picture.wrong + picture.missing + picture.extra, 0);
}

TEST(FrontSceneOf, TurnsTrianglesToUsAndLeavesOutWhatCannotBeDrawn) {
    Scene scene;
    const auto polygon = [&](std::vector<Vertex> vertices) {
        scene.polygons.push_back({.vertices = std::move(vertices)});
    };
    polygon({{.x = 1, .y = 1}, {.x = 1, .y = 9}, {.x = 9, .y = 1}});                    // from behind
    polygon({{.x = 1, .y = 1}, {.x = 5, .y = 5}, {.x = 9, .y = 9}});                    // no area
    polygon({{.x = 1, .y = 1}, {.x = NAN, .y = 5}, {.x = 9, .y = 9}});                  // no number
    polygon({{.x = 1, .y = 1}, {.x = 9, .y = 1}, {.x = 9, .y = 9}, {.x = 1, .y = 9}});  // two triangles
    polygon({{.x = 1, .y = 1, .w = 0}, {.x = 9, .y = 1}, {.x = 9, .y = 9}});            // behind the eye
    const FrontScene front = front_scene_of(scene);
    ASSERT_EQ(front.triangles(), 3U);
    for (std::size_t n = 0; n < 3; ++n) {
        const auto p = front.corners(n);
        EXPECT_GT((p[1].x - p[0].x) * (p[2].y - p[0].y), (p[2].x - p[0].x) * (p[1].y - p[0].y));
    }
}

}  // namespace
}  // namespace texelscope
