#include <gtest/gtest.h>

#include <cmath>

#include "app/lesson/questions.h"
#include "core/measure/bill.h"
#include "tests/app/state/random_fixture.h"

namespace texelscope::answers_race_test {
namespace {

/// The fixture's scene with other triangles, and questions about it.
struct Board {
    Scene scene;
    std::unique_ptr<Drawing> drawing;
    std::unique_ptr<Steps> steps;

    Board(int count, float size) : scene(random_document()->scene) {
        scene.random = RandomTriangles{count, size, 5};
        if (count == 0) scene.random.reset();
        place_random(scene);
        drawing = std::make_unique<Drawing>(scene, DrawSettings{find_method("edge-walk"), NumberFormat::f64, 0, {}});
        steps = std::make_unique<Steps>(*drawing);
    }
    [[nodiscard]] Accepted ask(const std::string& answer) {
        Prediction asked;
        asked.kind = find_question(answer.substr(0, answer.find(' ')))->kind;
        asked.answer = answer, asked.explain = "auto";
        return accepted(asked, *drawing, *steps, *parse_path("t1"));
    }
    [[nodiscard]] Integer operations(std::string_view method) {
        return bill_of(scene, *find_method(method)).whole().all();
    }
};

TEST(RaceQuestions, TheOrderIsThatOfTheCountedOperations) {
    Board board(20, 40);
    const Integer walk = board.operations("edge-walk"), edge = board.operations("edge-equations"),
                  weights = board.operations("barycentric");
    ASSERT_LT(walk, edge);
    ASSERT_LT(edge, weights);
    EXPECT_EQ(board.ask("operations-order edge-walk edge-equations barycentric").number, 123);
    EXPECT_EQ(board.ask("operations-order barycentric edge-walk edge-equations").number, 231);
    EXPECT_EQ(board.ask("operations-order edge-equations barycentric edge-walk").number, 312);
    EXPECT_EQ(board.ask("operations-order edge-equations barycentric edge-walk").tolerance, 0);
    EXPECT_EQ(board.ask("operations-order edge-walk edge-equations barycentric").step.text(), "t1");
}

TEST(RaceQuestions, SetUpTakesMoreOfSmallTriangles) {
    Board small(20, 5), large(20, 48);
    const Accepted most = small.ask("set-up-share"), least = large.ask("set-up-share");
    ASSERT_TRUE(most.number && least.number);
    EXPECT_GT(*most.number, *least.number + 20);
    EXPECT_EQ(most.step.text(), "t1/s0");
    EXPECT_NE(small.ask("set-up-share edge-equations").number, most.number);
}

TEST(RaceQuestions, TenMillionPixelsASecondIn1995) {
    Board board(12, 24);
    Integer pixels = 0;
    each_sample(*board.drawing, 0, 12, {board.scene.framebuffer.rect(), 1},
                [&](int, const Sample& s) { pixels += s.fate == Fate::written; });
    const Accepted a = board.ask("frames-1995");
    ASSERT_TRUE(a.number);
    EXPECT_NEAR(*a.number, 1e7 / static_cast<double>(pixels), 1e-6 * *a.number);
    EXPECT_NEAR(a.tolerance / *a.number, .05, 1e-12);
}

TEST(RaceQuestions, ASceneWithoutShapesHasNoAnswer) {
    Board board(0, 1);
    for (const char* question :
         {"set-up-share", "frames-1995", "operations-order edge-walk edge-equations barycentric"})
        EXPECT_FALSE(board.ask(question).number) << question;
}

TEST(RaceQuestions, OnlyRacersAreRanked) {
    const Method& method = *find_method("edge-walk");
    EXPECT_TRUE(parse_question("operations-order edge-walk sections barycentric", method));
    for (const char* bad : {"operations-order edge-walk sections", "operations-order edge-walk sections forward",
                            "operations-order edge-walk sections nobody", "set-up-share two-pass"})
        EXPECT_FALSE(parse_question(bad, method)) << bad;
}

}  // namespace
}  // namespace texelscope::answers_race_test
