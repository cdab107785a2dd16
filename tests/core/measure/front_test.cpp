#include "core/measure/front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace texelscope {
namespace {

/// Errors alone.
[[nodiscard]] std::vector<FrontPoint> errors_of(std::vector<const FrontSceneInfo*> scenes,
                                                const std::vector<std::string>& ids, std::uint64_t seed = 1) {
    FrontOptions options{.scenes = std::move(scenes), .rounds = 0, .seed = seed};
    for (const std::string& id : ids) {
        options.rungs.push_back(find_rung(id));
        EXPECT_NE(options.rungs.back(), nullptr) << id;
    }
    FrontRun run(std::move(options));
    while (!run.step()) continue;
    return run.points();
}
[[nodiscard]] std::vector<const FrontSceneInfo*> all_scenes() {
    std::vector<const FrontSceneInfo*> all;
    for (const FrontSceneInfo& scene : front_scenes()) all.push_back(&scene);
    return all;
}

/// Right triangles with legs of 3 to 9 px whose u and v run from 0 to 256: exact.md's input for cancellation.
[[nodiscard]] FrontScene small_ones(std::uint64_t seed, int offset) {
    std::mt19937_64 engine(seed);
    const auto within = [&](int low, int high) {
        return static_cast<float>(low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1)));
    };
    FrontScene scene{.frame = {offset, offset, offset + 64, offset + 64}};
    for (int n = 0; n < 300; ++n) {
        const float leg = within(3 * 128, 9 * 128) / 128, x = within(0, 54 * 128) / 128, y = within(0, 54 * 128) / 128;
        const float o = static_cast<float>(offset);
        scene.vertices.push_back({.x = o + x, .y = o + y, .u = 0, .v = 0});
        scene.vertices.push_back({.x = o + x + leg, .y = o + y, .u = 256, .v = 0});
        scene.vertices.push_back({.x = o + x, .y = o + y + leg, .u = 0, .v = 256});
    }
    return scene;
}
constexpr FrontSceneInfo kSmallFar{"small-far", "", "", [](std::uint64_t seed) { return small_ones(seed, 1 << 16); }};
constexpr FrontSceneInfo kSmallNear{"small-near", "", "", [](std::uint64_t seed) { return small_ones(seed, 0); }};

TEST(Front, ExactAndFastHaveNoWrongSampleAnywhere) {
    for (const std::uint64_t seed : {1, 2})
        for (const FrontPoint& p : errors_of(all_scenes(), {"exact", "fast"}, seed)) {
            SCOPED_TRACE(p.scene + " " + p.rung);
            EXPECT_EQ(p.missing, 0);
            EXPECT_EQ(p.extra, 0);
            EXPECT_EQ(p.wrong, 0);
            EXPECT_EQ(p.max_error, 0);
            EXPECT_GT(p.checked, 100);
        }
}

TEST(Front, RationalNumbersHaveNoErrorInAnyMethodThatHasPerspective) {
    for (const FrontPoint& p : errors_of(all_scenes(), {"barycentric:exact", "backward-projective:exact"})) {
        SCOPED_TRACE(p.scene + " " + p.rung);
        EXPECT_EQ(p.missing + p.extra + p.wrong, 0);
        EXPECT_EQ(p.max_error, 0);
    }
}

TEST(Front, FloatLosesHalfATexelFarFromTheOriginAndNothingWhenBasedAtACorner) {
    const auto points = errors_of({&kSmallFar}, {"edge-equations:f32", "edge-equations:f32:based", "tile-based"});
    EXPECT_GT(points[0].max_error, .2);
    EXPECT_LT(points[0].max_error, .8);
    EXPECT_LT(points[1].max_error, 1e-4);
    EXPECT_LT(points[2].max_error, 1e-4);
}

