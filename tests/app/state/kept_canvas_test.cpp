// The canvas as it is kept over a drag equals the one that is drawn anew, and costs no more than what changed.
#include "app/state/kept_canvas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/method/blend.h"
#include "tests/app/state/fixture.h"
#include "tests/core/method/cases.h"

namespace texelscope {
namespace {

/// Sample by sample, all shapes in their order.
Grid<CanvasCell> one_after_the_other(const Drawing& drawing, int current, const Window& window) {
    const auto cells_of = [&](int pixels) { return (pixels + window.stride - 1) / window.stride; };
    CanvasCell empty;
    empty.now = empty.later = drawing.scene().framebuffer.clear;
    Grid<CanvasCell> cells(cells_of(window.rect.width()), cells_of(window.rect.height()), empty);
    each_sample(drawing, 0, drawing.shape_count(), window, [&](int shape, const Sample& s) {
        CanvasCell& cell = cells.at((static_cast<int>(s.x) - window.rect.x0) / window.stride,
                                    (static_cast<int>(s.y) - window.rect.y0) / window.stride);
        if (shape == current) cell.will_be_visited = true, cell.fate = s.fate, cell.note = s.note;
        if (s.fate != Fate::written) return;
        cell.later = blended(cell.later, s.colour, drawing.is_half(shape)), cell.will_be_written = true;
        if (shape < current) cell.now = cell.later, cell.written = true;
    });
    return cells;
}

[[nodiscard]] auto fields_of(const CanvasCell& c) {
    return std::tuple(c.now, c.later, c.written, c.will_be_written, c.visited, c.will_be_visited, c.fate, c.note);
}
void expect_same(const Grid<CanvasCell>& is, const Grid<CanvasCell>& expected, const std::string& where) {
    ASSERT_EQ(is.width(), expected.width()) << where;
    ASSERT_EQ(is.height(), expected.height()) << where;
    for (int y = 0; y < is.height(); ++y)
        for (int x = 0; x < is.width(); ++x)
            ASSERT_TRUE(fields_of(is.at(x, y)) == fields_of(expected.at(x, y))) << where << ", cell " << x << ' ' << y;
}

[[nodiscard]] laws::Family any_family(laws::Dice& dice) {
    return static_cast<laws::Family>(dice.whole(0, laws::kFamilies - 1));
}
[[nodiscard]] Scene scene_of(laws::Dice& dice, unsigned seed) {
    Scene scene = laws::random_scene(seed);
    for (int n = dice.whole(0, 4); n > 0; --n) {
        Polygon more;
        more.vertices = laws::random_corners(dice, any_family(dice), scene.framebuffer.rect(), dice.whole(3, 5));
        scene.polygons.push_back(more);
    }
    if (dice.often(0.3)) scene.depth = Depth::less;
    if (dice.often(0.3)) scene = laws::with_half(scene, seed);
    return scene;
}

/// What a person does to a scene with the mouse, and now and then what files can hold.
void edit(laws::Dice& dice, Scene& scene) {
    for (int n = dice.whole(1, 2); n > 0; --n) {
        Polygon& polygon = scene.polygons[dice.whole(0, static_cast<int>(scene.polygons.size()) - 1)];
        Vertex& v = polygon.vertices[dice.whole(0, static_cast<int>(polygon.vertices.size()) - 1)];
        if (dice.often(0.7)) v.x += dice.within(-3, 3), v.y += dice.within(-3, 3);
        if (dice.often(0.2)) v.u += dice.within(-3, 3);
        if (dice.often(0.1)) v.x = dice.within(-40, 40);
        if (dice.often(0.05)) v.w = dice.within(-1, 3);
        if (dice.often(0.05)) v.y = std::isnan(v.y) ? 3 : NAN;
        if (dice.often(0.05)) polygon.light = dice.within(0, 2);
        if (dice.often(0.05)) polygon.half = !polygon.half;
        if (dice.often(0.05)) scene.framebuffer.clear.r ^= 64;
        if (dice.often(0.03)) polygon.vertices.push_back(v);
    }
}

TEST(KeptCanvas, OverRandomDragsEqualsDrawingAllOfIt) {
    for (const laws::Case& c : laws::every_case()) {
        for (unsigned seed = 0; seed < 4; ++seed) {
            laws::Dice dice(seed * 7919 + 13);
            auto scene = std::make_unique<Scene>(scene_of(dice, seed));
            auto drawing = std::make_unique<Drawing>(*scene, c.settings);
            const Window window{scene->framebuffer.rect(), dice.whole(1, 3)};
            int shape = dice.whole(-1, drawing->shape_count() - 1);
            KeptCanvas kept;
            for (int frame = 0; frame < 9; ++frame) {
                const std::string where =
                    c.text() + " seed " + std::to_string(seed) + " frame " + std::to_string(frame);
                const auto expected = one_after_the_other(*drawing, shape, window);
                expect_same(kept.before(*drawing, shape, window).cells, expected, where);
                kept.begin_step();
                expect_same(kept.step().cells, expected, where + ", step");
                each_sample(*drawing, 0, drawing->shape_count(), window, [&](int, const Sample& s) {
                    if (dice.often(0.1)) kept.step_in(s).visited = true;  // what the next frame has to take back
                });
                auto next = std::make_unique<Scene>(*scene);
                edit(dice, *next);
                auto next_drawing = std::make_unique<Drawing>(*next, c.settings);
                kept.change(*drawing, *next_drawing);
                drawing = std::move(next_drawing), scene = std::move(next);
                if (dice.often(0.2)) shape = dice.whole(-1, drawing->shape_count() - 1);
                shape = std::min(shape, drawing->shape_count() - 1);
            }
        }
    }
}

/// Many quads on 320 x 240 pixels, all of them over others.
[[nodiscard]] std::shared_ptr<const Document> crowded_document(Depth depth, bool half) {
    auto document = std::make_shared<Document>(*quad_document());
    laws::Dice dice(7);
    document->scene.framebuffer = {320, 240, 0, 0, {}};
    document->scene.depth = depth;
    document->scene.polygons.clear();
    for (int n = 0; n < 60; ++n) {
        Polygon polygon;
        const float x = dice.within(-20, 280), y = dice.within(-20, 200), w = dice.within(30, 90),
                    h = dice.within(30, 90), z = dice.within(0, 1);
        polygon.vertices = {
            {x, y, z, 1, 0, 0}, {x + w, y, z, 1, 16, 0}, {x + w, y + h, z, 1, 16, 16}, {x, y + h, z, 1, 0, 16}};
        polygon.half = half && n % 2 == 0;
        document->scene.polygons.push_back(polygon);
    }
    return document;
}

/// Pixels of the frame that a polygon's box meets.
[[nodiscard]] double box_of(const Scene& scene, int polygon) {
    float x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
    for (const Vertex& v : scene.polygons[static_cast<std::size_t>(polygon)].vertices)
        x0 = std::min(x0, v.x), x1 = std::max(x1, v.x), y0 = std::min(y0, v.y), y1 = std::max(y1, v.y);
    const auto within = [](float a, int high) { return std::clamp<double>(a, 0, high); };
    return (within(std::ceil(x1), scene.framebuffer.width) - within(std::floor(x0), scene.framebuffer.width)) *
           (within(std::ceil(y1), scene.framebuffer.height) - within(std::floor(y0), scene.framebuffer.height));
}

TEST(KeptCanvas, DraggingOneVertexDrawsAtMostTheTwoBoxesAgain) {
    for (const auto& [depth, half] : {std::pair(Depth::off, false), {Depth::less, false}, {Depth::off, true}}) {
        Store store(opened(crowded_document(depth, half), State{}));
        const Window all{store.derived().scene().framebuffer.rect(), 1};
        static_cast<void>(store.derived().canvas(all));
        laws::Dice dice(3);
        for (int n = 0; n < 200; ++n) {
            const Handle handle{dice.whole(0, 59), dice.whole(0, 3), false};
            const double old_box = box_of(store.derived().scene(), handle.polygon);
            const std::int64_t drawn = store.derived().cells_drawn();
            const float far = dice.often(0.5) ? 3.0F : 60.0F;
            const glm::vec2 at = position_of(store.derived().scene(), handle);
            store.dispatch(
                action::MoveVertex{handle, at + glm::vec2(dice.within(-far, far), dice.within(-far, far)), 1});
            static_cast<void>(store.derived().canvas(all));
            const double new_box = box_of(store.derived().scene(), handle.polygon);
            ASSERT_GT(store.derived().cells_drawn(), drawn);
            ASSERT_LE(static_cast<double>(store.derived().cells_drawn() - drawn), 1.2 * (old_box + new_box)) << n;
        }
    }
}

TEST(KeptCanvas, WhileNothingChangesNothingIsDrawn) {
    Store store(opened(crowded_document(Depth::off, false), State{}));
    const Window all{store.derived().scene().framebuffer.rect(), 1};
    static_cast<void>(store.derived().canvas(all));
    const std::int64_t drawn = store.derived().cells_drawn();
    EXPECT_EQ(drawn, 320 * 240);
    const std::uint64_t version = store.derived().canvas(all).version;
    for (int n = 0; n < 3; ++n) {
        static_cast<void>(store.derived().highlight({.kind = Selection::Kind::line, .line = 40}));
        EXPECT_EQ(store.derived().canvas(all).version, version);
    }
    EXPECT_EQ(store.derived().cells_drawn(), drawn);
    store.dispatch(action::Step{1});  // what stands before the shape stays
    EXPECT_NE(store.derived().canvas(all).version, version);
    EXPECT_EQ(store.derived().cells_drawn(), drawn);
}

}  // namespace
}  // namespace texelscope
