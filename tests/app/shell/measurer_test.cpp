#include "app/shell/measurer.h"

#include <gtest/gtest.h>

#include "app/platform/scripted_input.h"
#include "app/shell/headless.h"
#include "app/state/front_key.h"
#include "tests/app/state/random_fixture.h"

namespace texelscope {
namespace {

/// Goes on by a tenth of a slice whenever it is read, so that a slice ends after a few steps.
struct TenthClock {
    std::shared_ptr<double> time = std::make_shared<double>(0);
    double operator()() const { return *time += Measurer::kSlice / 10; }
};

/// Until nothing runs any more. @return how many slices it took.
int run(Store& store, Measurer& measurer) {
    int slices = 0;
    while (store.state().measure.running && ++slices < 100'000)
        if (const auto found = measurer.advance(store.state(), store.derived().scene())) store.dispatch(*found);
    return slices;
}

TEST(Measurer, MeasuresTheFrontInSlicesAndStops) {
    Store store{opened(random_document(), {})};
    const TenthClock clock;
    Measurer measurer(clock);
    EXPECT_FALSE(measurer.advance(store.state(), store.derived().scene())) << "nobody asked for it";
    store.dispatch(action::StartMeasure{Measure::What::front, true});
    double share = 0, before = *clock.time;
    int slices = 0;
    while (store.state().measure.running && ++slices < 100'000) {
        EXPECT_TRUE(store.state().measure.front.empty()) << "points without times are none";
        const auto found = measurer.advance(store.state(), store.derived().scene());
        ASSERT_TRUE(found);
        EXPECT_LT(*clock.time - before, 2 * Measurer::kSlice) << "the window waits";
        EXPECT_GE(found->found.share, share);
        share = found->found.share, before = *clock.time;
        store.dispatch(*found);
    }
    EXPECT_GT(slices, 10);
    EXPECT_EQ(share, 1);
    ASSERT_EQ(store.state().measure.front.size(), rungs().size());
    for (const FrontPoint& point : store.state().measure.front) {
        EXPECT_EQ(point.scene, front_key(store.derived().scene(), store.state().work));
        EXPECT_GT(point.min_ns, 0) << point.rung;
    }
    EXPECT_FALSE(measurer.advance(store.state(), store.derived().scene()));
}

TEST(Measurer, AnotherSceneIsMeasuredAnewWhileItIsLive) {
    Store store{opened(random_document(), {})};
    Measurer measurer{TenthClock{}};
    store.dispatch(action::StartMeasure{Measure::What::front, true});
    run(store, measurer);
    ASSERT_FALSE(store.state().measure.front.empty());
    const Integer pixels = store.state().measure.front.front().pixels;
    store.dispatch(action::SetRandom{{12, 40, 9}});
    EXPECT_TRUE(store.state().measure.running);
    EXPECT_TRUE(store.state().measure.front.empty()) << "those were of another scene";
    run(store, measurer);
    ASSERT_FALSE(store.state().measure.front.empty());
    EXPECT_NE(store.state().measure.front.front().pixels, pixels);
    store.dispatch(action::Undo{});
    EXPECT_TRUE(store.state().measure.running) << "undo brings back the scene, not its times";
    store.dispatch(action::StartMeasure{Measure::What::front, false});
    store.dispatch(action::Redo{});
    EXPECT_FALSE(store.state().measure.running);
    EXPECT_FALSE(measurer.advance(store.state(), store.derived().scene()));
}

TEST(Measurer, TheSceneMayChangeInTheMiddle) {
    Store store{opened(random_document(), {})};
    Measurer measurer{TenthClock{}};
    store.dispatch(action::StartMeasure{Measure::What::front, true});
    for (int n = 0; n < 5; ++n)
        if (const auto found = measurer.advance(store.state(), store.derived().scene())) store.dispatch(*found);
    store.dispatch(action::SetRandom{{3, 20, 1}});
    run(store, measurer);
    ASSERT_FALSE(store.state().measure.front.empty());
    EXPECT_EQ(store.state().measure.front.front().triangles, 3);
}

TEST(Measurer, SkipsAreTimedAndAgainForAnotherSwitch) {
    Store store{opened(random_document(), {})};
    Measurer measurer{TenthClock{}};
    store.dispatch(action::StartMeasure{Measure::What::skips, true});
    run(store, measurer);
    EXPECT_EQ(store.state().measure.skips.size(), kRasterSkips.size() + 2);
    Look look = store.state().look;
    look.skips = 3;
    store.dispatch(action::SetLook{look});
    EXPECT_TRUE(store.state().measure.running);
    EXPECT_FALSE(store.state().measure.skips.empty()) << "what is known holds still";
    run(store, measurer);
    EXPECT_EQ(store.state().measure.skips.back().skips, 3U);
}

TEST(Measurer, EscapeStopsItAndAnotherDocumentForgetsIt) {
    Store store{opened(random_document(), {})};
    Measurer measurer{TenthClock{}};
    store.dispatch(action::StartMeasure{Measure::What::skips, true});
    store.dispatch(action::Escape{});
    EXPECT_FALSE(store.state().measure.running);
    store.dispatch(action::StartMeasure{Measure::What::skips, true});
    run(store, measurer);
    store.dispatch(action::Open{random_document()});
    EXPECT_TRUE(store.state().measure.skips.empty());
    EXPECT_FALSE(store.state().measure.live);
}

}  // namespace
}  // namespace texelscope
