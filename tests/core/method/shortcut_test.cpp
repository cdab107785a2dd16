// What draws otherwise than it is shown draws the same: hard shapes, wrap modes, sizes, lights, places.
#include "core/method/shortcut.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/measure/families.h"
#include "core/measure/reference.h"
#include "core/method/blend.h"
#include "core/method/fast_picture.h"
#include "tests/core/method/cases.h"

namespace texelscope::shortcut_test {
namespace {

[[nodiscard]] DrawSettings settings_of(std::string_view id) {
    return laws::settings_of(*find_method(id), NumberFormat::f64, 0);
}
/// The samples of the steps, put together.
[[nodiscard]] Image stepped(const Scene& scene, const DrawSettings& settings) {
    const Drawing drawing(scene, settings);
    const Rect frame = scene.framebuffer.rect();
    Image picture(frame.width(), frame.height(), scene.framebuffer.clear);
    each_sample(drawing, 0, drawing.shape_count(), {frame, 1}, [&](int shape, const Sample& s) {
        if (s.fate != Fate::written) return;
        Rgb& pixel = picture.at(static_cast<int>(s.x) - frame.x0, static_cast<int>(s.y) - frame.y0);
        pixel = blended(pixel, s.colour, drawing.is_half(shape));
    });
    return picture;
}
[[nodiscard]] DrawSettings in_exact(std::string_view id) {
    return laws::settings_of(*find_method(id), NumberFormat::exact, 0);
}
[[nodiscard]] Image defined(const Scene& scene) { return stepped(scene, in_exact("barycentric")); }
/// By the method's own loop over each shape alone.
[[nodiscard]] Image one_by_one(const Scene& scene, std::string_view id) {
    Image picture(scene.framebuffer.width, scene.framebuffer.height, scene.framebuffer.clear);
    const Drawing drawing(scene, settings_of(id));
    for (int n = 0; n < drawing.shape_count(); ++n)
        if (drawing.refusal(n) == Fate::written)
            (void)drawing.settings().method->render(NumberFormat::exact, drawing.job(n), picture);
    return picture;
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
                ASSERT_EQ(one_by_one(scene, "exact"), expected) << where;
                ASSERT_EQ(one_by_one(scene, "fast"), expected) << where;
                for (const std::string_view id : {"exact", "fast", "barycentric"})
                    ASSERT_EQ(render(Drawing(scene, in_exact(id))), expected) << id << ' ' << where;
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
            EXPECT_EQ(one_by_one(scene, "exact"), expected);
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
        const Image expected = one_by_one(scene, "exact");
        EXPECT_EQ(render(Drawing(scene, settings_of("fast"))), expected);
        EXPECT_EQ(render(Drawing(scene, in_exact("barycentric"))), expected);
        EXPECT_EQ(one_by_one(scene, "fast"), expected);
    }
}

constexpr std::string_view kAffine[] = {"edge-equations", "edge-walk", "sections"};

TEST(FastPicture, StandsInForExactNumbersWithoutAQuirkAlone) {
    for (const laws::Case& c : laws::every_case()) {
        const std::string_view id = c.settings.method->id;
        const bool ideal = id == "exact" || id == "fast" || id == "barycentric" ||
                           std::find(std::begin(kAffine), std::end(kAffine), id) != std::end(kAffine);
        EXPECT_EQ(draws_the_same_as_fast(c.settings),
                  ideal && c.corrected() && c.settings.format == NumberFormat::exact)
            << c.text();
    }
}

TEST(FastPicture, OfHardShapesIsThatOfTheStepsOfAffineMethods) {
    for (const Family& family : families())
        for (const std::string_view id : kAffine) {
            const HardShape shape = in_mode(family.make(seed_of(12, family, 0)), {false, false});
            if (shape.vertices.size() > 60) continue;  // exact steps take their time
            const Scene scene = scene_of(shape, 0);
            ASSERT_EQ(render(Drawing(scene, in_exact(id))), stepped(scene, in_exact(id)))
                << id << ", " << family.name << ": " << text_of(shape.vertices);
        }
}

/// Scenes in which shapes that the rasterizer may draw lie among others: masks of odd sizes, quads, halves.
TEST(FastPicture, OfMixedScenesIsThatOfTheSteps) {
    for (unsigned seed = 1; seed <= 24; ++seed) {
        laws::Dice dice(seed);
        Scene scene = laws::random_scene(seed);
        scene.textures.front() = laws::texture_of(7, 9, Wrap::mask);
        if (seed % 2 == 0) scene = laws::with_half(scene, seed);
        for (const std::string_view id : {"barycentric", "edge-equations", "edge-walk", "sections"}) {
            ASSERT_EQ(render(Drawing(scene, in_exact(id))), stepped(scene, in_exact(id))) << id << ", seed " << seed;
        }
    }
}

}  // namespace
}  // namespace texelscope::shortcut_test
