// The step tree is one list at each level: the same forward as backward, and any of it reached directly.
#include "core/method/steps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cases.h"
#include "tests/core/method/cases.h"

namespace texelscope::steps_test {
namespace {

using laws::Case;

constexpr std::array kAllLevels{Level::triangle, Level::stage, Level::scanline, Level::pixel, Level::expression};
constexpr std::size_t kMostSteps = 200000;

std::vector<Path> forward(Steps& steps, Level level) {
    std::vector<Path> paths;
    for (auto path = steps.first(level); path && paths.size() < kMostSteps; path = steps.next(*path, level))
        paths.push_back(*path);
    return paths;
}

std::vector<Path> backward(Steps& steps, Level level) {
    std::vector<Path> paths;
    for (auto path = steps.last(level); path && paths.size() < kMostSteps; path = steps.previous(*path, level))
        paths.push_back(*path);
    return paths;
}

std::string text_of(const std::optional<Path>& path) { return path ? path->text() : "none"; }

/// One scene for each case, with fewer scenes where numbers are slow.
void for_every_case(const std::function<void(const Drawing&)>& check) {
    for (const Case& c : laws::every_case()) {
        const unsigned seeds = c.settings.format == NumberFormat::f64 ? cases(14, 7) : cases(2, 1);
        for (unsigned seed = 1; seed <= seeds; ++seed) {
            SCOPED_TRACE(c.text() + ", random_scene(" + std::to_string(seed) + ")");
            const Scene scene = laws::random_scene(seed);
            check(Drawing(scene, c.settings));
            if (testing::Test::HasFailure()) return;
        }
    }
}

TEST(Steps, BackwardIsForwardReversedAtEveryLevel) {
    for_every_case([](const Drawing& drawing) {
        Steps steps(drawing);
        for (const Level level : kAllLevels) {
            const std::vector<Path> there = forward(steps, level);
            std::vector<Path> back = backward(steps, level);
            std::reverse(back.begin(), back.end());
            ASSERT_LT(there.size(), kMostSteps);
            ASSERT_EQ(there.size(), back.size()) << id_of(level);
            for (std::size_t n = 0; n < there.size(); ++n) ASSERT_EQ(there[n].text(), back[n].text()) << id_of(level);
        }
    });
}

TEST(Steps, NoStepComesTwice) {
    for_every_case([](const Drawing& drawing) {
        Steps steps(drawing);
        for (const Level level : kAllLevels) {
            std::vector<std::string> texts;
            for (const Path& path : forward(steps, level)) texts.push_back(path.text());
            std::sort(texts.begin(), texts.end());
            ASSERT_EQ(std::adjacent_find(texts.begin(), texts.end()), texts.end()) << id_of(level);
        }
    });
}

TEST(Steps, AStepIsItselfAtItsLevelAndLiesInItsCoarserOnes) {
    for_every_case([](const Drawing& drawing) {
        Steps steps(drawing);
        for (const Level level : kAllLevels) {
            std::vector<Path> coarser;
            if (level != Level::triangle) coarser = forward(steps, static_cast<Level>(static_cast<int>(level) - 1));
            std::size_t at = 0;
            for (const Path& path : forward(steps, level)) {
                ASSERT_EQ(steps.at_level(path, level).text(), path.text());
                ASSERT_EQ(text_of(steps.nearest(path, level)), path.text());
                if (coarser.empty() || level == Level::expression) continue;
                const std::string above = steps.at_level(path, static_cast<Level>(static_cast<int>(level) - 1)).text();
                while (at < coarser.size() && coarser[at].text() != above) ++at;
                ASSERT_LT(at, coarser.size()) << path.text() << " lies in " << above << ", out of order";
            }
        }
    });
}

bool same_unit(const Visit& a, const Visit& b) {
    const auto same_named = [&](const Named& m, const Named& n) {
        return m.operation == n.operation && m.name.text() == n.name.text() && m.line == n.line;
    };
    return a.path == b.path && a.found && b.found && a.unit().expressions == b.unit().expressions &&
           a.unit().loop == b.unit().loop && a.unit().fate == b.unit().fate &&
           a.tape.operations.size() == b.tape.operations.size() &&
           std::equal(a.tape.names.begin(), a.tape.names.end(), b.tape.names.begin(), b.tape.names.end(), same_named);
}

TEST(Steps, AUnitReachedDirectlyIsTheOneReachedByWalking) {
    for_every_case([](const Drawing& drawing) {
        Steps walking(drawing);
        int n = 0;
        for (auto path = walking.first(Level::pixel); path; path = walking.next(*path, Level::pixel)) {
            const Visit walked = walking.at(*path);
            if (n++ % 5 != 0) continue;
            const std::optional<Path> parsed = parse_path(path->text());
            ASSERT_TRUE(parsed) << path->text();
            Steps fresh(drawing);
            ASSERT_TRUE(same_unit(walked, fresh.at(*parsed))) << path->text();
        }
    });
}

TEST(Steps, NearestGivesAStepThatExists) {
    for_every_case([](const Drawing& drawing) {
        Steps steps(drawing);
        laws::Dice dice(5);
        std::vector<std::vector<std::string>> lists;
        for (const Level level : kAllLevels) {
            lists.emplace_back();
            for (const Path& path : forward(steps, level)) lists.back().push_back(path.text());
        }
        for (int n = 0; n < 60; ++n) {
            Path path{{{'t', dice.whole(-1, 6)}}};
            if (dice.often(0.9)) path = path.child('s', dice.whole(-1, 9));
            if (dice.often(0.7)) path = path.child(dice.often(0.9) ? 'y' : 'v', dice.whole(-20, 30));
            if (dice.often(0.7)) path = path.child(dice.often(0.9) ? 'x' : 'u', dice.whole(-20, 30));
            if (dice.often(0.4)) path = path.child('e', dice.whole(-1, 40));
            for (std::size_t level = 0; level < lists.size(); ++level) {
                const std::string found = text_of(steps.nearest(path, kAllLevels[level]));
                ASSERT_NE(std::find(lists[level].begin(), lists[level].end(), found), lists[level].end())
                    << id_of(kAllLevels[level]) << ": nearest to " << path.text() << " is " << found;
            }
        }
    });
}

/// Whatever a method's loops run over, a sample that it puts is found again by its pixel.
TEST(Steps, ThePixelOfASampleLeadsToAStepThatWritesIt) {
    for_every_case([](const Drawing& drawing) {
        Steps steps(drawing);
        for (const auto& [shape, s] : laws::all_samples(drawing, {drawing.scene().framebuffer.rect(), 1})) {
            if (s.fate != Fate::written || s.note != Note::none) continue;
            const std::optional<Path> path = steps.at_pixel(shape, s.x, s.y);
            ASSERT_TRUE(path) << s.x << ", " << s.y;
            const Visit& found = steps.at(*path);
            ASSERT_TRUE(found.found) << path->text();
            ASSERT_EQ(found.unit().fate, Fate::written) << path->text();
        }
    });
}

TEST(Steps, AnEmptySceneHasNone) {
    const Scene scene;
    for (const Method* method : methods()) {
        const Drawing drawing(scene, laws::settings_of(*method, NumberFormat::f64, 0));
        Steps steps(drawing);
        for (const Level level : kAllLevels) {
            EXPECT_FALSE(steps.first(level));
            EXPECT_FALSE(steps.last(level));
            EXPECT_FALSE(steps.nearest(Path{{{'t', 3}}}, level));
        }
    }
}

}  // namespace
}  // namespace texelscope::steps_test
