#include "app/ui/widgets.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/app/ui/screen.h"

namespace texelscope::ui {
namespace {

constexpr std::string_view kLevels[] = {"T", "G", "S", "P", "E"};

TEST(Segments, EachIsReachedByMouseAndKeys) {
    std::optional<int> picked;
    Screen screen([&](Ui& ui) {
        if (const auto p = segments(ui, "level", {100, 10, 130, 24}, kLevels, 3)) picked = p;
    });
    screen.click({113, 20});
    EXPECT_EQ(picked, 0);
    screen.press(Key::tab);
    screen.press(Key::tab);
    screen.press(Key::enter);
    EXPECT_EQ(picked, 1);
}

TEST(Tabs, FitIntoAnyWidth) {
    for (const float width : {120.0F, 400.0F, 900.0F}) {
        Screen screen([&](Ui& ui) { tabs(ui, "t", {10, 10, width, 30}, kLevels, 0); });
        for (const ControlRecord& c : screen.report.controls) EXPECT_LE(c.area.right(), 10 + width + 0.5F);
    }
}

TEST(Slider, KeysMoveByStepsWithinTheRange) {
    double value = 0.5;
    Screen screen([&](Ui& ui) {
        if (const auto v = slider(ui, "s", {100, 100, 200, 24}, value, {0, 1, 0.1}, "speed")) value = *v;
    });
    screen.press(Key::tab);
    screen.press(Key::right);
    EXPECT_NEAR(value, 0.6, 1e-12);
    screen.press(Key::left, true);
    EXPECT_NEAR(value, 0.6 - 0.1 / 16, 1e-12);
    screen.press(Key::end);
    screen.press(Key::right);
    EXPECT_EQ(value, 1);
    screen.press(Key::home);
    EXPECT_EQ(value, 0);
    EXPECT_TRUE(screen.unused.empty());
}

TEST(Slider, TheMouseSetsTheNearestStep) {
    double value = 0;
    Screen screen([&](Ui& ui) {
        if (const auto v = slider(ui, "s", {100, 100, 212, 24}, value, {0, 10, 1}, "speed")) value = *v;
    });
    screen.mouse_down({100 + 6 + 71, 110});
    EXPECT_EQ(value, 4);
    screen.move({2000, 110});
    EXPECT_EQ(value, 10);
    screen.mouse_up();
}

struct FieldCase {
    std::string value = "16.5";
    FieldResult last;
    int commits = 0;
    void draw(Ui& ui) {
        last = field(ui, "f", {100, 100, 120, 28}, value);
        if (last.committed) value = last.text, ++commits;
    }
};

TEST(Field, TypingIsCommittedByEnter) {
    FieldCase f;
    Screen screen([&](Ui& ui) { f.draw(ui); });
    screen.press(Key::tab);
    EXPECT_TRUE(f.last.editing);
    screen.press(Key::home);
    screen.press(Key::del);
    screen.type("−2");
    screen.press(Key::enter);
    EXPECT_EQ(f.value, "−26.5");
    EXPECT_EQ(f.commits, 1);
    EXPECT_FALSE(f.last.editing);
}

TEST(Field, EscapeKeepsTheValue) {
    FieldCase f;
    Screen screen([&](Ui& ui) { f.draw(ui); });
    screen.press(Key::tab);
    screen.type("99");
    screen.press(Key::escape);
    EXPECT_TRUE(f.last.cancelled);
    screen.frame();
    EXPECT_EQ(f.value, "16.5");
    EXPECT_EQ(f.commits, 0);
}

TEST(Field, LeavingItCommitsAChange) {
    FieldCase f;
    Screen screen([&](Ui& ui) {
        f.draw(ui);
        button(ui, "b", {300, 100, 80, 24}, "B");
    });
    screen.click({150, 110});
    screen.frame();
    screen.type("1");
    screen.press(Key::tab);
    EXPECT_EQ(f.value, "16.51");
}

TEST(Field, LettersAreNoCommandsWhileTyping) {
    FieldCase f;
    Screen screen([&](Ui& ui) { f.draw(ui); });
    screen.press(Key::tab);
    screen.press(Key::p);
    EXPECT_TRUE(screen.unused.empty());
    screen.press(Key::space);
    EXPECT_TRUE(screen.unused.empty());
}

TEST(Field, TheCaretMovesByCharacters) {
    FieldCase f;
    f.value = "aΔb";
    Screen screen([&](Ui& ui) { f.draw(ui); });
    screen.press(Key::tab);
    screen.press(Key::left);
    screen.press(Key::backspace);
    EXPECT_EQ(f.last.text, "ab");
}

TEST(Field, TakesNoControlCharactersAndNoBrokenUtf8) {
    FieldCase f;
    f.value.clear();
    Screen screen([&](Ui& ui) { f.draw(ui); });
    screen.press(Key::tab);
    screen.type(
        "a\x01\n\xFF"
        "b");
    EXPECT_EQ(f.last.text, "ab");
    screen.type(std::string(5000, 'x'));
    EXPECT_EQ(f.last.text, "ab");
}

TEST(Field, OneHandsOverToTheNext) {
    std::string a = "1", b = "2";
    // The later field is drawn first: its editing must not swallow the earlier one's text.
    Screen screen([&](Ui& ui) {
        const FieldResult rb = field(ui, "b", {300, 100, 120, 28}, b);
        const FieldResult ra = field(ui, "a", {100, 100, 120, 28}, a);
        if (rb.committed) b = rb.text;
        if (ra.committed) a = ra.text;
    });
    screen.press(Key::tab, true);
    screen.type("0");
    screen.press(Key::tab);
    screen.frame();
    screen.type("5");
    screen.press(Key::enter);
    EXPECT_EQ(a, "10");
    EXPECT_EQ(b, "25");
}

TEST(Widgets, RandomInputLeavesEverythingInRange) {
    double value = 0.5;
    std::string typed = "1";
    int tab = 0;
    bool shown = true;
    Screen screen([&](Ui& ui) {
        ui.begin_panel("p", {0, 0, 640, 360}, "Title", "note $u_x$");
        if (const auto v = slider(ui, "s", {20, 40, 200, 24}, value, {0, 1, 0.1}, "s", "tip $u_k$")) value = *v;
        if (const auto f = field(ui, "f", {20, 80, 90, 28}, typed); f.committed) typed = f.text;
        if (const auto t = tabs(ui, "t", {20, 120, 300, 30}, kLevels, tab)) tab = *t;
        const Area at = ui.begin_scroll("list", {20, 160, 200, 150});
        for (int i = 0; shown && i < 12; ++i)
            button(ui, "b" + std::to_string(i), {at.x, at.y + 30 * static_cast<float>(i), 90, 24}, "b");
        ui.end_scroll(shown ? 360 : 10);
        ui.end_panel();
    });
    std::mt19937 random(19);
    for (int i = 0; i < 10'000; ++i) {
        screen.input.mouse = {static_cast<float>(random() % 640), static_cast<float>(random() % 360)};
        screen.input.wheel.y = random() % 8 == 0 ? static_cast<float>(random() % 7) - 3 : 0;
        const bool was = screen.input.down[0];
        screen.input.down[0] = random() % 2 == 0;
        screen.input.pressed[0] = !was && screen.input.down[0];
        screen.input.released[0] = was && !screen.input.down[0];
        if (random() % 5 == 0) screen.input.text = "é7";
        if (random() % 50 == 0) shown = !shown;
        screen.press(static_cast<Key>(random() % 60), random() % 3 == 0);
        ASSERT_TRUE(value >= 0 && value <= 1);
        ASSERT_TRUE(screen.memory.focus == 0 || !screen.focused().empty());
        ASSERT_GE(screen.memory.scroll[id_of("list")].offset, 0);
        ASSERT_LE(screen.memory.scroll[id_of("list")].offset, 211);
        ASSERT_LE(screen.memory.caret, screen.memory.field_text.size());
    }
}

}  // namespace
}  // namespace texelscope::ui
