// Each family of hard input has the property that it is named for.
#include "core/measure/families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/fast/raster.h"
#include "core/geometry/polygon.h"
#include "core/image/image.h"
#include "core/measure/reference.h"

namespace texelscope {
namespace {

constexpr int kShapes = 40;

[[nodiscard]] std::vector<HardShape> shapes(std::string_view name, StressMode mode = {false, true}) {
    const Family* family = find_family(name);
    EXPECT_NE(family, nullptr) << name;
    std::vector<HardShape> all;
    for (int n = 0; family != nullptr && n < kShapes; ++n)
        all.push_back(in_mode(family->make(seed_of(7, *family, n)), mode));
    return all;
}
[[nodiscard]] std::span<const Vertex, 3> triangle(const HardShape& shape, std::size_t n = 0) {
    return std::span<const Vertex, 3>(&shape.vertices[3 * n], 3);
}
[[nodiscard]] std::vector<DecidedSample> decided(const HardShape& shape, std::size_t n = 0) {
    return decided_samples(triangle(shape, n), shape.frame);
}
[[nodiscard]] bool every_vertex(const HardShape& shape, const std::function<bool(const Vertex&)>& is) {
    return std::all_of(shape.vertices.begin(), shape.vertices.end(), is);
}
[[nodiscard]] bool on_centre(const Vertex& v) { return v.x - std::floor(v.x) == .5F && v.y - std::floor(v.y) == .5F; }
[[nodiscard]] bool whole_texels(const Vertex& v) { return v.u == std::floor(v.u) && v.v == std::floor(v.v); }
/// Some vertex of some shape.
[[nodiscard]] bool some_vertex(const std::vector<HardShape>& all, const std::function<bool(const Vertex&)>& is) {
    return std::any_of(all.begin(), all.end(), [&](const HardShape& shape) {
        return std::any_of(shape.vertices.begin(), shape.vertices.end(), is);
    });
}
/// Of all samples of a family, the share that has a property.
[[nodiscard]] double share(std::string_view name,
                           const std::function<bool(const HardShape&, const DecidedSample&)>& is) {
    std::size_t with = 0, all = 0;
    for (const HardShape& shape : shapes(name, {false, false}))
        for (const DecidedSample& s : decided(shape)) ++all, with += is(shape, s);
    return all == 0 ? 0 : static_cast<double>(with) / static_cast<double>(all);
}

TEST(Families, AreNamedOnceAndFound) {
    std::set<std::string_view> names;
    for (const Family& family : families()) {
        EXPECT_TRUE(names.insert(family.name).second) << family.name;
        EXPECT_EQ(find_family(family.name), &family);
        EXPECT_FALSE(family.summary.empty());
        EXPECT_GE(family.cost, 1);
    }
    EXPECT_EQ(find_family("no such family"), nullptr);
}

TEST(Families, TheSameSeedMakesTheSameShapeAndAnotherOneAnother) {
    for (const Family& family : families()) {
        std::set<std::vector<float>> made;
        for (int n = 0; n < kShapes; ++n) {
            const HardShape shape = family.make(seed_of(3, family, n)), again = family.make(seed_of(3, family, n));
            ASSERT_EQ(text_of(shape.vertices), text_of(again.vertices)) << family.name;
            ASSERT_EQ(shape.vertices.size() % 3, 0U) << family.name;
            std::vector<float> numbers;
            for (const Vertex& v : shape.vertices)
                if (is_finite(v)) numbers.insert(numbers.end(), {v.x, v.y, v.u, v.v});
            made.insert(numbers);
        }
        EXPECT_GT(made.size(), kShapes / 4U) << family.name;
    }
}

TEST(Families, DrawSomethingWhereTheyShould) {
    for (const Family& family : families()) {
        const bool nothing = family.name == "without-area" || family.name == "not-finite";
        std::size_t samples = 0;
        for (const HardShape& shape : shapes(family.name))
            for (std::size_t n = 0; n < shape.vertices.size() / 3; ++n) samples += decided(shape, n).size();
        EXPECT_EQ(samples == 0, nothing) << family.name << " has " << samples << " samples";
    }
}

TEST(Families, ModesSnapAndFlatten) {
    for (const Family& family : families()) {
        if (family.name == "not-finite") continue;
        const HardShape shape = in_mode(family.make(seed_of(1, family, 0)), {true, false});
        EXPECT_TRUE(every_vertex(shape, [](const Vertex& v) {
            return v.w == 1 && v.x * 256 == std::floor(v.x * 256) && v.y * 256 == std::floor(v.y * 256);
        })) << family.name;
    }
}

TEST(Families, ClosedMeshesOwnEachSampleOnce) {
    std::size_t meshes = 0;
    for (const Family& family : families())
        for (const StressMode mode : kStressModes)
            for (const HardShape& shape : shapes(family.name, mode)) {
                if (!shape.closed) continue;
                Grid<int> counts(shape.frame.width(), shape.frame.height());
                for (std::size_t n = 0; n < shape.vertices.size() / 3; ++n)
                    for (const DecidedSample& s : decided(shape, n))
                        ++counts.at(static_cast<int>(s.x) - shape.frame.x0, static_cast<int>(s.y) - shape.frame.y0);
                ASSERT_TRUE(std::all_of(counts.data(), counts.data() + counts.size(), [](int n) { return n == 1; }))
                    << family.name;
                ++meshes;
            }
    EXPECT_EQ(meshes, 4U * 4 * kShapes);
}

TEST(Families, LayersCoverTiles) {
    std::uint64_t left_out = 0;
    const std::vector<HardShape> all = shapes("layers");
    for (const HardShape& first : all) {
        std::vector<Vertex> together;
        for (const HardShape& shape : all)
            if (shape.frame == first.frame)
                together.insert(together.end(), shape.vertices.begin(), shape.vertices.end());
        const Rect& frame = first.frame;
        std::vector<std::uint32_t> pixels(static_cast<std::size_t>(frame.width() * frame.height()));
        const std::uint32_t texel = 1;
        RasterCounters counters;
        draw({pixels.data(), frame.width(), frame.width(), frame.height(), frame.x0, frame.y0}, {&texel, 1, 1},
             {.vertices = together}, {}, counters);
        left_out += counters.of(RasterSkip::overdrawn);
    }
    EXPECT_GT(left_out, all.size());
}

TEST(Families, CornersLieWhereTheFamilySays) {
    for (const HardShape& shape : shapes("on-centres")) EXPECT_TRUE(every_vertex(shape, on_centre));
    for (const HardShape& shape : shapes("ratios"))
        EXPECT_TRUE(every_vertex(shape, [](const Vertex& v) { return on_centre(v) && whole_texels(v); }));
    for (const HardShape& shape : shapes("whole-depths"))
        EXPECT_TRUE(every_vertex(
            shape, [](const Vertex& v) { return on_centre(v) && whole_texels(v) && v.w == std::floor(v.w); }));
    for (const HardShape& shape : shapes("grid-aligned"))
        EXPECT_TRUE(every_vertex(shape, [](const Vertex& v) { return v.x * 16 == std::floor(v.x * 16); }));
    for (const HardShape& shape : shapes("near-ties"))
        EXPECT_TRUE(every_vertex(shape, [](const Vertex& v) { return std::abs(v.x - std::floor(v.x) - .5F) < 1e-4F; }));
    for (const HardShape& shape : shapes("big-indices"))
        EXPECT_GT(std::max(std::abs(shape.vertices[0].u), std::abs(shape.vertices[1].u)), 0x1p18F);
    EXPECT_TRUE(some_vertex(shapes("big-indices"), [](const Vertex& v) { return std::abs(v.u) > 0x1p31F; }));
    EXPECT_TRUE(some_vertex(shapes("denormal"), [](const Vertex& v) { return std::fpclassify(v.x) == FP_SUBNORMAL; }));
    EXPECT_TRUE(some_vertex(shapes("huge"), [](const Vertex& v) { return std::abs(v.x) > 1e30F; }));
    EXPECT_TRUE(some_vertex(shapes("class-limits"), [](const Vertex& v) { return std::abs(v.x) >= 0x1p21F; }));
    EXPECT_TRUE(some_vertex(shapes("extreme-depths"), [](const Vertex& v) { return v.w < 1e-38F; }));
    EXPECT_TRUE(some_vertex(shapes("extreme-depths"), [](const Vertex& v) { return v.w > 1e30F; }));
    for (const HardShape& shape : shapes("equal-depths"))
        EXPECT_TRUE(every_vertex(shape, [&](const Vertex& v) { return v.w == shape.vertices[0].w && v.w != 1; }));
    for (const HardShape& shape : shapes("not-finite")) EXPECT_FALSE(every_vertex(shape, is_finite));
    for (const HardShape& shape : shapes("without-area")) EXPECT_EQ(ExactTriangle(triangle(shape)).winding(), 0);
    for (const HardShape& shape : shapes("far-offset")) EXPECT_GE(shape.frame.x0, 256);
}

TEST(Families, SidesRunThroughSamples) {
    for (const HardShape& shape : shapes("through-centres")) {
        // With the third corner on the one side and on the other, a sample of the side is owned by one of the two.
        HardShape turned = shape;
        Vertex& third = turned.vertices[2];
        third.x = shape.vertices[0].x + shape.vertices[1].x - third.x;
        third.y = shape.vertices[0].y + shape.vertices[1].y - third.y;
        const auto &p = shape.vertices[0], &q = shape.vertices[1];
        int on_side = 0;
        for (int y = -8; y < 44; ++y)
            for (int x = -8; x < 52; ++x) {
                const double a = (double{q.x} - p.x) * (y + .5 - p.y) - (double{q.y} - p.y) * (x + .5 - p.x);
                const double t = (x + .5 - p.x) * (double{q.x} - p.x) + (y + .5 - p.y) * (double{q.y} - p.y);
                const double whole =
                    (double{q.x} - p.x) * (double{q.x} - p.x) + (double{q.y} - p.y) * (double{q.y} - p.y);
                on_side += a == 0 && t >= 0 && t <= whole;
            }
        EXPECT_GT(on_side, 0) << text_of(shape.vertices);
    }
}

TEST(Families, TexelsBeginOnSamplesWhereTheyShould) {
    const auto begins = [](const HardShape& shape, const DecidedSample& s) {
        const ExactCoordinates coordinates(triangle(shape));
        return coordinates.distance(coordinates.at(s.x, s.y), static_cast<double>(s.texel.u), 0)[0] == 0;
    };
    EXPECT_GT(share("ratios", begins), .05);
    EXPECT_GT(share("blits", begins), .15);
    EXPECT_LT(share("random", begins), .001);
}

TEST(Families, ThinOnesAreThinAndTinyOnesTiny) {
    const auto area = [](const HardShape& shape) {
        const auto &a = shape.vertices[0], &b = shape.vertices[1], &c = shape.vertices[2];
        return std::abs((double{b.x} - a.x) * (double{c.y} - a.y) - (double{c.x} - a.x) * (double{b.y} - a.y)) / 2;
    };
    const auto longest = [](const HardShape& shape) {
        double most = 0;
        for (const Vertex& p : shape.vertices)
            for (const Vertex& q : shape.vertices)
                most = std::max(most, std::hypot(double{p.x} - q.x, double{p.y} - q.y));
        return most;
    };
    for (const HardShape& shape : shapes("slivers")) EXPECT_LT(area(shape), 2.1 * longest(shape));
    for (const HardShape& shape : shapes("opened-lines")) EXPECT_LT(area(shape), .13 * longest(shape));
    for (const HardShape& shape : shapes("tiny")) EXPECT_LT(longest(shape), 4 * std::sqrt(2.0));
    for (const HardShape& shape : shapes("nearly-in-line")) EXPECT_LT(area(shape), .2 * longest(shape));
    for (const HardShape& shape : shapes("long-legs")) EXPECT_GT(longest(shape), 181);
}

TEST(Families, OrdersAreOneTriangleSixTimes) {
    for (const HardShape& shape : shapes("orders")) {
        ASSERT_EQ(shape.vertices.size(), 18U);
        for (std::size_t n = 1; n < 6; ++n) EXPECT_EQ(decided(shape, n).size(), decided(shape).size());
    }
}

}  // namespace
}  // namespace texelscope
