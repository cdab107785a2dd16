#include <random>

#include <gtest/gtest.h>

#include "app/platform/scripted_input.h"
#include "tests/app/shell/laws.h"
#include "tests/cases.h"

namespace texelscope::random_events_test {
namespace {

constexpr int kEvents = static_cast<int>(cases(10000, 3000)), kBetweenChecks = 250;
constexpr glm::vec2 kSize{1280, 720};

/// Keys that a person may hit; those that write files are left to their own tests.
[[nodiscard]] ui::KeyPress random_key(std::mt19937& random) {
    ui::KeyPress press;
    press.key =
        static_cast<ui::Key>(std::uniform_int_distribution<int>(1, static_cast<int>(ui::Key::right_bracket))(random));
    press.ctrl = random() % 5 == 0;
    press.shift = random() % 4 == 0;
    if (press.ctrl && (press.key == ui::Key::s || press.key == ui::Key::e)) press.ctrl = false;
    return press;
}

/// One event: a key, text, a click, a drag, the wheel.
[[nodiscard]] std::vector<ui::Input> random_event(const ui::Input& before, std::mt19937& random) {
    const auto place = [&] {
        return glm::vec2(static_cast<float>(random() % 1280), static_cast<float>(random() % 720));
    };
    switch (random() % 10) {
        case 0: return click(before, place());
        case 1: return drag(before, place(), place(), 3);
        case 2: return {turn_wheel(move_mouse(before, place()), {0, random() % 2 == 0 ? 1.0F : -1.0F})};
        case 3: return {move_mouse(before, place())};
        case 4: return double_click(before, place());
        case 5: return {type_text(before, std::string(1, static_cast<char>(' ' + random() % 95)))};
        default: return {press_key(before, random_key(random))};
    }
}

TEST(RandomEvents, LeaveEveryLawIntact) {
    const unsigned seed = 20261122;
    std::mt19937 random(seed);
    auto app = Headless::start(*state_of("5", {.reduced_motion = true}), kSize);
    ASSERT_TRUE(app) << app.error().text();
    for (int n = 0; n < kEvents; ++n) {
        for (const ui::Input& input : random_event((*app)->input, random)) {
            (*app)->input = input;
            (*app)->frame();
        }
        // One pixel's worth of text is enough: a scale of 250 % would only make the run slower.
        if ((*app)->state().look.scale > 1.5F) {
            Look look = (*app)->state().look;
            look.scale = 1;
            (*app)->store().dispatch(action::SetLook{look});
        }
        if (n % kBetweenChecks != 0) continue;
        ASSERT_EQ(broken_law(**app), "") << "seed " << seed << ", event " << n;
    }
}

TEST(RandomEvents, ThreeEscapesReturnToTheCanvasFromAnywhere) {
    std::mt19937 random(7);
    auto app = Headless::start(*state_of("9", {.reduced_motion = true}), kSize);
    ASSERT_TRUE(app) << app.error().text();
    for (int round = 0; round < static_cast<int>(cases(60, 30)); ++round) {
        for (int n = 0; n < 12; ++n) {
            for (const ui::Input& input : random_event((*app)->input, random)) {
                (*app)->input = input;
                (*app)->frame();
            }
        }
        for (int n = 0; n < 3; ++n) {
            (*app)->input = press_key((*app)->input, {ui::Key::escape});
            (*app)->frame();
        }
        EXPECT_EQ((*app)->state().overlay, Overlay::none) << round;
        EXPECT_FALSE((*app)->state().look.blank) << round;
        EXPECT_EQ((*app)->shell().memory().field, 0U) << round;
        EXPECT_EQ((*app)->shell().memory().focus, 0U) << round;
    }
}

}  // namespace
}  // namespace texelscope::random_events_test
