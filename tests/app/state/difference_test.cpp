// Two runs over one scene: every cause in a scene where it is certain, and its count against one counted directly.
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "app/lesson/facts.h"
#include "app/state/compared_run.h"
#include "app/state/comparisons.h"
#include "core/image/patterns.h"

namespace texelscope::difference_test {
namespace {

constexpr Rect kFrame{0, 0, 32, 25};
static_assert(Integer{kFrame.width()} * kFrame.height() <= kMaxExact);

/// A parallelogram over the frame, 30 x 23 pixels for 16 x 16 texels; `far` is the w of its upper side. Its
/// borders pass through no sample, with `on_samples` its left and upper ones through many.
[[nodiscard]] Scene face(float far = 1, bool on_samples = false) {
    Scene scene;
    scene.framebuffer.width = kFrame.x1, scene.framebuffer.height = kFrame.y1;
    scene.textures.push_back(
        std::make_shared<const Texture>(Texture{.name = "t", .texels = make_pattern(Pattern::address, 16, 16, 1)}));
    const float x = on_samples ? 1.5F : 1.25F, y = on_samples ? 1.5F : 1.25F;
    const float inset = far > 1 ? 7.5F : 0;  // of a face that is as wide far away as near
    Polygon quad;
    quad.vertices = {{.x = x + inset, .y = y, .w = far, .u = 0, .v = 0},
                     {.x = x + 30 - inset, .y = y, .w = far, .u = 16, .v = 0},
                     {.x = x + 30, .y = y + 23, .w = 1, .u = 16, .v = 16},
                     {.x = x, .y = y + 23, .w = 1, .u = 0, .v = 16}};
    scene.polygons.push_back(std::move(quad));
    return scene;
}

[[nodiscard]] DrawSettings run(std::string_view words, std::string_view quirk = {}) {
    DrawSettings settings = settings_of(*parse_run(words), {find_method("edge-equations")});
    if (!quirk.empty()) settings.quirks |= QuirkSet{1} << quirk_number(*settings.method, quirk).value();
    return settings;
}
[[nodiscard]] Difference compared(const Scene& scene, const DrawSettings& own, const DrawSettings& other) {
    return compare(Drawing(scene, own), other, {kFrame});
}
/// Pixels that end up with another texel, or are drawn by one run only.
[[nodiscard]] int counted(const Scene& scene, const DrawSettings& own, const DrawSettings& other, bool one_only) {
    using Picture = std::map<std::pair<Integer, Integer>, std::pair<int, int>>;
    const auto picture = [&](const DrawSettings& settings) {
        Picture all;
        const Drawing drawing(scene, settings);
        each_sample(drawing, 0, drawing.shape_count(), {kFrame}, [&](int, const Sample& s) {
            if (s.fate == Fate::written) all[{s.x, s.y}] = {s.column, s.row};
        });
        return all;
    };
    const Picture a = picture(own), b = picture(other);
    int only = 0, texels = 0;
    for (const auto& [place, texel] : a) {
        const auto there = b.find(place);
        only += there == b.end();
        texels += there != b.end() && there->second != texel;
    }
    for (const auto& [place, texel] : b) only += a.count(place) == 0;
    return one_only ? only : texels;
}
[[nodiscard]] int differing(const Difference& d) {
    return d.of(Cause::coverage) + d.of(Cause::rounding) + d.of(Cause::offset) + d.of(Cause::warp);
}

TEST(Compare, WhatDiffersIsWhatACountOfTexelsFinds) {
    for (const float far : {1.0F, 2.0F})
        for (const std::string_view own : {"edge-equations as-printed", "sections", "forward", "barycentric fx8.8"})
            for (const std::string_view other : {"barycentric", "edge-walk as-printed f32", "backward-affine"}) {
                const Scene scene = face(far);
                const Difference d = compared(scene, run(own), run(other));
                EXPECT_EQ(differing(d),
                          counted(scene, run(own), run(other), false) + counted(scene, run(own), run(other), true))
                    << own << " against " << other;
                EXPECT_EQ(differing(d) + d.of(Cause::same) + d.of(Cause::nothing), kFrame.width() * kFrame.height());
            }
}

TEST(Compare, SamplesAtCornersAreAnOffsetOfExactlyHalfAPixel) {
    const Scene scene = face();
    const Difference d = compared(scene, run("edge-equations", "corners"), run("edge-equations"));
    const int texels = counted(scene, run("edge-equations", "corners"), run("edge-equations"), false);
    EXPECT_GT(texels, 200);
    EXPECT_EQ(d.of(Cause::offset), texels);
    EXPECT_EQ(d.of(Cause::rounding) + d.of(Cause::warp), 0);
    for (std::size_t n = 0; n < d.cells.size(); ++n) {
        const DifferenceCell& cell = d.cells.data()[n];
        if (cell.cause != Cause::offset) continue;
        EXPECT_NEAR(cell.u, -16.0 / 30 / 2, 1e-12);
        EXPECT_NEAR(cell.v, -16.0 / 23 / 2, 1e-12);
    }
}

TEST(Compare, AnOffsetIsOneInCoarseNumbersToo) {
    const Scene scene = face();
    const Difference d = compared(scene, run("edge-equations fx16.16", "corners"), run("edge-equations f32"));
    EXPECT_GT(d.of(Cause::offset), 200);
    EXPECT_EQ(d.of(Cause::warp), 0);
}

TEST(Compare, SidesThatBothOwnAreCoverage) {
    const Scene scene = face(1, true);
    const Difference d = compared(scene, run("edge-equations", "inclusive"), run("edge-equations"));
    EXPECT_EQ(d.of(Cause::coverage), 30 + 23 + 1);  // the samples on the lower and right side
    EXPECT_EQ(d.of(Cause::coverage), counted(scene, run("edge-equations", "inclusive"), run("edge-equations"), true));
    EXPECT_EQ(differing(d), d.of(Cause::coverage));
}

TEST(Compare, PerspectiveAgainstAffineIsWarp) {
    const Scene scene = face(2);
    const DrawSettings own = run("backward-projective"), other = run("backward-affine");
    const Difference d = compared(scene, own, other);
    EXPECT_GT(d.of(Cause::warp), 50);
    EXPECT_EQ(d.of(Cause::warp), counted(scene, own, other, false));
    EXPECT_EQ(d.of(Cause::offset) + d.of(Cause::rounding), 0);
    EXPECT_EQ(compared(scene, own, run("constant-z")).of(Cause::warp), 0);
}

TEST(Compare, FixedPointAgainstDoubleIsRounding) {
    const Scene scene = face();
    for (const std::string_view method : {"edge-walk", "backward-affine", "barycentric"}) {
        const DrawSettings own = run(std::string(method) + " fx8.8");
        for (const DrawSettings& other : {run(method), run("edge-equations")}) {
            const Difference d = compared(scene, own, other);
            EXPECT_GT(d.of(Cause::rounding), 0) << method;
            EXPECT_EQ(d.of(Cause::rounding), counted(scene, own, other, false) + counted(scene, own, other, true))
                << method;
        }
    }
}

TEST(Compare, FloatsInPlaceOfDoublesAreRoundingAlsoAsAQuirk) {
    Scene scene = face(1, true);
    scene.framebuffer.origin_x = 3'000'000;  // far from the origin, where float has few bits left
    for (Vertex& v : scene.polygons[0].vertices) v.x += 3'000'000;
    const Difference d = compare(Drawing(scene, run("edge-equations", "float_pixels")), run("edge-equations"),
                                 {scene.framebuffer.rect()});
    EXPECT_GT(d.of(Cause::rounding), 0);
    EXPECT_EQ(d.of(Cause::rounding), differing(d));
}

TEST(Compare, HolesAreCoverageAndWhatForwardRoundsIsRounding) {
    for (const float far : {1.0F, 2.0F}) {
        const Scene scene = face(far);
        const DrawSettings own = run("forward"), other = run("backward-projective");
        const Difference d = compared(scene, own, other);
        EXPECT_EQ(d.of(Cause::coverage), counted(scene, own, other, true));
        EXPECT_GT(d.of(Cause::coverage), 200);
        EXPECT_EQ(d.of(Cause::offset) + d.of(Cause::warp), 0) << far;
    }
    const Difference d = compared(face(2), run("forward"), run("backward-affine"));
    EXPECT_GT(d.of(Cause::warp), 20);
}

TEST(Compare, TheSameRunDiffersNowhereAndKeepsToTheWindow) {
    const Scene scene = face();
    EXPECT_EQ(differing(compared(scene, run("sections"), run("sections"))), 0);
    const Difference part = compare(Drawing(scene, run("sections")), run("edge-equations fx8.8"), {{-9, 4, 12, 99}, 3});
    EXPECT_EQ(part.window.rect, (Rect{0, 4, 12, 25}));
    EXPECT_EQ(part.cells.width(), 4);
    EXPECT_EQ(part.cells.height(), 7);
}

TEST(Compare, ALargeWindowNamesTheSameCauses) {
    Scene scene = face(2);
    scene.framebuffer.width = 200, scene.framebuffer.height = 100;  // beyond kMaxExact
    const Window all{scene.framebuffer.rect()};
    ASSERT_GT(Integer{200} * 100, kMaxExact);
    for (const std::string_view other : {"backward-affine", "backward-projective fx16.16", "forward"}) {
        const Difference large = compare(Drawing(scene, run("backward-projective")), run(other), all),
                         small = compare(Drawing(scene, run("backward-projective")), run(other), {kFrame});
        for (const Cause cause : {Cause::same, Cause::coverage, Cause::rounding, Cause::offset, Cause::warp})
            EXPECT_EQ(large.of(cause), small.of(cause)) << other;
    }
}

TEST(ComparedRun, WordsAreReadAndPrintedBothWays) {
    for (const std::string_view words : {"barycentric", "edge-equations as-printed", "sections f32",
                                         "edge-equations as-published fx8.8", "forward corrected exact"}) {
        const auto read = parse_run(words);
        ASSERT_TRUE(read) << words;
        EXPECT_EQ(text_of(*read), words);
    }
    EXPECT_EQ(text_of(ComparedRun{}), "");
    for (const std::string_view words : {"", "barycentrics", "sections as-published", "sections f32 as-printed",
                                         "sections f32 f64", "sections corrected corrected", "f32"})
        EXPECT_FALSE(parse_run(words)) << words;
}

TEST(ComparedRun, WhatItLeavesOpenIsTheUsual) {
    const DrawSettings own{find_method("edge-walk"), NumberFormat::f32, 3, {}};
    EXPECT_EQ(settings_of({}, own), (DrawSettings{find_method("barycentric"), NumberFormat::f32, 0, {}}));
    const DrawSettings weights{find_method("barycentric"), NumberFormat::f64, 0, {}};
    EXPECT_EQ(settings_of({}, weights).method, find_method("edge-equations"));
    EXPECT_EQ(text_of(completed({}, own)), "barycentric corrected f32");
    EXPECT_EQ(text_of(completed(*parse_run("edge-walk as-printed exact"), own)), "edge-walk as-printed exact");
}

}  // namespace
}  // namespace texelscope::difference_test
