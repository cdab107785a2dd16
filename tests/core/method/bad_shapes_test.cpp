// Shapes that cannot be drawn, or hardly: none crashes or hangs, and each says what became of it.
#include <gtest/gtest.h>

#include <limits>

#include "core/method/steps.h"
#include "tests/cases.h"
#include "tests/core/method/cases.h"

namespace texelscope::bad_shapes_test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Vertex at(float x, float y, float u, float v) {
    Vertex vertex;
    vertex.x = x, vertex.y = y, vertex.u = u, vertex.v = v;
    return vertex;
}

Vertex at(float x, float y) { return at(x, y, x, y); }

Scene scene_of(std::vector<Vertex> corners) {
    Scene scene;
    scene.framebuffer = {.width = 16, .height = 12};
    scene.textures = {laws::texture_of(8, 8, Wrap::repeat)};
    Polygon polygon;
    polygon.vertices = std::move(corners);
    scene.polygons = {polygon};
    return scene;
}

/// Draws, samples and walks all of a scene at a coarse level; returns the fate of its first shape.
Fate drawn(const Scene& scene, const DrawSettings& settings) {
    const Drawing drawing(scene, settings);
    EXPECT_EQ(render(drawing).width(), scene.framebuffer.width);
    EXPECT_LT(laws::all_samples(drawing, {scene.framebuffer.rect(), 1}).size(), 20000U);
    Steps steps(drawing);
    int count = 0;
    for (auto path = steps.first(Level::scanline); path && count < 5000; path = steps.next(*path, Level::scanline))
        ++count;
    EXPECT_LT(count, 5000);
    const auto last = steps.last(Level::expression);
    EXPECT_TRUE(last && visit(drawing, *last).found);
    return visit(drawing, Path{{{'t', 0}}}).shape_fate;
}

void for_every_case(const std::function<void(const laws::Case&)>& check) {
    for (const laws::Case& c : laws::every_case()) {
        SCOPED_TRACE(c.text());
        check(c);
    }
}

TEST(BadShapes, AlignedCornersHaveNoArea) {
    for_every_case([](const laws::Case& c) {
        EXPECT_EQ(drawn(scene_of({at(1, 1), at(5, 5), at(9, 9)}), c.settings), Fate::zero_area);
        EXPECT_EQ(drawn(scene_of({at(1, 1), at(1, 1), at(1, 1)}), c.settings), Fate::zero_area);
        EXPECT_EQ(drawn(scene_of({at(1, 1), at(9, 4), at(1, 1)}), c.settings), Fate::zero_area);
        EXPECT_EQ(drawn(scene_of({at(1, 4), at(9, 4), at(5, 4)}), c.settings), Fate::zero_area);
    });
}

TEST(BadShapes, NumbersThatAreNotFiniteAreRefused) {
    for_every_case([](const laws::Case& c) {
        for (const float bad : {kNan, kInfinity, -kInfinity}) {
            for (float Vertex::*member : {&Vertex::x, &Vertex::y, &Vertex::z, &Vertex::w, &Vertex::u, &Vertex::v}) {
                Scene scene = scene_of({at(1, 1), at(9, 2), at(3, 8)});
                scene.polygons[0].vertices[1].*member = bad;
                EXPECT_EQ(drawn(scene, c.settings), Fate::not_finite);
            }
        }
        Scene scene = scene_of({at(1, 1), at(9, 2), at(3, 8)});
        scene.polygons[0].light = kNan;
        EXPECT_EQ(drawn(scene, c.settings), Fate::not_finite);
    });
}

TEST(BadShapes, CornersAtOrBehindTheEyeAreRefused) {
    for_every_case([](const laws::Case& c) {
        for (const float w : {0.0F, -0.0F, -1.0F, -3e38F}) {
            Scene scene = scene_of({at(1, 1), at(9, 2), at(3, 8)});
            scene.polygons[0].vertices[2].w = w;
            EXPECT_EQ(drawn(scene, c.settings), Fate::behind_eye);
        }
    });
}

TEST(BadShapes, BackFacesAreCulledOnlyWhereAskedFor) {
    for_every_case([](const laws::Case& c) {
        Scene scene = scene_of({at(1, 1), at(3, 8), at(9, 2)});
        EXPECT_EQ(drawn(scene, c.settings), Fate::written);
        scene.cull = Cull::back;
        EXPECT_EQ(drawn(scene, c.settings), Fate::culled);
        std::swap(scene.polygons[0].vertices[1], scene.polygons[0].vertices[2]);
        EXPECT_EQ(drawn(scene, c.settings), Fate::written);
    });
}

