#include "app/ui/ui.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/app/ui/screen.h"

namespace texelscope::ui {
namespace {

const Area kA{100, 100, 80, 24}, kB{200, 100, 80, 24}, kC{300, 100, 80, 24};

void three_buttons(Ui& ui) {
    ButtonStyle off;
    off.enabled = false;
    button(ui, "a", kA, "A");
    button(ui, "off", {400, 100, 80, 24}, "Off", {}, off);
    button(ui, "b", kB, "B");
    button(ui, "c", kC, "C");
}

TEST(Focus, TabVisitsEveryControlOnceAndComesRound) {
    Screen screen(three_buttons);
    std::vector<std::string> seen;
    for (int i = 0; i < 4; ++i) {
        screen.press(Key::tab);
        seen.push_back(screen.focused());
    }
    EXPECT_EQ(seen, (std::vector<std::string>{"a", "b", "c", "a"}));
    screen.press(Key::tab, true);
    EXPECT_EQ(screen.focused(), "c");
}

TEST(Focus, DisabledControlsAreSkipped) {
    Screen screen(three_buttons);
    std::set<std::string> seen;
    for (int i = 0; i < 12; ++i) {
        screen.press(Key::tab, i % 2 == 0);
        seen.insert(screen.focused());
    }
    EXPECT_EQ(seen.count("off"), 0U);
}

TEST(Focus, EscapeGivesItBack) {
    Screen screen(three_buttons);
    screen.press(Key::tab);
    screen.press(Key::escape);
    EXPECT_EQ(screen.memory.focus, 0U);
    EXPECT_TRUE(screen.unused.empty());
    screen.press(Key::escape);
    EXPECT_EQ(screen.unused.size(), 1U);
}

TEST(Focus, GoesWhenItsControlGoes) {
    bool shown = true;
    Screen screen([&](Ui& ui) {
        if (shown) button(ui, "a", kA, "A");
        button(ui, "b", kB, "B");
    });
    screen.press(Key::tab);
    shown = false;
    screen.frame();
    EXPECT_EQ(screen.memory.focus, 0U);
    screen.press(Key::tab);
    EXPECT_EQ(screen.focused(), "b");
}

TEST(Focus, F6GoesFromPanelToPanel) {
    Screen screen([](Ui& ui) {
        for (const char* name : {"one", "two", "three"}) {
            ui.begin_panel(name, {0, 0, 600, 200});
            button(ui, std::string(name) + "/a", kA, "A");
            button(ui, std::string(name) + "/b", kB, "B");
            ui.end_panel();
        }
    });
    screen.press(Key::f6);
    EXPECT_EQ(screen.focused(), "one/a");
    screen.press(Key::tab);
    EXPECT_EQ(screen.focused(), "one/b");
    screen.press(Key::f6);
    EXPECT_EQ(screen.focused(), "two/a");
    screen.press(Key::f6, true);
    EXPECT_EQ(screen.focused(), "one/a");
}

TEST(Control, AClickIsAPressAndAReleaseOverIt) {
    int clicks = 0;
    Screen screen([&](Ui& ui) { clicks += button(ui, "a", kA, "A").clicked ? 1 : 0; });
    screen.click(kA.centre());
    EXPECT_EQ(clicks, 1);
    screen.mouse_down(kA.centre());
    screen.input.mouse = {900, 600};
    screen.mouse_up();
    EXPECT_EQ(clicks, 1);
}

TEST(Control, EnterAndSpaceClickWhatHasTheFocusAndAreUsedUp) {
    int clicks = 0;
    Screen screen([&](Ui& ui) { clicks += button(ui, "a", kA, "A").by_key ? 1 : 0; });
    screen.press(Key::space);
    EXPECT_EQ(clicks, 0);
    EXPECT_EQ(screen.unused.size(), 1U);
    screen.press(Key::tab);
    screen.press(Key::space);
    EXPECT_TRUE(screen.unused.empty());
    screen.press(Key::enter);
    EXPECT_EQ(clicks, 2);
}

TEST(Control, DisabledOnesDoNothing) {
    int clicks = 0;
    Screen screen([&](Ui& ui) {
        ButtonStyle off;
        off.enabled = false;
        clicks += button(ui, "a", kA, "A", {}, off).clicked ? 1 : 0;
    });
    screen.click(kA.centre());
    EXPECT_EQ(clicks, 0);
}

TEST(Control, SmallOnesHaveATargetOf24) {
    int clicks = 0;
    const Area tiny{100, 100, 6, 6};
    Screen screen([&](Ui& ui) { clicks += ui.control({"a", tiny}).clicked ? 1 : 0; });
    screen.click({95, 95});
    EXPECT_EQ(clicks, 1);
    EXPECT_TRUE(small_targets(screen.report).empty());
}

TEST(Control, ADrawnAreaBeatsAGrownOne) {
    std::string clicked;
    Screen screen([&](Ui& ui) {
        if (ui.control({"under", {100, 100, 40, 40}}).clicked) clicked = "under";
        if (ui.control({"over", {142, 100, 4, 40}}).clicked) clicked = "over";
    });
    screen.click({136, 120});
    EXPECT_EQ(clicked, "under");
    screen.click({144, 120});
    EXPECT_EQ(clicked, "over");
}

TEST(Control, RoundHandlesEndAtTheirRadius) {
    Screen screen([&](Ui& ui) { ui.control({"v", {100, 100, 32, 32}, Kind::handle, {}, {}, true, true, true}); });
    screen.move({116, 101});
    EXPECT_NE(screen.memory.hot, 0U);
    screen.move({102, 102});
    EXPECT_EQ(screen.memory.hot, 0U);
}

TEST(Control, ADragSumsUpToTheWay) {
    glm::vec2 sum{0}, total{0};
    Screen screen([&](Ui& ui) {
        const Control c = ui.control({"v", kA, Kind::handle});
        if (c.held) sum += c.drag, total = c.drag_total;
    });
    screen.mouse_down(kA.centre());
    for (int i = 1; i <= 5; ++i) screen.move(kA.centre() + glm::vec2(11 * i, -7 * i));
    screen.mouse_up();
    EXPECT_EQ(sum, glm::vec2(55, -35));
    EXPECT_EQ(total, sum);
    EXPECT_EQ(screen.memory.active, 0U);
}

TEST(Panel, TitleAndNoteAreShortenedNotCut) {
    for (float width = 40; width < 400; width += 9) {
        Screen screen([&](Ui& ui) {
            ui.begin_panel("p", {0, 0, width, 60}, "A very long title indeed",
                           "from $P_1$ to $P_2$, and `some/file.h`");
            ui.end_panel();
        });
        EXPECT_TRUE(texts_cut(screen.report).empty()) << width << ' ' << texts_cut(screen.report).front().text;
    }
}

TEST(Focus, AClickLeavesTheKeysToStepping) {
    Screen screen(three_buttons);
    screen.click(kA.centre());
    EXPECT_EQ(screen.memory.focus, 0U);
    screen.press(Key::space);
    EXPECT_EQ(screen.unused.size(), 1U);
}

TEST(Report, FindsTextThatIsCutButNotInScrollingRegions) {
    const auto body = [](Ui& ui, bool scrolls) {
        if (scrolls) ui.begin_scroll("s", {0, 0, 50, 50});
        if (!scrolls) ui.begin_clip({0, 0, 50, 50});
        ui.text(Face::prose, {10, 20}, Role::text, "longer than the room");
        if (scrolls) ui.end_scroll(200);
        if (!scrolls) ui.end_clip();
    };
    Screen cut([&](Ui&ui) { body(ui, false); }), scrolled([&](Ui&ui) { body(ui, true); });
    scrolled.frame();
    EXPECT_EQ(texts_cut(cut.report).size(), 1U);
    EXPECT_TRUE(texts_cut(scrolled.report).empty());
}

TEST(Scroll, WheelAndKeysStayWithinTheContent) {
    Screen screen([](Ui& ui) {
        ui.begin_scroll("s", {0, 0, 100, 100});
        ui.end_scroll(350);
    });
    screen.frame();
    screen.input.mouse = {50, 50};
    screen.input.wheel = {0, -100};
    screen.frame();
    EXPECT_FLOAT_EQ(screen.memory.scroll[id_of("s")].offset, 250);
    screen.input.wheel = {0, 100};
    screen.frame();
    EXPECT_FLOAT_EQ(screen.memory.scroll[id_of("s")].offset, 0);
    screen.press(Key::tab);
    screen.press(Key::end);
    EXPECT_FLOAT_EQ(screen.memory.scroll[id_of("s")].offset, 250);
}

TEST(Scroll, FollowsTheFocus) {
    Screen screen([](Ui& ui) {
        const Area at = ui.begin_scroll("s", {0, 0, 100, 100});
        for (int i = 0; i < 10; ++i)
            button(ui, "b" + std::to_string(i), {0, at.y + 40 * static_cast<float>(i), 80, 24}, "x");
        ui.end_scroll(400);
    });
    screen.frame();
    for (int i = 0; i < 11; ++i) {
        screen.press(Key::tab);
        screen.frame();
    }
    ASSERT_EQ(screen.focused(), "b9");
    EXPECT_TRUE((Area{0, 0, 100, 100}).covers(screen.report.controls.back().area));
}

TEST(Tip, AppearsAfterItsDelayWithItsMathematics) {
    Screen screen([](Ui& ui) { button(ui, "a", kA, "A", "the gradient $u_x$"); });
    screen.move(kA.centre());
    EXPECT_TRUE(screen.wants_frame);
    screen.frame();
    EXPECT_TRUE(std::any_of(screen.report.texts.begin(), screen.report.texts.end(),
                            [](const TextRecord& t) { return t.text == "gradient"; }));
    EXPECT_TRUE(texts_cut(screen.report).empty());
}

TEST(Fade, ReachesItsEndAndThenAsksForNothing) {
    bool on = false;
    float value = -1;
    Screen screen([&](Ui& ui) { value = ui.fade("f", on); });
    EXPECT_EQ(value, 0);
    on = true;
    screen.input.time -= 0.94;
    screen.frame();
    EXPECT_GT(value, 0);
    EXPECT_LT(value, 1);
    EXPECT_TRUE(screen.wants_frame);
    screen.frame();
    EXPECT_EQ(value, 1);
    EXPECT_FALSE(screen.wants_frame);
}

TEST(Links, ATermIsAControlAndAnswersToItsLink) {
    LinkId clicked = 0;
    const MathBox box = set_math(sum({linked(symbol("u_x"), 41), linked(symbol("u_k"), 42)}),
                                 {&test_fonts(), MathSize::row, false, false});
    Screen screen([&](Ui& ui) {
        if (const auto e = ui.formula("f", box, {100, 100}); e && e->control.clicked) clicked = e->link;
    });
    screen.click(screen.report.controls.at(1).area.centre());
    EXPECT_EQ(clicked, 42U);
}

TEST(Ui, TheSameFrameTwiceIsTheSameReport) {
    Screen screen(three_buttons);
    const std::size_t texts = screen.report.texts.size();
    screen.frame();
    EXPECT_EQ(screen.report.texts.size(), texts);
    EXPECT_EQ(screen.report.controls.size(), 4U);
    EXPECT_TRUE(faint_texts(screen.report, 4.5).empty());
}

}  // namespace
}  // namespace texelscope::ui
