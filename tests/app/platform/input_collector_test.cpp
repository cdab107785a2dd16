#include "app/platform/input_collector.h"

#include <gtest/gtest.h>

namespace texelscope {
namespace {

using ui::Key;

TEST(InputCollector, EventsBelongToOneFrameAndStatesToAll) {
    InputCollector events;
    events.move({5, 6});
    events.wheel({0, 1});
    events.wheel({0, 2});
    events.drop("a.png");
    events.key_down(30, Key::v, false);
    events.character(U'v');
    const ui::Input first = events.take({100, 50}, 1.5);
    EXPECT_EQ(first.wheel, glm::vec2(0, 3));
    EXPECT_EQ(first.text, "v");
    EXPECT_EQ(first.dropped, std::vector<std::string>{"a.png"});
    EXPECT_EQ(first.keys, std::vector<ui::KeyPress>{{Key::v}});
    EXPECT_EQ(first.size, glm::vec2(100, 50));
    EXPECT_EQ(first.time, 1.5);
    const ui::Input second = events.take({100, 50}, 2);
    EXPECT_EQ(second.mouse, glm::vec2(5, 6));
    EXPECT_EQ(second.held, std::vector<Key>{Key::v});
    EXPECT_TRUE(second.keys.empty() && second.text.empty() && second.dropped.empty());
    EXPECT_EQ(second.wheel, glm::vec2(0));
}

TEST(InputCollector, APressActsWhereItWasMade) {
    InputCollector events;
    events.move({5, 6});
    events.button(0, true, 0);
    events.move({7, 8});
    events.move({9, 9});
    events.button(0, false, 0.001);
    events.move({20, 20});
    EXPECT_TRUE(events.waiting());
    const ui::Input press = events.take({1, 1}, 0), release = events.take({1, 1}, 0), after = events.take({1, 1}, 0);
    EXPECT_TRUE(press.pressed[0] && press.down[0] && !press.released[0]);
    EXPECT_EQ(press.mouse, glm::vec2(5, 6));
    EXPECT_TRUE(release.released[0] && !release.pressed[0] && !release.down[0]);
    EXPECT_EQ(release.mouse, glm::vec2(9, 9));
    EXPECT_FALSE(after.pressed[0] || after.released[0] || after.down[0]);
    EXPECT_EQ(after.mouse, glm::vec2(20, 20));
    EXPECT_FALSE(events.waiting());
}

TEST(InputCollector, AKeyHeldWithAnotherIsHeldInItsFrame) {
    InputCollector events;
    events.key_down(1, Key::v, false);
    events.key_down(2, Key::right, false);
    events.key_up(2);
    events.key_up(1);
    EXPECT_EQ(events.take({1, 1}, 0).keys, std::vector<ui::KeyPress>{{Key::v}});
    const ui::Input arrow = events.take({1, 1}, 0);
    EXPECT_EQ(arrow.keys, std::vector<ui::KeyPress>{{Key::right}});
    EXPECT_EQ(arrow.held, (std::vector<Key>{Key::v, Key::right}));
    EXPECT_TRUE(events.take({1, 1}, 0).held.empty());
}

bool doubled(double later, glm::vec2 away) {
    InputCollector events;
    events.move({50, 50});
    events.button(0, true, 1);
    events.button(0, false, 1.05);
    events.move(glm::vec2(50, 50) + away);
    events.button(0, true, 1 + later);
    static_cast<void>(events.take({1, 1}, 2));
    static_cast<void>(events.take({1, 1}, 2));
    return events.take({1, 1}, 2).double_clicked;
}

TEST(InputCollector, ADoubleClickIsSoonAndNear) {
    EXPECT_TRUE(doubled(0.2, {0, 0}));
    EXPECT_TRUE(doubled(0.4, {4, 4}));
    EXPECT_FALSE(doubled(0.5, {0, 0}));
    EXPECT_FALSE(doubled(0.2, {7, 0}));
}

TEST(InputCollector, AThirdPressIsNoDoubleClick) {
    InputCollector events;
    const auto press = [&](double time) {
        events.button(0, true, time);
        events.button(0, false, time);
        const bool double_clicked = events.take({1, 1}, time).double_clicked;
        static_cast<void>(events.take({1, 1}, time));
        return double_clicked;
    };
    EXPECT_FALSE(press(1));
    EXPECT_TRUE(press(1.1));
    EXPECT_FALSE(press(1.2));
    EXPECT_TRUE(press(1.3));
}

TEST(InputCollector, AKeyIsLetGoAsWhatItWasPressedAs) {
    InputCollector events;
    events.key_down(24, Key::q, false);
    EXPECT_EQ(events.take({1, 1}, 0).held, std::vector<Key>{Key::q});
    events.key_down(24, Key::a, true);
    EXPECT_EQ(events.take({1, 1}, 0).held, std::vector<Key>{Key::q});
    events.key_up(24);
    EXPECT_TRUE(events.take({1, 1}, 0).held.empty());
}

TEST(InputCollector, RepeatsOfOneKeyShareAFrame) {
    InputCollector events;
    events.key_down(7, Key::right, false);
    events.key_down(7, Key::right, true);
    events.key_down(7, Key::right, true);
    EXPECT_FALSE(events.waiting());
    EXPECT_EQ(events.take({1, 1}, 0).keys.size(), 3U);
}

TEST(InputCollector, KeysCarryTheModifiersOfTheirMoment) {
    InputCollector events;
    events.modifiers(true, false, false);
    events.key_down(1, Key::z, false);
    events.modifiers(false, true, false);
    events.key_down(2, Key::y, false);
    EXPECT_EQ(events.take({1, 1}, 0).keys, std::vector<ui::KeyPress>({{Key::z, true}}));
    EXPECT_EQ(events.take({1, 1}, 0).keys, std::vector<ui::KeyPress>({{Key::y, false, true}}));
}

TEST(InputCollector, ADragOutsideKeepsItsPositionAndAHoverDoesNot) {
    InputCollector events;
    events.move({3, 4});
    events.button(0, true, 0);
    events.leave();
    EXPECT_EQ(events.take({1, 1}, 0).mouse, glm::vec2(3, 4));
    events.button(0, false, 0);
    events.leave();
    EXPECT_EQ(events.take({1, 1}, 0).mouse, glm::vec2(3, 4));
    EXPECT_EQ(events.take({1, 1}, 0).mouse, ui::Input{}.mouse);
}

TEST(InputCollector, UnknownButtonsAndKeysAreIgnored) {
    InputCollector events;
    events.button(3, true, 0);
    events.button(-1, true, 0);
    events.key_down(9, Key::none, false);
    const ui::Input input = events.take({1, 1}, 0);
    EXPECT_TRUE(input.keys.empty() && input.held.empty());
    EXPECT_EQ(input.pressed, (std::array<bool, 3>{}));
}

TEST(Utf8, EachLengthIsEncoded) {
    EXPECT_EQ(utf8_of(U'A'), "A");
    EXPECT_EQ(utf8_of(U'\u00DF'), "\u00DF");
    EXPECT_EQ(utf8_of(U'\u20AC'), "\u20AC");
    EXPECT_EQ(utf8_of(U'\U0001F600'), "\U0001F600");
}

TEST(Utf8, WhatIsNoCharacterIsEmpty) {
    for (const char32_t c : {U'\0', U'\n', char32_t{0x7F}, char32_t{0x9F}, char32_t{0xD800}, char32_t{0x110000}}) {
        EXPECT_EQ(utf8_of(c), "");
    }
}

TEST(Utf8, ACutNeverEndsWithinACharacter) {
    const std::string text = "a\u20ACb";
    EXPECT_EQ(cut_utf8(text, 5), text);
    EXPECT_EQ(cut_utf8(text, 4), "a\u20AC");
    EXPECT_EQ(cut_utf8(text, 3), "a");
    EXPECT_EQ(cut_utf8(text, 0), "");
}

}  // namespace
}  // namespace texelscope
