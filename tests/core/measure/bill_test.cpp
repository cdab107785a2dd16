#include "core/measure/bill.h"

#include <gtest/gtest.h>

#include "core/method/shortcut.h"
#include "tests/core/method/cases.h"

namespace texelscope::bill_test {
namespace {

[[nodiscard]] Scene random_scene(int count, float size) {
    Scene scene;
    scene.framebuffer = {.width = 320, .height = 240};
    scene.textures = {laws::texture_of(16, 16, Wrap::repeat)};
    scene.random = RandomTriangles{.count = count, .size = size, .seed = 3};
    place_random(scene);
    return scene;
}
/// Three corners at three heights, all in the frame.
[[nodiscard]] Scene one_triangle() {
    Scene scene = random_scene(1, 40);
    scene.polygons[0].vertices = {
        {3.5F, 20.25F, 0, 1, 1, 12}, {11.25F, 1.75F, 0, 1, 5, 1}, {29.75F, 15.25F, 0, 1, 15, 15}};
    return scene;
}
[[nodiscard]] Bill bill(const Scene& scene, std::string_view id) { return bill_of(scene, *find_method(id)); }

/// By hand, from the listing. Set-up: Δ 5 − 2 ×; a plane 12 − 6 × 2 ÷, twice; a side 3 + 2 ×, three times. A sample
/// inside: X and Y 2 +; three sides and two planes, 2 + 2 × each.
TEST(Bill, EdgeEquationsAreWhatTheListingSays) {
    const Bill b = bill(one_triangle(), "edge-equations");
    EXPECT_EQ(b.set_up, (OperationCount{5 + 24 + 9, 2 + 12 + 6, 4}));
    EXPECT_EQ(b.in_rows, OperationCount{});
    Integer inside = 0, outside[3]{};
    Scene scene = one_triangle();
    const Drawing drawing(scene, {find_method("edge-equations"), NumberFormat::f64, 0, {}});
    each_sample(drawing, 0, 1, {scene.framebuffer.rect(), 1}, [&](int, const Sample& s) {
        if (s.fate == Fate::written)
            ++inside;
        else
            ++outside[static_cast<int>(s.fate) - static_cast<int>(Fate::outside_edge_a)];
    });
    ASSERT_GT(outside[0] * outside[1] * outside[2], 0) << "the test wants samples of every fate";
    EXPECT_EQ(b.pixels, inside);
    EXPECT_EQ(b.samples, inside + outside[0] + outside[1] + outside[2]);
    const OperationCount start{2, 0, 0}, affine{2, 2, 0};
    EXPECT_EQ(b.in_pixels, inside * (start + 5 * affine) + outside[0] * (start + affine) +
                               outside[1] * (start + 2 * affine) + outside[2] * (start + 3 * affine));
}

/// Set-up: area 5 − 2 ×; the cut 8 ± 3 × 1 ÷; three sides, each 4 − 3 ÷; three starts, each 5 + 3 ×; five first and
/// last rows. A row: two ends 2 −, dx, du, dv 3 − 2 ÷, to the first sample 4 + 2 ×, to the next row 6 +.
TEST(Bill, EdgeWalkIsWhatTheListingSays) {
    const Bill b = bill(one_triangle(), "edge-walk");
    EXPECT_EQ(b.set_up, (OperationCount{5 + 8 + 12 + 15 + 5, 2 + 3 + 9, 1 + 9}));
    EXPECT_GT(b.rows, 10);
    EXPECT_EQ(b.in_rows, b.rows * (OperationCount{2 + 3 + 4 + 6, 2, 2}));
    EXPECT_EQ(b.samples, b.pixels);
    EXPECT_EQ(b.in_pixels, b.pixels * (OperationCount{2, 0, 0}));
}

TEST(Bill, AllRacersWriteTheSamePixels) {
    const Scene scene = random_scene(40, 60);
    const Integer pixels = bill(scene, "edge-walk").pixels;
    EXPECT_GT(pixels, 1000);
    for (const Method* racer : racers()) {
        const Bill b = bill_of(scene, *racer);
        EXPECT_EQ(b.method, racer);
        EXPECT_EQ(b.pixels, pixels) << racer->id;
        EXPECT_EQ(b.counted, 40) << racer->id;
        EXPECT_GT(b.set_up.all(), 0) << racer->id;
        EXPECT_GT(b.in_pixels.all(), 0) << racer->id;
    }
    for (const Method* method : methods()) {
        const auto all = racers();
        if (std::find(all.begin(), all.end(), method) != all.end() || shortcut_of(*method) != nullptr) continue;
        EXPECT_NE(render(Drawing(scene, {method, NumberFormat::f64, 0, {}})),
                  render(Drawing(scene, {&default_method(), NumberFormat::f64, 0, {}})))
            << method->id << " draws the same: why does it not race?";
    }
}

TEST(Bill, SmallTrianglesPayForSetUpAndLargeOnesForPixels) {
    const Scene small = random_scene(50, 6), large = random_scene(50, 200);
    for (const Method* racer : racers()) {
        const double least = bill_of(large, *racer).set_up_share(), most = bill_of(small, *racer).set_up_share();
        EXPECT_LT(least, .1) << racer->id;
        EXPECT_GT(most, 3 * least) << racer->id;
    }
}

TEST(Bill, OfManyTrianglesSomeAreCountedAndStandForAll) {
    const Scene scene = random_scene(3000, 20);
    const Bill b = bill(scene, "edge-walk");
    EXPECT_EQ(b.shapes, 3000);
    EXPECT_LE(b.counted, kMostBilled);
    Integer pixels = 0;
    const Drawing drawing(scene, {find_method("edge-walk"), NumberFormat::f64, 0, {}});
    each_sample(drawing, 0, drawing.shape_count(), {scene.framebuffer.rect(), 1},
                [&](int, const Sample& s) { pixels += s.fate == Fate::written; });
    EXPECT_NEAR(b.scene_pixels() / static_cast<double>(pixels), 1, .1);
}

TEST(Bill, NothingDrawnCostsNothing) {
    Scene scene = random_scene(1, 20);
    scene.polygons.clear();
    const Bill b = bill(scene, "edge-walk");
    EXPECT_EQ(b.whole(), OperationCount{});
    EXPECT_EQ(b.set_up_share(), 0);
    EXPECT_EQ(b.scene_pixels(), 0);
}

}  // namespace
}  // namespace texelscope::bill_test
