// The views of formulas, code and values: drawn at every kind of step, and worked with.
#include <gtest/gtest.h>

#include <set>

#include "app/views/formula_blocks.h"
#include "tests/app/views/view_stage.h"

namespace texelscope {
namespace {

using Places = std::vector<std::pair<std::string, ui::Area>>;

const Places kPlaces{{"formula", {864, 40, 416, 208}}, {"code", {656, 248, 624, 288}}, {"variables", {0, 536, 656, 96}},
                     {"ring", {240, 40, 376, 264}},    {"passes", {0, 310, 240, 220}}, {"owners", {0, 40, 240, 264}}};
const std::vector<std::string> kTriangleSteps{"t0",    "t0/s0",     "t0/s1",         "t0/s3",      "t0/s4",
                                              "t0/s5", "t0/s5/y11", "t0/s5/y11/x16", "t0/s5/y1/x3"};
const std::vector<std::string> kPolygonSteps{"t0", "t0/s0", "t0/s1", "t0/s3/y14", "t0/s3/y14/x9"};

void expect_fits(ViewStage& stage, const std::string& what) {
    for (const ui::TextRecord& cut : ui::texts_cut(stage.report)) ADD_FAILURE() << what << ": cut text " << cut.text;
    for (const ui::ControlRecord& small : ui::small_targets(stage.report))
        ADD_FAILURE() << what << ": small target " << small.name;
    std::vector<std::string> names;
    for (const ui::ControlRecord& c : stage.report.controls) names.push_back(c.name);
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) ADD_FAILURE() << what << ": two controls are called " << *twice;
}

TEST(FormulaViews, NoTextIsCutAtAnyStepOfBothMethods) {
    for (const bool polygon : {false, true}) {
        for (const std::string variant : {"corrected", "as-printed"}) {
            ViewStage stage({.method = polygon ? "sections" : "edge-equations", .variant = variant});
            for (const std::string& step : polygon ? kPolygonSteps : kTriangleSteps) {
                stage.go(step);
                stage.frame(kPlaces);
                stage.frame(kPlaces);
                expect_fits(stage, variant + " " + step);
                for (Integer e = 0; e < static_cast<Integer>(stage.derived.visit().unit().expressions.size()); ++e) {
                    stage.go(step + "/e" + std::to_string(e));
                    stage.frame(kPlaces);
                    expect_fits(stage, variant + " " + step + "/e" + std::to_string(e));
                }
            }
        }
    }
}

TEST(FormulaViews, NoTextIsCutWhenPresentingOrEnlarged) {
    for (const ui::FontSpec& fonts : {ui::FontSpec{1, true}, ui::FontSpec{1.5F, false}, ui::FontSpec{2.5F, false}}) {
        ViewStage stage({.fonts = fonts, .theme = fonts.presenting ? ui::ThemeName::presenting : ui::ThemeName::light});
        for (const std::string view : {"formula", "code", "variables", "owners"}) {
            stage.frame(view, {656, 112, 624, 440});
            expect_fits(stage, view);
            EXPECT_GE(ui::smallest_text(stage.report, false), fonts.presenting ? 24 : 10) << view;
        }
    }
}

TEST(FormulaViews, TextsAreReadableInEveryTheme) {
    for (const ui::ThemeName theme : {ui::ThemeName::dark, ui::ThemeName::light}) {
        ViewStage stage({.theme = theme});
        stage.frame(kPlaces);
        for (const ui::TextRecord& t : ui::faint_texts(stage.report, 4.5)) ADD_FAILURE() << t.text;
    }
}

TEST(Formula, ATermCanBeHoveredAndPinned) {
    ViewStage stage;
    stage.frame("formula", {864, 40, 416, 208});
    const ui::ControlRecord* term = stage.control("u_x");
    if (term == nullptr) term = stage.control("v_x");
    ASSERT_NE(term, nullptr);
    const std::string name = term->label;
    stage.input.mouse = term->area.centre();
    stage.frame("formula", {864, 40, 416, 208});
    const auto* hover = stage.done<action::Hover>();
    ASSERT_NE(hover, nullptr);
    EXPECT_EQ(hover->what.kind, Selection::Kind::name);
    EXPECT_EQ(hover->what.name, name);
    stage.input.pressed[0] = stage.input.down[0] = true;
    stage.frame("formula", {864, 40, 416, 208});
    stage.input.down[0] = false, stage.input.released[0] = true;
    stage.frame("formula", {864, 40, 416, 208});
    const auto* pin = stage.done<action::Pin>();
    ASSERT_NE(pin, nullptr);
    EXPECT_EQ(pin->what.name, name);
}

TEST(Formula, ACornersCoordinateCanBeDragged) {
    ViewStage stage({.step = "t0/s3/e0", .level = Level::expression});
    const ui::Area place{864, 40, 416, 208};
    stage.frame("formula", place);
    const ui::ControlRecord* term = stage.control("y_1");
    ASSERT_NE(term, nullptr);
    stage.input.mouse = term->area.centre();
    stage.frame("formula", place);
    stage.input.pressed[0] = stage.input.down[0] = true;
    stage.frame("formula", place);
    stage.input.mouse.x += 16;
    stage.frame("formula", place);
    const auto* move = stage.done<action::MoveVertex>();
    ASSERT_NE(move, nullptr);
    EXPECT_EQ(move->handle, (Handle{0, 1, false}));
    EXPECT_EQ(move->to, glm::vec2(11.25F, 2.75F));
    EXPECT_NE(move->gesture, 0);
}

TEST(Formula, TheTexelOfThePixelIsToldInFigures) {
    ViewStage stage;
    stage.frame("formula", {864, 40, 416, 208});
    EXPECT_TRUE(stage.shows("#0709"));
    EXPECT_TRUE(stage.shows("column"));
}

TEST(Formula, AnOverflowIsSaidInWords) {
    ViewStage stage({.step = "t0/s0", .format = NumberFormat::fx8_8, .level = Level::stage});
    stage.frame("formula", {864, 40, 416, 208});
    EXPECT_TRUE(stage.shows("left 8.8"));
    EXPECT_TRUE(stage.shows("fx8.8"));
}

TEST(FormulaViews, SayWhatToDoWhereThereIsNoShape) {
    auto empty = std::make_shared<Document>();
    empty->scene = stage_scene(false);
    empty->scene.polygons.clear();
    ViewStage stage({}, empty);
    stage.state.cursor.step = {};
    stage.frame(kPlaces);
    EXPECT_TRUE(stage.shows("scene"));
    expect_fits(stage, "empty");
}

TEST(Code, TheCurrentLineIsInViewAtEveryStep) {
    ViewStage stage({.level = Level::expression});
    for (const std::string& step : kTriangleSteps) {
        stage.go(step);
        stage.frame("code", {656, 248, 624, 288});
        const int line = stage.derived.line();
        if (line == 0) continue;
        EXPECT_TRUE(std::any_of(stage.report.controls.begin(), stage.report.controls.end(),
                                [&](const ui::ControlRecord& c) {
                                    return c.name == "code/line" + std::to_string(line) &&
                                           ui::intersection(c.area, {656, 272, 624, 264}).h >= 17;
                                }))
            << step << " line " << line;
    }
}

TEST(Code, AFoldOpensOnAClickAndTraceComesBackOnDemand) {
    ViewStage stage;
    const ui::Area place{656, 248, 624, 288};
    stage.frame("code", place);
    const auto click = [&](const std::string& prefix) {
        for (const ui::ControlRecord& c : std::vector<ui::ControlRecord>(stage.report.controls)) {
            if (c.name.rfind(prefix, 0) != 0 || ui::intersection(c.area, place).h < c.area.h) continue;
            stage.input.mouse = c.area.centre();
            stage.frame("code", place);
            stage.input.pressed[0] = stage.input.down[0] = true;
            stage.frame("code", place);
            stage.input.down[0] = false, stage.input.released[0] = true;
            stage.frame("code", place);
            return;
        }
        ADD_FAILURE() << prefix;
    };
    click("code/fold");
    ASSERT_NE(stage.done<action::SetLook>(), nullptr);
    EXPECT_EQ(stage.done<action::SetLook>()->look.unfolded.size(), 1U);
    click("code/trace");
    ASSERT_NE(stage.done<action::SetLook>(), nullptr);
    EXPECT_FALSE(stage.done<action::SetLook>()->look.plain_code);
}

TEST(Code, TheGuiltyLineOfAQuirkIsMarked) {
    ViewStage stage({.variant = "as-printed", .step = "t0/s3/e0", .level = Level::expression});
    stage.frame("code", {0, 0, 900, 700});
    EXPECT_TRUE(stage.shows("Q2"));
    stage.state.work.quirks = 0;
    stage.frame("code", {0, 0, 900, 700});
    EXPECT_FALSE(stage.shows("Q2"));
}

TEST(Variables, TheFirstIsTheCurrentOne) {
    ViewStage stage({.step = "t0/s5/y11/x16/e2", .level = Level::expression});
    stage.frame("variables", {0, 536, 656, 96});
    const auto first = std::find_if(
        stage.report.controls.begin(), stage.report.controls.end(),
        [](const ui::ControlRecord& c) { return c.name.rfind("variables/", 0) == 0 && c.kind == ui::Kind::link; });
    ASSERT_NE(first, stage.report.controls.end());
    EXPECT_EQ(first->label, stage.derived.named()->name.text());
    EXPECT_TRUE(stage.shows("−172.6875"));
}

TEST(Ring, PointsAtTheTwoCornersOfTheSection) {
    ViewStage stage({.method = "sections", .variant = "as-printed", .step = "t0/s3/y14", .level = Level::scanline});
    stage.frame("ring", {904, 40, 376, 264});
    EXPECT_TRUE(stage.shows("left"));
    EXPECT_TRUE(stage.shows("right"));
    EXPECT_TRUE(stage.shows("0.3333"));
    EXPECT_TRUE(stage.shows("25.25"));
    EXPECT_NE(stage.control("section 4"), nullptr);
    EXPECT_EQ(stage.control("section 5"), nullptr);
}

TEST(Passes, AreShownOnlyForTheFormWithArrays) {
    ViewStage stage;
    stage.frame("passes", {0, 40, 656, 208});
    EXPECT_EQ(stage.control("mask"), nullptr);
    EXPECT_TRUE(stage.shows("arrays"));
    stage.state.work.quirks = 1U << 6U;
    stage.go("t0/s6/y11/x16");
    stage.frame("passes", {0, 40, 656, 208});
    for (const std::string pass : {"box", "mask", "indices", "uv", "store"})
        EXPECT_NE(stage.control(pass), nullptr) << pass;
    EXPECT_TRUE(stage.shows("540"));
    EXPECT_TRUE(stage.shows("27 × 20"));
    EXPECT_TRUE(stage.shows("1 mask"));
    EXPECT_TRUE(stage.shows("4 store"));
    EXPECT_TRUE(stage.shows("0 of 222")) << "a pass that is not begun has no results";
}

[[nodiscard]] std::shared_ptr<const Document> square() {
    auto document = std::make_shared<Document>();
    document->scene = stage_scene(false);
    Polygon quad;
    for (const auto& [x, y] : {std::pair{4.0F, 4.0F}, {12.0F, 4.0F}, {12.0F, 12.0F}, {4.0F, 12.0F}}) {
        Vertex vertex;
        vertex.x = vertex.u = x;
        vertex.y = vertex.v = y;
        quad.vertices.push_back(vertex);
    }
    document->scene.polygons = {quad};
    return document;
}

TEST(Owners, AnInclusiveRuleDrawsTheDiagonalTwice) {
    ViewStage stage({.step = "t1/s5/y6/x6"}, square());
    stage.state.work.quirks = 1;
    stage.frame("owners", {0, 40, 300, 300});
    EXPECT_TRUE(stage.shows("written 2 times"));
    EXPECT_TRUE(stage.shows("8 pixels drawn twice"));
}

TEST(Owners, TheTopLeftRuleGivesTheDiagonalToOne) {
    ViewStage stage({.step = "t1/s5/y6/x6"}, square());
    stage.frame("owners", {0, 40, 300, 300});
    EXPECT_TRUE(stage.shows("written once"));
    EXPECT_TRUE(stage.shows("on side C, its own"));
    EXPECT_TRUE(stage.shows("not its own"));
    EXPECT_TRUE(stage.shows("no pixel drawn twice"));
}

TEST(Owners, WhatIsNotDecidedIsNotTold) {
    ViewStage stage({.step = "t0/s5/y6/x6/e2"}, square());
    stage.state.cursor.level = Level::expression;
    stage.frame("owners", {0, 40, 300, 300});
    EXPECT_TRUE(stage.shows("not written yet"));
    EXPECT_TRUE(stage.shows("undecided"));
    EXPECT_TRUE(stage.shows("comes later"));
    EXPECT_FALSE(stage.shows("its own"));
    const std::size_t count = stage.derived.visit().unit().expressions.size();
    stage.go("t0/s5/y6/x6/e" + std::to_string(count - 1));
    stage.frame("owners", {0, 40, 300, 300});
    EXPECT_FALSE(stage.shows("undecided"));
    EXPECT_TRUE(stage.shows("comes later"));
}

TEST(Owners, AWholeShapeHasNoPixelButACount) {
    ViewStage stage({.step = "t1"}, square());
    stage.state.work.quirks = 1;
    stage.frame("owners", {0, 40, 208, 208});
    EXPECT_TRUE(stage.shows("8 pixels drawn twice"));
}

TEST(Formula, AListHasOneSizeAndEachNameOnce) {
    ViewStage stage({.step = "t0/s3"});
    stage.derived.update(stage.state);
    const Visit& visit = stage.derived.visit();
    const std::vector<std::int32_t> names = listed_names(visit);
    std::set<std::string> texts;
    for (const std::int32_t n : names) {
        EXPECT_TRUE(texts.insert(visit.tape.names[static_cast<std::size_t>(n)].name.text()).second);
    }
    const ui::Fonts& fonts = stage_fonts({});
    for (const float width : {200.0F, 300.0F, 408.0F}) {
        std::set<float> sizes;
        for (const FormulaBlock& block : formula_list(fonts, visit.tape, names, -1, width)) {
            float most = 0;
            for (const ui::MathText& t : block.box.texts) most = std::max(most, t.font->em);
            sizes.insert(most);
        }
        EXPECT_EQ(sizes.size(), 1U) << width;
    }
}

TEST(Code, ThePinnedLineIsOnTheScreen) {
    const ui::Area place{656, 248, 624, 288};
    for (const std::string step : {"t0", "t0/s3", "t0/s5/y11/x16", "t0/s5/y11"}) {
        for (const std::string text :
             {"quirk.corners", "if (quirk.inclusive)", "quirk.one_winding", "quirk.trunc_box"}) {
            ViewStage stage({.step = step});
            stage.derived.update(stage.state);
            const int line = line_with(stage.derived.listing(), text);
            stage.state.pinned = {.kind = Selection::Kind::line, .line = line};
            stage.frame("code", place);
            bool seen = false;
            for (const ui::TextRecord& t : stage.report.texts) seen |= t.text == std::to_string(line);
            EXPECT_TRUE(seen) << step << ", line " << line;
        }
    }
}

TEST(Code, SteppingOnLeavesThePinnedLine) {
    const ui::Area place{656, 248, 624, 160};
    ViewStage stage({.step = "t0/s5/y11/x16/e0"});
    stage.derived.update(stage.state);
    const int line = line_with(stage.derived.listing(), "quirk.corners");
    stage.state.pinned = {.kind = Selection::Kind::line, .line = line};
    stage.frame("code", place);
    stage.go("t0/s5/y11/x16/e10");
    stage.frame("code", place);
    bool seen = false;
    for (const ui::TextRecord& t : stage.report.texts) seen |= t.text == std::to_string(stage.derived.line());
    EXPECT_TRUE(seen);
}

TEST(Code, BlankLinesAreNoControls) {
    ViewStage stage;
    stage.frame("code", {656, 248, 624, 800});
    for (const ui::ControlRecord& c : stage.report.controls) EXPECT_FALSE(c.label.empty()) << c.name;
}

TEST(Variables, OnlyWholeRowsAreShown) {
    for (const float height : {72.0F, 100.0F, 131.0F, 144.0F}) {
        for (const float scale : {1.0F, 1.5F}) {
            ViewStage stage({.fonts = {scale, false}});
            stage.frame("variables", {0, 536, 656, height});
            for (const ui::ControlRecord& c : stage.report.controls) {
                const bool cut = c.area.bottom() > c.clip.bottom() + 1 && c.area.y < c.clip.bottom() - 1;
                EXPECT_FALSE(cut) << height << ' ' << scale << ' ' << c.name;
            }
        }
    }
}

}  // namespace
}  // namespace texelscope
