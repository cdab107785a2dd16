#include "app/platform/glfw_keys.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace texelscope {
namespace {

using ui::Key;

TEST(GlfwKeys, LettersFollowTheLayout) {
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Q, "a"), Key::a);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Y, "z"), Key::z);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_SEMICOLON, "m"), Key::m);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_SLASH, "-"), Key::minus);
}

TEST(GlfwKeys, AKeyThatTheLayoutGivesNoKnownSignIsTakenByItsPlace) {
    EXPECT_EQ(key_from_glfw(GLFW_KEY_V, "\u043C"), Key::v);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_1, "&"), Key::n1);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_I, nullptr), Key::i);
}

TEST(GlfwKeys, TheEndsOfTheRangesAreRight) {
    EXPECT_EQ(key_from_glfw(GLFW_KEY_A, "a"), Key::a);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_Z, "z"), Key::z);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_0, "0"), Key::n0);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_9, "9"), Key::n9);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_F1, nullptr), Key::f1);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_F12, nullptr), Key::f12);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_KP_9, "9"), Key::n9);
    EXPECT_EQ(key_from_glfw(GLFW_KEY_KP_ENTER, nullptr), Key::enter);
}

TEST(GlfwKeys, OtherKeysAreNone) {
    for (const int key : {GLFW_KEY_UNKNOWN, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_CAPS_LOCK, GLFW_KEY_F13, GLFW_KEY_LAST}) {
        EXPECT_EQ(key_from_glfw(key, nullptr), Key::none);
    }
    EXPECT_EQ(key_from_glfw(GLFW_KEY_WORLD_1, "<"), Key::none);
}

}  // namespace
}  // namespace texelscope
