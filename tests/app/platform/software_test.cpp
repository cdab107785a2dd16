#include "app/platform/software.h"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "app/platform/scripted_input.h"

namespace texelscope {
namespace {

ui::Input input_of_size(float width, float height) {
    ui::Input input;
    input.size = {width, height};
    return input;
}

int count(const Image& picture, const Rgb& colour) {
    int n = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) n += picture.data()[i] == colour ? 1 : 0;
    return n;
}

TEST(Software, HasNoPictureBeforeTheFirstFrame) { EXPECT_TRUE(SoftwarePlatform().picture().empty()); }

TEST(Software, AFilledRectangleCoversExactlyItsPixels) {
    SoftwarePlatform platform;
    platform.frame(input_of_size(16, 8), [] {
        ImGui::GetBackgroundDrawList()->AddRectFilled({3, 2}, {7, 5}, IM_COL32(10, 200, 30, 255));
    });
    Image expected(16, 8);
    for (int y = 2; y < 5; ++y) {
        for (int x = 3; x < 7; ++x) expected.at(x, y) = {10, 200, 30};
    }
    EXPECT_EQ(platform.picture(), expected);
}

TEST(Software, AClipRectangleCutsWhatIsDrawn) {
    SoftwarePlatform platform;
    platform.frame(input_of_size(16, 8), [] {
        ImDrawList* const list = ImGui::GetBackgroundDrawList();
        list->PushClipRect({4, 3}, {6, 4});
        list->AddRectFilled({0, 0}, {16, 8}, IM_COL32_WHITE);
        list->PopClipRect();
    });
    Image expected(16, 8);
    expected.at(4, 3) = expected.at(5, 3) = {255, 255, 255};
    EXPECT_EQ(platform.picture(), expected);
}

TEST(Software, AnImageShowsItsTexelsEnlargedWithoutBlur) {
    SoftwarePlatform platform;
    Grid<Rgba> pixels(2, 1);
    pixels.at(0, 0) = {255, 0, 0, 255};
    pixels.at(1, 0) = {0, 0, 255, 255};
    platform.frame(input_of_size(8, 4), [&] {
        ImGui::GetBackgroundDrawList()->AddImage(platform.textures().image(7, 1, pixels), {0, 0}, {8, 4});
    });
    const Image picture = platform.picture();
    EXPECT_EQ(count(picture, {255, 0, 0}), 16);
    EXPECT_EQ(count(picture, {0, 0, 255}), 16);
    EXPECT_EQ(picture.at(3, 0), (Rgb{255, 0, 0}));
    EXPECT_EQ(picture.at(4, 0), (Rgb{0, 0, 255}));
}

TEST(Software, APictureIsReadAgainOnlyWhenItsVersionChanges) {
    SoftwarePlatform platform;
    const auto shown = [&](std::uint64_t version, Rgba colour) {
        const Grid<Rgba> pixels(1, 1, colour);
        platform.frame(input_of_size(1, 1), [&] {
            ImGui::GetBackgroundDrawList()->AddImage(platform.textures().image(1, version, pixels), {0, 0}, {1, 1});
        });
        return platform.picture().at(0, 0);
    };
    EXPECT_EQ(shown(1, {9, 0, 0, 255}), (Rgb{9, 0, 0}));
    EXPECT_EQ(shown(1, {0, 9, 0, 255}), (Rgb{9, 0, 0}));
    EXPECT_EQ(shown(2, {0, 9, 0, 255}), (Rgb{0, 9, 0}));
}

TEST(Software, PicturesThatAreNotAskedForAreForgottenAndTheirHandlesDrawNothing) {
    SoftwarePlatform platform;
    ImTextureID id = nullptr;
    platform.frame(input_of_size(1, 1), [&] {
        id = platform.textures().image(1, 1, Grid<Rgba>(1, 1, Rgba{9, 9, 9, 255}));
    });
    for (int i = 0; i <= TextureCache::kFramesKept; ++i) platform.frame(input_of_size(1, 1), [] {});
    EXPECT_EQ(dynamic_cast<SoftwareTextures&>(platform.textures()).find(id), nullptr);
    platform.frame(input_of_size(1, 1), [&] { ImGui::GetBackgroundDrawList()->AddImage(id, {0, 0}, {1, 1}); });
    EXPECT_EQ(platform.picture().at(0, 0), Rgb{});
}

TEST(Software, AnEmptyPictureShowsNothing) {
    SoftwarePlatform platform;
    platform.frame(input_of_size(4, 4), [&] {
        ImGui::GetBackgroundDrawList()->AddImage(platform.textures().image(1, 1, Grid<Rgba>()), {0, 0}, {4, 4});
    });
    EXPECT_EQ(platform.picture(), Image(4, 4));
}

TEST(Software, MoreThan65536VerticesAreDrawn) {
    SoftwarePlatform platform;
    platform.frame(input_of_size(300, 100), [] {
        ImDrawList* const list = ImGui::GetBackgroundDrawList();
        for (int i = 0; i < 30000; ++i) {
            const ImVec2 at(static_cast<float>(i % 300), static_cast<float>(i / 300));
            list->AddRectFilled(at, {at.x + 1, at.y + 1}, IM_COL32(1, 2, 3, 255));
        }
    });
    EXPECT_EQ(platform.picture(), Image(300, 100, Rgb{1, 2, 3}));
}

TEST(Software, TextOfANewAtlasIsDrawnFromTheNextFrame) {
    SoftwarePlatform platform;
    ImFontAtlas atlas;
    ImFontConfig large;
    large.SizePixels = 40;
    atlas.AddFontDefault(&large);
    const auto draw = [] { ImGui::GetBackgroundDrawList()->AddText({0, 0}, IM_COL32_WHITE, "H"); };
    platform.frame(input_of_size(60, 60), draw);
    const int small_ink = count(platform.picture(), {255, 255, 255});
    platform.set_fonts(atlas);
    platform.frame(input_of_size(60, 60), draw);
    EXPECT_GT(small_ink, 10);
    EXPECT_GT(count(platform.picture(), {255, 255, 255}), 3 * small_ink);
}

TEST(Software, TwoPlatformsDoNotDisturbEachOther) {
    SoftwarePlatform a, b;
    const auto fill = [](ImU32 colour) {
        return [colour] { ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, {4, 4}, colour); };
    };
    a.frame(input_of_size(4, 4), fill(IM_COL32(1, 1, 1, 255)));
    b.frame(input_of_size(4, 4), fill(IM_COL32(2, 2, 2, 255)));
    EXPECT_EQ(a.picture(), Image(4, 4, Rgb{1, 1, 1}));
    EXPECT_EQ(b.picture(), Image(4, 4, Rgb{2, 2, 2}));
}

