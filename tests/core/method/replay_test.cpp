// The trace changes nothing: steps, tiles and partial runs put together are the picture, for every method.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/method/blend.h"
#include "core/method/steps.h"
#include "tests/cases.h"
#include "tests/core/method/cases.h"

namespace texelscope::replay_test {
namespace {

using laws::Case;

/// Puts a colour where it belongs, over what the polygon lets through.
void put(const Drawing& drawing, int shape, Integer x, Integer y, const Rgb& colour, Image& picture) {
    const Framebuffer& framebuffer = drawing.scene().framebuffer;
    Rgb& pixel = picture.at(static_cast<int>(x) - framebuffer.origin_x, static_cast<int>(y) - framebuffer.origin_y);
    pixel = blended(pixel, colour, drawing.is_half(shape));
}

/// The value last named `name` on the way to the unit.
std::optional<Integer> named_integer(const Visit& visit, std::string_view name) {
    for (auto named = visit.tape.names.rbegin(); named != visit.tape.names.rend(); ++named) {
        if (named->name.text() != name) continue;
        const auto* value =
            std::get_if<Integer>(&visit.tape.operations[static_cast<std::size_t>(named->operation)].value);
        if (value != nullptr) return *value;
    }
    return std::nullopt;
}

bool names_a_colour(const Visit& visit) {
    return std::any_of(visit.unit().expressions.begin(), visit.unit().expressions.end(), [&](std::int32_t n) {
        return visit.tape.names[static_cast<std::size_t>(n)].name.text() == "b";
    });
}

/// The picture from the tapes of single steps, each visited as if it were the only one.
Image replayed(const Drawing& drawing) {
    const Framebuffer& framebuffer = drawing.scene().framebuffer;
    Image picture(framebuffer.width, framebuffer.height, framebuffer.clear);
    Steps steps(drawing);
    for (auto path = steps.first(Level::pixel); path; path = steps.next(*path, Level::pixel)) {
        const Visit v = visit(drawing, *path);
        EXPECT_TRUE(v.found) << path->text();
        if (v.unit().fate != Fate::written || !names_a_colour(v)) continue;
        const Integer x = named_integer(v, "x").value_or(-1), y = named_integer(v, "y").value_or(-1);
        if (!framebuffer.rect().contains(x, y)) continue;
        const auto channel = [&](const char* name) {
            return static_cast<std::uint8_t>(named_integer(v, name).value_or(0));
        };
        put(drawing, static_cast<int>(path->parts[0].index), x, y, {channel("r"), channel("g"), channel("b")}, picture);
    }
    return picture;
}

Image painted(const Drawing& drawing, const std::vector<std::pair<int, Sample>>& samples) {
    const Framebuffer& framebuffer = drawing.scene().framebuffer;
    Image picture(framebuffer.width, framebuffer.height, framebuffer.clear);
    for (const auto& [shape, s] : samples) {
        if (s.fate == Fate::written) put(drawing, shape, s.x, s.y, s.colour, picture);
    }
    return picture;
}

void for_every_case(unsigned seeds, const std::function<void(const Drawing&, const Case&)>& check) {
    for (const Case& c : laws::every_case()) {
        for (unsigned seed = 1; seed <= cases(seeds, (seeds + 1) / 2); ++seed) {
            SCOPED_TRACE(c.text() + ", random_scene(" + std::to_string(seed) + ")");
            const Scene scene = laws::random_scene(seed);
            check(Drawing(scene, c.settings), c);
            if (testing::Test::HasFailure()) return;
        }
    }
}

TEST(Replay, StepsAloneRebuildThePicture) {
    for_every_case(14, [](const Drawing& drawing, const Case&) { EXPECT_EQ(replayed(drawing), render(drawing)); });
}

TEST(Replay, SamplesOfTheWholeFrameAreThePicture) {
    for_every_case(60, [](const Drawing& drawing, const Case&) {
        EXPECT_EQ(painted(drawing, laws::all_samples(drawing, {drawing.scene().framebuffer.rect(), 1})),
                  render(drawing));
    });
}

TEST(Replay, HalfTransparentPolygonsBlendInTheirOrder) {
    for_every_case(2, [](const Drawing& drawing, const Case& c) {
        for (const Depth depth : {Depth::off, Depth::less}) {
            Scene scene = laws::with_half(drawing.scene(), static_cast<unsigned>(drawing.shape_count()));
            scene.depth = depth;
            const Drawing half(scene, c.settings);
            EXPECT_EQ(painted(half, laws::all_samples(half, {scene.framebuffer.rect(), 1})), render(half));
            if (depth == Depth::off) {
                EXPECT_EQ(replayed(half), render(half));
            }
        }
    });
}

TEST(Replay, SamplesOfTilesTogetherAreThoseOfTheFrame) {
    for_every_case(30, [](const Drawing& drawing, const Case&) {
        const Rect frame = drawing.scene().framebuffer.rect();
        const auto whole = laws::all_samples(drawing, {frame, 1});
        const Rect around{frame.x0 - 2, frame.y0 - 1, frame.x1 + 3, frame.y1 + 3};  // tiles may stick out
        for (int y = around.y0; y < around.y1; y += 4) {
            for (int x = around.x0; x < around.x1; x += 5) {
                const Rect tile{x, y, x + 5, y + 4};
                const auto part = laws::all_samples(drawing, {tile, 1});
                std::vector<std::pair<int, Sample>> expected;
                std::copy_if(whole.begin(), whole.end(), std::back_inserter(expected),
                             [&](const auto& s) { return tile.contains(s.second.x, s.second.y); });
                ASSERT_TRUE(std::equal(part.begin(), part.end(), expected.begin(), expected.end(),
                                       [](const auto& a, const auto& b) { return laws::same(a, b); }))
                    << "tile at " << x << ", " << y << ": " << part.size() << " samples of " << expected.size();
            }
        }
    });
}

TEST(Replay, AStrideTakesOneSampleInSoManyEachWay) {
    for_every_case(20, [](const Drawing& drawing, const Case&) {
        const Rect frame = drawing.scene().framebuffer.rect();
        const auto whole = laws::all_samples(drawing, {frame, 1});
        for (const int stride : {2, 3, 5}) {
            const Rect view{frame.x0 - 1, frame.y0 + 1, frame.x1 - 1, frame.y1};
            const auto part = laws::all_samples(drawing, {view, stride});
            std::vector<std::pair<int, Sample>> expected;
            std::copy_if(whole.begin(), whole.end(), std::back_inserter(expected), [&](const auto& s) {
                return view.contains(s.second.x, s.second.y) && (s.second.x - view.x0) % stride == 0 &&
                       (s.second.y - view.y0) % stride == 0;
            });
            ASSERT_TRUE(std::equal(part.begin(), part.end(), expected.begin(), expected.end(),
                                   [](const auto& a, const auto& b) { return laws::same(a, b); }))
                << "stride " << stride << ": " << part.size() << " samples of " << expected.size();
        }
    });
}

TEST(Replay, DepthHidesTheSameSamplesInEveryTile) {
    for_every_case(14, [](const Drawing& drawing, const Case& c) {
        Scene scene = drawing.scene();
        scene.depth = Depth::less;
        const Drawing deep(scene, c.settings);
        const Rect frame = scene.framebuffer.rect();
        const auto whole = laws::all_samples(deep, {frame, 1});
        EXPECT_EQ(painted(deep, whole), render(deep));
        const Rect tile{frame.x0 + 2, frame.y0 + 3, frame.x0 + 7, frame.y0 + 6};
        std::vector<std::pair<int, Sample>> expected;
        std::copy_if(whole.begin(), whole.end(), std::back_inserter(expected),
                     [&](const auto& s) { return tile.contains(s.second.x, s.second.y); });
        const auto part = laws::all_samples(deep, {tile, 1});
        EXPECT_TRUE(std::equal(part.begin(), part.end(), expected.begin(), expected.end(),
                               [](const auto& a, const auto& b) { return laws::same(a, b); }));
    });
}

std::vector<Sample> samples_until(const Drawing& drawing, int shape, const Path& path) {
    std::vector<Sample> samples;
    const Job job = drawing.job(shape);
    (void)drawing.settings().method->until(drawing.settings().format, job, {job.frame, 1}, path,
                                           [&](const Sample& s) { samples.push_back(s); });
    return samples;
}

/// One after the other, the steps of a shape put its samples, in order, at most one each.
void check_growth(const Drawing& drawing, int shape) {
    const Job job = drawing.job(shape);
    std::vector<Sample> whole;
    drawing.settings().method->samples(drawing.settings().format, job, {job.frame, 1},
                                       [&](const Sample& s) { whole.push_back(s); });
    Steps steps(drawing);
    std::size_t before = 0;
    for (auto path = std::optional(steps.at_level(Path{{{'t', shape}}}, Level::pixel));
         path && path->parts[0].index == shape; path = steps.next(*path, Level::pixel)) {
        const std::vector<Sample> part = samples_until(drawing, shape, *path);
        ASSERT_LE(part.size(), whole.size());
        ASSERT_TRUE(part.size() == before || part.size() == before + 1)
            << path->text() << ": from " << before << " to " << part.size();
        ASSERT_TRUE(std::equal(part.begin(), part.end(), whole.begin(), [](const Sample& a, const Sample& b) {
            return laws::same(a, b);
        })) << path->text();
        if (part.size() > before && part.back().note == Note::none && path->index_of('x') && path->index_of('y')) {
            ASSERT_EQ(part.back().x, path->index_of('x'));
            ASSERT_EQ(part.back().y, path->index_of('y'));
        }
        before = part.size();
    }
    ASSERT_EQ(before, whole.size());
    ASSERT_EQ(samples_until(drawing, shape, Path{{{'t', shape}}}).size(), whole.size());
}

TEST(Replay, UntilAStepPutsTheSamplesUpToItInOrder) {
    for_every_case(7, [](const Drawing& drawing, const Case&) {
        for (int shape = 0; shape < std::min(drawing.shape_count(), 2); ++shape) check_growth(drawing, shape);
    });
}

TEST(Replay, LineCountsGrowFromStepToStep) {
    for_every_case(4, [](const Drawing& drawing, const Case&) {
        Steps steps(drawing);
        const auto ignore = [](const Sample&) {};
        LineCounts before;
        for (auto path = steps.first(Level::pixel); path && path->parts[0].index == 0;
             path = steps.next(*path, Level::pixel)) {
            const Job job = drawing.job(0);
            const LineCounts counts =
                drawing.settings().method->until(drawing.settings().format, job, {job.frame, 1}, *path, ignore);
            for (std::size_t line = 0; line < before.size(); ++line)
                ASSERT_GE(counts.at(line), before[line]) << path->text();
            before = counts;
        }
    });
}

}  // namespace
}  // namespace texelscope::replay_test
