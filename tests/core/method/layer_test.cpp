// What stands in a window once some shapes are drawn equals drawing them one after the other.
#include "core/method/layer.h"

#include <gtest/gtest.h>

#include "core/method/blend.h"
#include "tests/core/method/cases.h"

namespace texelscope::layer_test {
namespace {

Grid<LayerCell> one_after_the_other(const Drawing& drawing, int last, const Window& window) {
    const auto cells_of = [&](int pixels) { return (pixels + window.stride - 1) / window.stride; };
    Grid<LayerCell> cells(cells_of(window.rect.width()), cells_of(window.rect.height()));
    each_sample(drawing, 0, last, window, [&](int shape, const Sample& s) {
        if (s.fate != Fate::written) return;
        LayerCell& cell = cells.at((static_cast<int>(s.x) - window.rect.x0) / window.stride,
                                   (static_cast<int>(s.y) - window.rect.y0) / window.stride);
        const Rgb before = cell.shape < 0 ? drawing.scene().framebuffer.clear : cell.colour;
        cell = {blended(before, s.colour, drawing.is_half(shape)), shape};
    });
    return cells;
}

Window random_window(laws::Dice& dice, const Rect& frame) {
    Window window{frame, dice.whole(1, 3)};
    if (dice.often(0.5)) window.rect.x0 += dice.whole(0, 4), window.rect.y1 -= dice.whole(0, 3);
    return window;
}

TEST(Layer, EqualsDrawingEachShapeInItsOrder) {
    for (const laws::Case& c : laws::every_case()) {
        for (unsigned seed = 0; seed < 12; ++seed) {
            laws::Dice dice(seed);
            Scene scene = laws::random_scene(seed);
            if (dice.often(0.2)) scene.depth = Depth::less;
            if (dice.often(0.4)) scene = laws::with_half(scene, seed);
            const Drawing drawing(scene, c.settings);
            const Window window = random_window(dice, scene.framebuffer.rect());
            const Layer all = layer_of(drawing, drawing.shape_count(), window);
            for (int last = 0; last <= drawing.shape_count(); ++last) {
                const auto expected = one_after_the_other(drawing, last, window);
                EXPECT_EQ(layer_of(drawing, last, window).cells(), expected) << c.text() << " seed " << seed;
                EXPECT_EQ(layer_of(drawing, last, window, &all).cells(), expected) << c.text() << " seed " << seed;
            }
        }
    }
}

TEST(Layer, DrawingOnOverSomeShapesGivesAllOfThem) {
    for (const laws::Case& c : laws::every_case()) {
        for (unsigned seed = 0; seed < 6; ++seed) {
            laws::Dice dice(seed);
            const Scene scene = laws::with_half(laws::random_scene(seed), seed);
            const Drawing drawing(scene, c.settings);
            const Window window = random_window(dice, scene.framebuffer.rect());
            const int first = dice.whole(0, drawing.shape_count());
            Layer layer = layer_of(drawing, first, window);
            draw_over(drawing, first, drawing.shape_count(), layer);
            EXPECT_EQ(layer.cells(), one_after_the_other(drawing, drawing.shape_count(), window))
                << c.text() << " seed " << seed;
        }
    }
}

/// Larger than a square of cells, with shapes that cover several.
TEST(Layer, SquaresOfCellsMeetWithoutASeam) {
    for (const Method* method : methods()) {
        laws::Dice dice(5);
        Scene scene = laws::random_scene(0);
        scene.framebuffer = {.width = 150, .height = 131, .origin_x = -20, .origin_y = 7};
        scene.polygons.clear();
        for (int n = 0; n < 40; ++n) {
            Polygon polygon;
            polygon.vertices = laws::random_corners(dice, laws::Family::any, scene.framebuffer.rect(), 4);
            for (Vertex& v : polygon.vertices) v.x = v.x / 2, v.y = v.y / 2 + 30;
            scene.polygons.push_back(polygon);
        }
        const Drawing drawing(scene, laws::settings_of(*method, NumberFormat::f64, 0));
        for (const int stride : {1, 2, 3}) {
            const Window window{scene.framebuffer.rect(), stride};
            EXPECT_EQ(layer_of(drawing, drawing.shape_count(), window).cells(),
                      one_after_the_other(drawing, drawing.shape_count(), window))
                << method->id << " stride " << stride;
        }
    }
}

}  // namespace
}  // namespace texelscope::layer_test
