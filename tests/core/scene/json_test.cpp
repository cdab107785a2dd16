#include "core/scene/json.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <random>

#include "core/geometry/polygon.h"

namespace texelscope::json_test {
namespace {

constexpr const char* kTriangle = R"([{"x":1,"y":2,"u":0,"v":0},{"x":9,"y":2,"u":8,"v":0},{"x":1,"y":8,"u":0,"v":8}])";

Result<LoadedScene> parse(std::string_view text) { return parse_scene(text, "s.json", {}); }

/// A scene with these further members, each on a line of its own from line 2.
Result<LoadedScene> with(const std::string& members) { return parse("{\"texelscope\":1,\n" + members + "}"); }

/// One triangle whose first x is written so.
Result<LoadedScene> with_x(const std::string& x) {
    return with(R"("polygons":[{"vertices":[{"x":)" + x +
                R"(,"y":2,"u":0,"v":0},{"x":9,"y":2,"u":8,"v":0},{"x":1,"y":8,"u":0,"v":8}]}])");
}

std::string error_of(const Result<LoadedScene>& scene) { return scene ? "none" : scene.error().text(); }

bool same(const Scene& a, const Scene& b) {
    if (a.textures.size() != b.textures.size()) return false;
    for (std::size_t i = 0; i < a.textures.size(); ++i)
        if (!(*a.textures[i] == *b.textures[i])) return false;
    return a.framebuffer == b.framebuffer && a.depth == b.depth && a.cull == b.cull && a.polygons == b.polygons;
}

Scene random_scene(std::mt19937& random) {
    std::string textures;
    for (const char* pattern : {"address", "checker", "uv", "solid"})
        textures += fmt::format(R"({}{{"name":"{}\"\u00e4\n","pattern":"{}","size":[{},{}],"wrap":"{}"{}}})",
                                textures.empty() ? "" : ",", pattern, pattern, 1 + random() % 40, 1 + random() % 40,
                                random() % 2 != 0 ? "clamp" : "repeat", random() % 2 != 0 ? ",\"palette\":16" : "");
    Scene scene = with("\"textures\":[" + textures + "]")->scene;
    const auto any_float = [&random] {
        for (;;) {
            const auto bits = static_cast<std::uint32_t>(random());
            float value = 0;
            std::memcpy(&value, &bits, sizeof value);
            if (!std::isnan(value)) return value;  // nan is not equal to itself
        }
    };
    for (int i = 0; i < 30; ++i) {
        Polygon polygon{.vertices = {}, .texture = static_cast<int>(random() % 4), .light = std::fabs(any_float())};
        const auto corners = 3 + random() % 4;
        for (unsigned k = 0; k < corners; ++k) {
            const float x = any_float(), y = any_float(), z = any_float(), w = any_float();
            polygon.vertices.push_back({x, y, z, w, any_float(), -0.0F});
        }
        scene.polygons.push_back(polygon);
    }
    scene.framebuffer = {1 + static_cast<int>(random() % 16384), 7, -1'000'000, kMaxOrigin, {1, 2, 255}};
    scene.depth = random() % 2 != 0 ? Depth::less : Depth::off;
    scene.cull = random() % 2 != 0 ? Cull::back : Cull::none;
    return scene;
}

TEST(Scene, WrittenAndReadIsTheSame) {
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        const Scene scene = random_scene(random);
        const std::string text = scene_to_json(scene);
        const Result<LoadedScene> read = parse(text);
        ASSERT_TRUE(read) << read.error().text();
        ASSERT_TRUE(same(read->scene, scene)) << text;
        ASSERT_EQ(scene_to_json(read->scene), text);
    }
}

TEST(Scene, QuirkOfJellyCubesIsReadAndWritten) {
    const std::string cubes = R"("meshes":[{"solid":"jelly-cubes","rotate2":[10,20,30],"move":[0,0,5]}])";
    const auto without = with(cubes), there = with(cubes + R"(,"quirks":["size_twice"])");
    ASSERT_TRUE(without && there);
    EXPECT_FALSE(without->scene.size_twice);
    EXPECT_TRUE(there->scene.size_twice);
    EXPECT_NE(there->scene.polygons, without->scene.polygons);
    const auto again = parse(scene_to_json(there->scene));
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_TRUE(again->scene.size_twice);
    EXPECT_EQ(again->scene.polygons, there->scene.polygons);
}

TEST(Scene, SignOfZeroSurvivesWriting) {
    const Result<LoadedScene> read = parse(scene_to_json(with_x("-0.0")->scene));
    EXPECT_TRUE(std::signbit(read->scene.polygons[0].vertices[0].x));
}

