#include "app/views/screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "app/platform/scripted_input.h"
#include "app/shell/headless.h"
#include "app/views/screen_parts.h"
#include "tests/app/state/fixture.h"

namespace texelscope::screen_test {
namespace {

using ui::Key;

constexpr glm::vec2 kSize{1280, 720};

/// The whole program over the quad, without a lesson or with a small one.
class ScreenTest : public testing::Test {
protected:
    static std::shared_ptr<const Document> lesson_document() {
        auto document = std::make_shared<Document>(*quad_document());
        Lesson lesson;
        lesson.id = "05-test", lesson.number = 5, lesson.title = "Half-planes and the bounding box",
        lesson.levels = "SP";
        lesson.method = "edge-equations", lesson.variant = "corrected", lesson.format = "f32";
        for (int n = 0; n < 7; ++n) {
            Beat beat;
            beat.lead = "Inside is where three signs agree.";
            beat.prose = "Two decided this sample: $E_A$ said minus, $E_B$ said plus, and the third was never asked.";
            if (n == 1)
                beat.prediction = Prediction{"$P_1$ and $P_2$ are exchanged. What is drawn?",
                                             Prediction::Kind::choice,
                                             {"the same", "nothing", "the box"}};
            if (n == 2) beat.prediction = Prediction{"Which pixel?", Prediction::Kind::pixel};
            if (n == 3) beat.prediction = Prediction{"How many?", Prediction::Kind::number};
            lesson.beats.push_back(beat);
        }
        document->lesson = lesson;
        return document;
    }
    void open(std::shared_ptr<const Document> document, const Look& look = {}, glm::vec2 size = kSize) {
        State before;
        before.look = look;
        before.look.reduced_motion = true;
        auto started = Headless::start(opened(std::move(document), before), size);
        ASSERT_TRUE(started) << started.error().text();
        app = *std::move(started);
        app->settle();
    }
    void press(const ui::KeyPress& key) {
        app->input = press_key(app->input, key);
        app->frame();
        app->settle();
    }
    [[nodiscard]] const ui::ControlRecord* control(std::string_view name) const {
        for (const ui::ControlRecord& c : app->shell().report().controls) {
            if (c.name == name) return &c;
        }
        return nullptr;
    }
    [[nodiscard]] bool shows(std::string_view text) const {
        const auto& texts = app->shell().report().texts;
        return std::any_of(texts.begin(), texts.end(),
                           [&](const ui::TextRecord& t) { return t.text.find(text) != std::string::npos; });
    }
    void click_on(std::string_view name) {
        const ui::ControlRecord* c = control(name);
        ASSERT_NE(c, nullptr) << name;
        click_at(c->area.centre());
    }
    void click_at(glm::vec2 place) {
        for (const ui::Input& input : click(app->input, place)) {
            app->input = input;
            app->frame();
        }
        app->settle();
    }
    std::unique_ptr<Headless> app;
};

TEST_F(ScreenTest, EveryControlIsReachedByTab) {
    open(lesson_document());
    for (const Overlay overlay : {Overlay::none, Overlay::lessons, Overlay::keys, Overlay::formats, Overlay::quirks}) {
        app->store().dispatch(action::Show{overlay});
        app->settle();
        std::set<ui::Id> wanted, met;
        for (const ui::ControlRecord& c : app->shell().report().controls) {
            if (c.enabled && c.focusable) wanted.insert(c.id);
        }
        for (std::size_t n = 0; n < 2 * wanted.size() + 4; ++n) {
            press({Key::tab});
            met.insert(app->shell().memory().focus);
        }
        for (const ui::ControlRecord& c : app->shell().report().controls) {
            if (!c.enabled || !c.focusable) continue;
            EXPECT_TRUE(met.count(c.id) != 0) << c.name;
        }
        for (int n = 0; n < 3; ++n) press({Key::escape});
        EXPECT_EQ(app->state().overlay, Overlay::none);
        EXPECT_EQ(app->shell().memory().focus, 0U);
    }
}

TEST_F(ScreenTest, ControlsHaveNamesOfTheirOwnAndLabels) {
    open(lesson_document());
    for (const Overlay overlay :
         {Overlay::none, Overlay::lessons, Overlay::keys, Overlay::formats, Overlay::quirks, Overlay::go_to}) {
        app->store().dispatch(action::Show{overlay});
        app->settle();
        std::set<std::string> names;
        for (const ui::ControlRecord& c : app->shell().report().controls) {
            EXPECT_TRUE(names.insert(c.name).second) << c.name;
            EXPECT_TRUE(c.kind == ui::Kind::link || !c.label.empty()) << c.name;
        }
        app->store().dispatch(action::Show{Overlay::none});
    }
}

TEST_F(ScreenTest, NoTextOfTheFrameWorkLeavesItsPlace) {
    for (const glm::vec2 size : {glm::vec2{800, 600}, kSize, glm::vec2{1920, 1080}}) {
        for (const float scale : {1.0F, 1.25F, 1.5F, 2.0F, 2.5F}) {
            Look look;
            look.scale = scale;
            open(lesson_document(), look, size);
            for (const Overlay overlay :
                 {Overlay::none, Overlay::lessons, Overlay::keys, Overlay::formats, Overlay::quirks, Overlay::go_to}) {
                if (overlay != Overlay::none) app->store().dispatch(action::Show{overlay});
                app->settle();
                for (const ui::TextRecord& t : texts_cut(app->shell().report()))
                    ADD_FAILURE() << size.x << " x " << size.y << " scale " << scale << " overlay "
                                  << static_cast<int>(overlay) << ": " << t.text;
                app->store().dispatch(action::Show{Overlay::none});
            }
        }
    }
}

TEST_F(ScreenTest, PresentingShowsNoTextBelowTwentyFourPixels) {
    Look look;
    look.presenting = true;
    open(lesson_document(), look);
    for (int tab = 0; tab < 5; ++tab) {
        look.tab = tab;
        app->store().dispatch(action::SetLook{look});
        app->settle();
        EXPECT_GE(smallest_text(app->shell().report(), false), 24) << tab;
        for (const ui::TextRecord& t : texts_cut(app->shell().report())) ADD_FAILURE() << tab << ": " << t.text;
    }
}

TEST_F(ScreenTest, TextIsReadableInBothThemes) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        Look look;
        look.theme = theme;
        open(lesson_document(), look);
        for (const Overlay overlay :
             {Overlay::none, Overlay::lessons, Overlay::keys, Overlay::formats, Overlay::quirks}) {
            if (overlay != Overlay::none) app->store().dispatch(action::Show{overlay});
            app->settle();
            for (const ui::TextRecord& t : faint_texts(app->shell().report(), 4.5))
                ADD_FAILURE() << static_cast<int>(theme) << ": " << t.text;
            app->store().dispatch(action::Show{Overlay::none});
        }
    }
}

