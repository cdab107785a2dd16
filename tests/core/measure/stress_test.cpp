// Stress finds what is wrong and nothing where all is right.
#include "core/measure/stress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/measure/bounded.h"
#include "core/measure/stress_methods.h"
#include "tests/core/method/cases.h"

namespace texelscope {
namespace {

[[nodiscard]] StressRow row(std::string_view family, std::string_view method, NumberFormat format, int shapes,
                            QuirkSet quirks = 0, StressMode mode = {}) {
    return stress_method(*find_family(family), mode, laws::settings_of(*find_method(method), format, quirks), 5,
                         shapes);
}

TEST(Stress, EveryMethodTakesPartOrSaysWhyNot) {
    std::set<std::string_view> ids;
    for (const StressedMethod& stressed : stressed_methods()) {
        EXPECT_TRUE(ids.insert(stressed.id).second);
        EXPECT_EQ(stressed.why_not.empty(), stressed.affine && stressed.perspective) << stressed.id;
    }
    for (const Method* method : methods()) EXPECT_EQ(ids.count(method->id), 1U) << method->id;
    EXPECT_EQ(ids.size(), methods().size());
}

/// The exact triangle, and the methods that claim to define the same, against each other.
TEST(Stress, ExactNumbersShowNoFaultWhereAMethodDefinesTheSame) {
    for (const StressedMethod& stressed : stressed_methods()) {
        for (const bool perspective : {false, true}) {
            if (!(perspective ? stressed.perspective : stressed.affine)) continue;
            for (const char* family : {"random", "on-centres", "near-ties", "slivers"}) {
                const StressRow found = row(family, stressed.id, NumberFormat::exact, 4, 0, {false, perspective});
                EXPECT_EQ(found.missing + found.extra + found.twice + found.wrong, 0) << stressed.id << ", " << family;
                EXPECT_EQ(found.exceeded, 0) << stressed.id << ", " << family << ": " << found.fault;
                EXPECT_EQ(found.triangles, 4);
            }
        }
    }
}

TEST(Stress, WhatWasPrintedDrawsTooMuch) {
    const QuirkSet printed = quirks_of(*find_method("edge-equations"), "as-printed");
    const StressRow found = row("on-centres", "edge-equations", NumberFormat::f64, 40, printed);
    EXPECT_GT(found.extra + found.missing, 100);
    EXPECT_GT(found.wrong, 100);
    const StressRow sides = row("blits", "barycentric", NumberFormat::f64, 40, 1);  // both own the side
    EXPECT_GT(sides.twice, 0);
    EXPECT_GT(sides.leaky, 0);
    EXPECT_EQ(sides.meshes, 40);
}

TEST(Stress, AnotherMappingHasWrongTexelsAndGreatErrors) {
    const QuirkSet affine = 0b10000;  // of barycentric: without perspective
    const StressRow found = row("steep", "barycentric", NumberFormat::f64, 40, affine, {false, true});
    EXPECT_EQ(found.missing + found.extra, 0);
    EXPECT_GT(found.wrong, found.samples / 10);
    EXPECT_GT(found.worst, 1);
    EXPECT_GE(found.worst, found.p99);
    EXPECT_GE(found.p99, found.mean);
}

/// exact.md: float32 planes that are counted from the origin lose what lies far from it.
TEST(Stress, ErrorsGrowWithTheOffsetInFloat32AndStayWithinTheirBounds) {
    const StressRow near = row("random", "edge-equations", NumberFormat::f32, 60),
                    far = row("far-offset", "edge-equations", NumberFormat::f32, 60),
                    wide = row("far-offset", "edge-equations", NumberFormat::f64, 60);
    EXPECT_GT(far.worst, 100 * near.worst);
    EXPECT_LT(wide.worst, 1e-6);
    for (const StressRow* r : {&near, &far, &wide}) {
        EXPECT_GT(r->bound, r->worst);
        EXPECT_EQ(r->exceeded, 0) << r->fault;
        EXPECT_GT(r->worst, 0);
    }
}

TEST(Stress, EverySampleOfAMethodThatTakesPartHasABound) {
    const HardShape shape = in_mode(find_family("random")->make(3), {});
    const auto texture = laws::texture_of(64, 64, Wrap::repeat);
    const Job job{.corners = shape.vertices, .texture = texture.get(), .frame = shape.frame};
    for (const StressedMethod& stressed : stressed_methods()) {
        const auto samples = drawn_samples(*find_method(stressed.id), NumberFormat::f32, job);
        EXPECT_FALSE(samples.empty()) << stressed.id;
        for (const DrawnSample& s : samples) {
            const bool bounded = s.u_bound < INFINITY && s.v_bound < INFINITY;
            ASSERT_EQ(bounded, stressed.affine) << stressed.id;
            ASSERT_GT(s.u_bound + s.v_bound, 0) << stressed.id;
        }
    }
}

TEST(Stress, ARowFailsForWhatMustBeRight) {
    StressRow fast{.family = &families()[0], .mode = {}, .method = "fast", .number = ""};
    EXPECT_FALSE(fast.failed());
    for (std::int64_t StressRow::*fault : {&StressRow::missing, &StressRow::extra, &StressRow::twice, &StressRow::wrong,
                                           &StressRow::leaky, &StressRow::together, &StressRow::exceeded}) {
        StressRow wrong = fast;
        wrong.*fault = 1;
        EXPECT_TRUE(wrong.failed());
    }
    StressRow other{.family = &families()[0], .mode = {}, .method = "edge-walk", .number = "f32"};
    other.missing = other.wrong = 5;
    EXPECT_FALSE(other.failed()) << "float32 may be wrong";
    other.exceeded = 1;
    EXPECT_TRUE(other.failed());
}

TEST(Stress, TheFastRasterizerIsComparedPixelForPixel) {
    for (const char* family : {"random", "near-ties", "grids", "slivers"}) {
        const StressRow found = stress_fast(*find_family(family), {}, 4, 20);
        EXPECT_FALSE(found.failed()) << family << ": " << found.fault;
        EXPECT_GT(found.samples, 50) << family;
        EXPECT_EQ(found.counters.samples, static_cast<std::uint64_t>(found.samples)) << family;
        EXPECT_EQ(found.not_served, 0) << family;
    }
}

TEST(Stress, ErrorBoundsFollowTheArithmetic) {
    using B = Bounded<float>;
    const B third = B(1) / B(3);
    EXPECT_GE(third.error(), std::abs(1.0 / 3 - double{third.value()}));
    EXPECT_LT(third.error(), 0x1p-24);
    const B lost = (B::of(1e8F, 0) + third) - B::of(1e8F, 0);
    EXPECT_EQ(lost.value(), 0);
    EXPECT_GE(lost.error(), 1.0 / 3);
    EXPECT_EQ((B(1) / lost).error(), INFINITY) << "the divisor may be 0";
    EXPECT_EQ((B::of(3e38F, 0) * B(2)).error(), INFINITY);
    const auto fixed = Bounded<Fixed8>(Integer{1}) / Bounded<Fixed8>(Integer{3});
    EXPECT_GE(fixed.error(), 1.0 / 3 - approximate(fixed.value()));
    EXPECT_EQ(Bounded<Fixed8>(Integer{1000}).error(), INFINITY);
}

}  // namespace
}  // namespace texelscope
