// The views of lessons 2 to 4: strip, lockstep, buffer.
#include <gtest/gtest.h>

#include "tests/app/state/sampling_fixture.h"
#include "tests/app/views/view_stage.h"

namespace texelscope::sampling_views_test {
namespace {

constexpr ui::Area kLarge{656, 248, 624, 288};

[[nodiscard]] std::shared_ptr<const Document> document_of(Scene scene) {
    auto document = std::make_shared<Document>();
    document->scene = std::move(scene);
    return document;
}

/// Eight texels over 14 pixels, and over four.
[[nodiscard]] std::shared_ptr<const Document> ratios() {
    Texture texture{.name = "t", .texels = make_pattern(Pattern::address, 8, 1, 1)};
    Scene scene;
    scene.framebuffer.width = 34, scene.framebuffer.height = 12;
    scene.textures.push_back(std::make_shared<const Texture>(std::move(texture)));
    const auto add = [&](float left, float right, float top) {
        scene.polygons.push_back({.vertices = {{left, top, 0, 1, 0, 0},
                                               {right, top, 0, 1, 8, 0},
                                               {right, top + 4, 0, 1, 8, 1},
                                               {left, top + 4, 0, 1, 0, 1}},
                                  .texture = 0,
                                  .light = 1});
    };
    add(1, 15, 1), add(1, 5, 7);
    return document_of(std::move(scene));
}

[[nodiscard]] int count_of(const ViewStage& stage, const std::string& text) {
    int count = 0;
    for (const ui::TextRecord& t : stage.report.texts) count += t.text == text;
    return count;
}

TEST(Strip, NamesRatioAndStartAndMarksWhatIsReadAgain) {
    ViewStage stage({.method = "sampling-1d", .variant = "as-printed", .step = "t0/s2/y2", .level = Level::scanline},
                    ratios());
    stage.frame("strip", kLarge);
    EXPECT_TRUE(stage.shows("0.57"));
    EXPECT_EQ(count_of(stage, "×2"), 6);
    EXPECT_EQ(count_of(stage, "×0"), 0);
    EXPECT_TRUE(stage.shows("0 never read, 6 read again"));
}

TEST(Strip, MarksTexelsThatAreNeverReadOnceTheRowIsDone) {
    ViewStage stage({.method = "sampling-1d", .variant = "as-printed", .step = "t1/s2/y8", .level = Level::scanline},
                    ratios());
    stage.frame("strip", kLarge);
    EXPECT_EQ(count_of(stage, "×0"), 4);
    stage.go("t1/s2/y8/x2");
    stage.frame("strip", kLarge);
    EXPECT_EQ(count_of(stage, "×0"), 0);
}

TEST(Strip, SaysNothingOfPixelsThatAreStillToCome) {
    ViewStage stage({.method = "sampling-1d", .variant = "as-printed", .step = "t0/s1", .level = Level::stage},
                    ratios());
    stage.frame("strip", kLarge);
    EXPECT_EQ(count_of(stage, "7"), 1) << "the texel's own number alone";
    EXPECT_EQ(count_of(stage, "×2"), 0);
}

TEST(Strip, ShowsAnIndexPastTheEnd) {
    ViewStage stage({.method = "sampling-1d", .step = "t1/s2/y8", .level = Level::scanline}, ratios());
    stage.state.work.quirks = 0b1000;
    stage.frame("strip", kLarge);
    EXPECT_EQ(count_of(stage, "8"), 2) << "over the end, and below its pixel";
    EXPECT_TRUE(stage.shows("past end"));
}

TEST(Strip, ItsStartsAreOneChoice) {
    ViewStage stage({.method = "sampling-1d", .variant = "as-printed", .step = "t0/s2/y2", .level = Level::scanline},
                    ratios());
    stage.frame("strip", kLarge);
    const ui::ControlRecord* zero = stage.control("0");
    ASSERT_NE(zero, nullptr);
    stage.input.mouse = zero->area.centre();
    stage.frame("strip", kLarge);
    stage.input.pressed[0] = stage.input.down[0] = true;
    stage.frame("strip", kLarge);
    stage.input.down[0] = false, stage.input.released[0] = true;
    stage.frame("strip", kLarge);
    const auto* set = stage.done<action::SetQuirks>();
    ASSERT_NE(set, nullptr);
    EXPECT_EQ(set->quirks, 0b0110U);
}

TEST(Strip, ItsSliderMovesTheCornersAtTheRightEnd) {
    ViewStage stage({.method = "sampling-1d", .step = "t0/s2/y2", .level = Level::scanline}, ratios());
    stage.frame("strip", kLarge);
    const ui::ControlRecord* n = stage.control("$n$");
    ASSERT_NE(n, nullptr);
    stage.input.mouse = {n->area.right() - 1, n->area.centre().y};
    stage.frame("strip", kLarge);
    stage.input.pressed[0] = stage.input.down[0] = true;
    stage.frame("strip", kLarge);
    const auto* move = stage.done<action::MoveShape>();
    ASSERT_NE(move, nullptr);
    EXPECT_EQ(move->to, (std::vector<glm::vec2>{{1, 1}, {33, 1}, {33, 5}, {1, 5}}));
    EXPECT_NE(move->gesture, 0);
}

TEST(LockstepView, SaysHowMuchForwardLeavesEmptyOnceItIsDone) {
    ViewStage stage({.method = "forward", .step = "t0/s1", .level = Level::stage},
                    document_of(turned_scene(64, 64, 0, 1.5)));
    stage.frame("lockstep", kLarge);
    EXPECT_FALSE(stage.shows("% empty"));
    stage.go("t0");
    stage.frame("lockstep", kLarge);
    EXPECT_TRUE(stage.shows("55.6 % empty: 5120 of 9216"));
    EXPECT_TRUE(stage.shows("9216 drawn, each once"));
}

TEST(LockstepView, SaysHowMuchIsWrittenAgainAt30Degrees) {
    ViewStage stage({.method = "forward", .step = "t0", .level = Level::triangle},
                    document_of(turned_scene(64, 64, 30, 1)));
    stage.frame("lockstep", kLarge);
    EXPECT_TRUE(stage.shows("13.5 % empty: 552 of 4096"));
    EXPECT_TRUE(stage.shows("512 written again"));
}

TEST(LockstepView, APixelCanBePinnedInEitherPicture) {
    ViewStage stage({.method = "forward", .step = "t0", .level = Level::triangle},
                    document_of(turned_scene(16, 16, 0, 1.5)));
    for (const char* name : {"Forward", "Backward"}) {
        stage.frame("lockstep", kLarge);
        const ui::ControlRecord* picture = stage.control(name);
        ASSERT_NE(picture, nullptr) << name;
        stage.input.mouse = picture->area.centre();
        stage.frame("lockstep", kLarge);
        stage.input.pressed[0] = stage.input.down[0] = true;
        stage.frame("lockstep", kLarge);
        stage.input.down[0] = false, stage.input.released[0] = true;
        stage.frame("lockstep", kLarge);
        const auto* pin = stage.done<action::Pin>();
        ASSERT_NE(pin, nullptr) << name;
        EXPECT_EQ(pin->what.kind, Selection::Kind::pixel);
    }
}

TEST(LockstepView, ThePixelThatATexelFallsOnIsTheCursors) {
    ViewStage stage({.method = "forward", .step = "t0/s2/v8/u9"}, document_of(turned_scene(64, 64, 0, 1.5)));
    stage.derived.update(stage.state);
    EXPECT_EQ(stage.derived.pixel(), glm::ivec2(12 + 14, 12 + 12));
    stage.go("t0/s2/v8/u9/e0");
    stage.state.cursor.level = Level::expression;
    stage.derived.update(stage.state);
    EXPECT_EQ(stage.derived.pixel(), std::nullopt) << "not computed yet";
}

TEST(BufferView, ThePixelThatTheSecondPassWritesIsTheCursorsAsPrintedToo) {
    for (const char* variant : {"as-printed", "corrected"}) {
        ViewStage stage({.method = "two-pass", .variant = variant}, document_of(turned_scene(16, 16, 0, 1)));
        stage.go(std::string(variant) == "corrected" ? "t0/s4/x60/y58" : "t0/s4/x60/v6");
        stage.derived.update(stage.state);
        EXPECT_EQ(stage.derived.pixel(), glm::ivec2(60, 58)) << variant;
        EXPECT_EQ(stage.derived.texel(), glm::ivec2(8, 6)) << variant;
        stage.frame("buffer", kLarge);
        EXPECT_TRUE(stage.shows("16 of 16 columns")) << variant;
    }
}

TEST(BufferView, SaysHowWideTheBufferIs) {
    for (const auto& [degrees, text] : std::vector<std::pair<double, std::string>>{
             {60, "32 of 64 columns"}, {75, "16.6 of 64 columns"}, {90, "0 of 64 columns"}}) {
        ViewStage stage({.method = "two-pass", .step = "t0", .level = Level::triangle},
                        document_of(turned_scene(64, 16, degrees, 1)));
        stage.frame("buffer", kLarge);
        EXPECT_TRUE(stage.shows(text)) << degrees;
    }
}

TEST(BufferView, TurningMovesAllCornersAtOnce) {
    ViewStage stage({.method = "two-pass", .step = "t0", .level = Level::triangle},
                    document_of(turned_scene(64, 16, 0, 1)));
    stage.frame("buffer", kLarge);
    const ui::ControlRecord* turn = stage.control("turn");
    ASSERT_NE(turn, nullptr);
    stage.input.mouse = {turn->area.x + 6 + (turn->area.w - 12) * .75F,
                         turn->area.centre().y};  // between the knob's ends
    stage.frame("buffer", kLarge);
    stage.input.pressed[0] = stage.input.down[0] = true;
    stage.frame("buffer", kLarge);
    const auto* move = stage.done<action::MoveShape>();
    ASSERT_NE(move, nullptr);
    ASSERT_EQ(move->to.size(), 4U);
    EXPECT_NEAR(move->to[0].x, 68, 1);
    EXPECT_NEAR(move->to[1].y, 92, 1);
}

TEST(SamplingViews, SayWhatTheyAreForUnderAnotherMethodAndWithoutAShape) {
    for (const auto& [view, method] : std::vector<std::pair<std::string, std::string>>{
             {"strip", "sampling-1d"}, {"lockstep", "forward"}, {"buffer", "two-pass"}}) {
        ViewStage other;
        other.frame(view, kLarge);
        EXPECT_TRUE(other.shows(method)) << view;
        ViewStage empty({.step = "t0"}, document_of(Scene{}));
        empty.frame(view, kLarge);
        EXPECT_TRUE(empty.shows(method)) << view;
    }
}

}  // namespace
}  // namespace texelscope::sampling_views_test
