#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "core/image/load.h"
#include "core/method/method.h"
#include "tests/app/cli/program.h"

namespace texelscope::command_line_test {
namespace {

constexpr const char* kScene = R"({"texelscope":1,"framebuffer":{"width":8,"height":6},
"polygons":[{"vertices":[{"x":0,"y":0,"u":0,"v":0},{"x":8,"y":0,"u":8,"v":0},{"x":0,"y":6,"u":0,"v":6}]}]})";

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text + "\n";
}
long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

void expect_bad_input(const Ran& ran, const std::string& part) {
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(lines(ran.err), 1) << ran.err;
    EXPECT_EQ(ran.err.substr(0, 12), "texelscope: ");
    EXPECT_NE(ran.err.find(part), std::string::npos) << ran.err;
}

TEST(CommandLine, EverySubcommandHasHelp) {
    EXPECT_EQ(run_program("--help").code, 0);
    for (const Subcommand* command : commands()) {
        const Ran ran = run_program(std::string(command->name) + " --help");
        EXPECT_EQ(ran.code, 0);
        EXPECT_NE(ran.out.find("Usage: texelscope " + std::string(command->name)), std::string::npos) << ran.out;
    }
}

TEST(CommandLine, WhatIsWrongIsOneLineAndExitCode2) {
    expect_bad_input(run_program("pixles"), "did you mean 'pixels'?");
    expect_bad_input(run_program("banana"), "expected");
    expect_bad_input(run_program("pixels"), "SCENE");
    expect_bad_input(run_program("pixels --nonsense -", kScene), "nonsense");
    expect_bad_input(run_program("pixels /nowhere/scene.json"), "/nowhere/scene.json");
    expect_bad_input(run_program("trace - --pixel 3", kScene), "--pixel '3'");
    expect_bad_input(run_program("trace - --pixel 8,0", kScene), "outside the picture");
    expect_bad_input(run_program("trace - --level atom", kScene), "atom");
    expect_bad_input(run_program("render - --reduce 3", kScene), "--reduce");
    expect_bad_input(run_program("list nothing"), "nothing");
}

TEST(CommandLine, ShotGoesToABeatAndThenToAStep) {
    const std::string file = (std::filesystem::temp_directory_path() / "texelscope_shot.png").string();
    const auto shot = [&](const std::string& arguments) {
        const Ran ran = run_program("shot 5 --size 640x480 -o '" + file + "' " + arguments);
        EXPECT_EQ(ran.code, 0) << ran.err;
        const auto image = load_image(file);
        return image ? *image : Image();
    };
    const Image first = shot("");
    EXPECT_EQ(shot("--beat 1"), first);
    const Image third = shot("--beat 3");
    EXPECT_NE(third, first);
    EXPECT_NE(shot("--beat 3 --step t0/s0"), third);
    std::filesystem::remove(file);
}

TEST(CommandLine, ABeatThatIsNotThereIsNamed) {
    const std::string lesson = "shot " TEXELSCOPE_SOURCE_DIR "/lessons/example/texture-slides -o /dev/null --beat ";
    expect_bad_input(run_program(lesson + "0"), "--beat: 0, expected 1 to 6");
    expect_bad_input(run_program(lesson + "7"), "--beat: 7, expected 1 to 6");
    expect_bad_input(run_program(lesson + "x"), "--beat");
    const std::string scene = "shot " TEXELSCOPE_SOURCE_DIR "/lessons/example/texture-slides/scene.json";
    expect_bad_input(run_program(scene + " -o /dev/null --beat 1"), "a scene has no beats");
}

TEST(CommandLine, AWrongSettingNamesWhatThereIs) {
    expect_bad_input(run_program("pixels - --method edge-equation", kScene), "did you mean edge-equations?");
    expect_bad_input(run_program("pixels - --number f16", kScene), "fx16.16");
    expect_bad_input(run_program("pixels - --method sections --variant as-published", kScene),
                     "as-printed or corrected");
    expect_bad_input(run_program("pixels - --method sections --quirk Q9=on", kScene),
                     "Q1 (ghost), Q2 (end_texel) or Q3 (whole_pixels)");
    expect_bad_input(run_program("pixels - --quirk Q1", kScene), "expected ID=on or ID=off");
    expect_bad_input(run_program("pixels - --method sections --skip tiles=on", kScene), "tiles");
}