TEST(Scene, HasDefaults) {
    const Scene scene = with(std::string("\"polygons\":[{\"vertices\":") + kTriangle + "}]")->scene;
    EXPECT_EQ(scene.framebuffer, Framebuffer{});
    EXPECT_EQ(scene.polygons[0].vertices[1], (Vertex{9, 2, 0, 1, 8, 0}));
    EXPECT_EQ(scene.polygons[0].light, 1);
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0]->texels.at(0, 0), kSolid);
}

TEST(Scene, ReadsEverything) {
    const Result<LoadedScene> read =
        parse(R"({ "polygons": [ { "texture": "b", "light": 0.5, "vertices": )" + std::string(kTriangle) + R"( } ],
        "textures": [ { "name": "a", "pattern": "uv", "size": [2, 3] },
                      { "name": "b", "pattern": "address", "size": [32, 64], "wrap": "mask", "palette": 256 } ],
        "framebuffer": { "width": 16384, "height": 1, "origin": [-5, 6], "clear": [1, 2, 3] },
        "depth": "less", "cull": "back", "texelscope": 1 })");
    ASSERT_TRUE(read) << read.error().text();
    const Scene& scene = read->scene;
    EXPECT_EQ(scene.framebuffer, (Framebuffer{16384, 1, -5, 6, {1, 2, 3}}));
    EXPECT_EQ(scene.depth, Depth::less);
    EXPECT_EQ(scene.cull, Cull::back);
    EXPECT_EQ(scene.polygons[0].texture, 1);
    EXPECT_EQ(scene.polygons[0].light, 0.5F);
    EXPECT_EQ(scene.textures[1]->wrap, Wrap::mask);
    EXPECT_EQ(scene.textures[1]->width(), 32);
    EXPECT_EQ(scene.textures[1]->palette.size(), 256u);
    EXPECT_EQ(scene.textures[0]->texels, make_pattern(Pattern::uv, 2, 3, 0));
    EXPECT_TRUE(read->warnings.empty());
}

TEST(Scene, NumbersAreFloat32) {
    const auto x = [](const char* text) { return with_x(text)->scene.polygons[0].vertices[0].x; };
    EXPECT_EQ(x("0.1"), 0.1F);
    EXPECT_EQ(x("16777217"), 16777216.0F);
    EXPECT_EQ(x("1.0000000596046448"), 1.0F);  // a double half way between two float32, then to even
    EXPECT_EQ(x("\"0x1.8p+1\""), 3.0F);
    EXPECT_EQ(x("\"-0X.8\""), -0.5F);
    EXPECT_EQ(x("\"0x1.fffffep+127\""), std::numeric_limits<float>::max());
    EXPECT_EQ(x("\"inf\""), std::numeric_limits<float>::infinity());
    EXPECT_EQ(x("\"-inf\""), -std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(x("\"nan\"")));
    EXPECT_TRUE(std::isinf(x("1e39")));
    for (const char* wrong : {"\"1.5\"", "\"0x\"", "\"0x1p\"", "\"0x1p+1 \"", "\"\"", "\"infinity\"",
                              "\"0x1.8p+1\\u0000\"", "true", "null", "[]", "{}"})
        EXPECT_EQ(error_of(with_x(wrong)).substr(0, 25), "s.json:2: x of a vertex i") << wrong;
}

TEST(Scene, PolygonWithAFaultIsKeptAndNamed) {
    for (const char* bad : {"\"nan\"", "\"inf\"", "\"-inf\"", "1e39"}) {
        const Result<LoadedScene> read = with_x(bad);
        ASSERT_TRUE(read);
        ASSERT_EQ(read->warnings.size(), 1u);
        EXPECT_EQ(read->warnings[0], "s.json:2: polygon 0 draws nothing: x of its vertex 0 is not finite");
        ASSERT_EQ(read->scene.polygons.size(), 1u);
        EXPECT_FALSE(is_drawable(read->scene.polygons[0]));
    }
    const Result<LoadedScene> behind = with(R"("polygons":[{"vertices":)" + std::string(kTriangle) + R"(},
        {"vertices":[{"x":0,"y":0,"w":-1,"u":0,"v":0},{"x":1,"y":0,"u":0,"v":0},{"x":0,"y":1,"u":0,"v":0}]}])");
    ASSERT_EQ(behind->warnings.size(), 1u);
    EXPECT_EQ(behind->warnings[0], "s.json:3: polygon 1 draws nothing: w of its vertex 0 is not above 0");
    EXPECT_TRUE(is_drawable(behind->scene.polygons[0]));
}

