// The views of lessons 12 and 13: error map, matrix chain, operation counter.
#include <cmath>

#include <gtest/gtest.h>

#include "app/ui/ramp.h"
#include "tests/app/views/view_stage.h"

namespace texelscope::perspective_views_test {
namespace {

const ui::Area kLarge{0, 0, 624, 288}, kWide{0, 0, 416, 208};

/// S4's floor over 80 x 30 pixels, cut from its second to its third corner.
[[nodiscard]] std::shared_ptr<const Document> floor_document() {
    auto document = std::make_shared<Document>();
    Scene& scene = document->scene;
    scene.framebuffer.width = 80, scene.framebuffer.height = 30;
    Texture texture{.name = "t", .texels = make_pattern(Pattern::checker, 8, 8, 1)};
    scene.textures.push_back(std::make_shared<const Texture>(std::move(texture)));
    Polygon quad;
    quad.vertices = {{.x = 70.5F, .y = 10.5F, .z = 0, .w = 2, .u = 8, .v = 0},
                     {.x = 75.5F, .y = 25.5F, .z = 0, .w = 1, .u = 8, .v = 8},
                     {.x = 55.5F, .y = 25.5F, .z = 0, .w = 1, .u = 0, .v = 8},
                     {.x = 60.5F, .y = 10.5F, .z = 0, .w = 2, .u = 0, .v = 0}};
    scene.polygons.push_back(std::move(quad));
    return document;
}

[[nodiscard]] ViewStage stage_of(const std::string& method, const std::string& step, const ui::FontSpec& fonts = {},
                                 ui::ThemeName theme = ui::ThemeName::dark) {
    return ViewStage({.method = method, .step = step, .fonts = fonts, .theme = theme}, floor_document());
}

constexpr QuirkSet kAffine = 0b10000;

void click(ViewStage& stage, const std::string& view, glm::vec2 at) {
    stage.input.mouse = at;
    stage.frame(view, kLarge);
    stage.input.pressed[0] = true, stage.input.down[0] = true;
    stage.frame(view, kLarge);
    stage.input.released[0] = true, stage.input.down[0] = false;
    stage.frame(view, kLarge);
}

TEST(Heat, NamesTheWorstPlaceAndGoesThere) {
    ViewStage stage = stage_of("barycentric", "t1");
    stage.state.work.quirks = kAffine;
    stage.frame("heat", kLarge);
    EXPECT_TRUE(stage.shows("worst at "));
    const ui::ControlRecord* worst = stage.control("worst place");
    ASSERT_NE(worst, nullptr);
    click(stage, "heat", worst->area.centre());
    const auto* step = stage.done<action::StepTo>();
    ASSERT_NE(step, nullptr);
    const glm::ivec2 at = *stage.derived.errors({{0, 0, 80, 30}, 1}).worst;
    EXPECT_EQ(step->path.index_of('x'), at.x);
    EXPECT_EQ(step->path.index_of('y'), at.y);
}

TEST(Heat, SaysThatThereIsNoErrorInPerspective) {
    ViewStage stage = stage_of("barycentric", "t1");
    stage.frame("heat", kLarge);
    EXPECT_TRUE(stage.shows("no error"));
    EXPECT_EQ(stage.control("worst place"), nullptr);
}

TEST(Heat, TunesTheDepthOfTheChosenCornerAndTurnsTheDiagonal) {
    ViewStage stage = stage_of("barycentric", "t1");  // corners 0, 2 and 3 of the quad
    stage.frame("heat", kLarge);
    const ui::ControlRecord* other = stage.control("other diagonal");
    ASSERT_NE(other, nullptr);
    click(stage, "heat", other->area.centre());
    ASSERT_NE(stage.done<action::TurnRing>(), nullptr);
    EXPECT_EQ(stage.done<action::TurnRing>()->polygon, 0);

    stage.state.handle = {0, 2, false};
    stage.frame("heat", kLarge);
    const ui::ControlRecord* depth = stage.control("$w$ of $P_1$");  // as the canvas names it
    ASSERT_NE(depth, nullptr);
    const glm::vec2 three{depth->area.x + depth->area.w * (3 - .25F) / (4 - .25F), depth->area.centre().y};
    stage.input.mouse = three;
    stage.frame("heat", kLarge);
    stage.input.pressed[0] = true, stage.input.down[0] = true;
    stage.frame("heat", kLarge);
    const auto* set = stage.done<action::SetDepth>();
    ASSERT_NE(set, nullptr);
    EXPECT_EQ(set->handle, (Handle{0, 2, false}));
    EXPECT_NEAR(set->w, 3, .15F);

    stage.state.handle = {0, 1, false};
    stage.input.released[0] = true, stage.input.down[0] = false;
    stage.frame("heat", kLarge);
    EXPECT_NE(stage.control("$w$ of corner 1"), nullptr);
}

TEST(Ramp, RisesInLightnessFromViolet) {
    EXPECT_EQ(ui::viridis(0), ui::hex(0x440154));
    EXPECT_EQ(ui::viridis(1), ui::hex(0xFDE725));
    EXPECT_EQ(ui::viridis(-3), ui::viridis(0));
    EXPECT_EQ(ui::viridis(NAN), ui::viridis(0));
    EXPECT_EQ(ui::viridis(INFINITY), ui::viridis(1));
    double before = -1;
    for (int n = 0; n <= 100; ++n) {
        const double lightness = ui::seen(ui::viridis(n / 100.0), ui::Sight::normal).l;
        EXPECT_GT(lightness, before) << n;
        before = lightness;
    }
}

TEST(MatrixView, ShowsTheChainWithItsNumbersAndMarksWhatIsUsed) {
    ViewStage stage = stage_of("backward-projective", "t0/s1/e23");
    stage.state.cursor.level = Level::expression;
    stage.frame("matrix", kLarge);
    for (const char* name : {"a", "i", "det"}) EXPECT_NE(stage.control(name), nullptr) << name;
    for (const char* name : {"A_11", "X_0", "h", "u_0"}) EXPECT_NE(stage.control(name), nullptr) << name;
    EXPECT_TRUE(stage.shows("0.0333"));  // h = 1/30
    EXPECT_EQ(stage.derived.named()->name.text(), "h");
}

TEST(MatrixView, InAPixelItsCoefficientsAreNoChannels) {
    ViewStage stage = stage_of("backward-projective", "t0/s2/y15/x60");
    stage.frame("matrix", kLarge);
    EXPECT_TRUE(stage.shows("0.0333"));
    EXPECT_FALSE(stage.shows("255"));  // the pixel's green and blue
    const ui::ControlRecord* g = stage.control("g");
    ASSERT_NE(g, nullptr);
    stage.input.mouse = g->area.centre();
    for (int n = 0; n < 3; ++n) stage.frame("matrix", kLarge);
    EXPECT_TRUE(stage.shows("grows"));
    EXPECT_FALSE(stage.shows("green"));
}

TEST(MatrixView, OfAMethodWithoutAMatrixSaysWhichHaveOne) {
    ViewStage stage = stage_of("barycentric", "t0/s0");
    stage.frame("matrix", kWide);
    EXPECT_TRUE(stage.shows("backward-projective"));
}

TEST(Operations, ShowWhatTheTapeHas) {
    ViewStage stage = stage_of("backward-projective", "t0/s2/y15/x65");
    stage.frame("operations", kLarge);
    EXPECT_TRUE(stage.shows("a pixel"));
    EXPECT_TRUE(stage.shows("its row of 13"));
    for (const char* title : {"Backward: two additions", "Backward in perspective", "Floors and walls"})
        EXPECT_NE(stage.control(title), nullptr) << title;
    EXPECT_TRUE(stage.shows(std::to_string(stage.derived.costs()[1].whole().divisions)));
}

TEST(Code, DoesNotNameTheGuiltyLineWhileAQuestionAsksForIt) {
    auto document = std::make_shared<Document>(*floor_document());
    Lesson lesson;
    lesson.method = "backward-projective";
    Beat beat;
    beat.prediction = Prediction{"Which?", Prediction::Kind::line, {}, "guilty-line wrong_slope", "auto"};
    lesson.beats = {beat, Beat{}};
    document->lesson = lesson;
    ViewStage stage({.method = "backward-projective", .variant = "as-printed", .step = "t0/s2/y15/x65"}, document);
    const ui::Area tall{0, 0, 624, 2000};
    stage.frame("code", tall);
    EXPECT_TRUE(stage.shows("wrong_slope"));
    EXPECT_FALSE(stage.shows("Q1"));
    stage.state.cursor.beat = 1;
    stage.frame("code", tall);
    EXPECT_TRUE(stage.shows("Q1"));
}

TEST(PerspectiveViews, FitAndCanBeReadAtEverySizeOfText) {
    for (const bool presenting : {false, true}) {
        for (const float scale : {1.0F, 1.5F, 2.5F}) {
            if (presenting && scale > 1) continue;
            for (const auto theme : {ui::ThemeName::dark, ui::ThemeName::light}) {
                const ui::ThemeName shown = presenting ? ui::ThemeName::presenting : theme;
                for (const auto& [view, method, step] : {std::tuple{"heat", "barycentric", "t1"},
                                                         {"heat", "backward-affine", "t0/s2/y15/x65"},
                                                         {"matrix", "backward-projective", "t0/s1/e16"},
                                                         {"matrix", "backward-affine", "t0/s1"},
                                                         {"operations", "backward-projective", "t0/s2/y15/x65"},
                                                         {"operations", "constant-z", "t0"}}) {
                    ViewStage stage = stage_of(method, step, {scale, presenting}, shown);
                    if (std::string(method) == "barycentric") stage.state.work.quirks = kAffine;
                    for (const ui::Area& area : {kWide, kLarge, ui::Area{0, 0, 208, 208}, ui::Area{0, 0, 624, 496}}) {
                        stage.frame(view, area), stage.frame(view, area);
                        const std::string what = std::string(view) + " " + method + " at " + std::to_string(scale) +
                                                 " in " + std::to_string(area.w);
                        for (const ui::TextRecord& text : ui::texts_cut(stage.report))
                            ADD_FAILURE() << what << ": '" << text.text << "' is cut";
                        const double least = ui::make_theme(shown).text_contrast();
                        for (const ui::TextRecord& text : ui::faint_texts(stage.report, least))
                            ADD_FAILURE() << what << ": '" << text.text << "' is faint";
                        EXPECT_TRUE(ui::small_targets(stage.report).empty()) << what;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace texelscope::perspective_views_test
