// Questions about walked rows, limited numbers and weights.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "app/lesson/questions.h"
#include "core/image/patterns.h"

namespace texelscope::answers_numbers_test {
namespace {

struct Board {
    std::unique_ptr<Scene> scene;
    std::unique_ptr<Drawing> drawing;
    std::unique_ptr<Steps> steps;

    Board(std::vector<Vertex> corners, std::string_view method, NumberFormat format) {
        scene = std::make_unique<Scene>();
        scene->framebuffer.width = 60, scene->framebuffer.height = 60;
        Texture texture;
        texture.texels = make_pattern(Pattern::address, 256, 128, 1);
        scene->textures.push_back(std::make_shared<Texture>(texture));
        scene->polygons.push_back({.vertices = std::move(corners), .texture = 0, .light = 1});
        drawing = std::make_unique<Drawing>(*scene, DrawSettings{find_method(method), format, 0, {}});
        steps = std::make_unique<Steps>(*drawing);
    }
    [[nodiscard]] Accepted ask(std::string_view answer) {
        Prediction asked;
        asked.kind = find_question(answer.substr(0, answer.find(' ')))->kind;
        asked.answer = answer;
        asked.explain = "auto";
        return accepted(asked, *drawing, *steps, parse_path("t0/s0").value());
    }
};

[[nodiscard]] Vertex corner(float x, float y, float u = 0, float v = 0) {
    return {.x = x, .y = y, .w = 1, .u = u, .v = v};
}
[[nodiscard]] std::vector<Vertex> steep() {
    return {corner(4.25F, 3.5F), corner(52.25F, 5.5F, 256, 0), corner(10.5F, 42.3125F, 0, 128)};
}

TEST(DoubleRow, IsTheRowOfTheMiddleCornerAndNoneWhereHalvesAreHalfOpen) {
    Board board({corner(15, 2), corner(28, 12.75F), corner(4, 21)}, "edge-walk", NumberFormat::f64);
    const Accepted twice = board.ask("double-row inclusive=on");
    ASSERT_TRUE(twice.number);
    EXPECT_EQ(*twice.number, 13);
    EXPECT_EQ(twice.step.index_of('y'), 13);
    EXPECT_FALSE(board.ask("double-row").number);
}

TEST(FirstFlip, IsTheLeastDistanceWithAWrongTexel) {
    Board board(steep(), "edge-equations", NumberFormat::f32);
    EXPECT_EQ(board.ask("first-flip 0 100 50000 500000").options, std::vector<int>{2});
    EXPECT_EQ(board.ask("first-flip 50000 500000 600000 700000").options, std::vector<int>{0});
}

TEST(FirstFlip, IsNoneWhereTheErrorDoesNotGrow) {
    Board board(steep(), "edge-equations", NumberFormat::f32);
    EXPECT_EQ(board.ask("first-flip 0 100 50000 500000 based=on").options, std::vector<int>{4});
    Board exact(steep(), "edge-equations", NumberFormat::exact);
    EXPECT_EQ(exact.ask("first-flip 0 100 50000 500000").options, std::vector<int>{4});
}

TEST(WeightsAt, AreThePixelsRoundTheWeightedMeanOfTheCorners) {
    for (const bool turned : {false, true}) {
        std::vector<Vertex> p = steep();
        if (turned) std::swap(p[1], p[2]);
        Board board(p, "barycentric", NumberFormat::f64);
        const Accepted a = board.ask("weights-at 0.2 0.3 0.5");
        const double x = .2 * double{p[0].x} + .3 * double{p[1].x} + .5 * double{p[2].x};
        const double y = .2 * double{p[0].y} + .3 * double{p[1].y} + .5 * double{p[2].y};
        const glm::ivec2 meant(std::floor(x), std::floor(y));
        EXPECT_NE(std::find(a.places.begin(), a.places.end(), meant), a.places.end());
        for (const glm::ivec2 place : a.places) {
            EXPECT_LE(std::abs(place.x - meant.x), 4);
            EXPECT_LE(std::abs(place.y - meant.y), 4);
        }
        EXPECT_TRUE(a.step.index_of('x'));
    }
}

TEST(WeightsAt, AreNowhereOutsideOfTheTriangle) {
    Board board(steep(), "barycentric", NumberFormat::f64);
    EXPECT_TRUE(board.ask("weights-at 3 -1 -1").places.empty());
}

}  // namespace
}  // namespace texelscope::answers_numbers_test
