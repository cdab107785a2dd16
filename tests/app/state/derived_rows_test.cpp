// Rows read off their own steps, and the error of a row against exact numbers.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/state/fixture.h"

namespace texelscope::derived_rows_test {
namespace {

[[nodiscard]] Vertex corner(float x, float y, float u, float v) { return {.x = x, .y = y, .w = 1, .u = u, .v = v}; }

/// One triangle on a small frame.
[[nodiscard]] State state_over(std::vector<Vertex> corners, std::string_view method, std::string_view step) {
    auto document = std::make_shared<Document>(*quad_document());
    document->scene.polygons = {{std::move(corners), 0, 1}};
    State state;
    state.document = document;
    state.work.method = method;
    state.work.variant = "corrected";
    state.cursor.step = parse_path(step).value();
    return state;
}
[[nodiscard]] std::vector<Vertex> kite() { return {corner(15, 2, 8, 0), corner(28, 12, 16, 8), corner(4, 21, 0, 16)}; }

TEST(WalkedRows, AreAllRowsOfBothHalvesFromTheTop) {
    Derived derived;
    derived.update(state_over(kite(), "edge-walk", "t0/s2/y5"));
    const std::vector<WalkedRow>& rows = derived.walked_rows();
    ASSERT_EQ(rows.size(), 19U);
    for (std::size_t n = 0; n < rows.size(); ++n) EXPECT_EQ(rows[n].y, static_cast<Integer>(n) + 2);
    EXPECT_EQ(rows.front().path.text(), "t0/s2/y2");
    EXPECT_EQ(rows.back().path.text(), "t0/s3/y20");
    EXPECT_NEAR(rows[0].left, 15 - 11.0 / 19 / 2, 1e-12);   // half a row below the top, along the long side
    EXPECT_NEAR(rows[0].right, 15 + 13.0 / 10 / 2, 1e-12);  // and along the short one
}

TEST(WalkedRows, HoldTheMiddleRowTwiceWhereBothHalvesDrawIt) {
    State state = state_over(kite(), "edge-walk", "t0");
    state.work.quirks = 1;  // inclusive
    Derived derived;
    derived.update(state);
    const std::vector<WalkedRow>& rows = derived.walked_rows();
    ASSERT_EQ(rows.size(), 21U);
    EXPECT_EQ(rows[10].y, 12);
    EXPECT_EQ(rows[11].y, 12);
}

TEST(WalkedRows, AreNoneForAMethodThatDoesNotWalk) {
    Derived derived;
    derived.update(state_over(kite(), "edge-equations", "t0/s5/y5"));
    EXPECT_TRUE(derived.walked_rows().empty());
}

TEST(RowError, IsZeroForExactNumbersAndTheDifferenceForOthers) {
    State state = state_over(kite(), "edge-equations", "t0/s5/y9");
    state.work.format = NumberFormat::exact;
    Derived derived;
    derived.update(state);
    ASSERT_FALSE(derived.row_error().pixels.empty());
    for (const RowError::At& at : derived.row_error().pixels) EXPECT_TRUE(at.u == 0 && at.v == 0 && !at.other);

    std::vector<Sample> exact = derived.row_samples();
    std::erase_if(exact, [](const Sample& s) { return s.fate != Fate::written; });
    state.work.format = NumberFormat::fx8_8;
    derived.update(state);
    const RowError& error = derived.row_error();
    std::vector<Sample> fixed = derived.row_samples();
    std::erase_if(fixed, [](const Sample& s) { return s.fate != Fate::written; });
    ASSERT_EQ(error.pixels.size(), exact.size());
    ASSERT_EQ(fixed.size(), exact.size());
    int others = 0;
    for (std::size_t n = 0; n < exact.size(); ++n) {
        EXPECT_EQ(error.pixels[n].x, exact[n].x);
        EXPECT_EQ(error.pixels[n].u, fixed[n].u - exact[n].u);
        EXPECT_EQ(error.pixels[n].v, fixed[n].v - exact[n].v);
        others += fixed[n].column != exact[n].column || fixed[n].row != exact[n].row;
    }
    EXPECT_EQ(error.others, others);
    const auto shape = derived.shape_error();
    ASSERT_TRUE(shape);
    EXPECT_GE(shape->others, others);
    EXPECT_GT(shape->most, 0);
}

TEST(RowError, IsEmptyOutsideOfRowsAndTheShapesWhereItIsTooLarge) {
    State state = state_over(kite(), "edge-equations", "t0/s0");
    Derived derived;
    derived.update(state);
    EXPECT_TRUE(derived.row_error().pixels.empty());
    auto large = std::make_shared<Document>(*state.document);
    large->scene.framebuffer.width = large->scene.framebuffer.height = 400;
    large->scene.polygons = {{{corner(0, 0, 0, 0), corner(390, 0, 16, 0), corner(0, 390, 0, 16)}, 0, 1}};
    state.document = large;
    derived.update(state);
    EXPECT_FALSE(derived.shape_error());
}

}  // namespace
}  // namespace texelscope::derived_rows_test
