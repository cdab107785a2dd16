#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "core/base/file.h"
#include "core/image/load.h"
#include "core/scene/json.h"

namespace texelscope {
namespace {

namespace fs = std::filesystem;

/// root/scene/, root/assets/, root/secret.png, and root/scene-2/ whose name begins as the scene's folder does.
class SceneTextures : public testing::Test {
protected:
    void SetUp() override {
        root_ = fs::canonical(fs::temp_directory_path()) / ("texelscope-scene-test-" + std::to_string(::getpid()));
        for (const char* folder : {"scene/sub", "assets", "scene-2"}) fs::create_directories(root_ / folder);
        const auto png = *encode_png(picture_);
        for (const char* file : {"scene/a.png", "scene/sub/b.png", "assets/c.png", "secret.png", "scene-2/d.png"})
            ASSERT_FALSE(write_file_atomically(root_ / file, png));
    }
    void TearDown() override { fs::remove_all(root_); }

    [[nodiscard]] Result<LoadedScene> with_file(const std::string& file) const {
        const std::string text = "{\"texelscope\":1,\n\"textures\":[{\"name\":\"t\",\"file\":\"" + file + "\"}]}";
        EXPECT_FALSE(write_file_atomically(root_ / "scene/s.json", bytes_of(text)));
        return load_scene(root_ / "scene/s.json", root_ / "assets");
    }
    [[nodiscard]] std::string error_of(const std::string& file) const {
        const Result<LoadedScene> scene = with_file(file);
        return scene ? "none" : scene.error().text();
    }

