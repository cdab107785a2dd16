#include "app/shell/documents.h"

#include <chrono>

#include <gtest/gtest.h>

#include "app/shell/headless.h"
#include "app/state/link.h"
#include "core/image/load.h"
#include "tests/app/shell/lesson_folder.h"

namespace texelscope {
namespace {

TEST(Documents, AStateOfALessonElsewhereOpensAgain) {
    const LessonFolder folder;
    auto state = open_state(folder.lesson().string(), {});
    ASSERT_TRUE(state) << state.error().text();
    Store store(*state);
    store.dispatch(action::Advance{});
    const std::string line = print_link(store.state());
    const auto again = open_state(line, {});
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->document->files.front(), folder.lesson());
    EXPECT_EQ(again->cursor, store.state().cursor);
    EXPECT_EQ(print_link(*again), line);
}

TEST(Documents, AFileOfAnotherNameOpensAgain) {
    const LessonFolder folder;
    folder.write("other.md", kOwnLesson);
    const auto document = open_document((folder.path / "other.md").string());
    ASSERT_TRUE(document) << document.error().text();
    EXPECT_EQ((*document)->id, (folder.path / "other.md").string());
    EXPECT_TRUE(open_document((*document)->id));
}

TEST(Documents, AShippedLessonIsNamedInShort) {
    for (const char* target : {"5", "05-half-planes"}) {
        const auto document = open_document(target);
        ASSERT_TRUE(document) << document.error().text();
        EXPECT_EQ((*document)->id, "05-half-planes");
    }
    const auto by_file = open_document(TEXELSCOPE_SOURCE_DIR "/lessons/05-half-planes/lesson.md");
    ASSERT_TRUE(by_file) << by_file.error().text();
    EXPECT_EQ((*by_file)->id, "05-half-planes");
}

TEST(Documents, TheFolderOneStandsInIsALesson) {
    const LessonFolder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path);
    const auto document = open_document(".");
    std::filesystem::current_path(before);
    ASSERT_TRUE(document) << document.error().text();
    EXPECT_EQ((*document)->lesson->id, "22-mine");
    EXPECT_EQ((*document)->lesson->number, 22);
    EXPECT_EQ((*document)->id, folder.path.string());
}

TEST(Documents, TheSceneAndItsPicturesAreWatched) {
    const auto document = open_document(TEXELSCOPE_SOURCE_DIR "/lessons/example/texture-slides");
    ASSERT_TRUE(document) << document.error().text();
    std::vector<std::string> names;
    for (const auto& file : (*document)->files) names.push_back(file.filename().string());
    EXPECT_EQ(names, (std::vector<std::string>{"lesson.md", "scene.json", "grid.png"}));
    for (const auto& file : (*document)->files) EXPECT_TRUE(std::filesystem::exists(file)) << file;
}

/// Saves a file as an editor does, so that its time is another one.
void save(const LessonFolder& folder, const std::string& name, std::string_view text) {
    const auto file = folder.path / name;
    const auto time = std::filesystem::exists(file) ? std::filesystem::last_write_time(file)
                                                    : std::filesystem::file_time_type::clock::now();
    folder.write(name, text);
    std::filesystem::last_write_time(file, time + std::chrono::seconds(1));
}

class Reload : public testing::Test {
protected:
    void SetUp() override {
        auto state = open_state(folder_.lesson().string(), {});
        ASSERT_TRUE(state) << state.error().text();
        auto app = Headless::start(*state, {1280, 720});
        ASSERT_TRUE(app) << app.error().text();
        app_ = *std::move(app);
    }
    void save_lesson(std::string_view from, std::string_view to) {
        std::string text(kOwnLesson);
        text.replace(text.find(from), from.size(), to);
        save(folder_, "lesson.md", text);
        ASSERT_TRUE(app_->shell().poll());
    }
    [[nodiscard]] std::string step() const { return app_->state().cursor.step.text(); }

    LessonFolder folder_;
    std::unique_ptr<Headless> app_;
};

TEST_F(Reload, KeepsTheStepWhereTheBeatAsksForTheSame) {
    app_->store().dispatch(action::StepTo{*parse_path("t0/s1")});
    save_lesson("Prose.", "Other prose.");
    EXPECT_EQ(step(), "t0/s1");
    EXPECT_EQ(app_->state().document->lesson->beats[0].prose, "Other prose.");
}

TEST_F(Reload, TakesTheBeatsNewStepAndLevel) {
    app_->store().dispatch(action::StepTo{*parse_path("t0/s1")});
    save_lesson("x6/e8", "x7/e2");
    EXPECT_EQ(step(), "t0/s5/y5/x7/e2");
    EXPECT_EQ(app_->state().cursor.level, Level::expression);
    save_lesson("x6/e8\"", "x7/e2\"\nlevel = \"pixel\"");
    EXPECT_EQ(step(), "t0/s5/y5/x7");
}

TEST_F(Reload, AnotherBeatsStepMovesNothing) {
    app_->store().dispatch(action::StepTo{*parse_path("t0/s1")});
    save_lesson("\"t0/s0\"", "\"t0/s3\"");
    EXPECT_EQ(step(), "t0/s1");
    app_->store().dispatch(action::Advance{});
    EXPECT_EQ(step(), "t0/s3");
}

TEST_F(Reload, FollowsAChangedPicture) {
    const auto picture = [](std::uint8_t grey) {
        Image image(2, 2);
        for (std::size_t n = 0; n < image.size(); ++n) image.data()[n] = {grey, grey, grey};
        const auto png = encode_png(image);
        return std::string(png->begin(), png->end());
    };
    std::string scene(kOwnScene);
    const std::string_view pattern = R"("pattern": "checker", "size": [16, 16])";
    scene.replace(scene.find(pattern), pattern.size(), R"("file": "own.png")");
    save(folder_, "own.png", picture(10));
    save(folder_, "scene.json", scene);
    ASSERT_TRUE(app_->shell().poll());
    EXPECT_EQ(app_->store().derived().texture().texels.at(0, 0).r, 10);
    static_cast<void>(app_->shell().poll());  // takes note of the picture
    EXPECT_FALSE(app_->shell().poll());
    save(folder_, "own.png", picture(20));
    ASSERT_TRUE(app_->shell().poll());
    EXPECT_EQ(app_->store().derived().texture().texels.at(0, 0).r, 20);
}

}  // namespace
}  // namespace texelscope
