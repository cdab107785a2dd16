// What the summaries of the workloads claim, and that all machines draw the same triangles.
#include "core/measure/workloads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/exact/triangle.h"
#include "core/image/image.h"
#include "core/method/drawing.h"
#include "core/scene/triangles_scene.h"

namespace texelscope::workloads_test {
namespace {

TrianglesFile made(std::string_view name, std::uint64_t seed = 1) { return find_workload(name)->make(seed); }

std::size_t count_of(const TrianglesFile& file) { return file.vertices.size() / 3; }

std::span<const Vertex, 3> corners_of(const TrianglesFile& file, std::size_t n) {
    return std::span<const Vertex, 3>(&file.vertices[3 * n], 3);
}

/// Twice the area with its sign; exact for corners on the grid of 1/256 px.
double doubled_area(std::span<const Vertex, 3> p) {
    const double bx = double{p[1].x} - double{p[0].x}, by = double{p[1].y} - double{p[0].y};
    const double cx = double{p[2].x} - double{p[0].x}, cy = double{p[2].y} - double{p[0].y};
    return bx * cy - cx * by;
}

double mean_area(const TrianglesFile& file) {
    double sum = 0;
    for (std::size_t n = 0; n < count_of(file); ++n) sum += std::abs(doubled_area(corners_of(file, n))) / 2;
    return sum / static_cast<double>(count_of(file));
}

/// FNV-1a.
std::uint64_t hash_of(const std::string& bytes) {
    std::uint64_t hash = 0xCBF29CE484222325;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3;
    return hash;
}

template <class Put>
void each_sample_of(const TrianglesFile& file, std::size_t n, const Put& put) {
    const auto corners = corners_of(file, n);
    const ExactTriangle triangle(corners);
    if (triangle.winding() == 0) return;
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const int first = std::max(0, static_cast<int>(std::floor(low)) - 1),
              last = std::min(file.height, static_cast<int>(std::ceil(high)) + 1);
    for (int y = first; y < last; ++y) {
        const PixelRange row = triangle.row(y, 0, file.width);
        for (Integer x = row.x0; x < row.x1; ++x) put(static_cast<int>(x), y);
    }
}

TEST(Workloads, AreTheSameEverywhere) {
    // Another number here means other triangles than those of all earlier figures.
    const std::map<std::string_view, std::uint64_t> expected{{"big", 0x91E001FE14A3BB4B},
                                                             {"hundred", 0x882AFFB0295D9212},
                                                             {"four", 0x9579CFE7CE2F8FEF},
                                                             {"mesh", 0x1803365800B48AC2},
                                                             {"big-perspective", 0xBD70D522EFBB5B29},
                                                             {"hundred-perspective", 0xCFDDDA3A6ABEE603},
                                                             {"waste", 0x533332CEFC8214A4},
                                                             {"slivers", 0x402631BCF4C921BE}};
    ASSERT_EQ(workloads().size(), expected.size());
    for (const Workload& workload : workloads())
        EXPECT_EQ(hash_of(print_triangles(workload.make(1))), expected.at(workload.name)) << workload.name;
}

TEST(Workloads, DifferWithTheSeedAndKeepIt) {
    for (const Workload& workload : workloads()) {
        const TrianglesFile one = workload.make(1), two = workload.make(2);
        EXPECT_EQ(one.seed, 1U);
        EXPECT_EQ(one.vertices.size(), two.vertices.size()) << workload.name;
        EXPECT_NE(one.vertices, two.vertices) << workload.name;
    }
}

TEST(Workloads, CanBeWrittenAndRead) {
    for (const Workload& workload : workloads()) {
        const TrianglesFile file = workload.make(3);
        EXPECT_EQ(file.width, 1024);
        EXPECT_EQ(file.height, 1024);
        EXPECT_EQ(file.texture_width, 256);
        EXPECT_EQ(file.texture_height, 256);
        const Result<TrianglesFile> again = parse_triangles(print_triangles(file), "x.tri");
        ASSERT_TRUE(again) << workload.name << ": " << again.error().text();
        EXPECT_EQ(*again, file) << workload.name;
    }
}

TEST(Workloads, AreFoundByName) {
    for (const Workload& workload : workloads()) EXPECT_EQ(find_workload(workload.name), &workload);
    EXPECT_EQ(find_workload(""), nullptr);
    EXPECT_EQ(find_workload("Big"), nullptr);
}

TEST(Workloads, HaveAsManyTrianglesOfSuchAnAreaAsTheySay) {
    struct Claim {
        std::string_view name;
        std::size_t triangles;
        double area;
    };
    for (const Claim& claim : {Claim{"big", 400, 20'000},
                               {"hundred", 40'000, 100},
                               {"four", 200'000, 4},
                               {"mesh", 259'200, 4},
                               {"big-perspective", 400, 20'000},
                               {"hundred-perspective", 40'000, 100}}) {
        const TrianglesFile file = made(claim.name);
        EXPECT_EQ(count_of(file), claim.triangles) << claim.name;
        EXPECT_NEAR(mean_area(file), claim.area, claim.area * .02) << claim.name;
    }
}

TEST(Workloads, LieMostlyOnTheScreen) {
    for (const std::string_view name : {"big", "hundred"}) {
        const TrianglesFile file = made(name);
        const double area = mean_area(file) * static_cast<double>(count_of(file));
        EXPECT_NEAR(static_cast<double>(covered_samples(file)), area, area * .02) << name;
    }
}

TEST(Workloads, PutPerspectiveWhereTheySayOnly) {
    for (const Workload& workload : workloads()) {
        const TrianglesFile file = workload.make(1);
        EXPECT_EQ(file.perspective, workload.name.find("perspective") != workload.name.npos) << workload.name;
        float least = 1, most = 1;
        for (const Vertex& vertex : file.vertices) least = std::min(least, vertex.w), most = std::max(most, vertex.w);
        EXPECT_TRUE(file.perspective ? least >= 1 && most > 3.9F && most < 4 : most == 1) << workload.name;
    }
}

TEST(Workloads, MeshCoversEachSampleOnceAwayFromItsBorder) {
    const TrianglesFile file = made("mesh");
    Grid<std::uint8_t> times(file.width, file.height);
    for (std::size_t n = 0; n < count_of(file); ++n) each_sample_of(file, n, [&](int x, int y) { ++times.at(x, y); });
    constexpr int kBorder = 2;
    for (int y = kBorder; y < file.height - kBorder; ++y)
        for (int x = kBorder; x < file.width - kBorder; ++x) ASSERT_EQ(times.at(x, y), 1) << x << ", " << y;
}

TEST(Workloads, SliversAreAsLongAndThinAsTheySay) {
    const TrianglesFile file = made("slivers");
    EXPECT_EQ(count_of(file), 20'000U);
    double longest_of_all = 0;
    for (std::size_t n = 0; n < count_of(file); ++n) {
        const auto p = corners_of(file, n);
        std::array<double, 3> side{};
        for (std::size_t k = 0; k < 3; ++k)
            side[k] = std::hypot(double{p[k].x} - double{p[(k + 1) % 3].x}, double{p[k].y} - double{p[(k + 1) % 3].y});
        const double length = *std::max_element(side.begin(), side.end());
        const double width = std::abs(doubled_area(p)) / length;
        ASSERT_TRUE(length > 599.9 && length < 8000.1) << length;
        ASSERT_TRUE(width > .49 && width < 3.01) << width;
        longest_of_all = std::max(longest_of_all, length);
    }
    EXPECT_GT(longest_of_all, 7900);
}

TEST(Workloads, NineInTenOfTheWasteAreForNothing) {
    const TrianglesFile file = made("waste");
    EXPECT_EQ(count_of(file), 1'000'000U);
    ASSERT_TRUE(file.depth && file.cull_back);
    constexpr std::size_t kWalls = 200, kLookedAt = 50'000;
    Grid<std::uint8_t> wall(file.width, file.height);
    for (std::size_t n = 0; n < kWalls; ++n) each_sample_of(file, n, [&](int x, int y) { wall.at(x, y) = 1; });
    std::map<std::string_view, double> share;
    for (std::size_t n = kWalls; n < kWalls + kLookedAt; ++n) {
        const auto p = corners_of(file, n);
        bool sampled = false, seen = false;
        if (doubled_area(p) > 0)
            each_sample_of(file, n, [&](int x, int y) {
                sampled = true;
                seen = seen || p[0].z < .3F || (p[0].z > .4F && wall.at(x, y) == 0);
            });
        const bool outside = p[0].x < 0 || p[0].x > static_cast<float>(file.width);
        const std::string_view fate = doubled_area(p) <= 0 ? "back"
                                      : seen               ? "seen"
                                      : sampled            ? "hidden"
                                      : outside            ? "outside"
                                                           : "no sample";
        share[fate] += 1.0 / kLookedAt;
    }
    EXPECT_NEAR(share["seen"], .10, .01);
    EXPECT_NEAR(share["hidden"], .25, .01);
    EXPECT_NEAR(share["back"], .25, .01);
    EXPECT_NEAR(share["outside"], .20, .01);
    EXPECT_NEAR(share["no sample"], .20, .01);
}

TEST(Jitter, KeepsSharedCornersTogetherAndStaysWithinItsMost) {
    const TrianglesFile file = made("mesh");
    TrianglesFile shaken = file;
    jitter(shaken, .03F, 5);
    std::map<std::pair<float, float>, std::pair<float, float>> place;
    float farthest = 0;
    for (std::size_t n = 0; n < file.vertices.size(); ++n) {
        const Vertex &a = file.vertices[n], &b = shaken.vertices[n];
        const auto [at, added] = place.try_emplace({a.x, a.y}, b.x, b.y);
        ASSERT_EQ(at->second, std::pair(b.x, b.y));
        farthest = std::max({farthest, std::abs(b.x - a.x), std::abs(b.y - a.y)});
        ASSERT_EQ((std::array{a.z, a.w, a.u, a.v}), (std::array{b.z, b.w, b.u, b.v}));
    }
    EXPECT_LT(farthest, .03F + 1e-4F);
    EXPECT_GT(farthest, .029F);
}

TEST(Jitter, LeavesTheGridAndIsTheSameForASeed) {
    const TrianglesFile file = made("big");
    TrianglesFile one = file, again = file, other = file;
    jitter(one, .03F, 5), jitter(again, .03F, 5), jitter(other, .03F, 6);
    EXPECT_EQ(one, again);
    EXPECT_NE(one, other);
    const auto on_grid = std::count_if(one.vertices.begin(), one.vertices.end(),
                                       [](const Vertex& v) { return v.x * 256 == std::floor(v.x * 256); });
    EXPECT_LT(on_grid, 200);
}

TEST(CoveredSamples, AreThoseThatTheDefinitionWrites) {
    std::uint32_t state = 1;
    const auto dice = [&](float low, float high) {
        state = state * 1664525 + 1013904223;
        return low + (high - low) * static_cast<float>(state >> 8) / 16777216.0F;
    };
    TrianglesFile file{.width = 31, .height = 23, .texture_width = 8, .texture_height = 8};
    for (int n = 0; n < 180; ++n) {
        const auto shake = [&](float range) {
            return n % 3 == 0 ? std::floor(dice(-5, range)) + .5F : dice(-5, range);
        };
        const float x = shake(36), y = shake(28);
        file.vertices.push_back({x, y, dice(0, 1.2F), 1, 0, 0});
    }
    for (const bool depth : {false, true})
        for (const bool cull : {false, true}) {
            file.depth = depth, file.cull_back = cull;
            const Scene scene = scene_of(file, Image(8, 8));
            const Drawing drawing(scene, {.method = find_method("barycentric"), .format = NumberFormat::exact});
            std::uint64_t written = 0;
            each_sample(drawing, 0, drawing.shape_count(), {scene.framebuffer.rect(), 1},
                        [&](int, const Sample& s) { written += s.fate == Fate::written ? 1 : 0; });
            EXPECT_GT(written, 1000U);
            EXPECT_EQ(covered_samples(file), written) << depth << cull;
        }
}

}  // namespace
}  // namespace texelscope::workloads_test
