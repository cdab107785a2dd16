// What lessons 12 and 13 show as numbers: S4's figures, the error map, the counted operations.
#include <array>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "app/lesson/facts.h"
#include "app/state/derived.h"
#include "core/image/patterns.h"
#include "core/scene/json.h"

namespace texelscope::perspective_test {
namespace {

/// A quad of S4's picture, cut from its second to its third corner; the texture is one unit wide.
[[nodiscard]] Scene s4_quad(float x0, float x1, float y0, float x2, float x3, float y1, float far) {
    Scene scene;
    scene.framebuffer.width = 800, scene.framebuffer.height = 300;
    Texture texture{.name = "t", .texels = make_pattern(Pattern::checker, 8, 8, 1)};
    scene.textures.push_back(std::make_shared<const Texture>(std::move(texture)));
    Polygon quad;
    quad.vertices = {{.x = x1, .y = y0, .z = 0, .w = far, .u = 1, .v = 0},
                     {.x = x3, .y = y1, .z = 0, .w = 1, .u = 1, .v = 1},
                     {.x = x2, .y = y1, .z = 0, .w = 1, .u = 0, .v = 1},
                     {.x = x0, .y = y0, .z = 0, .w = far, .u = 0, .v = 0}};
    scene.polygons.push_back(std::move(quad));
    return scene;
}
[[nodiscard]] Scene flat_trapezoid() { return s4_quad(350, 450, 100, 300, 500, 250, 1); }
[[nodiscard]] Scene floor() { return s4_quad(600, 700, 100, 550, 750, 250, 2); }

/// A state that draws the scene, as Derived wants it.
struct Board {
    State state;
    Derived derived;
    Board(Scene scene, std::string_view method, std::string_view quirk = {}, std::string_view step = "t0") {
        auto document = std::make_shared<Document>();
        document->scene = std::move(scene);
        state.document = document;
        state.work.method = method;
        state.work.variant = "corrected";
        if (!quirk.empty()) state.work.quirks = QuirkSet{1} << quirk_number(*find_method(method), quirk).value();
        state.cursor.step = parse_path(step).value();
        derived.update(state);
    }
    /// (u, v) where S4 samples pixel (x, y): at its corner.
    [[nodiscard]] Sample at(int shape, int x, int y) {
        Scene moved = derived.scene();
        for (Vertex& v : moved.polygons.front().vertices) v.x += .5F, v.y += .5F;
        const Drawing drawing(moved, derived.drawing().settings());
        for (const auto& [n, sample] : samples_at(drawing, x, y))
            if (n == shape && sample.fate == Fate::written) return sample;
        ADD_FAILURE() << "shape " << shape << " does not draw " << x << ", " << y;
        return {};
    }
};

TEST(S4, InTheFlatTrapezoidUAgreesOnTheDiagonalButItsSlopeHalves) {
    Board board(flat_trapezoid(), "barycentric", "affine");
    // Row 150: the diagonal passes x = 400; shape 0 lies to its right.
    const double on = board.at(0, 400, 150).u, left = board.at(1, 399, 150).u, right = board.at(0, 401, 150).u;
    EXPECT_NEAR(on, 2.0 / 3, 1e-12);
    EXPECT_NEAR(on - left, 0.010, 1e-12);
    EXPECT_NEAR(right - on, 0.005, 1e-12);
    EXPECT_NEAR(left + 0.010, on, 1e-12);  // the upper triangle's own value there
}

TEST(S4, WithDepthTheTexturesMiddleIsAThirdOfTheWayDown) {
    Board board(floor(), "barycentric"), flat(floor(), "barycentric", "affine");
    EXPECT_NEAR(board.at(0, 660, 150).v, 0.5, 1e-12);
    EXPECT_NEAR(flat.at(0, 660, 175).v, 0.5, 1e-12);
}

TEST(S4, TheWorstAffineErrorOfVIs0172) {
    Board board(floor(), "barycentric", "affine");
    const ErrorMap& map = board.derived.errors({board.derived.scene().framebuffer.rect(), 1});
    EXPECT_NEAR(map.v_most, 3 - 2 * std::sqrt(2.0), 2e-5);
    ASSERT_TRUE(map.worst);
    EXPECT_GE(map.error.length(), map.v_most);
}

TEST(S4, ItsFloorHasOneDepthARow) {
    Board board(floor(), "backward-projective", {}, "t0/s1");
    const auto value = [&](const char* name) { return approximate(value_named(board.derived.visit(), name).value()); };
    EXPECT_NEAR(value("g"), 0, 1e-15);
    EXPECT_NEAR(value("h"), 1.0 / 300, 1e-12);
    EXPECT_NEAR(value("i"), 1.0 / 6, 1e-12);
}

TEST(S4, ItsPictureWritesTheThreeDiagonalsTwice) {
    const std::filesystem::path assets = std::filesystem::path(TEXELSCOPE_SOURCE_DIR) / "assets";
    const auto loaded = load_scene(assets / "scenes/s4.json", assets);
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_TRUE(loaded->warnings.empty());
    const Method& method = *find_method("barycentric");
    const Drawing drawing(loaded->scene, {&method, NumberFormat::f64, quirks_of(method, "as-printed"), {}});
    const Grid<std::uint8_t> counts = write_counts(drawing);
    std::array<int, 3> twice{};
    for (int y = 0; y < counts.height(); ++y)
        for (int x = 0; x < counts.width(); ++x) twice[x < 550 ? 0 : x < 1050 ? 1 : 2] += counts.at(x, y) > 1;
    EXPECT_EQ(twice, (std::array{401, 301, 301}));
    const Image picture = render(drawing);
    EXPECT_EQ(picture.at(0, 0), (Rgb{180, 179, 210}));
    EXPECT_EQ(picture.at(180, 130), (Rgb{255, 255, 255}));
    EXPECT_EQ(picture.at(102, 102), (Rgb{0, 127, 0}));  // black, halved with green: 0/2 + 255/2
}

TEST(ErrorMap, InPerspectiveThereIsNoError) {
    for (const std::string_view method : {"barycentric", "backward-projective"}) {
        Board board(floor(), method);
        const ErrorMap& map = board.derived.errors({board.derived.scene().framebuffer.rect(), 4});
        ASSERT_TRUE(map.worst) << method;
        EXPECT_LT(map.error.length(), 1e-9) << method;
    }
}

TEST(ErrorMap, IsContinuousAcrossTheDiagonalAndZeroAtTheCorners) {
    Board board(floor(), "barycentric", "affine");
    const ErrorMap& map = board.derived.errors({board.derived.scene().framebuffer.rect(), 1});
    const auto error = [&](int x, int y) { return map.cells.at(x, y).length(); };
    EXPECT_LT(error(600, 100), 0.02);
    EXPECT_LT(error(745, 248), 0.02);
    EXPECT_NEAR(error(649, 150), error(650, 150), 0.01);  // the diagonal runs between the two
}

TEST(ErrorMap, TellsApartWhatOnlyOneOfTheTwoDraws) {
    Board board(floor(), "edge-equations", "corners");
    const ErrorMap& map = board.derived.errors({board.derived.scene().framebuffer.rect(), 1});
    int one_only = 0;
    for (std::size_t n = 0; n < map.cells.size(); ++n) one_only += map.cells.data()[n].kind == UvError::Kind::one_only;
    EXPECT_GT(one_only, 100);  // a row or column of pixels at most sides
    EXPECT_EQ(map.cells.at(0, 0).kind, UvError::Kind::nothing);
    const ErrorMap& empty = board.derived.errors({{0, 0, 40, 40}, 1});
    EXPECT_FALSE(empty.worst);
}

[[nodiscard]] const MethodCost& cost(const std::vector<MethodCost>& costs, std::string_view id) {
    for (const MethodCost& c : costs)
        if (c.method->id == id) return c;
    ADD_FAILURE() << id;
    return costs.front();
}

TEST(Costs, APixelInPerspectiveIsThreeAdditionsAndTwoDivisions) {
    for (const std::string_view step : {"t0/s1/e3", "t0/s2/y150", "t0/s2/y150/x660", "t0/s2/y150/x640/e3"}) {
        Board board(floor(), "backward-projective", {}, step);
        const auto& costs = board.derived.costs();
        ASSERT_EQ(costs.size(), 3U);
        EXPECT_EQ(cost(costs, "backward-projective").pixel, (OperationCount{3, 0, 2})) << step;
        EXPECT_EQ(cost(costs, "backward-affine").pixel, (OperationCount{2, 0, 0})) << step;
        EXPECT_EQ(cost(costs, "constant-z").pixel, (OperationCount{2, 0, 0})) << step;
    }
}

TEST(Costs, OneReciprocalIsOneDivisionAndTwoProducts) {
    Board board(floor(), "backward-projective", "reciprocal", "t0/s2/y150/x660");
    EXPECT_EQ(cost(board.derived.costs(), "backward-projective").pixel, (OperationCount{3, 2, 1}));
}

TEST(Costs, OfAFloorTheDivisionLeavesTheInnerLoop) {
    Board board(floor(), "constant-z", {}, "t0/s2/y150/x660");
    const auto& costs = board.derived.costs();
    const MethodCost &z = cost(costs, "constant-z"), &full = cost(costs, "backward-projective");
    EXPECT_TRUE(z.current);
    EXPECT_FALSE(z.columns);
    EXPECT_EQ(z.line.divisions - full.line.divisions, 1);
    EXPECT_EQ(z.lines, 150);
    EXPECT_EQ(z.line_pixels, 134);
    EXPECT_EQ(z.pixels, full.pixels);
    EXPECT_EQ(full.whole().divisions, full.setup.divisions + 150 * full.line.divisions + 2 * full.pixels);
}

TEST(Costs, OfAWallItGoesByColumns) {
    Scene wall = floor();
    for (Vertex& v : wall.polygons.front().vertices) std::swap(v.x, v.y);
    wall.framebuffer.width = 300, wall.framebuffer.height = 800;
    Board board(wall, "backward-projective");
    const MethodCost& z = cost(board.derived.costs(), "constant-z");
    EXPECT_TRUE(z.columns);
    EXPECT_EQ(z.pixel.divisions, 0);
    EXPECT_EQ(z.lines, 150);
}

TEST(Costs, OfAnotherMethodStandBesideThoseOfTheMatrix) {
    Board board(floor(), "barycentric", {}, "t0/s4/y200/x700");
    ASSERT_EQ(board.derived.costs().size(), 4U);
    EXPECT_TRUE(board.derived.costs().back().current);
    EXPECT_EQ(board.derived.costs().back().pixel.divisions, 3 + 3 + 2);  // areas halved, weights, u and v
}

}  // namespace
}  // namespace texelscope::perspective_test