TEST_F(ScreenTest, TheHeadersButtonsNeverMove) {
    open(lesson_document());
    const auto places = [&] {
        std::vector<ui::Area> all;
        for (const char* name :
             {"undo", "redo", "level/T", "level/E", "format", "variant", "smaller", "larger", "theme", "present"}) {
            const ui::ControlRecord* c = control(name);
            EXPECT_NE(c, nullptr) << name;
            if (c != nullptr) all.push_back(c->area);
        }
        return all;
    };
    const std::vector<ui::Area> before = places();
    app->store().dispatch(action::SetFormat{NumberFormat::fx16_16});
    app->store().dispatch(action::SetVariant{"as-printed"});
    app->store().dispatch(action::StepEnd{true});
    app->store().dispatch(action::SetLevel{Level::expression});
    app->settle();
    EXPECT_EQ(places(), before);
}

TEST_F(ScreenTest, OnlyTheLessonsLevelsAreSwitches) {
    open(lesson_document());
    app->store().dispatch(action::SetLevel{Level::pixel});
    app->settle();
    EXPECT_TRUE(control("level/S")->enabled);
    EXPECT_FALSE(control("level/E")->enabled);
    press({Key::down});
    EXPECT_EQ(app->state().cursor.level, Level::expression) << "keys go everywhere";
}

TEST_F(ScreenTest, TheFormatListChangesTheFormatAndItsPolicy) {
    open(lesson_document());
    click_on("format");
    EXPECT_EQ(control("overflow/2"), nullptr) << "floats have no overflow policy";
    click_on("format/fx8.8");
    EXPECT_EQ(app->state().work.format, NumberFormat::fx8_8);
    click_on("overflow/2");
    EXPECT_EQ(app->state().work.mode.overflow, Overflow::wrap);
    press({Key::escape});
    press({Key::escape});
    EXPECT_EQ(app->state().overlay, Overlay::none);
}

TEST_F(ScreenTest, EveryQuirkIsASwitch) {
    open(lesson_document());
    click_on("variant");
    const Method& method = app->store().derived().method();
    for (std::size_t n = 0; n < method.quirks.size(); ++n) {
        const std::string name = "quirk/" + std::string(method.quirks[n].field);
        const QuirkSet before = app->state().work.quirks;
        app->shell().memory().focus = ui::id_of(name);
        press({Key::enter});
        EXPECT_EQ(app->state().work.quirks ^ before, QuirkSet{1} << n) << name;
    }
}

