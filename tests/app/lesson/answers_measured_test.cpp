#include <gtest/gtest.h>

#include "app/lesson/questions.h"
#include "app/lesson/random_text.h"
#include "core/measure/front.h"
#include "core/measure/skip_bill.h"
#include "core/method/decisions.h"
#include "tests/app/state/random_fixture.h"

namespace texelscope {
namespace {

struct Board {
    Scene scene;
    std::unique_ptr<Drawing> drawing;
    std::unique_ptr<Steps> steps;

    explicit Board(Scene made) : scene(std::move(made)) {
        drawing = std::make_unique<Drawing>(scene, DrawSettings{find_method("fast"), NumberFormat::f64, 0, {}});
        steps = std::make_unique<Steps>(*drawing);
    }
    [[nodiscard]] Accepted ask(const std::string& answer) {
        Prediction asked;
        asked.kind = find_question(answer.substr(0, answer.find(' ')))->kind;
        asked.answer = answer, asked.explain = "auto";
        return accepted(asked, *drawing, *steps, *parse_path("t0"));
    }
};
[[nodiscard]] Scene random_scene(int count) {
    Scene scene = random_document()->scene;
    scene.random->count = count;
    if (count == 0) scene.random.reset();
    place_random(scene);
    return scene;
}

TEST(MeasuredQuestions, AnErrorIsPlacedBesideTwoOthers) {
    Board board(random_scene(12));
    // 8 bits behind the point are more off than 16, and these than double.
    const std::string coarse = "edge-equations:fx8.8 ", fine = "edge-equations:fx16.16 ", best = "edge-equations:f64 ";
    EXPECT_EQ(board.ask("error-place " + fine + best + coarse).options, std::vector<int>{1});
    EXPECT_EQ(board.ask("error-place " + fine + coarse + best).options, std::vector<int>{1});
    EXPECT_EQ(board.ask("error-place " + coarse + best + fine).options, std::vector<int>{2});
    EXPECT_EQ(board.ask("error-place " + best + fine + coarse).options, std::vector<int>{0});
    EXPECT_EQ(board.ask("error-place " + best + fine + coarse).step.text(), "t0");
    EXPECT_EQ(Board(random_scene(0)).ask("error-place " + best + fine + coarse).options, std::vector<int>{1})
        << "none of them errs";
}

TEST(MeasuredQuestions, WhatMustBeDrawnIsCountedAndScaled) {
    Scene scene = random_scene(500);
    scene.depth = Depth::less, scene.cull = Cull::back;
    scene.random->size = 6;
    place_random(scene);
    const auto drawn = static_cast<double>(count_skips(scene, kAllSkips).counters.drawn);
    const Accepted a = Board(scene).ask("needed 1000000");
    ASSERT_TRUE(a.number);
    EXPECT_DOUBLE_EQ(*a.number, drawn * 2000);
    EXPECT_NEAR(a.tolerance, *a.number / 10, 1e-6);
    scene.random->waste = 90;
    place_random(scene);
    EXPECT_LT(*Board(scene).ask("needed 1000000").number, *a.number / 2);
    EXPECT_FALSE(Board(random_scene(0)).ask("needed 10").number);
}

TEST(MeasuredQuestions, UncertainPixelsAreThoseOnBorders) {
    Scene scene = random_scene(0);
    Polygon polygon;
    for (const auto& [x, y, u, v] :
         {std::array{4.5F, 4.5F, 0.0F, 0.0F}, {20.5F, 4.5F, 6.0F, 0.0F}, {4.5F, 20.5F, 0.0F, 6.0F}})
        polygon.vertices.push_back({.x = x, .y = y, .u = u, .v = v});
    scene.polygons.push_back(polygon);
    const Accepted a = Board(scene).ask("uncertain");
    ASSERT_FALSE(a.places.empty());
    for (const glm::ivec2 p : a.places) EXPECT_TRUE((p.x - 4) % 8 == 0 || (p.y - 4) % 8 == 0) << p.x << ", " << p.y;
    EXPECT_EQ(a.step.text().substr(0, 3), "t0/");
    // Moved by half a pixel no u and no v is a whole number.
    for (Vertex& vertex : scene.polygons[0].vertices) vertex.x += .5F, vertex.y += .5F;
    EXPECT_TRUE(Board(scene).ask("uncertain").places.empty());
}

TEST(MeasuredQuestions, WrongRungsAreNamed) {
    const auto call = parse_question("error-place fast slow exact", *find_method("fast"));
    ASSERT_FALSE(call);
    EXPECT_NE(call.error().what.find("'slow'"), std::string::npos);
}

TEST(RandomText, IsReadAsItWasWritten) {
    RandomTriangles random{48, 96.5F, 7};
    EXPECT_EQ(text_of(random), "48 96.5 7");
    EXPECT_EQ(parse_random("48 96.5 7"), random);
    random.kind = RandomKind::steep, random.distance = 16, random.waste = 5;
    EXPECT_EQ(text_of(random, ','), "48,96.5,7,steep,16,5");
    EXPECT_EQ(parse_random("48,96.5,7,steep,16,5", ','), random);
    for (const char* wrong :
         {"", "48 96", "48 96 7 steep", "48 96 7 round 0 0", "48 96 7 plain 20 0", "48 96 7 plain 0 96", "0 96 7",
          "48 0 7", "48 96 10000", "48 96 7 plain 0 0 0", "48  96 7"})
        EXPECT_FALSE(parse_random(wrong)) << wrong;
}

}  // namespace
}  // namespace texelscope
