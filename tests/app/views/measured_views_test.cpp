// The views of lessons 19 to 21: front, certificate and skips.
#include <gtest/gtest.h>

#include "app/state/front_key.h"
#include "core/method/decisions.h"
#include "tests/app/state/random_fixture.h"
#include "tests/app/views/view_stage.h"

namespace texelscope {
namespace {

constexpr ui::Area kSide{656, 40, 624, 496};

class MeasuredViews : public testing::Test {
protected:
    static StageSpec spec() { return {.method = "fast", .step = "t0", .level = Level::triangle}; }
    void click(const std::string& label) {
        const ui::ControlRecord* control = stage.control(label);
        ASSERT_NE(control, nullptr) << label;
        click_at(control->area.centre());
    }
    void click_at(glm::vec2 place) {
        stage.input.mouse = place;
        stage.frame(view, kSide);
        stage.input.pressed[0] = stage.input.down[0] = true;
        stage.frame(view, kSide);
        stage.input.down[0] = false, stage.input.released[0] = true;
        stage.frame(view, kSide);
    }
    /// Three rungs as they may have been measured for the stage's scene.
    [[nodiscard]] std::vector<FrontPoint> points() const {
        std::vector<FrontPoint> all;
        for (const auto& [id, ns, error] : {std::tuple{"fast", 2.0, 0.0},
                                            {"fixed-steps", 8.0, .001},
                                            {"tile-based", 12.0, .0001},
                                            {"edge-equations:f32", 10.0, .01}}) {
            const Rung& rung = *find_rung(id);
            FrontPoint p;
            p.scene = key, p.rung = id, p.label = rung.label, p.kind = id_of(rung.kind), p.numbers = id_of(rung.format);
            p.median_ns = p.min_ns = ns, p.max_error = error, p.pixels = 1000;
            all.push_back(p);
        }
        mark_dominated(all);
        return all;
    }
    std::string view = "front";
    ViewStage stage{spec(), random_document()};
    std::string key = front_key(random_document()->scene, {});
};

TEST_F(MeasuredViews, WithoutAMeasurementItSaysWhatToDoAndRunStartsIt) {
    stage.frame(view, kSide);
    EXPECT_TRUE(stage.shows("not measured yet"));
    click("Run");
    ASSERT_NE(stage.done<action::StartMeasure>(), nullptr);
    EXPECT_TRUE(stage.done<action::StartMeasure>()->on);
    EXPECT_EQ(stage.done<action::StartMeasure>()->what, Measure::What::front);
    EXPECT_FALSE(stage.wants_frame);
}

TEST_F(MeasuredViews, AnEarlierMeasurementIsShownForItsOwnSceneOnly) {
    auto document = std::make_shared<Document>(*random_document());
    document->front = points();
    stage.state.document = document;
    stage.frame(view, kSide);
    EXPECT_TRUE(stage.shows("measured earlier"));
    for (FrontPoint& point : document->front) point.scene = "12 24 6";
    stage.state.document = std::make_shared<Document>(*document);
    stage.frame(view, kSide);
    EXPECT_TRUE(stage.shows("not measured yet"));
}

TEST_F(MeasuredViews, PointsAreChosenOneAfterTheOther) {
    stage.state.measure = {.what = Measure::What::front, .front = points()};
    stage.frame(view, kSide);
    EXPECT_TRUE(stage.shows("measured here"));
    click("slower");
    ASSERT_NE(stage.done<action::SetLook>(), nullptr);
    EXPECT_EQ(stage.done<action::SetLook>()->look.rung, "fast") << "the fastest first";
    stage.state.look.rung = "fixed-steps";
    stage.frame(view, kSide);
    EXPECT_TRUE(stage.shows("16.16 additions"));
    EXPECT_TRUE(stage.shows("0.001"));
    click("slower");
    EXPECT_EQ(stage.done<action::SetLook>()->look.rung, "edge-equations:f32");
    click("faster");
    EXPECT_EQ(stage.done<action::SetLook>()->look.rung, "fast");
}

TEST_F(MeasuredViews, TheRungThatIsAskedAboutIsHiddenAndABandAnswers) {
    auto document = std::make_shared<Document>(*random_document());
    Lesson lesson;
    lesson.method = "fast";
    lesson.beats.resize(1);
    lesson.beats[0].prediction = Prediction{"Where?",
                                            Prediction::Kind::choice,
                                            {"below", "between", "above"},
                                            "error-place fixed-steps tile-based edge-equations:f32",
                                            "auto",
                                            {}};
    document->lesson = lesson;
    stage.state.document = document;
    stage.state.measure = {.what = Measure::What::front, .front = points()};
    stage.frame(view, kSide);
    EXPECT_FALSE(stage.shows("16.16"));
    const ui::ControlRecord *above = stage.control("more than both"), *between = stage.control("between"),
                            *below = stage.control("less than both");
    ASSERT_TRUE(above != nullptr && between != nullptr && below != nullptr);
    EXPECT_LT(above->area.y, between->area.y);
    EXPECT_LT(between->area.y, below->area.y);
    click("between");
    ASSERT_NE(stage.done<action::Choose>(), nullptr);
    EXPECT_EQ(stage.done<action::Choose>()->option, 1);
    stage.state.work.answers = {
        {.beat = 0, .chosen = {1}, .typed = {}, .places = {}, .verdict = Answer::Verdict::right}};
    stage.frame(view, kSide);
    EXPECT_TRUE(stage.shows("16.16"));
    EXPECT_EQ(stage.control("between"), nullptr);
}

TEST_F(MeasuredViews, EverySkipHasASwitchAndTheSamePicture) {
    view = "skips";
    stage.frame(view, kSide);
    for (const RasterSkipInfo& info : kRasterSkips) {
        EXPECT_TRUE(stage.shows(std::string(info.id))) << info.id;
        EXPECT_NE(stage.control(std::string(info.id)), nullptr) << info.id;
    }
    EXPECT_TRUE(stage.shows("0 of 3,072 pixels differ"));
    click("equal-w");
    ASSERT_NE(stage.done<action::SetLook>(), nullptr);
    EXPECT_EQ(stage.done<action::SetLook>()->look.skips, without(RasterSkip::equal_w));
    stage.state.look.skips = without(RasterSkip::equal_w);
    stage.frame(view, kSide);
    EXPECT_TRUE(stage.shows("off"));
    EXPECT_TRUE(stage.shows("0 of 3,072 pixels differ"));
    click("no skip at all");
    EXPECT_EQ(stage.done<action::SetLook>()->look.skips, 0U);
}

TEST_F(MeasuredViews, TimesStandBesideTheirSkips) {
    view = "skips";
    stage.state.measure = {.what = Measure::What::skips,
                           .skips = {{kAllSkips, .002}, {without(RasterSkip::hidden), .005}, {0, .012}}};
    stage.frame(view, kSide);
    EXPECT_TRUE(stage.shows("×2.50"));
    EXPECT_TRUE(stage.shows("×6.00"));
    EXPECT_TRUE(stage.shows("2.00 ms"));
}

TEST_F(MeasuredViews, TheCertificateCountsEveryPixelOfTheShape) {
    view = "certificate";
    stage.frame(view, kSide);
    const Decisions found = decisions_of(stage.derived.drawing(), 0);
    EXPECT_GT(found.of(Decision::certificate), 0U);
    EXPECT_TRUE(stage.shows(std::to_string(found.of(Decision::certificate))));
    EXPECT_TRUE(stage.shows("certified"));
    EXPECT_TRUE(stage.shows("Go to a pixel"));
}

TEST_F(MeasuredViews, EachSaysWhatToDoWithoutASceneOfItsOwn) {
    ViewStage other;
    other.frame("front", kSide);
    EXPECT_TRUE(other.shows("random"));
    other.frame("skips", kSide);
    EXPECT_TRUE(other.shows("random"));
}

}  // namespace
}  // namespace texelscope
