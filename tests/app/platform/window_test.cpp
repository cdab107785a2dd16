// With a real window: these tests need a display. Under Xvfb it must run with -noreset, or the server restarts between
// two windows and the second may find none: xvfb-run -a -s "-noreset -screen 0 1280x1024x24".
#include "app/platform/window.h"

#include <array>
#include <cstdlib>
#include <ctime>
#include <string>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace texelscope::window_test {
namespace {

class Window : public testing::Test {
protected:
    void SetUp() override {
        if (std::getenv("DISPLAY") == nullptr)
            FAIL() << "DISPLAY is not set; run the tests under a display, or xvfb-run";
    }
};

TEST_F(Window, ShowsWhatImGuiAndTheTexturesDraw) {
    int frames = 0;
    std::array<Rgb, 2> seen{};
    glm::vec2 size{0};
    const Grid<Rgba> red(3, 3, Rgba{255, 0, 0, 255});
    const auto result =
        run_window({"test", 320, 200}, {[&](const ui::Input& input, Host& host) {
                       size = input.size;
                       ImDrawList* const list = ImGui::GetBackgroundDrawList();
                       list->AddRectFilled({0, 0}, {100, 100}, IM_COL32(0, 255, 0, 255));
                       list->AddImage(host.textures().image(1, 1, red), {100, 0}, {200, 100});
                       if (++frames < 3) return host.wants_frames_until(input.time + 1);
                       list->AddCallback(
                           [](const ImDrawList*, const ImDrawCmd* command) {
                               auto& pixels = *static_cast<std::array<Rgb, 2>*>(command->UserCallbackData);
                               GLint box[4];
                               glGetIntegerv(GL_VIEWPORT, box);
                               glPixelStorei(GL_PACK_ALIGNMENT, 1);
                               glReadPixels(50, box[3] - 50, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, &pixels[0]);
                               glReadPixels(150, box[3] - 50, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, &pixels[1]);
                           },
                           &seen);
                       host.close(7);
                   }});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(*result, 7);
    EXPECT_EQ(frames, 3);
    EXPECT_EQ(size, glm::vec2(320, 200));
    EXPECT_EQ(seen[0], (Rgb{0, 255, 0}));
    EXPECT_EQ(seen[1], (Rgb{255, 0, 0}));
}

TEST_F(Window, SleepsWhileNothingHappensAndWakesWhenAsked) {
    int frames = 0, polls = 0;
    bool awake = false;
    std::clock_t before = 0;
    double spent = 1;
    const auto result =
        run_window({"test", 320, 200}, {[&](const ui::Input& input, Host& host) {
                                            ++frames;
                                            if (input.time >= 1.5) {
                                                spent = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
                                                awake = true;
                                                return host.close(0);
                                            }
                                            host.poll_every(0.25);
                                            host.wake_at(1.5);
                                            before = std::clock();
                                        },
                                        [&] { return ++polls < 0; }});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_TRUE(awake);
    EXPECT_LT(frames, 20);
    EXPECT_GE(polls, 3);
    EXPECT_LT(spent, 0.1) << "processor seconds in an idle second";
}

TEST_F(Window, AChangedPollDrawsAFrame) {
    int frames = 0, frames_at_poll = 0;
    bool changed = false;
    const auto result = run_window({"test", 320, 200}, {[&](const ui::Input&, Host& host) {
                                                            ++frames;
                                                            host.poll_every(0.3);
                                                            if (changed) host.close(0);
                                                        },
                                                        [&] {
                                                            frames_at_poll = frames;
                                                            return changed = true;
                                                        }});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(frames, frames_at_poll + 1);
}

TEST_F(Window, GoesToTheFullScreenAndBack) {
    int frames = 0;
    glm::vec2 last{0}, full{0};
    const auto result = run_window({"test", 320, 200}, {[&](const ui::Input& input, Host& host) {
                                       ++frames;
                                       host.wants_frames_until(input.time + 1);
                                       if (frames == 2) host.set_fullscreen(true);
                                       if (frames == 20) full = input.size, host.set_fullscreen(false);
                                       if (frames == 40) last = input.size, host.close(0);
                                   }});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_GT(full.x, 320);
    EXPECT_EQ(last, glm::vec2(320, 200));
}

TEST_F(Window, FontsChangeBetweenFrames) {
    ImFontAtlas large;
    ImFontConfig config;
    config.SizePixels = 40;
    large.AddFontDefault(&config);
    int frames = 0;
    float before = 0, after = 0;
    const auto result = run_window({"test", 320, 200}, {[&](const ui::Input& input, Host& host) {
                                       host.wants_frames_until(input.time + 1);
                                       if (++frames == 2) before = ImGui::GetFontSize(), host.set_fonts(large);
                                       if (frames == 4) after = ImGui::GetFontSize(), host.close(0);
                                   }});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(before, 13);
    EXPECT_EQ(after, 40);
}

TEST_F(Window, TheClipboardReturnsWhatWasPutIn) {
    std::string back;
    const auto result = run_window({"test", 320, 200}, {[&](const ui::Input&, Host& host) {
                                       host.set_clipboard("u/w = 3");
                                       back = host.clipboard();
                                       host.close(0);
                                   }});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(back, "u/w = 3");
}

TEST_F(Window, WithoutADisplaySaysSoInOneLine) {
    const std::string display = std::getenv("DISPLAY");
    unsetenv("DISPLAY");
    const auto result = run_window({}, {[](const ui::Input&, Host& host) { host.close(0); }});
    setenv("DISPLAY", display.c_str(), 1);
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().text().find("display"), std::string::npos);
    EXPECT_EQ(result.error().text().find('\n'), std::string::npos);
}

}  // namespace
}  // namespace texelscope::window_test
