// `texelscope bench` and `texelscope workload` as people call them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>

#include "core/base/file.h"
#include "core/image/load.h"
#include "core/image/packed.h"
#include "core/measure/workloads.h"
#include "core/method/method.h"
#include "core/scene/triangles_file.h"
#include "tests/app/cli/program.h"

namespace texelscope::bench_test {
namespace {

namespace fs = std::filesystem;

/// Triangles all over a small picture, not on any grid.
TrianglesFile some_triangles() {
    TrianglesFile file{.width = 41, .height = 29, .texture_width = 32, .texture_height = 16};
    std::uint32_t state = 1;
    const auto dice = [&](float low, float high) {
        state = state * 1664525 + 1013904223;
        return low + (high - low) * static_cast<float>(state >> 8) / 16777216.0F;
    };
    for (int n = 0; n < 60; ++n) {
        const float x = dice(-10, 50), y = dice(-10, 40), z = dice(0, 1), w = dice(1, 3), u = dice(-2, 2);
        file.vertices.push_back({x, y, z, w, u, dice(-2, 2)});
    }
    return file;
}

class BenchTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  ("texelscope_bench_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string put(const std::string& name, const std::string& bytes) const {
        EXPECT_FALSE(write_file_atomically(path(name), bytes_of(bytes)));
        return path(name);
    }
    std::string put(const std::string& name, const TrianglesFile& file) const {
        return put(name, print_triangles(file));
    }
    /// What `bench` draws.
    [[nodiscard]] Image drawn(const std::string& arguments) const {
        const Ran ran = run_program("bench --reps 1 -o '" + path("out.png") + "' " + arguments);
        EXPECT_EQ(ran.code, 0) << ran.err;
        const auto image = load_image(path("out.png"));
        EXPECT_TRUE(image);
        return image ? *image : Image();
    }

    fs::path folder_;
};

void expect_refused(const std::string& arguments, const std::string& reason) {
    const Ran ran = run_program(arguments);
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_EQ(ran.out, "") << arguments;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.err.find(reason), std::string::npos) << ran.err << "expected " << reason;
}

TEST_F(BenchTest, PrintsALineForEachFile) {
    const std::string one = put("one.tri", some_triangles()), two = put("two words.tri", some_triangles());
    const Ran ran = run_program("bench --reps 2 '" + one + "' '" + two + "'");
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    const std::string numbers = R"(\d+\.\d{4},\d+\.\d{4},\d+\.\d\d,\d+\.\d{3}\n)";
    EXPECT_TRUE(std::regex_match(ran.out, std::regex("fast,t1,one," + numbers + "fast,t1,two words," + numbers)))
        << ran.out;
}

TEST_F(BenchTest, DrawsWhatTheDefinitionDoes) {
    TrianglesFile file = some_triangles();
    for (const bool perspective : {false, true})
        for (const bool cull : {false, true}) {
            file.perspective = perspective, file.cull_back = cull;
            const std::string tri = put("x.tri", file);
            const Image fast = drawn(tri);
            EXPECT_EQ(fast.width(), 41);
            EXPECT_EQ(fast.height(), 29);
            EXPECT_EQ(fast, drawn(tri + " --method barycentric --number exact"));
            EXPECT_NE(fast, Image(41, 29));
        }
}

TEST_F(BenchTest, DrawsWithTheTextureThatItIsGiven) {
    Image image(8, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) image.at(x, y) = unpacked(static_cast<std::uint32_t>(0x0A1F35 + 0x051103 * x * y));
    const auto png = encode_png(image);
    ASSERT_TRUE(png);
    const std::string texture = put("t.png", std::string(png->begin(), png->end()));
    const std::string tri = put("x.tri", some_triangles());
    const Image fast = drawn(tri + " --texture '" + texture + "'");
    EXPECT_EQ(fast, drawn(tri + " --method barycentric --number exact --texture '" + texture + "'"));
    EXPECT_NE(fast, drawn(tri));
}

TEST_F(BenchTest, SnapsFirstWhereAsked) {
    TrianglesFile file = some_triangles();
    const Image snapped = drawn(put("x.tri", file) + " --snap 1");
    EXPECT_NE(snapped, drawn(put("x.tri", file)));
    for (Vertex& v : file.vertices) v.x = std::nearbyint(v.x * 2) / 2, v.y = std::nearbyint(v.y * 2) / 2;
    EXPECT_EQ(snapped, drawn(put("x.tri", file)));
}

TEST_F(BenchTest, CountsDecisionsOfOneDrawing) {
    const std::string tri = put("x.tri", some_triangles());
    const Ran once = run_program("bench --stats --reps 1 " + tri), often = run_program("bench --stats --reps 4 " + tri);
    EXPECT_EQ(once.err.rfind("{\"triangles\":20,", 0), 0U) << once.err;
    EXPECT_EQ(once.err, often.err);
    const std::string samples = "\"samples\":" + std::to_string(covered_samples(some_triangles())) + ",";
    EXPECT_NE(once.err.find(samples), std::string::npos) << once.err << samples;
}

