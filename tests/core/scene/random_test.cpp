#include "core/scene/random.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/polygon.h"
#include "core/scene/json.h"

namespace texelscope {
namespace {

Result<LoadedScene> with(const std::string& members) {
    return parse_scene("{ \"texelscope\": 1, \"framebuffer\": { \"width\": 640, \"height\": 480 }, " + members + " }",
                       "s.json", {});
}

TEST(Random, TheSameSeedGivesTheSameTrianglesAndAnotherOthers) {
    const auto a = with(R"("random": { "triangles": 50, "size": 80, "seed": 7 })"),
               b = with(R"("random": { "triangles": 50, "size": 80, "seed": 7 })"),
               c = with(R"("random": { "triangles": 50, "size": 80, "seed": 8 })");
    ASSERT_TRUE(a && b && c);
    EXPECT_EQ(a->scene.polygons, b->scene.polygons);
    EXPECT_NE(a->scene.polygons, c->scene.polygons);
    // One of them written down, so that no compiler or library changes the demonstration.
    EXPECT_EQ(a->scene.polygons[0].vertices[0].x * 16, std::floor(a->scene.polygons[0].vertices[0].x * 16));
}

TEST(Random, TrianglesLieInTheFrameAndAreOfTheSize) {
    const auto loaded = with(R"("random": { "triangles": 500, "size": 60 })");
    ASSERT_TRUE(loaded);
    ASSERT_EQ(loaded->scene.polygons.size(), 500U);
    int with_area = 0;
    for (const Polygon& p : loaded->scene.polygons) {
        ASSERT_TRUE(is_drawable(p));
        for (const Vertex& v : p.vertices) {
            EXPECT_GE(v.x, -1.0F / 16);
            EXPECT_LE(v.x, 640);
            EXPECT_GE(v.y, -1.0F / 16);
            EXPECT_LE(v.y, 480);
            EXPECT_LE(std::abs(v.x - p.vertices[0].x), 60 + 1.0F / 16);
        }
        with_area += doubled_area(p.vertices) != 0;
    }
    EXPECT_GT(with_area, 490);
}

TEST(Random, IsWrittenBackAsItWasAskedFor) {
    const auto loaded = with(R"("random": { "triangles": 12, "size": 33.5, "seed": 3 })");
    ASSERT_TRUE(loaded);
    const auto again = parse_scene(scene_to_json(loaded->scene), "again.json", {});
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->scene.random, loaded->scene.random);
    EXPECT_EQ(again->scene.polygons, loaded->scene.polygons);
}

TEST(Random, KindsAndWasteAreWrittenBackToo) {
    const auto loaded = with(R"("depth": "less", "random": { "triangles": 9, "kind": "slivers", "waste": 40 })");
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_EQ(loaded->scene.random->kind, RandomKind::slivers);
    EXPECT_EQ(loaded->scene.random->waste, 40);
    const auto again = parse_scene(scene_to_json(loaded->scene), "again.json", {});
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->scene.random, loaded->scene.random);
    EXPECT_EQ(again->scene.polygons, loaded->scene.polygons);
}

TEST(Random, FarFromTheOriginLieTheSameTriangles) {
    const auto near = with(R"("random": { "triangles": 60, "size": 90, "seed": 4 })"),
               far = parse_scene(R"({ "texelscope": 1, "framebuffer": { "width": 640, "height": 480,
                                      "origin": [524288, 524288] },
                                      "random": { "triangles": 60, "size": 90, "seed": 4 } })",
                                 "far.json", {});
    ASSERT_TRUE(near && far);
    for (std::size_t n = 0; n < 60; ++n)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vertex &a = near->scene.polygons[n].vertices[k], &b = far->scene.polygons[n].vertices[k];
            EXPECT_EQ(a.x + 524288, b.x);
            EXPECT_EQ(a.y + 524288, b.y);
        }
}

TEST(Random, SteepOnesDifferInDepthAndSliversAreThin) {
    const auto steep = with(R"("random": { "triangles": 60, "kind": "steep" })"),
               thin = with(R"("random": { "triangles": 60, "size": 100, "kind": "slivers" })");
    ASSERT_TRUE(steep && thin);
    for (const Polygon& p : steep->scene.polygons)
        for (const Vertex& v : p.vertices) EXPECT_TRUE(v.w >= 1 && v.w <= 16) << v.w;
    for (const Polygon& p : thin->scene.polygons) {
        const double area = std::abs(doubled_area(p.vertices));
        EXPECT_GT(area, 0);
        EXPECT_LE(area, 100 * 3.5);
    }
}

TEST(Random, PlacingAgainReplacesThem) {
    auto loaded = with(R"("random": { "triangles": 12 })");
    ASSERT_TRUE(loaded);
    loaded->scene.random->count = 5;
    place_random(loaded->scene);
    EXPECT_EQ(loaded->scene.polygons.size(), 5U);
    loaded->scene.random.reset();
    place_random(loaded->scene);
    EXPECT_TRUE(loaded->scene.polygons.empty());
}

TEST(Random, WrongNumbersAreNamed) {
    for (const char* wrong :
         {R"("random": {})", R"("random": { "triangles": 0 })", R"("random": { "triangles": 1e9 })",
          R"("random": { "triangles": 5, "size": 0 })", R"("random": { "triangles": 5, "size": "nan" })",
          R"("random": { "triangles": 5, "seed": -1 })", R"("random": { "triangles": 5, "kind": "round" })",
          R"("random": { "triangles": 5, "waste": 96 })", R"("random": 5)"}) {
        const auto loaded = with(wrong);
        ASSERT_FALSE(loaded) << wrong;
        EXPECT_EQ(loaded.error().where, "s.json:1") << wrong;
    }
}

}  // namespace
}  // namespace texelscope