TEST(BadShapes, OffScreenNothingIsDrawn) {
    for_every_case([](const laws::Case& c) {
        if (c.settings.method->may_stray(c.settings.quirks)) return;
        for (const Vertex& by : {at(40, 0), at(-40, 0), at(0, 40), at(0, -40), at(1e6F, 1e6F)}) {
            const Scene scene = scene_of({at(1 + by.x, 1 + by.y), at(9 + by.x, 2 + by.y), at(3 + by.x, 8 + by.y)});
            EXPECT_EQ(drawn(scene, c.settings), Fate::off_screen) << by.x << ", " << by.y;
            EXPECT_EQ(render(Drawing(scene, c.settings)), Image(16, 12));
        }
    });
}

TEST(BadShapes, HugeCoordinatesEndInBoundedTime) {
    for_every_case([](const laws::Case& c) {
        for (const float big : {1e9F, 1e18F, 1e30F, 3e38F}) {
            const std::vector<std::vector<Vertex>> shapes{{at(-big, -big), at(big, -big, 9, 0), at(0, big, 0, 9)},
                                                          {at(0, 0), at(big, 1, big, 0), at(1, big, 0, big)},
                                                          {at(-big, 3), at(big, 3.5F, 5, 0), at(big, 4)},
                                                          {at(4, -big), at(4.5F, big), at(5, -big)},
                                                          {at(1, 1, -big, big), at(9, 2, big, 0), at(3, 8)},
                                                          {at(1, 1), at(2, big / 2), at(3, big)},
                                                          {at(big, big), at(big, -big), at(-big, big), at(-big, -big)}};
            for (const auto& shape : shapes) {
                const Fate fate = drawn(scene_of(shape), c.settings);
                EXPECT_TRUE(fate == Fate::written || fate == Fate::off_screen || fate == Fate::zero_area ||
                            fate == Fate::undefined || fate == Fate::too_large)
                    << text_of(fate);
            }
        }
    });
}

TEST(BadShapes, PolygonsThatAreNotConvexEndInBoundedTime) {
    for_every_case([](const laws::Case& c) {
        EXPECT_EQ(drawn(scene_of({at(0, 0), at(9, 0), at(1, 1), at(0, 9)}), c.settings), Fate::written);
        EXPECT_EQ(drawn(scene_of({at(8, 0), at(12, 11), at(1, 4), at(15, 4), at(3, 11)}), c.settings), Fate::written);
        (void)drawn(scene_of({at(0, 0), at(9, 9), at(9, 0), at(0, 9)}), c.settings);
        for (unsigned seed = 1; seed <= cases(20, 5); ++seed) {
            laws::Dice dice(seed);
            std::vector<Vertex> corners;
            for (int n = 0; n < 9; ++n)
                corners.push_back(
                    at(dice.within(-4, 20), dice.within(-4, 16), dice.within(-9, 20), dice.within(-9, 20)));
            (void)drawn(scene_of(corners), c.settings);
        }
    });
}

TEST(BadShapes, RepeatedCornersDrawWhatTheShapeDrawsWithoutThem) {
    for (const Method* method : methods()) {
        if (method->triangles) continue;
        const DrawSettings settings = laws::settings_of(*method, NumberFormat::exact, 0);
        const std::vector<Vertex> ring{at(1, 1), at(9, 2, 9, 0), at(12, 8, 9, 9), at(3, 9, 0, 9)};
        const Image picture = render(Drawing(scene_of(ring), settings));
        for (std::size_t n = 0; n < ring.size(); ++n) {
            std::vector<Vertex> repeated = ring;
            repeated.insert(repeated.begin() + static_cast<std::ptrdiff_t>(n), 2, ring[n]);
            EXPECT_EQ(render(Drawing(scene_of(repeated), settings)), picture) << method->id << ", corner " << n;
        }
    }
}

TEST(BadShapes, AShapeOfOnePixelIsThatPixel) {
    for (const laws::Case& c : laws::every_case()) {
        if (!c.corrected()) continue;
        const Scene scene = scene_of({at(3.25F, 4.25F), at(3.75F, 4.25F), at(3.5F, 4.75F)});
        const auto samples = laws::all_samples(Drawing(scene, c.settings), {scene.framebuffer.rect(), 1});
        int written = 0;
        for (const auto& [shape, s] : samples) written += s.fate == Fate::written && s.x == 3 && s.y == 4;
        EXPECT_EQ(written, 1) << c.text();
    }
}

}  // namespace
}  // namespace texelscope::bad_shapes_test
