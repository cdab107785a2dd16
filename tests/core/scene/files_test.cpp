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

TEST(LoadScene, MissingFileIsNamed) {
    EXPECT_EQ(load_scene("none/s.json").error().where, "none/s.json");
    EXPECT_FALSE(load_scene("/"));
    EXPECT_FALSE(load_scene(""));
}

}  // namespace
}  // namespace texelscope