TEST(Software, AClickReachesAButtonAndTypedTextAField) {
    SoftwarePlatform platform;
    std::array<char, 32> text{};
    int clicks = 0;
    const auto draw = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({200, 100});
        ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
        clicks += ImGui::Button("button", {100, 20}) ? 1 : 0;
        ImGui::InputText("##text", text.data(), text.size());
        ImGui::End();
    };
    ui::Input last = input_of_size(200, 100);
    const auto play = [&](const ui::Input& input) { platform.frame(last = input, draw); };
    play(last);
    for (const ui::Input& input : click(last, {20, 15})) play(input);
    EXPECT_EQ(clicks, 1);
    for (const ui::Input& input : click(last, {20, 40})) play(input);
    play(type_text(last, "abß"));
    play(press_key(last, {ui::Key::backspace}));
    play(next_frame(last));
    EXPECT_STREQ(text.data(), "ab");
    play(press_key(last, {ui::Key::a, true}));
    play(press_key(last, {ui::Key::c, true}));
    EXPECT_EQ(platform.wishes().clipboard, "ab");
}

TEST(Software, SizesOutOfRangeAreBroughtIntoIt) {
    SoftwarePlatform platform;
    platform.frame(input_of_size(0, -5), [] {});
    EXPECT_EQ(platform.picture(), Image(1, 1));
    platform.frame(input_of_size(std::numeric_limits<float>::quiet_NaN(), 2.5F), [] {});
    EXPECT_EQ(platform.picture(), Image(1, 3));
}

}  // namespace
}  // namespace texelscope