TEST(Scene, WarnsOfDentsAndOddMasks) {
    const Result<LoadedScene> dent = with(
        R"("polygons":[{"vertices":[{"x":0,"y":0,"u":0,"v":0},{"x":9,"y":0,"u":0,"v":0},
                                    {"x":1,"y":1,"u":0,"v":0},{"x":0,"y":9,"u":0,"v":0}]}])");
    EXPECT_EQ(dent->warnings, (std::vector<std::string>{"s.json:2: polygon 0 is not convex, expected a convex one"}));
    EXPECT_EQ(with(R"("textures":[{"name":"t","pattern":"uv","size":[3,4],"wrap":"mask"}])")->warnings.size(), 1u);
}

TEST(Scene, EveryErrorNamesItsLineAndWhatWasExpected) {
    const std::string triangle(kTriangle);
    const std::vector<std::pair<std::string, std::string>> cases{
        {"\"x\":1",
         "s.json:2: key 'x' of a scene is not known, expected texelscope, framebuffer, depth, cull, textures, "
         "polygons, meshes, quirks, camera or random"},
        {"\n\"meshes\":{}", "s.json:3: meshes is an object, expected a list"},
        {"\"quirks\":{}", "s.json:2: quirks is an object, expected a list"},
        {"\"quirks\":[\n\"corners\"]", "s.json:3: a quirk of a scene is 'corners', expected size_twice"},
        {"\"camera\":[]", "s.json:2: camera is a list of 0, expected an object"},
        {"\"depth\":\n\"more\"", "s.json:3: depth is 'more', expected off or less"},
        {"\"cull\":1", "s.json:2: cull is 1, expected none or back"},
        {"\"framebuffer\":[]", "s.json:2: framebuffer is a list of 0, expected an object"},
        {"\"framebuffer\":{\n\"width\":3}", "s.json:2: framebuffer has no 'height'"},
        {"\"framebuffer\":{\"width\":16385,\"height\":1}",
         "s.json:2: width is 16385, expected a whole number from 1 to 16384"},
        {"\"framebuffer\":{\"width\":0,\"height\":1}", "s.json:2: width is 0, expected a whole number from 1 to 16384"},
        {"\"framebuffer\":{\"width\":1.5,\"height\":1}",
         "s.json:2: width is 1.5, expected a whole number from 1 to 16384"},
        {"\"framebuffer\":{\"width\":1,\"height\":1,\n\"clear\":[0,0]}",
         "s.json:3: clear is a list of 2, expected a list of 3 whole numbers"},
        {"\"framebuffer\":{\"width\":1,\"height\":1,\"clear\":[0,0,\n256]}",
         "s.json:3: clear is 256, expected a whole number from 0 to 255"},
        {"\"framebuffer\":{\"width\":1,\"height\":1,\"origin\":[1e300,0]}",
         "s.json:2: origin is 1e+300, expected a whole number from -1073741824 to 1073741824"},
        {"\"textures\":{}", "s.json:2: textures is an object, expected a list"},
        {"\"textures\":[{}]", "s.json:2: a texture has no 'name'"},
        {"\"textures\":[{\"name\":\"t\"}]", "s.json:2: texture 't': expected either 'file', 'files' or 'pattern'"},
        {"\"textures\":[{\"name\":\"t\",\"pattern\":\"uv\"}]",
         "s.json:2: texture 't' has no 'size', which a pattern needs"},
        {"\"textures\":[{\"name\":\"t\",\"pattern\":\"uv\",\"size\":[1,16385]}]",
         "s.json:2: size is 16385, expected a whole number from 1 to 16384"},
        {"\"textures\":[{\"name\":\"t\",\"pattern\":\"uv\",\"size\":[1,1],\"wrap\":\"mirror\"}]",
         "s.json:2: wrap is 'mirror', expected repeat, mask or clamp"},
        {"\"textures\":[{\"name\":\"t\",\"pattern\":\"uv\",\"size\":[1,1],\"palette\":257}]",
         "s.json:2: palette is 257, expected a whole number from 2 to 256"},
        {"\"textures\":[{\"name\":\"t\",\"pattern\":\"uv\",\"size\":[1,1]},\n{\"name\":\"t\",\"pattern\":\"uv\","
         "\"size\":[1,1]}]",
         "s.json:3: texture 't' is there twice, expected different names"},
        {"\"textures\":[{\"name\":\"t\",\n\"file\":\"t.png\"}]",
         "s.json:3: texture 't': file 't.png' cannot be read: this scene has no folder"},
        {"\"polygons\":[{}]", "s.json:2: a polygon has no 'vertices'"},
        {"\"polygons\":[{\"vertices\":[{},{}]}]",
         "s.json:2: vertices is a list of 2, expected a list of three or more vertices"},
        {"\"polygons\":[{\"texture\":\"b\",\"vertices\":" + triangle + "}]",
         "s.json:2: texture of a polygon is 'b', expected the name of one of the scene's textures"},
        {"\"polygons\":[{\"light\":-1,\"vertices\":" + triangle + "}]", "s.json:2: light is -1, expected 0 or more"},
        {"\"polygons\":[{\"vertices\":[\n{\"x\":1},1,2]}]", "s.json:3: a vertex has no 'y'"},
        {"\"polygons\":[{\"vertices\":[\n{\"x\":1,\n\"q\":2},1,2]}]",
         "s.json:4: key 'q' of a vertex is not known, expected x, y, z, w, u or v"},
    };
    for (const auto& [members, error] : cases) EXPECT_EQ(error_of(with(members)), error);
    EXPECT_EQ(error_of(parse("[]")), "s.json:1: a scene is a list of 0, expected an object");
    EXPECT_EQ(error_of(parse("{\n}")), "s.json:1: a scene has no 'texelscope'");
    EXPECT_EQ(error_of(parse("{\"new\":1,\n\"texelscope\":2}")),
              "s.json:2: texelscope, the version of the format, is 2, expected 1");
}

