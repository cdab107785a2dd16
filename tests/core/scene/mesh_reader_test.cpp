#include "core/scene/mesh_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/scene/json.h"
#include "core/scene/place.h"

namespace texelscope::mesh_reader_test {
namespace {

/// A scene with two textures and these further members, which begin on line 2.
Result<LoadedScene> with(const std::string& members) {
    return parse_scene(R"({"texelscope":1,"textures":[{"name":"a","pattern":"uv","size":[8,4]},)"
                       R"({"name":"b","pattern":"checker","size":[2,2]}],)"
                       "\n" +
                           members + "}",
                       "s.json", {});
}

std::string error_of(const std::string& members) {
    const Result<LoadedScene> scene = with(members);
    return scene ? "none" : scene.error().text();
}

constexpr const char* kEverything = R"("camera":{"focal":300,"near":0.5},"cull":"back","meshes":[
    {"solid":"cube","texture":"b","rotate":[20,30,0],"move":[0,0,400],"scale":100,"blend":"half","light":0.75},
    {"solid":"dodecahedron","move":[1,2,8]},{"solid":"icosahedron","move":[1,2,8],"texture":["b","a"]},
    {"solid":"torus","move":[0.1,0.2,8]},
    {"solid":"jelly-cubes","ratio":0.9,"rotate2":[1,2,3],"rotate":["0x1.8p+1",0,-0.0],"move":[0,0,8]}],
    "polygons":[{"blend":"half","vertices":[{"x":1,"y":2,"u":0,"v":0},{"x":9,"y":2,"u":8,"v":0},{"x":1,"y":8,"u":0,"v":8}]}])";

TEST(Meshes, AreReadWithAllTheirKeys) {
    const Result<LoadedScene> read = with(kEverything);
    ASSERT_TRUE(read) << read.error().text();
    const Scene& scene = read->scene;
    EXPECT_TRUE(read->warnings.empty());
    EXPECT_EQ(scene.camera, (Camera{300, 0.5F}));
    ASSERT_EQ(scene.meshes.size(), 5u);
    EXPECT_EQ(
        scene.meshes[0],
        (MeshPlacement{
            .textures = {1}, .rotate = {20, 30, 0}, .move = {0, 0, 400}, .scale = 100, .light = 0.75F, .half = true}));
    EXPECT_EQ(scene.meshes[1], (MeshPlacement{.shape = Shape3d::dodecahedron, .move = {1, 2, 8}}));
    EXPECT_EQ(scene.meshes[2].textures, (std::vector{1, 0}));
    EXPECT_EQ(scene.meshes[4].shape, Shape3d::jelly_cubes);
    EXPECT_EQ(scene.meshes[4].ratio, 0.9F);
    EXPECT_EQ(scene.meshes[4].rotate2, glm::vec3(1, 2, 3));
    EXPECT_EQ(scene.meshes[4].rotate, glm::vec3(3, 0, 0));
    EXPECT_TRUE(scene.polygons[0].half && scene.polygons[0].mesh == -1);
    for (std::size_t n = 1; n < scene.polygons.size(); ++n) EXPECT_GE(scene.polygons[n].mesh, 0);
    Scene again = scene;
    place_meshes(again);
    EXPECT_EQ(again.polygons, scene.polygons);
}

TEST(Meshes, AreWrittenAndTheirPolygonsAreNot) {
    const Scene scene = with(kEverything)->scene;
    const std::string text = scene_to_json(scene);
    const Result<LoadedScene> read = parse_scene(text, "again", {});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->scene.meshes, scene.meshes);
    EXPECT_EQ(read->scene.camera, scene.camera);
    EXPECT_EQ(read->scene.polygons, scene.polygons);
    EXPECT_EQ(scene_to_json(read->scene), text);
    std::size_t vertices = 0;
    for (std::size_t at = 0; (at = text.find("\"vertices\"", at)) != text.npos; ++at) ++vertices;
    EXPECT_EQ(vertices, 1u);
}

TEST(Meshes, WithoutTexturesAreGrey) {
    const Result<LoadedScene> read =
        parse_scene(R"({"texelscope":1,"meshes":[{"solid":"cube","move":[0,0,4]}]})", "s", {});
    ASSERT_TRUE(read);
    ASSERT_EQ(read->scene.textures.size(), 1u);
    EXPECT_EQ(read->scene.polygons.size(), 6u);
}