    fs::path root_;
    Image picture_ = make_pattern(Pattern::address, 5, 3, 1);
};

TEST_F(SceneTextures, LieInTheFolderTreeOrTheAssets) {
    for (const std::string file :
         {"a.png", "./a.png", "sub/b.png", "sub/../a.png", "../assets/c.png", "../scene/a.png"}) {
        const Result<LoadedScene> scene = with_file(file);
        ASSERT_TRUE(scene) << scene.error().text();
        EXPECT_EQ(scene->scene.textures[0]->texels, picture_);
        EXPECT_EQ(scene->scene.textures[0]->source.file, file);
    }
    EXPECT_TRUE(with_file((root_ / "scene/a.png").string()));
}

TEST_F(SceneTextures, OutsideAreRefusedWhetherTheyExistOrNot) {
    fs::create_symlink(root_ / "secret.png", root_ / "scene/link.png");
    fs::create_directory_symlink(root_, root_ / "scene/up");
    for (const std::string& file :
         {std::string("../secret.png"), std::string("sub/../../secret.png"), std::string("/etc/passwd"),
          std::string("../scene-2/d.png"), std::string("link.png"), std::string("up/secret.png"),
          std::string("../none.png"), (root_ / "secret.png").string(), std::string("..")})
        EXPECT_NE(error_of(file).find("s.json:2: texture 't': file"), std::string::npos) << error_of(file);
    EXPECT_NE(error_of("../secret.png").find("lies outside the scene's folder and the assets"), std::string::npos);
    EXPECT_NE(error_of("../none.png").find("lies outside"), std::string::npos);
    EXPECT_NE(error_of("link.png").find("lies outside"), std::string::npos);
}

TEST_F(SceneTextures, LinkToInsideIsFollowed) {
    fs::create_symlink("sub/b.png", root_ / "scene/link.png");
    EXPECT_TRUE(with_file("link.png"));
}

TEST_F(SceneTextures, MissingAndWrongFilesAreNamedWithTheirLine) {
    EXPECT_EQ(error_of("none.png"), (root_ / "scene/s.json:2: texture 't': file 'none.png' does not exist").string());
    for (const std::string& file :
         {std::string("sub"), std::string("s.json"), std::string(""), std::string("a.png\\u0000"),
          std::string(5000, 'x'), std::string("a.png/x"), std::string("a\\nb")}) {
        const std::string error = error_of(file);
        EXPECT_EQ(error.rfind((root_ / "scene/s.json:2: texture 't': file '").string(), 0), 0u) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos);
    }
}

TEST_F(SceneTextures, SurviveWriting) {
    const Result<LoadedScene> scene = with_file("sub/b.png");
    const Result<LoadedScene> again =
        parse_scene(scene_to_json(scene->scene), "again", {root_ / "scene", root_ / "assets"});
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(*again->scene.textures[0], *scene->scene.textures[0]);
}

/// root/scene/ with a strip of ten frames, two pictures of one size, one of another, and a model.
class SceneParts : public SceneTextures {
protected:
    void SetUp() override {
        SceneTextures::SetUp();
        const Image strip = make_pattern(Pattern::address, 4, 40, 1);
        ASSERT_FALSE(write_file_atomically(root_ / "scene/strip.png", *encode_png(strip)));
        const Image other = make_pattern(Pattern::checker, 5, 3, 1), large = make_pattern(Pattern::uv, 6, 3, 1);
        ASSERT_FALSE(write_file_atomically(root_ / "scene/other.png", *encode_png(other)));
        ASSERT_FALSE(write_file_atomically(root_ / "scene/large.png", *encode_png(large)));
        const std::string model = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        ASSERT_FALSE(write_file_atomically(root_ / "scene/m.obj", bytes_of(model)));
        ASSERT_FALSE(write_file_atomically(root_ / "secret.obj", bytes_of(model)));
        const std::string bad = "v 0 0 0\nf 1 1 1\n";
        ASSERT_FALSE(write_file_atomically(root_ / "scene/bad.obj", bytes_of(bad)));
    }
    [[nodiscard]] Result<LoadedScene> with(const std::string& members) const {
        return parse_scene("{\"texelscope\":1,\n" + members + "}", "s.json", {root_ / "scene", root_ / "assets"});
    }
    [[nodiscard]] std::string error_with(const std::string& members) const {
        const Result<LoadedScene> scene = with(members);
        return scene ? "none" : scene.error().text();
    }
};

TEST_F(SceneParts, StripIsAnAnimation) {
    Result<LoadedScene> read = with(R"("textures":[{"name":"t","pattern":"uv","size":[2,2]},
        {"name":"s","file":"strip.png","frames":10,"palette":2}])");
    ASSERT_TRUE(read) << read.error().text();
    Scene& scene = read->scene;
    ASSERT_EQ(scene.animations.size(), 1u);
    EXPECT_EQ(scene.animations[0].texture, 1);
    ASSERT_EQ(scene.animations[0].frames.size(), 10u);
    EXPECT_EQ(scene.textures[1], scene.animations[0].frames[0]);
    const std::string text = scene_to_json(scene);
    show_frame(scene, 13);
    EXPECT_EQ(scene.textures[1], scene.animations[0].frames[3]);
    EXPECT_EQ(scene.textures[1]->width(), 4);
    EXPECT_EQ(scene.textures[1]->height(), 4);
    EXPECT_EQ(scene.textures[1]->palette.size(), 2u);
    EXPECT_EQ(scene_to_json(scene), text);  // whichever frame is shown
    const Result<LoadedScene> again = parse_scene(text, "again", {root_ / "scene", {}});
    ASSERT_TRUE(again) << again.error().text();
    for (std::size_t n = 0; n < 10; ++n)
        EXPECT_EQ(*again->scene.animations[0].frames[n], *scene.animations[0].frames[n]);
}