TEST(CommandLine, ABadSceneNamesItsLine) {
    expect_bad_input(run_program("pixels -", "{\n\"texelscope\": 1,\n\"colour\": 3}"), "stdin:3: ");
    const std::string good = one_line(kScene);
    const Ran ran = run_program("pixels - -o /dev/null", good + good + "{}\n");
    expect_bad_input(ran, "stdin:3: ");
}

TEST(CommandLine, QuirksGoByNumberOrFieldAndMakeTheVariant) {
    std::string by_id, by_field, none = " --variant as-printed";
    for (const QuirkInfo& quirk : find_method("sections")->quirks) {
        by_id += " --quirk " + std::string(quirk.id) + "=on";
        by_field += " --quirk " + std::string(quirk.field) + "=on";
        none += " --quirk " + std::string(quirk.id) + "=off";
    }
    const std::string call = "pixels - --method sections";
    const std::string printed = run_program(call + " --variant as-printed", kScene).out;
    const std::string corrected = run_program(call, kScene).out;
    EXPECT_NE(printed, corrected);
    EXPECT_EQ(run_program(call + by_id, kScene).out, printed);
    EXPECT_EQ(run_program(call + by_field, kScene).out, printed);
    EXPECT_EQ(run_program(call + none, kScene).out, corrected);
}

TEST(CommandLine, JsonLinesGiveEachScenesRowsUnderItsLine) {
    const std::string rows = run_program("pixels -", kScene).out;
    const std::string header = rows.substr(0, rows.find('\n') + 1);
    EXPECT_EQ(header, "polygon,x,y,u,v,texel_x,texel_y,r,g,b,note\n");
    std::string expected = "scene," + header;
    for (const char* number : {"0,", "2,"}) {
        for (std::size_t at = header.size(); at < rows.size(); at = rows.find('\n', at) + 1)
            expected += number + rows.substr(at, rows.find('\n', at) + 1 - at);
    }
    EXPECT_EQ(run_program("pixels -", one_line(kScene) + "\n" + one_line(kScene)).out, expected);
}

TEST(CommandLine, RenderDrawsThePixelsThatPixelsLists) {
    const Ran png = run_program("render -", kScene);
    ASSERT_EQ(png.code, 0) << png.err;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(png.out.data());
    const auto picture = decode_image({bytes, png.out.size()}, "picture");
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width(), 8);
    EXPECT_EQ(picture->height(), 6);
    const auto drawn =
        std::count_if(picture->data(), picture->data() + picture->size(), [](Rgb c) { return c != Rgb{}; });
    EXPECT_EQ(drawn, lines(run_program("pixels -", kScene).out) - 1);
}

TEST(CommandLine, ListsAreJsonWithEveryEntry) {
    const auto methods_listed = nlohmann::json::parse(run_program("list methods --json").out);
    EXPECT_EQ(methods_listed.size(), methods().size());
    std::size_t quirks = 1;  // that of jelly cubes, which is no method's
    for (const Method* method : methods()) quirks += method->quirks.size();
    const auto quirks_listed = nlohmann::json::parse(run_program("list quirks --json").out);
    EXPECT_EQ(quirks_listed.size(), quirks);
    for (const auto& quirk : quirks_listed) EXPECT_GT(quirk.value("line", 0), 0) << quirk;
    for (const char* what : {"lessons", "numbers", "views"}) {
        const Ran ran = run_program(std::string("list ") + what + " --json");
        EXPECT_EQ(ran.code, 0);
        EXPECT_TRUE(nlohmann::json::parse(ran.out).is_array());
    }
}

}  // namespace
}  // namespace texelscope::command_line_test
