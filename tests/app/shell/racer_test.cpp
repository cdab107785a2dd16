#include "app/shell/racer.h"

#include <gtest/gtest.h>

#include "app/platform/scripted_input.h"
#include "app/shell/headless.h"
#include "core/measure/bill.h"
#include "tests/app/state/random_fixture.h"

namespace texelscope {
namespace {

/// Goes on by a quarter of a slice whenever it is read, so that a slice ends after a few shapes.
struct SteadyClock {
    std::shared_ptr<double> time = std::make_shared<double>(0);
    double operator()() const { return *time += Racer::kSlice / 4; }
};

TEST(Racer, RunsEveryMethodInTurnAndThenStops) {
    Store store{opened(random_document(), {})};
    const SteadyClock clock;
    Racer racer(clock);
    EXPECT_FALSE(racer.advance(store.state(), store.derived().scene())) << "nobody asked for it";
    store.dispatch(action::StartRace{true});
    std::vector<const Method*> order;
    for (int n = 0; n < 10'000 && store.state().race.running; ++n) {
        const double before = *clock.time;
        if (const auto lap = racer.advance(store.state(), store.derived().scene())) {
            order.push_back(lap->lap.method);
            EXPECT_EQ(lap->lap.triangles, 12);
            store.dispatch(*lap);
        }
        EXPECT_LT(*clock.time - before, 2 * Racer::kSlice) << "the window waits";
    }
    EXPECT_EQ(order, racers());
    EXPECT_EQ(store.state().race.laps.size(), order.size());
    EXPECT_FALSE(racer.advance(store.state(), store.derived().scene()));
}

TEST(Racer, ALapOfASceneThatIsGoneIsNotFinished) {
    Store store{opened(random_document(), {})};
    Racer racer{SteadyClock{}};
    store.dispatch(action::StartRace{true});
    EXPECT_FALSE(racer.advance(store.state(), store.derived().scene()));
    store.dispatch(action::SetRandom{{3, 20, 1}});
    EXPECT_FALSE(racer.advance(store.state(), store.derived().scene()));
    store.dispatch(action::StartRace{true});
    for (int n = 0; n < 1000 && store.state().race.laps.empty(); ++n) {
        if (const auto lap = racer.advance(store.state(), store.derived().scene())) store.dispatch(*lap);
    }
    ASSERT_FALSE(store.state().race.laps.empty());
    EXPECT_EQ(store.state().race.laps.front().triangles, 3);
}

TEST(Racer, TheButtonIsReachedByKeysAndTheWindowGoesToSleepAfterwards) {
    const auto found = state_of("17", {});
    ASSERT_TRUE(found) << found.error().text();
    auto started = Headless::start(*found, {1280, 720});
    ASSERT_TRUE(started) << started.error().text();
    Headless& app = **started;
    app.store().dispatch(action::SetRandom{{2, 8, 1}});  // little to draw
    app.settle();
    const Image idle = app.picture();
    app.settle();
    EXPECT_EQ(app.picture(), idle) << "nothing runs that nobody started";
    EXPECT_TRUE(app.state().race.laps.empty());
    for (int n = 0; n < 200 && app.shell().memory().focus != ui::id_of("race/run"); ++n) {
        app.input = press_key(app.input, {ui::Key::tab});
        app.frame();
    }
    ASSERT_EQ(app.shell().memory().focus, ui::id_of("race/run"));
    app.input = press_key(app.input, {ui::Key::enter});
    app.frame();
    EXPECT_TRUE(app.state().race.running);
    for (int n = 0; n < 10'000 && app.state().race.running; ++n) app.frame();
    EXPECT_EQ(app.state().race.laps.size(), racers().size());
}

}  // namespace
}  // namespace texelscope
