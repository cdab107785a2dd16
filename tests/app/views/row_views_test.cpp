// The views that show a row: the walk down the sides, the ribbon of its error, the weights of a sample.
#include "tests/app/views/view_stage.h"

namespace texelscope::row_views_test {
namespace {

/// Whether the words stand on the screen in this order, however they are divided.
[[nodiscard]] bool says(const ViewStage& stage, std::string words) {
    std::string all;
    for (const ui::TextRecord& text : stage.report.texts) all += text.text;
    for (std::string* s : {&all, &words}) std::erase(*s, ' ');
    return all.find(words) != std::string::npos;
}

constexpr ui::Area kSmall{20, 20, 208, 208}, kWide{20, 20, 416, 208};

TEST(WalkView, ListsTheRowsSoFarAndGoesToTheOneThatIsClicked) {
    ViewStage stage({.method = "edge-walk", .step = "t0/s2/y8", .level = Level::scanline});
    stage.frame("walk", kSmall);
    EXPECT_TRUE(stage.shows("left") && stage.shows("right"));
    ASSERT_NE(stage.control("row 8"), nullptr);
    EXPECT_EQ(stage.control("row 9"), nullptr);
    const ui::ControlRecord* row = stage.control("row 7");
    ASSERT_NE(row, nullptr);
    stage.input.mouse = row->area.centre();
    stage.frame("walk", kSmall);
    stage.input.pressed[0] = stage.input.down[0] = true;
    stage.frame("walk", kSmall);
    stage.input.down[0] = false, stage.input.released[0] = true;
    stage.frame("walk", kSmall);
    const auto* go = stage.done<action::StepTo>();
    ASSERT_NE(go, nullptr);
    EXPECT_EQ(go->path.text(), "t0/s2/y7");
}

TEST(WalkView, MarksTheRowThatIsDrawnTwice) {
    ViewStage stage({.method = "edge-walk", .step = "t0", .level = Level::triangle});
    stage.frame("walk", kWide);
    EXPECT_FALSE(stage.shows("2×"));
    stage.state.work.quirks = 1;  // inclusive
    stage.go("t0/s3/y15");
    stage.frame("walk", kWide);
    EXPECT_TRUE(stage.shows("2×"));
}

TEST(WalkView, SaysSoWhereNothingIsWalked) {
    ViewStage stage({.method = "barycentric", .step = "t0/s4/y11"});
    stage.frame("walk", kWide);
    EXPECT_TRUE(says(stage, "does not walk"));
}

TEST(RibbonView, SaysTheErrorAtTheEndAndHowManyTexelsDiffer) {
    ViewStage stage({.step = "t0/s5/y11", .format = NumberFormat::fx8_8, .level = Level::scanline});
    stage.frame("ribbon", kWide);
    const RowError& error = stage.derived.row_error();
    ASSERT_GT(error.others, 0);
    EXPECT_TRUE(stage.shows(std::to_string(error.others) + " of " + std::to_string(error.pixels.size())));
    EXPECT_TRUE(says(stage, "at x = " + std::to_string(error.pixels.back().x)));
    EXPECT_TRUE(stage.shows("fx8.8"));
    stage.state.work.format = NumberFormat::exact;
    stage.frame("ribbon", kWide);
    EXPECT_TRUE(stage.shows("the same texel at all"));
}

TEST(RibbonView, AsksForARowWhereThereIsNone) {
    ViewStage stage({.step = "t0/s0", .level = Level::stage});
    stage.frame("ribbon", kWide);
    EXPECT_TRUE(says(stage, "Step into a row"));
}

TEST(WeightsView, ShowsThreeWeightsThatSumToOne) {
    ViewStage stage({.method = "barycentric", .step = "t0/s4/y11/x15"});
    stage.frame("weights", kSmall);
    for (const std::string name : {"e_0", "e_1", "e_2"}) EXPECT_NE(stage.control(name), nullptr) << name;
    EXPECT_TRUE(stage.shows("pixel 15, 11"));
    EXPECT_FALSE(stage.shows("not computed"));
    EXPECT_FALSE(stage.shows("outside"));
}

TEST(WeightsView, FollowsTheMouseAndSaysWhatIsNotComputedOutside) {
    ViewStage stage({.method = "barycentric", .step = "t0/s4/y11/x15"});
    stage.state.hover = {.kind = Selection::Kind::pixel, .at = {28, 3}};  // beyond side B
    stage.frame("weights", kSmall);
    EXPECT_TRUE(stage.shows("pixel 28, 3"));
    EXPECT_TRUE(stage.shows("not computed"));
    EXPECT_TRUE(stage.shows("outside"));
}

TEST(RowViews, CutNoTextAtAnySize) {
    for (const float scale : {1.0F, 1.5F, 2.5F}) {
        for (const auto& [method, step, view] : {std::array<std::string, 3>{"edge-walk", "t0/s2/y8", "walk"},
                                                 {"edge-equations", "t0/s5/y11/x16", "ribbon"},
                                                 {"barycentric", "t0/s4/y11/x15", "weights"}}) {
            ViewStage stage({.method = method, .step = step, .fonts = {scale, false}});
            for (const ui::Area area : {kSmall, kWide}) {
                stage.frame(view, {area.x, area.y, area.w * scale, area.h * scale});
                for (const ui::TextRecord& text : ui::texts_cut(stage.report))
                    ADD_FAILURE() << view << " at " << scale << ": " << text.text;
            }
        }
    }
}

}  // namespace
}  // namespace texelscope::row_views_test
