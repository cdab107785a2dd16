#include "app/platform/scripted_input.h"

#include <gtest/gtest.h>

namespace texelscope {
namespace {

using ui::Key;

TEST(ScriptedInput, TheNextFrameIsLaterAndKeepsOnlyWhatIsHeld) {
    const ui::Input key = press_key(hold_key({}, Key::v), {Key::up, true});
    const ui::Input next = next_frame(key);
    EXPECT_GT(next.time, key.time);
    EXPECT_EQ(next.held, std::vector<Key>{Key::v});
    EXPECT_TRUE(next.keys.empty());
    EXPECT_FALSE(next.ctrl);
    EXPECT_TRUE(release_key(next, Key::v).held.empty());
}

TEST(ScriptedInput, ADragPressesOnceMovesInStepsAndLetsGoAtItsEnd) {
    const std::vector<ui::Input> frames = drag({}, {10, 10}, {30, 50}, 2);
    ASSERT_EQ(frames.size(), 5U);
    EXPECT_FALSE(frames[0].down[0]);
    EXPECT_TRUE(frames[1].pressed[0] && frames[1].down[0]);
    EXPECT_EQ(frames[1].mouse, glm::vec2(10, 10));
    EXPECT_EQ(frames[2].mouse, glm::vec2(20, 30));
    EXPECT_TRUE(frames[3].down[0] && !frames[3].pressed[0]);
    EXPECT_TRUE(frames[4].released[0] && !frames[4].down[0]);
    EXPECT_EQ(frames[4].mouse, glm::vec2(30, 50));
}

TEST(ScriptedInput, OnlyTheSecondPressOfADoubleClickIsMarked) {
    int marked = 0, presses = 0;
    for (const ui::Input& input : double_click({}, {1, 2})) {
        presses += input.pressed[0] ? 1 : 0;
        marked += input.double_clicked ? presses : 0;
    }
    EXPECT_EQ(presses, 2);
    EXPECT_EQ(marked, 2);
}

TEST(ScriptedInput, TextAndWheelLastOneFrame) {
    const ui::Input typed = turn_wheel(type_text({}, "x"), {0, -1});
    EXPECT_EQ(typed.text, "");
    EXPECT_EQ(typed.wheel.y, -1);
    EXPECT_EQ(next_frame(typed).wheel.y, 0);
}

}  // namespace
}  // namespace texelscope
