#include <cstring>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/image/load.h"
#include "core/measure/front.h"
#include "tests/app/cli/program.h"

namespace texelscope::front_test {
namespace {

/// A file that lasts as long as a test.
class Scratch {
public:
    explicit Scratch(const std::string& name)
        : path_((std::filesystem::temp_directory_path() / ("texelscope_front_" + std::to_string(getpid()) + name))
                    .string()) {}
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { std::filesystem::remove(path_); }
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
};

void expect_refused(const std::string& arguments, const std::string& about) {
    const Ran ran = run_program("front " + arguments);
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_NE(ran.err.find(about), std::string::npos) << arguments << ": " << ran.err;
    EXPECT_EQ(ran.out, "") << arguments;
}

TEST(FrontCommand, WrongUseIsAnErrorThatNamesWhatIsExpected) {
    expect_refused("--scenes nowhere", "near, far, steep, slivers, minified");
    expect_refused("--scenes near,near", "'near' twice");
    expect_refused("--reps 4", "5");
    expect_refused("--seed -1", "--seed");
    expect_refused("-o front.txt", ".csv or .png");
    expect_refused("--from /nonexistent/front.csv", "/nonexistent/front.csv");
    expect_refused("--from a.csv --scenes near", "--from");
    expect_refused("--theme blue", "blue");
    expect_refused("19 --scenes near", "only one of them");
    expect_refused("/nonexistent/scene.json", "/nonexistent/scene.json");
}

TEST(FrontCommand, ADamagedCsvIsNamedWithItsLine) {
    const Scratch csv("damaged.csv");
    std::ofstream(csv.path()) << "scene,rung\nnear,fast\n";
    expect_refused("--from " + csv.path(), csv.path() + ":1");
}

TEST(FrontCommand, WritesATableACsvAndAPictureThatIsDrawnAgainFromTheCsv) {
    const Scratch csv("whole.csv"), png("whole.png"), again("again.png");
    const Ran ran = run_program("front --scenes slivers --reps 5 -o " + csv.path() + " -o " + png.path());
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    const auto text = read_file(csv.path(), 1 << 20);
    ASSERT_TRUE(text);
    const auto points = parse_front(*text, "csv");
    ASSERT_TRUE(points) << points.error().text();
    EXPECT_EQ(points->size(), rungs().size());
    for (const Rung& rung : rungs()) EXPECT_NE(ran.out.find("\n" + rung.id), std::string::npos) << rung.id;
    const auto picture = load_image(png.path());
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width(), 1600);
    EXPECT_EQ(picture->height(), 1000);
    EXPECT_EQ(run_program("front --from " + csv.path() + " -o " + again.path()).out, ran.out);
    const auto second = load_image(again.path());
    ASSERT_TRUE(second);
    EXPECT_EQ(*second, *picture);
}

TEST(FrontCommand, MeasuresASceneOfOnesOwn) {
    const Scratch scene("scene.json"), csv("own.csv");
    std::ofstream(scene.path()) << R"({ "texelscope": 1, "framebuffer": { "width": 64, "height": 48 },
        "polygons": [], "random": { "triangles": 7, "size": 40, "seed": 3 } })";
    const Ran ran = run_program("front " + scene.path() + " --reps 5 -o " + csv.path());
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto text = read_file(csv.path(), 1 << 20);
    ASSERT_TRUE(text);
    const auto points = parse_front(*text, "csv");
    ASSERT_TRUE(points) << points.error().text();
    ASSERT_EQ(points->size(), rungs().size());
    EXPECT_EQ(points->front().scene, "7 40 3");
    EXPECT_EQ(points->front().triangles, 7);
}

}  // namespace
}  // namespace texelscope::front_test