TEST_F(ScreenTest, ScrubbingToATickIsSteppingToIt) {
    open(lesson_document());
    const Path first_row = *parse_path("t0/s5/y6");
    app->store().dispatch(action::StepTo{first_row});
    app->settle();
    const ui::Area lanes = control("timeline/lanes")->area;
    const Lane rows = app->store().derived().lanes()[2];
    ASSERT_GT(rows.count, 4);
    const float pitch = lanes.h / kLevels;
    const auto place = [&](Integer n) {
        return glm::vec2{lanes.x + lanes.w * (static_cast<float>(n) + .5F) / static_cast<float>(rows.count),
                         lanes.y + 2 * pitch + 4};
    };
    for (const ui::Input& input : drag(app->input, place(1), place(rows.count - 1), 7)) {
        app->input = input;
        app->frame();
    }
    app->settle();
    EXPECT_EQ(app->state().cursor.step.index_of('y'), rows.first + rows.count - 1);
    for (const ui::Input& input : drag(app->input, place(rows.count - 1), place(2), 5)) {
        app->input = input;
        app->frame();
    }
    app->settle();
    const Cursor scrubbed = app->state().cursor;
    app->store().dispatch(action::StepTo{first_row});
    const int way = rows.first + 2 > 6 ? 1 : -1;
    while (app->state().cursor.step.index_of('y') != rows.first + 2 ||
           app->state().cursor.step.index_of('t') != scrubbed.step.index_of('t')) {
        const Path before = app->state().cursor.step;
        app->store().dispatch(action::Step{way});
        ASSERT_NE(before, app->state().cursor.step);
    }
    EXPECT_EQ(app->state().cursor, scrubbed);
}

TEST_F(ScreenTest, HoveringATickHighlightsIt) {
    open(lesson_document());
    const ui::Area lanes = control("timeline/lanes")->area;
    app->input = move_mouse(app->input, {lanes.x + lanes.w * .3F, lanes.y + 2});
    app->frame();
    app->frame();
    EXPECT_EQ(app->state().hover.kind, Selection::Kind::tick);
    EXPECT_EQ(app->state().hover.tick, (Path{{{'t', 0}}}));
    app->input = move_mouse(app->input, {5, 5});
    app->frame();
    app->frame();
    EXPECT_EQ(app->state().hover.kind, Selection::Kind::none);
}

TEST_F(ScreenTest, APredictionIsAnsweredWithTheKeysAlone) {
    open(lesson_document());
    press({Key::page_down});
    const auto focus = [&](std::string_view name) {
        for (int n = 0; n < 200 && app->shell().memory().focus != ui::id_of(name); ++n) press({Key::tab});
    };
    focus("prediction/option/1");
    press({Key::space});
    ASSERT_EQ(app->state().work.answers.size(), 1U);
    EXPECT_EQ(app->state().work.answers[0].chosen, std::vector<int>{1});
    focus("prediction/skip");
    press({Key::enter});
    EXPECT_EQ(app->state().work.answers[0].verdict, Answer::Verdict::skipped);
    EXPECT_TRUE(shows("Skipped."));
}

TEST_F(ScreenTest, ANumberIsTypedAndAPlaceIsTakenFromWhatIsPinned) {
    open(lesson_document());
    press({Key::page_down});
    press({Key::page_down});
    Selection pinned;
    pinned.kind = Selection::Kind::pixel, pinned.at = {6, 7};
    app->store().dispatch(action::Pin{pinned});
    app->settle();
    click_on("prediction/pinned");
    EXPECT_EQ(app->state().work.answers[0].places, std::vector<glm::ivec2>{pinned.at});
    click_on("prediction/place/0");
    EXPECT_TRUE(app->state().work.answers[0].places.empty());
    press({Key::page_down});
    click_on("prediction/number");
    app->input = type_text(app->input, "12");
    app->frame();
    press({Key::enter});
    EXPECT_EQ(app->state().work.answers[1].typed, "12");
}

