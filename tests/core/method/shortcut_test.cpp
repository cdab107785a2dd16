// What draws otherwise than it is shown draws the same: hard shapes, wrap modes, sizes, lights, places.
#include "core/method/shortcut.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/measure/families.h"
#include "core/measure/reference.h"
#include "tests/core/method/cases.h"

namespace texelscope::shortcut_test {
namespace {

[[nodiscard]] DrawSettings settings_of(std::string_view id) {
    return laws::settings_of(*find_method(id), NumberFormat::f64, 0);
}
/// The steps of the definition, put together.
[[nodiscard]] Image defined(const Scene& scene) {
    const DrawSettings exact = laws::settings_of(*find_method("barycentric"), NumberFormat::exact, 0);
    return render(Drawing(scene, exact));
}

[[nodiscard]] Scene scene_of(const HardShape& shape, int n) {
    Scene scene;
    scene.framebuffer = {.width = shape.frame.width(),
                         .height = shape.frame.height(),
                         .origin_x = shape.frame.x0,
                         .origin_y = shape.frame.y0,
                         .clear = {1, 2, 3}};
    const auto wrap = static_cast<Wrap>(n % 3);
    scene.textures = {laws::texture_of(shape.texture_width, shape.texture_height, wrap, Pattern::uv),
                      laws::texture_of(19, 5, wrap)};
    for (std::size_t k = 0; k < shape.vertices.size(); k += 3) {
        Polygon polygon;
        polygon.vertices.assign(&shape.vertices[k], &shape.vertices[k] + 3);
        polygon.light = k % 2 == 0 ? 1.0F : 1.3F;
        polygon.texture = n % 2 == 0 && k % 4 == 1 ? 1 : 0;
        scene.polygons.push_back(polygon);
    }
    if (n % 4 == 3) scene.cull = Cull::back;
    return scene;
}

TEST(Shortcut, ThereIsOneForWhatDrawsOtherwiseThanItIsShown) {
    for (const Method* method : methods()) {
        const Shortcut* shortcut = shortcut_of(*method);
        const bool other = method->id == "exact" || method->id == "fast";
        ASSERT_EQ(shortcut != nullptr, other) << method->id;
        if (shortcut == nullptr) continue;
        const Method* shown = find_method(shortcut->steps_of);
        ASSERT_NE(shown, nullptr);
        EXPECT_EQ(method->listing, shown->listing);
        EXPECT_TRUE(method->quirks.empty());
        EXPECT_EQ(Drawing(Scene{}, settings_of(method->id)).settings().format, NumberFormat::exact);
    }
}

TEST(Shortcut, PicturesOfHardShapesAreThoseOfTheDefinition) {
    for (const Family& family : families())
        for (const StressMode mode : {StressMode{false, false}, StressMode{false, true}})
            for (int n = 0; n < 4; ++n) {
                const HardShape shape = in_mode(family.make(seed_of(11, family, n)), mode);
                if (shape.vertices.size() > 300) continue;  // the definition takes its time
                const Scene scene = scene_of(shape, n);
                const Image expected = defined(scene);
                const std::string where = std::string(family.name) + ": " + text_of(shape.vertices);
                ASSERT_EQ(render(Drawing(scene, settings_of("exact"))), expected) << where;
                ASSERT_EQ(render(Drawing(scene, settings_of("fast"))), expected) << where;
            }
}

TEST(Shortcut, IndicesBeyond64BitsEndWhereTheDefinitionsDo) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        Scene scene;
        scene.framebuffer = {.width = 24, .height = 16};
        scene.textures = {laws::texture_of(19, 8, wrap), laws::texture_of(16, 8, wrap)};
        for (const int texture : {0, 1}) {
            Polygon polygon;
            polygon.vertices = {{1, 1, 0, 1, -3e38F, 5}, {23, 2, 0, 2, 3e38F, 1e19F}, {4, 15, 0, 3, 1, -4e20F}};
            polygon.texture = texture;
            scene.polygons = {polygon};
            const Image expected = defined(scene);
            EXPECT_EQ(render(Drawing(scene, settings_of("exact"))), expected);
            EXPECT_EQ(render(Drawing(scene, settings_of("fast"))), expected);
        }
    }
}

/// Batches end where texture, light or kind changes, and later shapes lie on top.
TEST(Shortcut, ManyShapesAreDrawnInTheirOrder) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        laws::Dice dice(seed);
        Scene scene;
        scene.framebuffer = {.width = 60, .height = 44};
        scene.textures = {laws::texture_of(16, 8, Wrap::repeat), laws::texture_of(32, 16, Wrap::mask, Pattern::uv),
                          laws::texture_of(7, 9, Wrap::repeat)};
        for (int n = 0; n < 60; ++n) {
            Polygon polygon;
            polygon.vertices = laws::random_corners(dice, static_cast<laws::Family>(n % laws::kFamilies),
                                                    scene.framebuffer.rect(), 3 + n % 3);
            polygon.texture = n / 4 % 3;
            polygon.light = n % 8 < 5 ? 1.0F : .7F;
            scene.polygons.push_back(polygon);
        }
        const Image expected = render(Drawing(scene, settings_of("exact")));
        EXPECT_EQ(render(Drawing(scene, settings_of("fast"))), expected);
        Image one_by_one(60, 44, scene.framebuffer.clear);
        const Drawing drawing(scene, settings_of("fast"));
        for (int n = 0; n < drawing.shape_count(); ++n)
            (void)drawing.settings().method->render(NumberFormat::exact, drawing.job(n), one_by_one);
        EXPECT_EQ(one_by_one, expected);
    }
}

}  // namespace
}  // namespace texelscope::shortcut_test
