#include "core/measure/race.h"

#include <gtest/gtest.h>

#include "tests/core/method/cases.h"

namespace texelscope {
namespace {

/// Timings are no matter of pass and fail; what was drawn is.
TEST(Race, ALapCountsWhatTheMethodDraws) {
    Scene scene;
    scene.framebuffer = {.width = 64, .height = 48};
    scene.textures = {laws::texture_of(16, 16, Wrap::repeat)};
    scene.random = RandomTriangles{.count = 20, .size = 30, .seed = 3};
    place_random(scene);
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

}  // namespace
}  // namespace texelscope