TEST_F(ScreenTest, GoToTakesAPathOrAPixelAndExplainsAnythingElse) {
    open(lesson_document());
    const auto go = [&](const char* text) {
        press({Key::g, true});
        app->input = type_text(app->input, text);
        app->frame();
        press({Key::enter});
    };
    go("t1");
    EXPECT_EQ(app->state().cursor.step.index_of('t'), 1);
    go("12, 10");
    EXPECT_EQ(app->state().cursor.step.index_of('x'), 12);
    EXPECT_EQ(app->state().cursor.step.index_of('y'), 10);
    const Cursor before = app->state().cursor;
    go("0,0");
    EXPECT_TRUE(app->state().message.error);
    EXPECT_EQ(app->state().cursor, before);
    EXPECT_EQ(app->state().overlay, Overlay::none);
}

TEST_F(ScreenTest, TheListShowsTheLastLessonAsThere) {
    open(lesson_document());
    press({Key::l});
    EXPECT_TRUE(shows("Work not done"));
    app->store().dispatch(action::ChooseLesson{20});
    app->settle();
    EXPECT_FALSE(shows("version.")) << "no lesson of the curriculum is missing";
}

TEST_F(ScreenTest, ABlankScreenIsBlankAndComesBack) {
    Look look;
    look.presenting = true;
    open(lesson_document(), look);
    press({Key::b});
    EXPECT_TRUE(app->shell().report().texts.empty());
    EXPECT_TRUE(app->shell().report().controls.empty());
    press({Key::b});
    EXPECT_FALSE(app->shell().report().texts.empty());
}

TEST_F(ScreenTest, ASceneWithoutALessonGetsHints) {
    open(quad_document());
    EXPECT_TRUE(shows("Drag"));
    EXPECT_EQ(control("beat/next"), nullptr);
}

TEST_F(ScreenTest, ASceneWithoutShapesIsShownToo) {
    auto empty = std::make_shared<Document>(*quad_document());
    empty->scene.polygons.clear();
    open(empty);
    for (const Key key : {Key::right, Key::down, Key::home, Key::space, Key::m}) press({key});
    EXPECT_TRUE(shows("no shape"));
}

TEST_F(ScreenTest, NothingOpenSaysWhatToDo) {
    State state;
    auto started = Headless::start(state, kSize);
    ASSERT_TRUE(started) << started.error().text();
    app = *std::move(started);
    app->settle();
    EXPECT_TRUE(shows("lessons"));
}

TEST_F(ScreenTest, AMessageIsOneLineOverTheCanvas) {
    open(lesson_document());
    const std::string text(400, 'x');
    app->store().dispatch(action::Say{{text, true}});
    app->settle();
    ASSERT_NE(control("message"), nullptr);
    EXPECT_TRUE(texts_cut(app->shell().report()).empty());
    press({Key::right});
    EXPECT_EQ(control("message"), nullptr);
}

TEST(SideViews, ABeatReplacesTheLessonsAndTheyStayUntilTheNext) {
    auto document = std::make_shared<Document>();
    Lesson lesson;
    lesson.views = {"face", "ring", "code"};
    lesson.beats.resize(3);
    lesson.beats[1].set.views = {"formula"};
    document->lesson = lesson;
    State state;
    state.document = document;
    EXPECT_EQ(side_views(state), (std::vector<std::string_view>{"face", "ring", "code"}));
    EXPECT_EQ(layout_of(state, kSize).slots[0].w, 248);
    state.cursor.beat = 2;
    EXPECT_EQ(side_views(state), (std::vector<std::string_view>{"formula"}));
    state.look.difference = true;
    EXPECT_EQ(side_views(state), (std::vector<std::string_view>{"difference"}));
    state.cursor.beat = 0;
    EXPECT_EQ(side_views(state), (std::vector<std::string_view>{"face", "ring", "difference"}));
    state.document = nullptr;
    EXPECT_EQ(side_views(state), (std::vector<std::string_view>{"texels", "formula", "difference"}));
}

TEST(SideViews, ThePaletteTakesTheFirstPlaceWhereItIsAskedFor) {
    auto document = std::make_shared<Document>();
    Lesson lesson;
    lesson.beats.resize(1);
    State state;
    state.look.palette = true;
    const auto with = [&](std::vector<std::string> views) {
        lesson.views = std::move(views);
        document->lesson = lesson;
        state.document = document;
        const auto names = side_views(state);
        return std::vector<std::string>(names.begin(), names.end());
    };
    EXPECT_EQ(with({"texels", "formula", "code"}), (std::vector<std::string>{"palette", "formula", "code"}));
    EXPECT_EQ(with({"race"}), (std::vector<std::string>{"palette", "race"}));
    EXPECT_EQ(with({"texels", "palette"}), (std::vector<std::string>{"texels", "palette"}));
    state.document = nullptr;
    EXPECT_EQ(side_views(state).front(), "palette");
}

}  // namespace
}  // namespace texelscope::screen_test