TEST(Front, BasedPlanesAreAsGoodFarAwayAsNear) {
    for (const char* const id : {"edge-equations:f32:based", "tile-based", "fixed-steps", "newton-1"}) {
        const auto points = errors_of({&kSmallNear, &kSmallFar}, {id});
        EXPECT_NEAR(points[0].max_error, points[1].max_error, points[0].max_error / 10) << id;
    }
}

TEST(Front, NoPublishedBoundIsExceeded) {
    std::vector<std::string> ids;
    for (const Rung& rung : rungs())
        if (rung.bound != nullptr) ids.push_back(rung.id);
    EXPECT_GE(ids.size(), 16U);
    auto scenes = all_scenes();
    scenes.push_back(&kSmallFar);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        for (const FrontPoint& p : errors_of(scenes, ids, seed))
            EXPECT_LE(p.max_error, p.bound) << p.scene << " " << p.rung << " seed " << seed;
}

TEST(Front, BoundsAreNotFarAboveWhatHappens) {
    const FrontSceneInfo* const steep = find_front_scene("steep");
    for (const FrontPoint& p : errors_of({steep}, {"newton-0", "newton-1", "subdivided:f64:adaptive", "fixed-steps"}))
        EXPECT_GT(p.max_error, p.bound / 4) << p.rung;
}

TEST(Front, DoubleIsOffBySoLittleThatOnlyExactArithmeticTells) {
    for (const FrontPoint& p : errors_of({find_front_scene("near")}, {"edge-equations:f64", "barycentric:f64"})) {
        EXPECT_GT(p.max_error, 1e-15) << p.rung;
        EXPECT_LT(p.max_error, 1e-9) << p.rung;
    }
}

TEST(Front, SnappedCornersLoseSamplesAndNothingElse) {
    const auto points = errors_of({find_front_scene("slivers")}, {"coverage-24.8", "edge-equations:f64"});
    EXPECT_GT(points[0].missing, 0);
    EXPECT_GT(points[0].extra, 0);
    EXPECT_EQ(points[0].wrong, 0);
    EXPECT_LT(points[0].max_error, 1e-6);
}

TEST(Front, RepeatsExactlyButForTheTimes) {
    FrontOptions options{.scenes = {find_front_scene("near")}, .rungs = {find_rung("fast"), find_rung("fixed-steps")}};
    const auto run = [&] {
        FrontRun front(options);
        while (!front.advance(.01)) EXPECT_LT(front.share(), 1);
        EXPECT_EQ(front.share(), 1);
        std::vector<FrontPoint> points = front.points();
        for (FrontPoint& p : points) {
            EXPECT_GT(p.min_ns, 0);
            EXPECT_GE(p.median_ns, p.min_ns);
            p.median_ns = p.min_ns = 0, p.dominated_by = p.behind = "";
        }
        return print_front(points);
    };
    EXPECT_EQ(run(), run());
}

TEST(Front, TimesEveryRungOnceARoundAndTakesTheMedian) {
    // A clock by which the rungs' drawings take 1, 2, 3, … ms each: the rounds are counted, the first one is not.
    double now = 0, length = 0;
    int calls = 0;
    FrontOptions options{.scenes = {&kSmallNear}, .rungs = {find_rung("fast"), find_rung("exact")}};
    FrontRun front(options, [&] {
        if (calls++ % 2 == 1) now += length += .001;
        return now;
    });
    while (!front.step()) continue;
    ASSERT_EQ(front.points().size(), 2U);
    EXPECT_EQ(calls, 2 * 2 * (options.rounds + 1));
    const FrontPoint& fast = front.points()[0];  // 1 warms up; then 3, 5, 7, 9, 11 ms
    EXPECT_NEAR(fast.median_ns * static_cast<double>(fast.pixels), 7e6, 1);
    EXPECT_NEAR(fast.min_ns * static_cast<double>(fast.pixels), 3e6, 1);
}

[[nodiscard]] FrontPoint point(const char* rung, double ns, double error, const char* kind = "method") {
    FrontPoint p;
    p.scene = "near", p.rung = rung, p.label = rung, p.kind = kind, p.numbers = "f64";
    p.median_ns = p.min_ns = ns, p.max_error = error;
    return p;
}

