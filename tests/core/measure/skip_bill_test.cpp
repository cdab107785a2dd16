#include "core/measure/skip_bill.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/image/patterns.h"

namespace texelscope {
namespace {

[[nodiscard]] Scene wasteful(int waste, int count = 2000) {
    Scene scene;
    scene.framebuffer = {96, 72, 0, 0, {1, 2, 3}};
    scene.depth = Depth::less, scene.cull = Cull::back;
    Texture texture{.name = "uv", .texels = make_pattern(Pattern::uv, 32, 32, 1)};
    scene.textures.push_back(std::make_shared<const Texture>(std::move(texture)));
    scene.random = RandomTriangles{count, 8, 3};
    scene.random->waste = waste;
    place_random(scene);
    return scene;
}

TEST(SkipBill, WasteIsDroppedForEveryReasonAndThePictureStays) {
    const Scene scene = wasteful(90);
    const SkipCount all = count_skips(scene, kAllSkips);
    EXPECT_EQ(all.counters.triangles, 2000U);
    EXPECT_LT(all.counters.drawn, 600U) << "one in ten is seen, and some walls do not reach";
    for (const RasterSkip skip : {RasterSkip::off_screen, RasterSkip::no_sample, RasterSkip::zero_area,
                                  RasterSkip::back_face, RasterSkip::hidden, RasterSkip::equal_w})
        EXPECT_GT(all.counters.skipped[static_cast<std::size_t>(skip)], 20U) << static_cast<int>(skip);
    EXPECT_EQ(all.differs, 0U);
    for (const RasterSkipInfo& info : kRasterSkips) {
        const SkipCount count = count_skips(scene, without(info.skip));
        EXPECT_EQ(count.differs, 0U) << info.id;
        EXPECT_EQ(count.counters.skipped[static_cast<std::size_t>(info.skip)], 0U) << info.id;
    }
    const SkipCount none = count_skips(scene, 0);
    EXPECT_EQ(none.differs, 0U);
    EXPECT_GT(none.counters.drawn, all.counters.drawn + 1000);
}

TEST(SkipBill, MoreWasteMeansFewerDrawn) {
    const auto drawn = [](int waste) { return count_skips(wasteful(waste), kAllSkips).counters.drawn; };
    const std::uint64_t little = drawn(0), some = drawn(50), most = drawn(95);
    EXPECT_GT(little, some);
    EXPECT_GT(some, most);
}

TEST(SkipBill, EverySetOfSkipsIsTimedInTurn) {
    double now = 0;
    SkipRun run(wasteful(90, 100), 5, [&] { return now += 0.001; });
    int slices = 0;
    while (!run.advance(0.02)) {
        ASSERT_LT(++slices, 1000);
        EXPECT_LE(run.share(), 1);
    }
    EXPECT_GT(slices, 2) << "not all at once";
    ASSERT_EQ(run.times().size(), kRasterSkips.size() + 3) << "all, each left out, none, and as asked for";
    EXPECT_EQ(run.times().front().skips, kAllSkips);
    EXPECT_EQ(run.times().back().skips, 5U);
    for (const SkipTime& time : run.times()) EXPECT_NEAR(time.seconds, 0.001, 1e-9);
}

TEST(SkipBill, ASceneWithoutTrianglesIsNothing) {
    Scene scene = wasteful(90);
    scene.random.reset();
    place_random(scene);
    const SkipCount count = count_skips(scene, kAllSkips);
    EXPECT_EQ(count.counters.triangles, 0U);
    EXPECT_EQ(count.differs, 0U);
}

}  // namespace
}  // namespace texelscope
