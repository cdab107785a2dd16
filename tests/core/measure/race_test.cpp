#include "core/measure/race.h"

#include <gtest/gtest.h>

#include "core/measure/bill.h"
#include "tests/core/method/cases.h"

namespace texelscope::race_test {
namespace {

[[nodiscard]] Scene scene_of(int count, float size) {
    Scene scene;
    scene.framebuffer = {.width = 64, .height = 48};
    scene.textures = {laws::texture_of(16, 16, Wrap::repeat)};
    scene.random = RandomTriangles{.count = count, .size = size, .seed = 3};
    place_random(scene);
    return scene;
}

/// A clock that says how often it was asked, in units of a second.
struct Ticks {
    std::shared_ptr<int> count = std::make_shared<int>(0);
    double operator()() const { return (*count)++; }
};

/// Timings are no matter of pass and fail; what was drawn is.
TEST(Race, ALapCountsWhatTheMethodDraws) {
    const Scene scene = scene_of(20, 30);
    for (const Method* method : methods()) {
        const DrawSettings settings = laws::settings_of(*method, NumberFormat::f64, 0);
        Integer written = 0;
        for (const auto& [shape, s] : laws::all_samples(Drawing(scene, settings), {scene.framebuffer.rect(), 1}))
            written += s.fate == Fate::written;
        const Lap result = lap(scene, settings, 0);
        EXPECT_EQ(result.method, method);
        EXPECT_EQ(result.triangles, 20);
        EXPECT_EQ(result.pixels, written) << method->id;
        EXPECT_GT(result.pixels, 500) << method->id;
        EXPECT_GE(result.set_up, 0);
        EXPECT_LE(result.set_up, result.seconds) << method->id;
    }
}

TEST(Race, ASliceEndsWithTheShapeThatOverrunsIt) {
    const Scene scene = scene_of(20, 30);
    const Ticks ticks;
    LapRun run(scene, laws::settings_of(default_method(), NumberFormat::f64, 0), 0, ticks);
    // A shape takes a tick: counting, drawing and set-up are 20 shapes each, and a slice of half a tick is one of them.
    for (int n = 1; n < 60; ++n) EXPECT_FALSE(run.advance(.5)) << n;
    EXPECT_TRUE(run.advance(.5));
    EXPECT_EQ(*ticks.count, 120) << "one look at the clock before each shape, and one behind it";
}

TEST(Race, PausesBetweenSlicesBelongToNoRound) {
    const Scene scene = scene_of(20, 30);
    const DrawSettings settings = laws::settings_of(default_method(), NumberFormat::f64, 0);
    const Ticks ticks;
    LapRun run(scene, settings, 0, ticks);
    while (!run.advance(2.5)) *ticks.count += 1000;
    EXPECT_EQ(run.lap().seconds, 20) << "a tick for each shape";
    EXPECT_EQ(run.lap().set_up, 20);
    EXPECT_EQ(run.lap().pixels, lap(scene, settings, 0).pixels);
}

TEST(Race, TheFastestRoundCounts) {
    const Scene scene = scene_of(4, 30);
    // Later rounds are faster: a shape's time falls from 8 ticks to 1.
    const auto time = std::make_shared<double>(0), tick = std::make_shared<double>(8);
    LapRun run(scene, laws::settings_of(default_method(), NumberFormat::f64, 0), 100, [=] {
        *tick = std::max(1.0, *tick * .9);
        return *time += *tick;
    });
    EXPECT_TRUE(run.advance(1e9));
    EXPECT_EQ(run.lap().seconds, 4);
    EXPECT_EQ(run.lap().set_up, 4);
}

TEST(Race, AnEmptySceneIsOverAtOnce) {
    Scene scene = scene_of(1, 30);
    scene.polygons.clear();
    const Lap result = lap(scene, laws::settings_of(default_method(), NumberFormat::f64, 0), 0);
    EXPECT_EQ(result.triangles, 0);
    EXPECT_EQ(result.pixels, 0);
}

}  // namespace
}  // namespace texelscope::race_test