TEST(Meshes, EveryErrorNamesItsLineAndWhatWasExpected) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"\"meshes\":{}", "s.json:2: meshes is an object, expected a list"},
        {"\"meshes\":[1]", "s.json:2: a mesh is 1, expected an object"},
        {"\"meshes\":[\n{}]", "s.json:3: a mesh: expected either 'solid' or 'obj'"},
        {R"("meshes":[{"solid":"cube","obj":"a.obj"}])",
         "s.json:2: a mesh: file 'a.obj' cannot be read: this scene has no folder"},
        {R"("meshes":[{"solid":"ball"}])",
         "s.json:2: solid is 'ball', expected cube, dodecahedron, icosahedron, torus or jelly-cubes"},
        {R"("meshes":[{"solid":"cube","texture":"c"}])",
         "s.json:2: texture of a mesh is 'c', expected the name of one of the scene's textures"},
        {R"("meshes":[{"solid":"cube","texture":["a",)"
         "\n7]}]",
         "s.json:3: texture of a mesh is 7, expected a text"},
        {R"("meshes":[{"solid":"cube","texture":[]}])",
         "s.json:2: texture of a mesh is a list of 0, expected a name, or a list of one or more"},
        {R"("meshes":[{"solid":"cube","move":[0,0]}])", "s.json:2: move is a list of 2, expected a list of 3 numbers"},
        {R"("meshes":[{"solid":"cube","move":[0,0,"nan"]}])",
         "s.json:2: move is 'nan', expected a number from -1e+09 to 1e+09"},
        {R"("meshes":[{"solid":"cube","rotate":[0,"inf",0]}])",
         "s.json:2: rotate is 'inf', expected a number from -1e+06 to 1e+06"},
        {R"("meshes":[{"solid":"cube","scale":0}])", "s.json:2: scale is 0, expected a number from 1e-06 to 1e+06"},
        {R"("meshes":[{"solid":"cube","light":-1}])", "s.json:2: light is -1, expected a number from 0 to 1e+06"},
        {R"("meshes":[{"solid":"cube","blend":"add"}])", "s.json:2: blend is 'add', expected none or half"},
        {"\"meshes\":[{\"solid\":\"cube\",\n\"ratio\":1}]", "s.json:3: 'ratio' is for jelly-cubes"},
        {R"("meshes":[{"rotate2":[0,0,0],"solid":"torus"}])", "s.json:2: 'rotate2' is for jelly-cubes"},
        {R"("meshes":[{"solid":"jelly-cubes","ratio":0}])", "s.json:2: ratio is 0, expected a number from 0.01 to 100"},
        {R"("meshes":[{"solid":"cube","size":1}])",
         "s.json:2: key 'size' of a mesh is not known, expected solid, obj, texture, rotate, move, scale, blend, "
         "light, "
         "ratio or rotate2"},
        {R"("camera":{"focal":0})", "s.json:2: focal is 0, expected a number from 0.001 to 1e+09"},
        {R"("camera":{"near":"-inf"})", "s.json:2: near is '-inf', expected a number from 1e-06 to 1e+09"},
        {R"("camera":{"far":1})", "s.json:2: key 'far' of camera is not known, expected focal or near"},
        {R"("polygons":[{"blend":true}])", "s.json:2: blend is true, expected none or half"},
    };
    for (const auto& [members, error] : cases) EXPECT_EQ(error_of(members), error);
}

TEST(Meshes, AreBoundedInNumber) {
    std::string meshes;
    for (std::size_t i = 0; i <= kMaxMeshes; ++i) meshes += std::string(i == 0 ? "" : ",") + R"({"solid":"torus"})";
    EXPECT_EQ(error_of("\"meshes\":[" + meshes + "]"), "s.json:2: there are more than 4096 meshes");
}

/// Whatever the numbers within their bounds, what is drawn is finite.
TEST(Meshes, ExtremeNumbersGiveFinitePolygons) {
    for (const char* solid : {"cube", "torus", "jelly-cubes"}) {
        for (const char* scale : {"1e-6", "1e6", "1"}) {
            for (const char* move : {"[1e9,-1e9,1e9]", "[0,0,1e-6]", "[1e9,1e9,0.001]", "[0,0,-1e9]", "[3,0,1]"}) {
                for (const char* camera : {"{\"focal\":1e9,\"near\":1e-6}", "{}", "{\"focal\":0.001,\"near\":1e9}"}) {
                    const Result<LoadedScene> read = with(std::string("\"meshes\":[{\"solid\":\"") + solid +
                                                          "\",\"rotate\":[1e6,45,-1e6],\"scale\":" + scale +
                                                          ",\"move\":" + move + "}],\"camera\":" + camera);
                    ASSERT_TRUE(read) << read.error().text();
                    EXPECT_TRUE(read->warnings.empty());
                }
            }
        }
    }
}

}  // namespace
}  // namespace texelscope::mesh_reader_test