TEST(Front, DominatedIsWhatAnotherBeatsInBoth) {
    std::array points{point("quick", 1, .5), point("slow", 2, .5), point("good", 3, .1),
                      point("worse", 4, .2), point("exact", 9, 0), point("fast", 2.5, 0, "fast")};
    mark_dominated(points);
    const auto by = [&](std::size_t n) { return points[n].dominated_by + "/" + points[n].behind; };
    EXPECT_EQ(by(0), "/");
    EXPECT_EQ(by(1), "quick/quick") << "no worse is enough";
    EXPECT_EQ(by(2), "fast/");
    EXPECT_EQ(by(3), "fast/good") << "quick is faster, but worse";
    EXPECT_EQ(by(4), "fast/");
    EXPECT_EQ(by(5), "/");
}

TEST(Front, EqualPointsDominateNeither) {
    std::array points{point("a", 1, .5), point("b", 1, .5)};
    mark_dominated(points);
    EXPECT_EQ(points[0].dominated_by, "");
    EXPECT_EQ(points[1].dominated_by, "");
}

TEST(Front, ScenesDoNotCompete) {
    std::array points{point("a", 1, .1), point("b", 2, .5)};
    points[1].scene = "far";
    mark_dominated(points);
    EXPECT_EQ(points[1].dominated_by, "");
}

TEST(FrontCsv, RoundTrips) {
    std::vector<FrontPoint> points{point("a", 1.25, 1e-14), point("b", 1e6 / 3, INFINITY)};
    points[0].label = "float, corner", points[0].bound = .1, points[0].missing = 3, points[0].wrong = 1234567890123;
    points[1].dominated_by = "a";
    const std::string csv = print_front(points);
    const auto read = parse_front(csv, "x.csv");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(print_front(*read), csv);
    EXPECT_EQ((*read)[0].label, "float, corner");
    EXPECT_EQ((*read)[0].wrong, 1234567890123);
    EXPECT_EQ((*read)[1].median_ns, 1e6 / 3);
    EXPECT_TRUE(std::isinf((*read)[1].max_error));
    EXPECT_TRUE(std::isnan((*read)[1].bound));
    EXPECT_EQ((*read)[1].dominated_by, "a");
}

TEST(FrontCsv, DamageIsNamedWithItsLine) {
    const std::vector<FrontPoint> points{point("a", 1, .5)};
    const std::string csv = print_front(points), head = csv.substr(0, csv.find('\n') + 1);
    const auto error = [](const std::string& text) {
        const auto read = parse_front(text, "x.csv");
        return read ? std::string() : read.error().text();
    };
    EXPECT_NE(error("nonsense\n").find("x.csv:1"), std::string::npos);
    EXPECT_NE(error(head), "");
    EXPECT_NE(error(""), "");
    EXPECT_NE(error(head + "near,a\n").find("x.csv:2"), std::string::npos);
    EXPECT_NE(error(csv + "near,\"a\n").find("x.csv:3"), std::string::npos);
    std::string letter = csv;
    letter.replace(letter.find(",0.5,"), 5, ",0.x,");
    EXPECT_NE(error(letter).find("x.csv:2"), std::string::npos);
    for (std::size_t n = head.size() + 1; n + 1 < csv.size(); ++n) EXPECT_NE(error(csv.substr(0, n)), "") << n;
}

