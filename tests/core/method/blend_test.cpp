#include "core/method/blend.h"

#include <gtest/gtest.h>

#include "tests/core/method/cases.h"

namespace texelscope::blend_test {
namespace {

TEST(Blend, HalvesAreCutOffBeforeTheyAreAdded) {
    EXPECT_EQ(half_of_each(255, 255), 254);
    EXPECT_EQ(half_of_each(255, 0), 127);
    EXPECT_EQ(half_of_each(1, 1), 0);
    for (int a = 0; a < 256; ++a) {
        for (int b = 0; b < 256; ++b) {
            const int half = half_of_each(static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b));
            EXPECT_EQ(half, a / 2 + b / 2);
            EXPECT_LE(a + b - 2 * half, 2);
        }
    }
}

TEST(Blend, AnOpaqueSampleReplacesWhatWasThere) {
    EXPECT_EQ(blended({1, 2, 3}, {40, 50, 60}, false), (Rgb{40, 50, 60}));
    EXPECT_EQ(blended({1, 2, 3}, {40, 50, 60}, true), (Rgb{20, 26, 31}));
}

/// Red, then half green, then half blue over one pixel: in another order it would be another colour.
TEST(Blend, FollowsTheOrderOfDrawing) {
    Scene scene;
    scene.framebuffer = {.width = 4, .height = 4};
    const Rgb colours[] = {{200, 0, 0}, {0, 200, 0}, {0, 0, 200}};
    for (const Rgb& colour : colours) {
        auto texture = std::make_shared<Texture>();
        texture->texels = Image(4, 4, colour);
        Polygon polygon;
        const float corners[][2] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
        for (const auto& [x, y] : corners) polygon.vertices.push_back({.x = x, .y = y, .u = x, .v = y});
        polygon.texture = static_cast<int>(scene.textures.size());
        polygon.half = polygon.texture > 0;
        scene.textures.push_back(texture);
        scene.polygons.push_back(polygon);
    }
    for (const Method* method : methods()) {
        const Image picture = render(Drawing(scene, laws::settings_of(*method, NumberFormat::f64, 0)));
        EXPECT_EQ(picture.at(2, 2), (Rgb{50, 50, 100})) << method->id;
    }
}

}  // namespace
}  // namespace texelscope::blend_test