TEST(Scene, TexturesTogetherAreBounded) {
    const std::string t =
        R"({"name":"a","pattern":"solid","size":[1,1]},{"name":"b","pattern":"solid","size":[16384,16384]})";
    EXPECT_EQ(error_of(with("\"textures\":[" + t + "]")),
              "s.json:2: the textures have more than 268435456 texels together");
}

TEST(Scene, DamagedTextIsASceneOrAnErrorWithAPlace) {
    std::mt19937 random(3);
    const std::string text = scene_to_json(with(std::string("\"polygons\":[{\"vertices\":") + kTriangle + "}]")->scene);
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = text;
        for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = "{}[],:\"0-9e.x\n\\ "[random() % 16];
        const Result<LoadedScene> read = parse(damaged);
        if (!read) {
            ASSERT_EQ(read.error().where.rfind("s.json:", 0), 0u) << read.error().text();
        }
    }
}

TEST(Scene, TenThousandPolygonsAreReadQuickly) {
    std::string polygons;
    for (int i = 0; i < 10000; ++i)
        polygons += (i == 0 ? "{\"vertices\":" : ",\n{\"vertices\":") + std::string(kTriangle) + "}";
    const auto start = std::chrono::steady_clock::now();
    const Result<LoadedScene> read = with("\"polygons\":[" + polygons + "]");
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    ASSERT_EQ(read->scene.polygons.size(), 10000u);
    RecordProperty("milliseconds", std::to_string(seconds.count() * 1000));
    EXPECT_LT(seconds.count(), 10) << "expected some 0.03 s; 10 s leaves room for sanitizers";
}

TEST(SceneLines, AreTheLinesThatAreNotBlank) {
    const std::vector<SceneLine> lines = parse_scene_lines("{1}\n\n \t\r\n  {2}\r\n{3}");
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0].number, 0);
    EXPECT_EQ(lines[1].number, 3);
    EXPECT_EQ(lines[1].text, "{2}");
    EXPECT_EQ(lines[2].number, 4);
    EXPECT_TRUE(parse_scene_lines("\n \n").empty());
}

TEST(SceneLines, AreToldFromASceneOverSeveralLines) {
    const std::string one = R"({"texelscope":1,"textures":[{"name":"}\"{","pattern":"uv","size":[1,1]}]})";
    EXPECT_TRUE(is_scene_lines(one + "\n" + one));
    EXPECT_TRUE(is_scene_lines("\n" + one + "\n\n" + one + "\n"));
    EXPECT_FALSE(is_scene_lines(one + "\n"));
    EXPECT_FALSE(is_scene_lines(one + "\n]"));
    EXPECT_FALSE(is_scene_lines(scene_to_json(parse(one)->scene)));
    EXPECT_FALSE(is_scene_lines(""));
}

}  // namespace
}  // namespace texelscope::json_test
