// The views of lesson 17: race and palette.
#include <gtest/gtest.h>

#include "core/measure/bill.h"
#include "tests/app/state/random_fixture.h"
#include "tests/app/views/view_stage.h"

namespace texelscope::race_views_test {
namespace {

constexpr ui::Area kSide{656, 40, 624, 496}, kSmall{656, 40, 208, 208};

class RaceViews : public testing::Test {
protected:
    static StageSpec spec(const char* step = "t0") {
        return {.method = "edge-walk", .step = step, .level = Level::triangle};
    }
    void press(const std::string& label) {
        const ui::ControlRecord* control = stage.control(label);
        ASSERT_NE(control, nullptr) << label;
        stage.input.mouse = control->area.centre();
        stage.frame(view, area);
        stage.input.pressed[0] = stage.input.down[0] = true;
        stage.frame(view, area);
    }
    void click(const std::string& label) {
        press(label);
        stage.input.down[0] = false, stage.input.released[0] = true;
        stage.frame(view, area);
    }
    std::string view = "race";
    ui::Area area = kSide;
    ViewStage stage{spec(), random_document()};
};

TEST_F(RaceViews, EveryRacerHasItsBillAndNoTimeBeforeTheRace) {
    stage.frame(view, area);
    for (const Method* racer : racers()) {
        EXPECT_TRUE(stage.shows(std::string(racer->title).substr(0, 8))) << racer->id;
        int rows = 0;
        for (const ui::ControlRecord& c : stage.report.controls) rows += c.label == racer->title;
        EXPECT_EQ(rows, 1) << racer->id;
    }
    EXPECT_TRUE(stage.shows("Run times them"));
    EXPECT_FALSE(stage.wants_frame);
}

TEST_F(RaceViews, LapsAreShownBesideTheYear1995) {
    stage.state.race.laps = {{racers()[0], 12, 1000, .004, .001}};
    stage.frame(view, area);
    EXPECT_TRUE(stage.shows("4.00")) << "ms a frame";
    EXPECT_TRUE(stage.shows("0.25")) << "million pixels a second";
    EXPECT_TRUE(stage.shows("3000")) << "triangles a second";
    EXPECT_TRUE(stage.shows("1995"));
    EXPECT_TRUE(stage.shows("10.0")) << "million pixels a second, then";
}

TEST_F(RaceViews, RunStartsTheRaceAndStopStopsIt) {
    stage.frame(view, area);
    click("Run");
    ASSERT_NE(stage.done<action::StartRace>(), nullptr);
    EXPECT_TRUE(stage.done<action::StartRace>()->on);
    stage.state.race.running = true;
    stage.frame(view, area);
    EXPECT_TRUE(stage.shows("1 of " + std::to_string(racers().size())));
    click("Stop");
    ASSERT_NE(stage.done<action::StartRace>(), nullptr);
    EXPECT_FALSE(stage.done<action::StartRace>()->on);
}

TEST_F(RaceViews, AClickOnAMethodDrawsWithIt) {
    stage.frame(view, area);
    click("Sections");
    ASSERT_NE(stage.done<action::SetMethod>(), nullptr);
    EXPECT_EQ(stage.done<action::SetMethod>()->id, "sections");
}

TEST_F(RaceViews, ADragOfASliderIsOneGestureAndChangesOneNumber) {
    stage.frame(view, area);
    const ui::ControlRecord* count = stage.control("triangles");
    ASSERT_NE(count, nullptr);
    stage.input.mouse = {count->area.right() - 1, count->area.centre().y};
    stage.frame(view, area);
    stage.input.pressed[0] = stage.input.down[0] = true;
    stage.frame(view, area);
    const auto* set = stage.done<action::SetRandom>();
    ASSERT_NE(set, nullptr);
    EXPECT_EQ(set->to, (RandomTriangles{kMostTriangles, 24, 5}));
    EXPECT_NE(set->gesture, 0);
}

TEST_F(RaceViews, NumbersThatAreAskedForComeWithTheAnswer) {
    auto document = std::make_shared<Document>(*random_document());
    Lesson lesson;
    lesson.method = "edge-walk";
    lesson.beats.resize(1);
    lesson.beats[0].prediction = Prediction{"Which?", Prediction::Kind::number, {}, "set-up-share", "auto", {}};
    document->lesson = lesson;
    stage.state.document = document;
    stage.frame(view, area);
    EXPECT_FALSE(stage.shows("Sections"));
    EXPECT_FALSE(stage.shows("1995"));
    EXPECT_TRUE(stage.shows("Your answer first"));
    stage.state.work.answers = {
        {.beat = 0, .chosen = {}, .typed = "1", .places = {}, .verdict = Answer::Verdict::wrong}};
    stage.frame(view, area);
    EXPECT_TRUE(stage.shows("Sections"));
}

TEST_F(RaceViews, WithoutRandomTrianglesItSaysWhatToDo) {
    ViewStage other;
    other.frame(view, area);
    EXPECT_TRUE(other.shows("random"));
}

TEST_F(RaceViews, TheCurrentTexelsColourIsNamedWithItsUsers) {
    view = "palette";
    stage.frame(view, area);
    EXPECT_TRUE(stage.shows("8 of 256"));
    EXPECT_TRUE(stage.shows("Point at a colour"));
    stage.state.pinned = {.kind = Selection::Kind::texel, .at = {3, 4}};
    stage.frame(view, area);
    stage.derived.update(stage.state);
    const int index = stage.derived.texture().indices.at(3, 4);
    const PaletteUse& use = stage.derived.palette_use();
    const auto n = static_cast<std::size_t>(index);
    EXPECT_TRUE(stage.shows("index " + std::to_string(index)));
    EXPECT_TRUE(stage.shows(std::to_string(use.texels[n]) + " texels"));
    EXPECT_TRUE(stage.shows(std::to_string(use.pixels[n]) + " pixel"));
}

TEST_F(RaceViews, HoveringAColourAndClickingPinIt) {
    view = "palette", area = kSmall;
    stage.frame(view, area);
    const ui::ControlRecord* grid = stage.control("Palette");
    ASSERT_NE(grid, nullptr);
    const float cell = grid->area.w / 16;
    stage.input.mouse = {grid->area.x + 5.5F * cell, grid->area.y + .5F * cell};
    stage.frame(view, area);
    stage.frame(view, area);
    ASSERT_NE(stage.done<action::Hover>(), nullptr);
    EXPECT_EQ(stage.done<action::Hover>()->what, (Selection{.kind = Selection::Kind::colour, .colour = 5}));
    stage.input.pressed[0] = stage.input.down[0] = true;
    stage.frame(view, area);
    stage.input.down[0] = false, stage.input.released[0] = true;
    stage.frame(view, area);
    ASSERT_NE(stage.done<action::Pin>(), nullptr);
    EXPECT_EQ(stage.done<action::Pin>()->what.colour, 5);
    stage.input.mouse = {grid->area.x + 9.5F * cell, grid->area.y + .5F * cell};
    stage.frame(view, area);
    stage.frame(view, area);
    EXPECT_EQ(stage.done<action::Hover>(), nullptr) << "the texture has only eight colours";
}

TEST_F(RaceViews, ArrowsGoFromColourToColour) {
    view = "palette";
    stage.state.pinned = {.kind = Selection::Kind::colour, .colour = 6};
    stage.frame(view, area);
    const auto arrow = [&](ui::Key key) {
        stage.memory.focus = ui::id_of("palette");
        stage.input.keys = {{key}};
        stage.frame(view, area);
        return stage.done<action::Pin>();
    };
    ASSERT_NE(arrow(ui::Key::right), nullptr);
    EXPECT_EQ(stage.done<action::Pin>()->what.colour, 7);
    EXPECT_EQ(arrow(ui::Key::down), nullptr) << "there is no colour 22";
    ASSERT_NE(arrow(ui::Key::left), nullptr);
    EXPECT_EQ(stage.done<action::Pin>()->what.colour, 5);
}

TEST_F(RaceViews, ATextureWithoutAPaletteSaysWhatToDo) {
    ViewStage second(spec("t1"), random_document());
    second.frame("palette", kSmall);
    EXPECT_TRUE(second.shows("reduces")) << "the scene can";
    EXPECT_EQ(second.control("Palette"), nullptr) << "there is no grid";
}

}  // namespace
}  // namespace texelscope::race_views_test