TEST(FrontScenes, AreTheSameForTheSameSeedAndLieInTheirFrames) {
    for (const FrontSceneInfo& info : front_scenes()) {
        SCOPED_TRACE(info.id);
        const FrontScene scene = info.make(7);
        EXPECT_EQ(scene.vertices, info.make(7).vertices);
        EXPECT_NE(scene.vertices, info.make(8).vertices);
        EXPECT_GE(scene.triangles(), 200U);
        for (const Vertex& v : scene.vertices) {
            EXPECT_TRUE(v.x >= static_cast<float>(scene.frame.x0) && v.x <= static_cast<float>(scene.frame.x1));
            EXPECT_TRUE(v.y >= static_cast<float>(scene.frame.y0) && v.y <= static_cast<float>(scene.frame.y1));
        }
        for (std::size_t n = 0; n < scene.triangles(); ++n) {
            const auto c = scene.corners(n);
            EXPECT_GT((double{c[1].x} - c[0].x) * (double{c[2].y} - c[0].y) -
                          (double{c[2].x} - c[0].x) * (double{c[1].y} - c[0].y),
                      0);
        }
    }
}

TEST(FrontScenes, FarIsNearMovedAndNothingElse) {
    const FrontScene near = find_front_scene("near")->make(3), far = find_front_scene("far")->make(3);
    ASSERT_EQ(near.vertices.size(), far.vertices.size());
    for (std::size_t n = 0; n < near.vertices.size(); ++n) {
        EXPECT_EQ(double{near.vertices[n].x} + 65536, far.vertices[n].x);
        EXPECT_EQ(double{near.vertices[n].y} + 65536, far.vertices[n].y);
        EXPECT_EQ(near.vertices[n].u, far.vertices[n].u);
    }
}

TEST(Bounds, ThePublishedFiguresOfFixedPoint) {
    const std::array<Vertex, 3> wide{Vertex{.x = 0, .y = 0}, Vertex{.x = 1919, .y = 0, .u = 1024},
                                     Vertex{.x = 0, .y = 100, .v = 100}};
    EXPECT_NEAR(bounds::fixed_16_16(wide), .0147, .0001);
}

TEST(Bounds, AffineForPerspectiveIsReachedAndNeverExceeded) {
    EXPECT_NEAR(bounds::affine_for_perspective(1, 4), 1.0 / 3, 1e-15);
    EXPECT_EQ(bounds::affine_for_perspective(1, 1), 0);
    std::mt19937_64 engine(5);
    const auto chance = [&] { return static_cast<double>(engine() >> 11U) * 0x1p-53; };
    double closest = 0;
    for (int n = 0; n < 200'000; ++n) {
        std::array<double, 3> share{}, q{}, u{};
        double all = 0, weight = 0, affine = 0, right = 0;
        for (std::size_t k = 0; k < 3; ++k) all += share[k] = chance(), q[k] = .25 + .75 * chance(), u[k] = chance();
        for (std::size_t k = 0; k < 3; ++k) share[k] /= all, weight += share[k] * q[k];
        for (std::size_t k = 0; k < 3; ++k) affine += share[k] * u[k], right += share[k] * q[k] / weight * u[k];
        const auto [nearest, farthest] = std::minmax_element(q.begin(), q.end());
        const auto [low, high] = std::minmax_element(u.begin(), u.end());
        const double bound = bounds::affine_for_perspective(*high - *low, *farthest / *nearest);
        EXPECT_LE(std::abs(affine - right), bound * (1 + 1e-12));
        if (bound > .01) closest = std::max(closest, std::abs(affine - right) / bound);
    }
    EXPECT_GT(closest, .9);
}

TEST(Bounds, NothingIsPromisedWhereTheSignOfTheAreaIsInDoubt) {
    const std::array<Vertex, 3> line{Vertex{.x = 65536, .y = 65536}, Vertex{.x = 65600, .y = 65600, .u = 256},
                                     Vertex{.x = 65632, .y = 65632.0078125F, .v = 256}};
    EXPECT_TRUE(std::isfinite(bounds::direct_float(line)));
    const std::array<Vertex, 3> hair{Vertex{.x = 0, .y = 0}, Vertex{.x = 3, .y = 1.0000001F, .u = 256},
                                     Vertex{.x = 6, .y = 2, .v = 256}};
    EXPECT_TRUE(std::isinf(bounds::direct_float(hair)));
    EXPECT_TRUE(std::isfinite(bounds::direct_double(hair)));
}

}  // namespace
}  // namespace texelscope