TEST_F(SceneParts, ListOfFilesIsAnAnimation) {
    Result<LoadedScene> read = with(R"("textures":[{"name":"s","files":["a.png","other.png","sub/b.png"]}])");
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->scene.animations.size(), 1u);
    ASSERT_EQ(read->scene.animations[0].frames.size(), 3u);
    EXPECT_EQ(read->scene.textures[0]->texels, picture_);
    show_frame(read->scene, 1);
    EXPECT_EQ(read->scene.textures[0]->texels, make_pattern(Pattern::checker, 5, 3, 1));
    const Result<LoadedScene> again = parse_scene(scene_to_json(read->scene), "again", {root_ / "scene", {}});
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->scene.animations[0].frames.size(), 3u);
}

TEST_F(SceneParts, BadFramesAreNamed) {
    const std::string start = "\"textures\":[{\"name\":\"s\",";
    EXPECT_EQ(error_with(start + "\"files\":[\"a.png\",\"large.png\"]}]"),
              "s.json:2: texture 's': file 'large.png' is 6 x 3, expected 5 x 3 as of the first");
    EXPECT_EQ(error_with(start + "\"file\":\"strip.png\",\"frames\":3}]"),
              "s.json:2: texture 's': file 'strip.png' is 4 x 40, expected a side of 3 equal frames");
    EXPECT_EQ(error_with(start + "\"files\":[\"a.png\",\"../secret.png\"]}]"),
              "s.json:2: texture 's': file '../secret.png' lies outside the scene's folder and the assets");
    EXPECT_EQ(error_with(start + "\"files\":[]}]"),
              "s.json:2: files of a texture is a list of 0, expected a list of 1 to 256 names");
    EXPECT_EQ(error_with(start + "\"files\":[\"a.png\"],\"frames\":3}]"),
              "s.json:2: texture 's': 'frames' is for a 'file'");
    EXPECT_EQ(error_with(start + "\"files\":[\"a.png\"],\"file\":\"a.png\"}]"),
              "s.json:2: texture 's': expected either 'file', 'files' or 'pattern'");
    EXPECT_EQ(error_with(start + "\"file\":\"strip.png\",\"frames\":0}]"),
              "s.json:2: frames is 0, expected a whole number from 1 to 256");
}

TEST_F(SceneParts, ModelIsReadOnceAndPlaced) {
    const Result<LoadedScene> read =
        with(R"("meshes":[{"obj":"m.obj","move":[0,0,4]},{"obj":"sub/../m.obj","move":[1,0,4]}])");
    ASSERT_TRUE(read) << read.error().text();
    const Scene& scene = read->scene;
    EXPECT_EQ(scene.meshes[0].model, scene.meshes[1].model);
    EXPECT_EQ(scene.polygons.size(), 2u);
    const Result<LoadedScene> again = parse_scene(scene_to_json(scene), "again", {root_ / "scene", {}});
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->scene.polygons, scene.polygons);
    EXPECT_EQ(again->scene.meshes[1].file, "sub/../m.obj");
}

TEST_F(SceneParts, BadModelsAreNamed) {
    const auto with_obj = [&](const std::string& file) {
        return error_with("\"meshes\":[{\"obj\":\"" + file + "\"}]");
    };
    EXPECT_EQ(with_obj("bad.obj"),
              "s.json:2: a mesh: file 'bad.obj':2: two corners of the face that follow each other are at one place");
    EXPECT_EQ(with_obj("none.obj"), "s.json:2: a mesh: file 'none.obj' does not exist");
    EXPECT_EQ(with_obj("../secret.obj"),
              "s.json:2: a mesh: file '../secret.obj' lies outside the scene's folder and the assets");
    EXPECT_EQ(with_obj("a.png"), "s.json:2: a mesh: file 'a.png':3: has a character of no text");
    EXPECT_EQ(with_obj("sub").substr(0, 29), "s.json:2: a mesh: file 'sub' ");
}

TEST(LoadScene, MissingFileIsNamed) {
    EXPECT_EQ(load_scene("none/s.json").error().where, "none/s.json");
    EXPECT_FALSE(load_scene("/"));
    EXPECT_FALSE(load_scene(""));
}

}  // namespace
}  // namespace texelscope