TEST_F(BenchTest, TimesEveryMethod) {
    const std::string tri = put("x.tri", some_triangles());
    for (const Method* method : methods()) {
        const Ran ran = run_program("bench --reps 1 --method " + std::string(method->id) + " " + tri);
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.out.rfind(std::string(method->id) + ",t1,x,", 0), 0U) << ran.out;
    }
}

TEST_F(BenchTest, TakesAWorkloadByNameWhereThereIsNoSuchFile) {
    const Ran ran = run_program("bench --reps 1 big");
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out.rfind("fast,t1,big,", 0), 0U) << ran.out;
    expect_refused("bench bgi", "did you mean big?");
}

TEST_F(BenchTest, DrawsNothingInNoTime) {
    TrianglesFile file = some_triangles();
    file.vertices.clear();
    EXPECT_EQ(drawn(put("none.tri", file)), Image(41, 29));
}

TEST_F(BenchTest, RefusesDamagedFiles) {
    const std::string bytes = print_triangles(some_triangles());
    const auto with = [&](std::size_t at, char value) {
        std::string other = bytes;
        other[at] = value;
        return other;
    };
    std::string many = with(19, '\xFF'), not_a_number = with(66, '\xC0');
    for (const std::size_t at : {16U, 17U, 18U}) many[at] = '\xFF';
    not_a_number[67] = '\x7F';
    expect_refused("bench " + put("a.tri", std::string()), "a.tri: it has 0 bytes");
    expect_refused("bench " + put("a.tri", bytes.substr(0, bytes.size() - 1)), "a.tri: it has");
    expect_refused("bench " + put("a.tri", with(0, 'X')), "a.tri: it does not begin with TRIWL01");
    expect_refused("bench " + put("a.tri", many), "a.tri: there are 4294967295 triangles");
    expect_refused("bench " + put("a.tri", not_a_number), "a number that is not finite");
    expect_refused("bench " + put("fine.tri", bytes) + " " + put("a.tri", bytes.substr(0, 70)), "a.tri: it has");
}

TEST_F(BenchTest, RefusesWrongUse) {
    const std::string tri = put("x.tri", some_triangles());
    expect_refused("bench", "FILE is required");
    expect_refused("bench " + folder_.string(), "is a folder");
    expect_refused("bench " + path("none.tri"), "there is no such file");
    expect_refused("bench --reps 0 " + tri, "--reps");
    expect_refused("bench --reps many " + tri, "--reps");
    expect_refused("bench --method fats " + tri, "method 'fats' is not known");
    expect_refused("bench --target mmx " + tri, "--target");
    expect_refused("bench --target avx2 --method sections " + tri, "--target is for the method fast");
    expect_refused("bench --skip nothing=off " + tri, "nothing");
    expect_refused("bench --texture " + tri + " " + tri, "x.tri");
    expect_refused("bench -o " + path("a.png") + " " + tri + " " + tri, "-o with 2 files");
    expect_refused("bench --fast " + tri, "--fast");
}

TEST_F(BenchTest, SaysWhichTextureItCannotUse) {
    expect_refused("bench --texture " + path("none.png") + " " + put("x.tri", some_triangles()), "none.png");
}

TEST_F(BenchTest, WritesWorkloadsThatKnowTheirSamples) {
    const Ran ran = run_program("workload big --seed 7 -o " + path("big.tri"));
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto file = parse_triangles(*read_file(path("big.tri"), kMaxFileBytes), "big.tri");
    ASSERT_TRUE(file) << file.error().text();
    TrianglesFile expected = find_workload("big")->make(7);
    expected.covered = covered_samples(expected);
    EXPECT_EQ(*file, expected);
    EXPECT_GT(file->covered, 5'000'000U);
}

TEST_F(BenchTest, JittersWorkloadsByLittle) {
    ASSERT_EQ(run_program("workload big --jitter 0.03 -o " + path("big.tri")).code, 0);
    const auto file = parse_triangles(*read_file(path("big.tri"), kMaxFileBytes), "big.tri");
    ASSERT_TRUE(file) << file.error().text();
    const TrianglesFile plain = find_workload("big")->make(1);
    ASSERT_EQ(file->vertices.size(), plain.vertices.size());
    EXPECT_NE(file->vertices, plain.vertices);
    for (std::size_t n = 0; n < plain.vertices.size(); ++n)
        EXPECT_NEAR(file->vertices[n].x, plain.vertices[n].x, 0.0301F);
}

TEST_F(BenchTest, ListsWorkloads) {
    const Ran ran = run_program("workload --list");
    EXPECT_EQ(ran.code, 0) << ran.err;
    for (const Workload& workload : workloads())
        EXPECT_NE(ran.out.find(std::string(workload.summary)), std::string::npos) << ran.out;
}

TEST_F(BenchTest, RefusesUnknownWorkloads) {
    expect_refused("workload hundrde", "did you mean hundred?");
    expect_refused("workload", "expected one of big, hundred");
    expect_refused("workload big --jitter -1", "--jitter");
    expect_refused("workload big --seed x", "--seed");
    expect_refused("workload big -o " + folder_.string(), "it is a folder");
}

}  // namespace
}  // namespace texelscope::bench_test
