#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/lesson/facts.h"
#include "app/lesson/questions.h"
#include "core/scene/place.h"
#include "core/trace/listing.h"

namespace texelscope::questions_test {
namespace {

/// A drawing with its scene and steps.
struct Board {
    std::unique_ptr<Scene> scene = std::make_unique<Scene>();
    std::unique_ptr<Drawing> drawing;
    std::unique_ptr<Steps> steps;

    Board(Scene made, std::string_view method, std::string_view variant)
        : scene(std::make_unique<Scene>(std::move(made))) {
        const Method& found = *find_method(method);
        drawing =
            std::make_unique<Drawing>(*scene, DrawSettings{&found, NumberFormat::f64, quirks_of(found, variant), {}});
        steps = std::make_unique<Steps>(*drawing);
    }
    [[nodiscard]] Accepted ask(std::string_view answer, std::string_view at = "t0/s0") {
        const Question* question = find_question(answer.substr(0, answer.find(' ')));
        Prediction asked;
        asked.kind = question->kind;
        asked.answer = answer;
        asked.explain = "auto";
        return accepted(asked, *drawing, *steps, parse_path(at).value());
    }
};

[[nodiscard]] Scene scene_of(int width, int height, std::vector<std::vector<Vertex>> polygons) {
    Scene scene;
    scene.framebuffer.width = width, scene.framebuffer.height = height;
    Texture texture;
    texture.texels = make_pattern(Pattern::address, 16, 16, 1);
    scene.textures.push_back(std::make_shared<Texture>(texture));
    for (auto& vertices : polygons)
        scene.polygons.push_back({.vertices = std::move(vertices), .texture = 0, .light = 1});
    return scene;
}

[[nodiscard]] Vertex corner(float x, float y, float u = 0, float v = 0) {
    return {.x = x, .y = y, .z = 0, .w = 1, .u = u, .v = v};
}

[[nodiscard]] Scene square(int n) {
    const auto far = static_cast<float>(4 + n);
    return scene_of(n + 8, n + 8,
                    {{corner(4, 4), corner(far, 4, 16, 0), corner(far, far, 16, 16), corner(4, far, 0, 16)}});
}

[[nodiscard]] Scene cramer() {
    return scene_of(32, 24,
                    {{corner(3.5F, 20.25F, 1, 12), corner(11.25F, 1.75F, 5, 1), corner(29.75F, 15.25F, 15, 15)}});
}

[[nodiscard]] Scene half_planes() {
    return scene_of(32, 24, {{corner(6.5F, 3.25F), corner(27.25F, 9.5F), corner(11.75F, 21.5F)}});
}

[[nodiscard]] Scene pentagon() {
    return scene_of(32, 24,
                    {{corner(14, 2, 8, .5F), corner(27, 7, 15.5F, 6), corner(24, 19, 12.75F, 15),
                      corner(9, 22, 3.25F, 15), corner(4, 10, .5F, 6)},
                     {corner(29, 12, 8, 1), corner(27, 20, 4, 10), corner(31, 22, 12, 12)}});
}

TEST(Questions, ASquareOfNPixelsHasNDoublesAtCentresAndOneMoreAtCorners) {
    for (int n = 1; n <= 16; ++n) {
        Board board(square(n), "edge-equations", "corrected");
        EXPECT_EQ(board.ask("doubles").number, 0) << n;
        EXPECT_EQ(board.ask("drawn").number, n * n) << n;
        EXPECT_EQ(board.ask("doubles inclusive=on").number, n) << n;
        EXPECT_EQ(board.ask("doubles inclusive=on corners=on").number, n + 1) << n;
        EXPECT_EQ(board.ask("drawn inclusive=on corners=on").number, (n + 1) * (n + 1)) << n;
    }
}

TEST(Questions, Byte137IsTheBlueOfPixel45) {
    Board board(half_planes(), "edge-equations", "corrected");
    const Accepted a = board.ask("pixel-of-byte 137");
    ASSERT_EQ(a.places.size(), 1U);
    EXPECT_EQ(a.places[0], glm::ivec2(13, 1));
    EXPECT_NE(a.sentence.find("blue of pixel 45"), std::string::npos);
    EXPECT_TRUE(board.ask("pixel-of-byte 2304").places.empty());
}

TEST(Questions, BytesAndPixelsAreInverse) {
    Board board(half_planes(), "edge-equations", "corrected");
    for (int byte = 0; byte < 32 * 24 * 3; byte += 7) {
        const glm::ivec2 p = board.ask("pixel-of-byte " + std::to_string(byte)).places.at(0);
        const std::string place = std::to_string(p.x) + " " + std::to_string(p.y);
        EXPECT_EQ(board.ask("byte-of-pixel " + place + " " + std::to_string(byte % 3)).number, byte);
        EXPECT_EQ(board.ask("address-of " + place).number, byte / 3);
    }
}

TEST(Questions, TheSecondSideRejectsTheSampleOfLessonFive) {
    Board board(half_planes(), "edge-equations", "corrected");
    const Accepted a = board.ask("fate 23 14");
    EXPECT_EQ(a.options, std::vector{2});
    EXPECT_EQ(a.step.text(), "t0/s5/y14/x23");
    EXPECT_EQ(board.ask("fate 1 1").options, std::vector{4});
    EXPECT_EQ(board.ask("fate 12 9").options, std::vector{0});
    EXPECT_EQ(board.ask("box-samples").number, 22 * 19);
}

TEST(Questions, ExchangedCornersDrawTheSameUnlessOneWindingIsCulled) {
    Board board(half_planes(), "edge-equations", "corrected");
    EXPECT_EQ(board.ask("drawn-after-exchange 1 2").options, std::vector{0});
    EXPECT_EQ(board.ask("drawn-after-exchange 1 2 one_winding=on").options, std::vector{1});
    Board flat(scene_of(8, 8, {{corner(1, 1), corner(2, 2), corner(3, 3)}}), "edge-equations", "corrected");
    EXPECT_EQ(flat.ask("drawn-after-exchange 0 1").options, (std::vector{0, 1}));
}

TEST(Questions, OneUChangesTheThreeCoefficientsOfU) {
    Board board(cramer(), "edge-equations", "corrected");
    const Accepted a = board.ask("changed-coefficients u1 5 7");
    EXPECT_EQ(a.options, (std::vector{0, 1, 2}));
    ASSERT_EQ(a.option_steps.size(), 6U);
    EXPECT_EQ(a.option_steps[1].text(), "t0/s1/e1");
    EXPECT_EQ(board.ask("changed-coefficients v2 15 3").options, (std::vector{3, 4, 5}));
    EXPECT_EQ(board.ask("changed-coefficients x1 11.25 9").options.size(), 6U);
    EXPECT_TRUE(board.ask("changed-coefficients u1 5 5").options.empty());
}

TEST(Questions, TheNextPixelIsOneGradientAway) {
    Board board(cramer(), "edge-equations", "corrected");
    const double here = *board.ask("value u", "t0/s5/y11/x16").number,
                 next = *board.ask("value u 1 0", "t0/s5/y11/x16").number;
    EXPECT_NEAR(here, 7.8842, 5e-5);
    EXPECT_NEAR(next - here, *board.ask("value u_x", "t0/s5/y11/x16").number, 1e-12);
    EXPECT_EQ(board.ask("texel-of 16 11", "t0/s5/y11/x16").places.at(0), glm::ivec2(7, 9));
    EXPECT_FALSE(board.ask("value u 1 0", "t0/s1").number);
    EXPECT_FALSE(board.ask("value nothing", "t0/s1").number);
}

TEST(Facts, AnEquationIsOneWhereItsDecimalsSayAll) {
    EXPECT_EQ(equation("u", 8.25, 4), "u = 8.25");
    EXPECT_EQ(equation("u", -0.0625, 4), "u = -0.0625");
    EXPECT_EQ(equation("u", 0.03125, 4), "u \\approx 0.0312");
    EXPECT_EQ(equation("v", 3, 2), "v = 3");
    EXPECT_EQ(equation("v", 1.0 / 3, 2), "v \\approx 0.33");
}

TEST(Questions, AnExactValueIsSaidToBeOne) {
    Board board(scene_of(8, 8, {{corner(0, 0), corner(8, 0, 4), corner(0, 8)}}), "edge-equations", "corrected");
    EXPECT_EQ(board.ask("value u", "t0/s5/y1/x2").sentence, "$u = 1.25$ there.");
    EXPECT_EQ(board.ask("texel-of 2 1", "t0").sentence, "$u = 1.25$ and $v = 0$: column 1, row 0.");
}

TEST(Facts, OfAStepThatExistsNothingIsMissing) {
    for (const std::string_view method : {"edge-equations", "sections"}) {
        Board board(square(2), method, "corrected");
        int steps = 0;
        for (int level = 0; level < kLevels; ++level) {
            for (auto path = board.steps->first(static_cast<Level>(level)); path;
                 path = board.steps->next(*path, static_cast<Level>(level)), ++steps)
                EXPECT_EQ(missing_part(*board.steps, *path), std::nullopt) << path->text();
        }
        EXPECT_GT(steps, 50);
    }
}

TEST(Facts, WhatIsMissingIsSaidWithWhatIsThere) {
    Board board(square(2), "edge-equations", "corrected");
    const auto missing = [&](std::string_view path) {
        return missing_part(*board.steps, *parse_path(path)).value_or("");
    };
    EXPECT_EQ(missing("t2"), "the scene has t0 to t1");
    EXPECT_EQ(missing("t0/s6"), "t0 has s0 to s5");
    EXPECT_EQ(missing("t0/s1/e3"), "t0/s1 has e0 to e2");
    EXPECT_EQ(missing("t0/s1/y3"), "t0/s1 has e0 to e2");
    EXPECT_EQ(missing("t0/s5/y40/x5/e2"), "t0/s5 has y4 to y6");
    Board empty(scene_of(8, 8, {}), "edge-equations", "corrected");
    EXPECT_EQ(missing_part(*empty.steps, *parse_path("t0")), "the scene has no shape");
}

TEST(Questions, APentagonHasFourSectionsAndItsPointersTakeTurns) {
    Board board(pentagon(), "sections", "as-printed");
    EXPECT_EQ(board.ask("sections").number, 4);
    EXPECT_EQ(board.ask("next-pointer", "t0/s1").options, std::vector{1});
    EXPECT_EQ(board.ask("next-pointer", "t0/s2/y8").options, std::vector{0});
    EXPECT_EQ(board.ask("next-pointer", "t0/s3/y14").options, std::vector{1});
    EXPECT_EQ(board.ask("next-pointer", "t0/s4").options, std::vector{2});
    EXPECT_EQ(board.ask("row-pixels", "t0/s3/y14").number, 19);
}

TEST(Questions, TheGhostStandsInTheFreshBuffersFirstPixel) {
    Board printed(pentagon(), "sections", "as-printed"), corrected(pentagon(), "sections", "corrected");
    const Accepted a = printed.ask("ghost");
    ASSERT_EQ(a.places.size(), 1U);
    EXPECT_EQ(a.places[0], glm::ivec2(0, 0));
    EXPECT_EQ(a.step.text(), "t1/s1/y14");
    EXPECT_TRUE(corrected.ask("ghost").places.empty());
}

TEST(Questions, OnTheDiagonalTheTopLeftRuleNamesOneOwner) {
    Board board(square(8), "edge-equations", "corrected");
    EXPECT_EQ(board.ask("owner 6 6").options, std::vector{0});
    EXPECT_EQ(board.ask("owner 6 6 inclusive=on").options, std::vector{2});
    EXPECT_EQ(board.ask("owner 5 7").options, std::vector{1});
    EXPECT_EQ(board.ask("owner 1 1").options, std::vector{3});
}

TEST(Questions, GuiltyLinesAskForTheQuirk) {
    Board board(half_planes(), "edge-equations", "corrected");
    const Listing listing = load_listing("core/method/edge_equations.h");
    for (const QuirkInfo& quirk : find_method("edge-equations")->quirks) {
        const Accepted a = board.ask("guilty-line " + std::string(quirk.field));
        ASSERT_FALSE(a.places.empty()) << quirk.field;
        for (const glm::ivec2 place : a.places) {
            EXPECT_NE(listing.lines.at(static_cast<std::size_t>(place.x) - 1).find("quirk." + std::string(quirk.field)),
                      std::string::npos);
        }
    }
}

TEST(Questions, EachIsNamedOnceAndDocumented) {
    for (const Question& question : questions()) {
        EXPECT_EQ(find_question(question.name), &question);
        EXPECT_FALSE(question.says.empty());
        const bool offers = question.kind == Prediction::Kind::choice || question.kind == Prediction::Kind::many;
        EXPECT_EQ(option_count(question) > 0, offers) << question.name;
    }
    EXPECT_EQ(find_question("meaning-of-life"), nullptr);
}

/// A call of each question, with arguments that fit.
[[nodiscard]] std::string call_of(const Question& question, int a, int b) {
    if (question.form == "CORNER FROM TO") return std::string(question.name) + " u1 2 5.5";
    if (question.form == "NAME DX? DY?") return std::string(question.name) + " u 1 0";
    if (question.form == "FIELD")
        return std::string(question.name) + (question.method == "sections" ? " ghost" : " inclusive");
    std::string call(question.name);
    if (question.form == "A B") return call + " 1 2";
    if (question.form == "V") return call + " " + std::to_string(std::abs(b) % 3);
    if (question.form == "RACER RACER RACER") return call + " sections edge-walk barycentric";
    if (question.form == "RACER?") return call + " sections";
    if (question.form.starts_with("METHOD")) return call + (a % 2 == 0 ? " barycentric" : " forward as-printed fx8.8");
    if (question.form == "RUNG RUNG RUNG") return call + " fixed-steps edge-equations:f64 edge-equations:f32";
    if (question.form == "TRIANGLES") return call + " 1000";
    if (question.name == "first-flip") return call + " 0 100 10000 1000000";
    if (question.form == "N") return call + " " + std::to_string(100 * a);
    if (!question.form.empty()) call += " " + std::to_string(a) + " " + std::to_string(b);
    if (question.form == "X Y C") call += " 1";
    return call;
}

TEST(Questions, AnyCoordinatesGiveOneAnswerAndAStepThatExists) {
    std::mt19937 random(7);  // NOLINT: the same scenes every time
    std::uniform_int_distribution<int> quarter(-20, 160), kind(0, 9), pixel(-1, 33);
    for (int n = 0; n < 60; ++n) {
        std::vector<Vertex> corners(3);
        for (Vertex& p : corners)
            p = corner(static_cast<float>(quarter(random)) / 4, static_cast<float>(quarter(random)) / 4,
                       static_cast<float>(quarter(random)), 3);
        if (kind(random) == 0) corners[2] = corners[1];
        if (kind(random) == 0) corners[0].x = NAN;
        if (kind(random) == 0) corners[1].x = 1e30F;
        for (const std::string_view method : {"edge-equations", "sections"}) {
            Board board(scene_of(32, 24, {corners}), method, kind(random) < 5 ? "as-printed" : "corrected");
            for (const Question& question : questions()) {
                if (!question.method.empty() && question.method != method) continue;
                if (question.form == "FIELD" && method == "sections") continue;
                const std::string call = call_of(question, pixel(random), pixel(random));
                for (const std::string_view at : {"t0/s0", "t0/s3/y4/x5"}) {
                    const Accepted once = board.ask(call, at), twice = board.ask(call, at);
                    EXPECT_EQ(once.options, twice.options);
                    EXPECT_EQ(once.number, twice.number);
                    EXPECT_EQ(once.places, twice.places);
                    EXPECT_FALSE(once.sentence.empty()) << call;
                    EXPECT_TRUE(board.steps->nearest(once.step, Level::pixel)) << call;
                    EXPECT_TRUE(question.kind != Prediction::Kind::choice || !once.options.empty()) << call;
                }
            }
        }
    }
}

[[nodiscard]] Scene with_mesh(Shape3d shape, const glm::vec3& rotate) {
    Scene scene = scene_of(64, 48, {});
    scene.cull = Cull::back;
    scene.meshes.resize(1);
    scene.meshes[0].shape = shape, scene.meshes[0].rotate = rotate, scene.meshes[0].move = {0, 0, 8};
    place_meshes(scene);
    return scene;
}

TEST(Questions, ACubeShowsOneTwoOrThreeFacesAndSolidsOppositeOnesNeverBoth) {
    const auto visible = [](Shape3d shape, const glm::vec3& rotate) {
        return Board(with_mesh(shape, rotate), "sections", "corrected").ask("visible-faces").number;
    };
    EXPECT_EQ(visible(Shape3d::cube, {0, 0, 0}), 1);
    EXPECT_EQ(visible(Shape3d::cube, {0, 40, 0}), 2);
    EXPECT_EQ(visible(Shape3d::cube, {30, 40, 0}), 3);
    EXPECT_LE(visible(Shape3d::dodecahedron, {11, 22, 33}), 6);
    EXPECT_LE(visible(Shape3d::icosahedron, {11, 22, 33}), 10);
    EXPECT_FALSE(Board(half_planes(), "sections", "corrected").ask("visible-faces").number);
}

TEST(Questions, CornersOfTheSmallCubeStickOutAboveTheThirdRoot) {
    // Turned so that a diagonal of the small cube lies along x: its corners 0 and 7 are farthest.
    Scene scene = with_mesh(Shape3d::jelly_cubes, {0, 0, 0});
    scene.meshes[0].rotate2 = {0, 35.26F, 45};
    const auto cut = [&](float ratio) {
        scene.meshes[0].ratio = ratio;
        place_meshes(scene);
        return Board(scene, "sections", "corrected").ask("cut-corners").options;
    };
    EXPECT_TRUE(cut(0.57F).empty());
    EXPECT_EQ(cut(0.6F).size(), 1U) << "of opposite corners both are cut or neither";
    EXPECT_EQ(cut(1.9F).size(), 4U);
}

TEST(Questions, TheEndNearerToTheCutWeighsMore) {
    Board board(half_planes(), "sections", "corrected");
    EXPECT_NEAR(*board.ask("cut-weight 1.1 0.7").number, 0.75, 1e-12);
    EXPECT_NEAR(*board.ask("cut-weight 1.3 0.9").number, 0.25, 1e-12);
    EXPECT_FALSE(board.ask("cut-weight 0.9 0.7").number);
}

TEST(Questions, TwoRunsDifferWhereTheyReadOtherTexelsAndTheCauseIsNamed) {
    const Scene scene = scene_of(32, 24,
                                 {{{.x = 1.5F, .y = 18.5F, .w = 1, .u = 0, .v = 16},
                                   {.x = 10.5F, .y = .5F, .w = 2, .u = 2, .v = 0},
                                   {.x = 26.5F, .y = 8.5F, .w = 1, .u = 16, .v = 14}}});
    const auto drawn = [&](std::string_view method, std::string_view variant) {
        return Board(scene, method, variant).ask("drawn").number.value();
    };
    Board planes(scene, "edge-equations", "corrected");
    const Accepted warped = planes.ask("differs barycentric");
    EXPECT_GT(warped.places.size(), 50U);
    EXPECT_LT(static_cast<double>(warped.places.size()), drawn("edge-equations", "corrected"));
    EXPECT_EQ(warped.sentence, fmt::format("{0} pixels differ: {0} by warp.", warped.places.size()));
    for (const glm::ivec2 place : warped.places) {
        const auto a = samples_at(*planes.drawing, place.x, place.y);
        Board weights(scene, "barycentric", "corrected");
        const auto b = samples_at(*weights.drawing, place.x, place.y);
        ASSERT_TRUE(!a.empty() && !b.empty());
        EXPECT_TRUE(a[0].second.column != b[0].second.column || a[0].second.row != b[0].second.row);
    }
    EXPECT_FALSE(warped.step.empty());
    EXPECT_EQ(planes.ask("cause barycentric").options, std::vector<int>{3});
    EXPECT_EQ(planes.ask("cause sections").options, std::vector<int>{4});
    EXPECT_TRUE(planes.ask("differs sections").places.empty());
    EXPECT_EQ(planes.ask("cause backward-affine corrected fx8.8").options, std::vector<int>{2});
    Board forward(scene, "forward", "corrected");
    EXPECT_EQ(forward.ask("cause barycentric").options, std::vector<int>{0});
    EXPECT_EQ(find_question("differs")->kind, Prediction::Kind::pixel);
    EXPECT_FALSE(parse_question("differs", *find_method("sections")));
    EXPECT_FALSE(parse_question("differs nobody", *find_method("sections")));
    EXPECT_FALSE(parse_question("differs sections as-printed", *find_method("sections")));
}

TEST(Questions, ASceneWithoutShapesHasAnswersToo) {
    for (const std::string_view method : {"edge-equations", "sections"}) {
        Board board(scene_of(4, 4, {}), method, "corrected");
        for (const Question& question : questions()) {
            if (!question.method.empty() && question.method != method) continue;
            if (question.form == "FIELD" && method == "sections") continue;
            Prediction asked;
            asked.kind = question.kind, asked.answer = call_of(question, 1, 1), asked.explain = "auto";
            EXPECT_FALSE(accepted(asked, *board.drawing, *board.steps, Path{}).sentence.empty()) << question.name;
        }
    }
}

}  // namespace
}  // namespace texelscope::questions_test
