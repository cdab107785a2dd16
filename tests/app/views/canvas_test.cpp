#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "app/views/canvas_sections.h"
#include "app/views/canvas_values.h"
#include "tests/app/views/canvas_screen.h"

namespace texelscope::canvas_test {
namespace {

constexpr ui::Area kCanvas{0, 40, 656, 496}, kSmall{656, 40, 208, 208}, kFace{656, 40, 248, 264},
    kLarge{656, 248, 624, 288};
constexpr float kZoom = 20, kLeft = 16;

/// The middle of a pixel at the reference size.
glm::vec2 middle(int x, int y) {
    return {kLeft + (static_cast<float>(x) + .5F) * kZoom, 56 + (static_cast<float>(y) + .5F) * kZoom};
}

CanvasScreen::Setup cramer(std::string step = "t0/s5/y11/x16") {
    return {.scene = CanvasScreen::load("09-cramer"), .step = std::move(step)};
}
CanvasScreen::Setup sections(std::string step = "t0/s3/y14") {
    return {.scene = CanvasScreen::load("14-sections"),
            .method = "sections",
            .views = {"face", "ring", "code"},
            .step = std::move(step),
            .level = Level::scanline};
}

void expect_clean(const CanvasScreen& screen, const std::string& what) {
    for (const ui::TextRecord& t : ui::texts_cut(screen.report)) ADD_FAILURE() << what << ": cut '" << t.text << "'";
    const double least = screen.state().look.presenting ? 7 : 4.5;
    for (const ui::TextRecord& t : ui::faint_texts(screen.report, least))
        ADD_FAILURE() << what << ": faint '" << t.text << "'";
    for (const ui::ControlRecord& c : ui::small_targets(screen.report)) ADD_FAILURE() << what << ": small " << c.name;
}

TEST(Canvas, HoveringAndClickingAPixelSelectsIt) {
    CanvasScreen screen(cramer());
    screen.add("canvas", kCanvas);
    screen.frame();
    screen.move(middle(14, 9));
    screen.frame();
    EXPECT_EQ(screen.state().hover.kind, Selection::Kind::pixel);
    EXPECT_EQ(screen.state().hover.at, glm::ivec2(14, 9));
    screen.click(middle(14, 9));
    EXPECT_EQ(screen.state().pinned.at, glm::ivec2(14, 9));
    screen.click(middle(14, 9));
    EXPECT_EQ(screen.state().pinned.kind, Selection::Kind::none);
    screen.move({900, 600});
    EXPECT_EQ(screen.state().hover.kind, Selection::Kind::none);
}

TEST(Canvas, APictureOf640Times480HasAllOfItsPixelsAndSoNoRulers) {
    CanvasScreen::Setup setup = cramer("t0");
    setup.scene.framebuffer = {640, 480, 0, 0, {}};
    CanvasScreen screen(setup);
    screen.add("canvas", kCanvas);
    screen.frame();
    EXPECT_FALSE(screen.says("128"));
    screen.move({8 + 600.5F, 48 + 50.5F});
    screen.frame();
    EXPECT_EQ(screen.state().hover.at, glm::ivec2(600, 50));
}

TEST(Canvas, RestingTheMouseSaysNothingNew) {
    CanvasScreen screen(cramer());
    screen.add("canvas", kCanvas);
    screen.move(middle(14, 9));
    screen.frame();
    screen.frame();
    EXPECT_TRUE(screen.last_actions.empty());
}

TEST(Canvas, DoubleClickGoesToTheStepThatWroteThePixel) {
    CanvasScreen screen(cramer());
    screen.add("canvas", kCanvas);
    screen.move(middle(15, 7));
    screen.input.double_clicked = true;
    screen.input.pressed[0] = screen.input.down[0] = true;
    screen.frame();
    EXPECT_EQ(screen.state().cursor.step.text(), "t0/s5/y7/x15");
}

TEST(Canvas, DraggingACornerIsOneEntryToUndo) {
    CanvasScreen screen(cramer());
    screen.add("canvas", kCanvas);
    screen.frame();
    const ui::ControlRecord* handle = screen.control("vertex/0/2");
    ASSERT_NE(handle, nullptr);
    EXPECT_GE(handle->area.w, 32);
    const glm::vec2 from = handle->area.centre();
    screen.press(from);
    for (int n = 1; n <= 8; ++n) screen.move(from + glm::vec2(-5 * n, 4 * n));
    screen.release();
    const Vertex& moved = screen.store().derived().scene().polygons[0].vertices[2];
    EXPECT_NEAR(moved.x, 29.75F - 2, .05F);
    EXPECT_NEAR(moved.y, 15.25F + 1.6F, .05F);
    screen.store().dispatch(action::Undo{});
    EXPECT_EQ(screen.state().work.edits.size(), 0U);
    EXPECT_FALSE(screen.store().can_undo());
}

TEST(Canvas, TwoDragsAreTwoEntries) {
    CanvasScreen screen(cramer());
    screen.add("canvas", kCanvas);
    screen.frame();
    for (int drag = 0; drag < 2; ++drag) {
        const glm::vec2 from = screen.control("vertex/0/0")->area.centre();
        screen.press(from);
        screen.move(from + glm::vec2(40, -20));
        screen.release();
        screen.frame();
    }
    screen.store().dispatch(action::Undo{});
    EXPECT_TRUE(screen.store().can_undo());
}

TEST(Canvas, ShiftSnapsADraggedCornerToPixelCentres) {
    CanvasScreen screen(cramer());
    screen.add("canvas", kCanvas);
    screen.frame();
    screen.press(screen.control("vertex/0/0")->area.centre());
    screen.input.shift = true;
    screen.move(middle(5, 18) + glm::vec2(7, -6));
    const Vertex& moved = screen.store().derived().scene().polygons[0].vertices[0];
    EXPECT_EQ(moved.x, 5.5F);
    EXPECT_EQ(moved.y, 18.5F);
}

TEST(Canvas, AClickedCornerIsChosenAndKeysMoveAFocusedOne) {
    CanvasScreen screen(cramer());
    screen.add("canvas", kCanvas);
    screen.frame();
    screen.click(screen.control("vertex/0/1")->area.centre());
    EXPECT_EQ(screen.state().handle, (Handle{0, 1, false}));
    screen.input.mouse = {1200, 700};
    const auto press = [&](ui::Key key, bool shift) {
        screen.input.keys.push_back({.key = key, .shift = shift});
        screen.frame();
    };
    press(ui::Key::tab, false);
    press(ui::Key::right, false);
    press(ui::Key::down, true);
    ASSERT_EQ(screen.state().work.edits.size(), 1U);
    const VertexEdit& edit = screen.state().work.edits[0];
    const Vertex& before = screen.state().document->scene.polygons[0].vertices[static_cast<std::size_t>(edit.vertex)];
    EXPECT_EQ(edit.value.x, before.x + 1);
    EXPECT_EQ(edit.value.y, before.y + 1.0F / 16);
}

TEST(Canvas, APolygonStaysConvexWhileItIsDragged) {
    CanvasScreen screen(sections());
    screen.add("canvas", kCanvas);
    screen.frame();
    screen.press(screen.control("vertex/0/1")->area.centre());
    screen.move(middle(14, 12));
    EXPECT_TRUE(screen.state().work.edits.empty());
    EXPECT_NE(screen.state().message.text, "");
    screen.move(middle(28, 8));
    EXPECT_EQ(screen.state().work.edits.size(), 1U);
}

TEST(Canvas, WheelZoomsAtTheMouseAndTheMiddleButtonPans) {
    CanvasScreen screen(cramer());
    screen.add("canvas", kCanvas);
    screen.move(middle(10, 10));
    screen.input.wheel = {0, 2};
    screen.frame();
    EXPECT_GT(screen.state().look.zoom, kZoom);
    screen.frame();
    EXPECT_EQ(screen.state().hover.at, glm::ivec2(10, 10));
    const glm::vec2 centre = screen.state().look.centre;
    screen.press(middle(10, 10), 2);
    screen.move(middle(12, 10));
    EXPECT_LT(screen.state().look.centre.x, centre.x);
}

TEST(Canvas, AClickAnswersWhereAPixelIsAskedFor) {
    CanvasScreen::Setup setup = cramer();
    setup.prediction.emplace();
    setup.prediction->kind = Prediction::Kind::pixel;
    CanvasScreen screen(setup);
    screen.add("canvas", kCanvas);
    screen.frame();
    screen.click(middle(9, 4));
    ASSERT_EQ(screen.state().work.answers.size(), 1U);
    EXPECT_EQ(screen.state().work.answers[0].places, (std::vector<glm::ivec2>{{9, 4}}));
    EXPECT_EQ(screen.state().pinned.kind, Selection::Kind::none);
}

TEST(Canvas, EveryLookIsCleanInEveryLesson) {
    struct Case {
        CanvasScreen::Setup setup;
        std::string side;
    };
    CanvasScreen::Setup planes{
        .scene = CanvasScreen::load("05-half-planes"), .views = {"signs", "formula", "code"}, .step = "t0/s5/y14/x23"};
    CanvasScreen::Setup bytes{.scene = CanvasScreen::load("01-a-screen-is-an-array"),
                              .views = {"texels", "bytes", "code"},
                              .step = "t0/s5/y4/x13"};
    const Case cases[] = {{cramer(), "texels"},
                          {planes, "signs"},
                          {sections(), "face"},
                          {sections("t0/s2/y8/x12"), "face"},
                          {bytes, "bytes"}};
    for (const Case& c : cases) {
        for (const float scale : {1.0F, 1.25F, 1.5F, 2.0F, 2.5F}) {
            for (const int look : {0, 1, 2}) {
                CanvasScreen screen(c.setup);
                Look next = screen.state().look;
                next.scale = scale, next.theme = look == 1 ? Theme::light : Theme::dark, next.presenting = look == 2;
                screen.store().dispatch(action::SetLook{next});
                screen.add("canvas", kCanvas);
                screen.add(c.side, scale > 1.5F || look == 2 ? ui::Area{656, 112, 624, 424}
                                   : c.side == "face"        ? kFace
                                   : c.side == "bytes"       ? kLarge
                                                             : kSmall);
                screen.frame();
                screen.frame();
                expect_clean(screen, c.side + " at " + std::to_string(scale) + " look " + std::to_string(look));
            }
        }
    }
}

TEST(Canvas, EveryOverlayIsCleanZoomedIn) {
    for (const bool hits : {false, true}) {
        for (const float zoom : {8.0F, 48.0F, 128.0F}) {
            CanvasScreen screen(cramer("t0/s5/y14/x20"));
            Look look = screen.state().look;
            look.hits = hits, look.zoom = zoom, look.centre = {14, 10};
            screen.store().dispatch(action::SetLook{look});
            screen.add("canvas", kCanvas);
            screen.frame();
            expect_clean(screen, "zoom " + std::to_string(zoom));
        }
    }
}

TEST(Canvas, PixelsSayTheirColoursOnceThereIsRoom) {
    CanvasScreen screen(cramer("t0/s5/y18/x3"));
    screen.add("canvas", kCanvas);
    Look look = screen.state().look;
    look.zoom = 48, look.centre = {14, 10};
    screen.frame();
    const Rgb colour = screen.store().derived().final_picture().at(13, 9);
    EXPECT_FALSE(screen.says(std::to_string(colour.r)));
    screen.store().dispatch(action::SetLook{look});
    screen.frame();
    EXPECT_TRUE(screen.says(std::to_string(colour.r)));
}

TEST(Canvas, BadShapesAreNamedAndDrawNothingElse) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    struct Bad {
        float x, y, w;
    };
    for (const Bad& bad :
         {Bad{7.375F, 11, 1}, Bad{nan, 3, 1}, Bad{inf, 3, 1}, Bad{3, 3, 0}, Bad{3, 3, -1}, Bad{1e30F, 1e30F, 1}}) {
        CanvasScreen::Setup setup = cramer("t0");
        Vertex& v = setup.scene.polygons[0].vertices[2];
        v.x = bad.x, v.y = bad.y, v.w = bad.w;
        CanvasScreen screen(setup);
        screen.add("canvas", kCanvas);
        screen.add("texels", kSmall);
        screen.add("signs", kLarge);
        screen.frame();
        screen.frame();
        const auto& notices = screen.store().derived().notices();
        for (const Notice& notice : notices) EXPECT_TRUE(screen.says(notice.text)) << notice.text;
        expect_clean(screen, "bad shape");
    }
}

TEST(Canvas, AnEmptySceneSaysWhatToDo) {
    CanvasScreen screen({.scene = {}, .step = ""});
    for (const std::string_view view : {"texels", "face", "signs", "bytes"}) screen.add(view, kLarge);
    screen.add("canvas", kCanvas);
    screen.frame();
    EXPECT_TRUE(screen.says("Ctrl+O"));
}

TEST(Canvas, SectionsTileTheRowsOfTheirPolygon) {
    CanvasScreen screen(sections());
    const canvas::SectionPicture picture = canvas::sections_of(screen.store().derived());
    ASSERT_EQ(picture.sections.size(), 4U);
    EXPECT_EQ(picture.ring.size(), 5U);
    for (std::size_t n = 0; n + 1 < 4; ++n) EXPECT_EQ(picture.sections[n].last, picture.sections[n + 1].first);
    EXPECT_TRUE(picture.sections[2].current);
    EXPECT_FALSE(picture.sections[3].begun);
    // A section's corners are the polygon's wherever it begins or ends at one.
    EXPECT_EQ(picture.sections[0].right_bottom.u, 15.5);
    EXPECT_EQ(picture.sections[0].right_bottom.v, 6);
}

TEST(Canvas, PointersAreNamedAfterTheRingOnWhicheverSideTheyRun) {
    const auto x_of = [](const CanvasScreen& screen, std::string_view name) {
        for (const ui::TextRecord& t : screen.report.texts)
            if (t.text == name) return t.area.x;
        ADD_FAILURE() << name;
        return 0.0F;
    };
    for (const auto& [step, turned] : {std::pair{"t0/s3/y14", false}, {"t1/s1/y17", true}}) {
        CanvasScreen screen(sections(step));
        screen.add("canvas", kCanvas);
        screen.frame();
        EXPECT_EQ(x_of(screen, "left") > x_of(screen, "right"), turned) << step;
    }
}

TEST(Canvas, SamplesLieWhereTheMethodTakesThem) {
    CanvasScreen screen(sections());
    State state = screen.state();
    Derived derived;
    derived.update(state);
    EXPECT_EQ(canvas::sample_offset(state, derived), .5);
    state.work.quirks = quirks_of(*find_method("sections"), "as-printed");
    derived.update(state);
    EXPECT_EQ(canvas::sample_offset(state, derived), 0);
}

TEST(Canvas, NothingPointsAtTheAnswerOfAPixelQuestion) {
    CanvasScreen::Setup setup = sections();
    setup.prediction.emplace();
    setup.prediction->kind = Prediction::Kind::pixel;
    State state = CanvasScreen(setup).state();
    EXPECT_TRUE(canvas::pixel_question_ahead(state));
    for (const auto& [verdict, open] : {std::pair{Answer::Verdict::wrong, true},
                                        {Answer::Verdict::right, false},
                                        {Answer::Verdict::skipped, false}}) {
        state.work.answers = {{.verdict = verdict}};
        EXPECT_EQ(canvas::pixel_question_ahead(state), open);
    }
    setup.prediction->kind = Prediction::Kind::number;
    EXPECT_FALSE(canvas::pixel_question_ahead(CanvasScreen(setup).state()));
}

TEST(Canvas, ALessonAboutOtherThingsHasNoCorners) {
    CanvasScreen::Setup setup = cramer();
    CanvasScreen with(setup);
    setup.drag = "none";
    CanvasScreen none(setup);
    for (CanvasScreen* screen : {&with, &none}) screen->add("canvas", kCanvas), screen->frame();
    EXPECT_TRUE(with.says("29.75"));
    EXPECT_FALSE(none.says("29.75"));
}

TEST(Canvas, ThePresentersBadgeLeavesTheCurrentPixelFree) {
    CanvasScreen screen(cramer("t0/s5/y1/x12"));
    screen.add("canvas", kCanvas);
    Look look = screen.state().look;
    look.presenting = true;
    screen.store().dispatch(action::SetLook{look});
    screen.frame();
    const auto badge = std::find_if(screen.report.texts.begin(), screen.report.texts.end(),
                                    [](const ui::TextRecord& t) { return t.text == "12"; });
    ASSERT_NE(badge, screen.report.texts.end());
    // Row 1 lies too near the upper border for a plate there.
    EXPECT_GT(badge->area.y, kCanvas.centre().y);
}

TEST(Texels, HoveringATexelSelectsItAndItsCornerCanBeDragged) {
    CanvasScreen screen(cramer());
    screen.add("texels", kSmall);
    screen.frame();
    const ui::ControlRecord* handle = screen.control("texel-vertex/0/1");
    ASSERT_NE(handle, nullptr);
    const glm::vec2 from = handle->area.centre();
    screen.press(from);
    screen.move(from + glm::vec2(20, 10));
    screen.release();
    const Vertex& moved = screen.store().derived().scene().polygons[0].vertices[1];
    EXPECT_EQ(moved.u, 7);
    EXPECT_EQ(moved.v, 2);
    screen.move({686 + 125, 76 + 125});
    screen.frame();
    EXPECT_EQ(screen.state().hover.kind, Selection::Kind::texel);
    EXPECT_EQ(screen.state().hover.at, glm::ivec2(12, 12));
}

TEST(Signs, TheVerdictFollowsTheSample) {
    CanvasScreen::Setup setup{
        .scene = CanvasScreen::load("05-half-planes"), .views = {"signs", "formula", "code"}, .step = "t0/s5/y14/x23"};
    CanvasScreen screen(setup);
    screen.add("signs", kSmall);
    screen.frame();
    EXPECT_TRUE(screen.says("outside B, so rejected"));
    EXPECT_TRUE(screen.says("not computed"));
    EXPECT_TRUE(screen.says("32.5"));
    screen.store().dispatch(action::StepTo{*parse_path("t0/s5/y10/x14")});
    screen.frame();
    EXPECT_TRUE(screen.says("inside A, B and C"));
    screen.store().dispatch(action::StepTo{*parse_path("t0/s5")});
    screen.frame();
    EXPECT_TRUE(screen.says("pixel"));
}

TEST(Bytes, HoveringAByteSelectsItsPixel) {
    CanvasScreen::Setup setup{.scene = CanvasScreen::load("01-a-screen-is-an-array"),
                              .views = {"bytes", "formula", "code"},
                              .step = "t0/s5/y0/x0"};
    CanvasScreen screen(setup);
    screen.add("bytes", kLarge);
    screen.frame();
    const ui::ControlRecord* strip = screen.control("bytes");
    ASSERT_NE(strip, nullptr);
    screen.move({strip->area.x + 3, strip->area.y + 3});
    screen.frame();
    EXPECT_EQ(screen.state().hover.at, glm::ivec2(0, 0));
    screen.move({strip->area.right() - 8, strip->area.y + 3});
    screen.frame();
    EXPECT_GT(screen.state().hover.at.x, 0);
    EXPECT_EQ(screen.state().hover.at.y, 0);
}

}  // namespace
}  // namespace texelscope::canvas_test
