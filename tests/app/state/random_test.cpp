// Random triangles as a part of the state, the race over them, and the palette of their texture.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "app/state/link.h"
#include "tests/app/state/fixture.h"
#include "tests/app/state/random_fixture.h"

namespace texelscope {
namespace {

class RandomState : public testing::Test {
protected:
    [[nodiscard]] const Scene& scene() { return store.derived().scene(); }
    void set(int count, float size, std::uint32_t seed, int gesture = 0) {
        store.dispatch(action::SetRandom{{count, size, seed}, gesture});
    }
    Store store{opened(random_document(), {})};
};

TEST_F(RandomState, TheSceneGetsOtherTrianglesAndUndoBringsTheOldOnesBack) {
    const auto before = scene().polygons.front().vertices;
    set(30, 10, 9);
    EXPECT_EQ(scene().polygons.size(), 30U);
    EXPECT_NE(scene().polygons.front().vertices, before);
    store.dispatch(action::Undo{});
    EXPECT_EQ(scene().polygons.size(), 12U);
    EXPECT_EQ(scene().polygons.front().vertices, before);
    store.dispatch(action::Redo{});
    EXPECT_EQ(store.state().work.random, (RandomTriangles{30, 10, 9}));
}

TEST_F(RandomState, ADragIsOneEntryForUndo) {
    for (int n = 2; n < 9; ++n) set(n, 24, 5, 7);
    store.dispatch(action::Undo{});
    EXPECT_EQ(scene().polygons.size(), 12U);
    EXPECT_FALSE(store.can_undo());
}

TEST_F(RandomState, WhatIsAskedForStaysWithinItsLimits) {
    set(0, -3, 0);
    EXPECT_EQ(store.state().work.random, (RandomTriangles{1, kLeastTriangleSide, 0}));
    set(1 << 30, 1e9F, 4'000'000'000U);
    EXPECT_EQ(store.state().work.random, (RandomTriangles{kMostTriangles, kMostTriangleSide, 4'000'000'000U}));
    const auto before = store.state().work;
    set(10, std::nanf(""), 1);
    EXPECT_EQ(store.state().work, before);
}

TEST_F(RandomState, CornersThatWereMovedGoWithTheirTriangles) {
    store.dispatch(action::MoveVertex{{3, 1, false}, {10, 10}, 0});
    ASSERT_EQ(store.state().work.edits.size(), 1U);
    set(12, 24, 6);
    EXPECT_TRUE(store.state().work.edits.empty());
}

TEST_F(RandomState, TheCursorStaysOnAShapeThatIsThere) {
    store.dispatch(action::StepTo{*parse_path("t11")});
    set(4, 24, 5);
    EXPECT_EQ(store.derived().steps().nearest(store.state().cursor.step, store.state().cursor.level),
              store.state().cursor.step);
}

TEST_F(RandomState, ASceneWithoutRandomTrianglesSaysSo) {
    Store other{opened(quad_document(), {})};
    other.dispatch(action::SetRandom{{5, 5, 5}});
    EXPECT_FALSE(other.state().work.random);
    EXPECT_NE(other.state().message.text.find("no random triangles"), std::string::npos);
}

TEST_F(RandomState, TheStateAsALineHoldsThem) {
    set(77, 12.5F, 42);
    const auto link = parse_link(print_link(store.state()));
    ASSERT_TRUE(link) << link.error().text();
    EXPECT_EQ(link->work, store.state().work);
}

TEST_F(RandomState, ALineThatAsksForTooManyIsDamaged) {
    for (const RandomTriangles& bad : {RandomTriangles{kMostTriangles + 1, 5, 1}, RandomTriangles{0, 5, 1},
                                       RandomTriangles{5, 0, 1}, RandomTriangles{5, 2 * kMostTriangleSide, 1}}) {
        State state = store.state();
        state.work.random = bad;
        EXPECT_FALSE(parse_link(print_link(state))) << bad.count << ' ' << bad.size;
    }
}

/// A lap with a number that tells it from others.
[[nodiscard]] action::FinishLap lap_of(int n, bool last = false) {
    return {{.method = racers()[static_cast<std::size_t>(n)], .triangles = n, .pixels = 0, .seconds = 1, .set_up = 0},
            last};
}

TEST_F(RandomState, ARaceCollectsLapsUntilTheLast) {
    store.dispatch(lap_of(0));
    EXPECT_TRUE(store.state().race.laps.empty()) << "nobody asked for it";
    store.dispatch(action::StartRace{true});
    EXPECT_TRUE(store.state().race.running);
    store.dispatch(lap_of(0)), store.dispatch(lap_of(1, true));
    EXPECT_EQ(store.state().race.laps.size(), 2U);
    EXPECT_FALSE(store.state().race.running);
    store.dispatch(action::StartRace{true});
    EXPECT_TRUE(store.state().race.laps.empty()) << "a new race begins with nothing";
}

TEST_F(RandomState, TimingsAreDroppedWithWhatTheyWereTakenOf) {
    const auto raced = [&] {
        store.dispatch(action::StartRace{true});
        store.dispatch(lap_of(0));
    };
    for (const Action& change : std::vector<Action>{
             action::SetRandom{{13, 24, 5}}, action::SetFormat{NumberFormat::fx16_16},
             action::SetMode{{Overflow::wrap, false}}, action::MoveVertex{{0, 0, false}, {3, 3}, 0}, action::Undo{}}) {
        raced();
        store.dispatch(change);
        EXPECT_TRUE(store.state().race.laps.empty()) << change.index();
        EXPECT_FALSE(store.state().race.running) << change.index();
    }
    for (const Action& kept : std::vector<Action>{action::SetMethod{"sections"}, action::Step{1},
                                                  action::SetQuirk{0, true}, action::StepTo{*parse_path("t1")}}) {
        raced();
        store.dispatch(kept);
        EXPECT_EQ(store.state().race.laps.size(), 1U) << kept.index();
    }
}

TEST_F(RandomState, EscapeStopsARaceAndKeepsItsLaps) {
    store.dispatch(action::StartRace{true});
    store.dispatch(lap_of(0));
    store.dispatch(action::Escape{});
    EXPECT_FALSE(store.state().race.running);
    EXPECT_EQ(store.state().race.laps.size(), 1U);
}

TEST_F(RandomState, ExactNumbersDoNotRace) {
    store.dispatch(action::SetFormat{NumberFormat::exact});
    store.dispatch(action::StartRace{true});
    EXPECT_FALSE(store.state().race.running);
    EXPECT_FALSE(store.state().message.text.empty());
}

TEST_F(RandomState, EveryTexelAndEveryPixelHasItsColourCounted) {
    store.dispatch(action::StepTo{*parse_path("t0")});
    const PaletteUse& use = store.derived().palette_use();
    const Texture& texture = store.derived().texture();
    ASSERT_EQ(texture.palette.size(), 8U);
    EXPECT_EQ(std::accumulate(use.texels.begin(), use.texels.end(), Integer{0}), 16 * 16);
    std::array<Integer, 256> pixels{};
    Grid<int> last(64, 48, -1);  // the index that the last sample of a pixel reads
    each_sample(store.derived().drawing(), 0, 12, {scene().framebuffer.rect(), 1}, [&](int shape, const Sample& s) {
        if (s.fate != Fate::written) return;
        const bool own = store.derived().drawing().job(shape).texture == &texture;
        last.at(static_cast<int>(s.x), static_cast<int>(s.y)) = own ? texture.indices.at(s.column, s.row) : -1;
    });
    for (std::size_t n = 0; n < last.size(); ++n) {
        EXPECT_EQ(use.shown.data()[n], last.data()[n]) << n;
        if (last.data()[n] >= 0) ++pixels[static_cast<std::size_t>(last.data()[n])];
    }
    EXPECT_EQ(use.pixels, pixels);
    EXPECT_GT(std::accumulate(pixels.begin(), pixels.end(), Integer{0}), 100);
}

TEST_F(RandomState, AColourMeansItsTexelsAndItsPixels) {
    store.dispatch(action::StepTo{*parse_path("t0")});
    const PaletteUse use = store.derived().palette_use();
    Selection colour{.kind = Selection::Kind::colour, .colour = 3};
    const Highlight h = store.derived().highlight(colour);
    EXPECT_EQ(static_cast<Integer>(h.texels.size()), use.texels[3]);
    EXPECT_EQ(static_cast<Integer>(h.pixels.size()), use.pixels[3]);
    for (const glm::ivec2 t : h.texels) EXPECT_EQ(store.derived().texture().indices.at(t.x, t.y), 3);
    colour.colour = 200;
    EXPECT_TRUE(store.derived().highlight(colour).texels.empty());
}

TEST_F(RandomState, ATextureWithoutAPaletteHasNoUse) {
    store.dispatch(action::StepTo{*parse_path("t1")});
    const PaletteUse& use = store.derived().palette_use();
    EXPECT_EQ(std::accumulate(use.texels.begin(), use.texels.end(), Integer{0}), 0);
    EXPECT_EQ(std::accumulate(use.pixels.begin(), use.pixels.end(), Integer{0}), 0);
}

}  // namespace
}  // namespace texelscope
