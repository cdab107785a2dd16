#include <gtest/gtest.h>

#include "app/lesson/facts.h"
#include "tests/app/views/view_stage.h"

namespace texelscope {
namespace {

const ui::Area kLarge{0, 0, 624, 288};
const Window kAll{{0, 0, 40, 30}, 1};

/// A parallelogram over 40 x 30 pixels; `far` is the w of its upper side.
[[nodiscard]] std::shared_ptr<const Document> face_document(float far) {
    auto document = std::make_shared<Document>();
    Scene& scene = document->scene;
    scene.framebuffer.width = 40, scene.framebuffer.height = 30;
    Texture texture{.name = "t", .texels = make_pattern(Pattern::checker, 16, 16, 1)};
    scene.textures.push_back(std::make_shared<const Texture>(std::move(texture)));
    const float inset = far > 1 ? 7.5F : 0;  // of a face that is as wide far away as near
    Polygon quad;
    quad.vertices = {{.x = 4.25F + inset, .y = 3.25F, .z = 0, .w = far, .u = 0, .v = 0},
                     {.x = 34.25F - inset, .y = 3.25F, .z = 0, .w = far, .u = 16, .v = 0},
                     {.x = 34.25F, .y = 26.5F, .z = 0, .w = 1, .u = 16, .v = 16},
                     {.x = 4.25F, .y = 26.5F, .z = 0, .w = 1, .u = 0, .v = 16}};
    scene.polygons.push_back(std::move(quad));
    return document;
}

[[nodiscard]] std::unique_ptr<ViewStage> stage_of(const std::string& method, float far, std::string_view quirk = {}) {
    auto stage = std::make_unique<ViewStage>(StageSpec{.method = method, .step = "t0"}, face_document(far));
    if (!quirk.empty()) stage->state.work.quirks = QuirkSet{1} << quirk_number(*find_method(method), quirk).value();
    stage->derived.update(stage->state);
    return stage;
}
[[nodiscard]] int count(const ViewStage& stage, std::string_view other, Cause cause) {
    return stage.derived.difference(kAll, *find_method(other)).count[static_cast<std::size_t>(cause)];
}

TEST(Difference, TwoCorrectedMethodsOnAFlatFaceDifferInRoundingAtMost) {
    const auto stage = stage_of("barycentric", 1);
    for (const std::string_view other : {"edge-equations", "backward-affine", "backward-projective"}) {
        EXPECT_EQ(count(*stage, other, Cause::coverage), 0) << other;
        EXPECT_EQ(count(*stage, other, Cause::offset), 0) << other;
        EXPECT_EQ(count(*stage, other, Cause::warp), 0) << other;
        EXPECT_GT(count(*stage, other, Cause::same), 600) << other;
    }
}

TEST(Difference, PerspectiveAgainstAffineIsWarp) {
    const auto stage = stage_of("backward-projective", 2);
    EXPECT_GT(count(*stage, "backward-affine", Cause::warp), 50);
    EXPECT_EQ(count(*stage, "backward-affine", Cause::offset), 0);
    EXPECT_EQ(count(*stage, "constant-z", Cause::warp), 0);
}

TEST(Difference, AStepTooEarlyIsAnOffset) {
    const auto stage = stage_of("backward-affine", 1, "add_first");
    EXPECT_GT(count(*stage, "backward-projective", Cause::offset), 50);
    EXPECT_EQ(count(*stage, "backward-projective", Cause::warp), 0);
}

TEST(Difference, WhatOnlyOneDrawsIsCoverage) {
    const auto stage = stage_of("edge-equations", 1, "corners");
    EXPECT_GT(count(*stage, "barycentric", Cause::coverage), 20);
}

TEST(Difference, CellsOfAllCausesAreAllCells) {
    const auto stage = stage_of("backward-projective", 2);
    const Difference& d = stage->derived.difference(kAll, *find_method("edge-walk"));
    int sum = 0;
    for (const int n : d.count) sum += n;
    EXPECT_EQ(sum, kAll.rect.width() * kAll.rect.height());
}

TEST(DifferenceView, TheOtherMethodIsChosenThere) {
    const auto made = stage_of("backward-projective", 2);
    ViewStage& stage = *made;
    stage.frame("difference", kLarge);
    EXPECT_TRUE(stage.shows("against Backward: two additions"));
    EXPECT_TRUE(stage.shows("warp"));
    const ui::ControlRecord* next = stage.control("next method");
    ASSERT_NE(next, nullptr);
    stage.input.mouse = next->area.centre();
    stage.frame("difference", kLarge);
    stage.input.pressed[0] = true, stage.input.down[0] = true;
    stage.frame("difference", kLarge);
    stage.input.released[0] = true, stage.input.down[0] = false;
    stage.frame("difference", kLarge);
    const auto* look = stage.done<action::SetLook>();
    ASSERT_NE(look, nullptr);
    EXPECT_EQ(look->look.other, "barycentric");  // its own method is left out
}

TEST(DifferenceView, FitsAndCanBeReadAtEverySizeOfText) {
    for (const float scale : {1.0F, 1.5F, 2.5F}) {
        for (const auto theme : {ui::ThemeName::dark, ui::ThemeName::light}) {
            ViewStage stage({.method = "barycentric", .step = "t0", .fonts = {scale, false}, .theme = theme},
                            face_document(2));
            for (const ui::Area& area :
                 {kLarge, ui::Area{0, 0, 416, 208}, ui::Area{0, 0, 208, 208}, ui::Area{0, 0, 624, 496}}) {
                stage.frame("difference", area);
                for (const ui::TextRecord& text : ui::texts_cut(stage.report))
                    ADD_FAILURE() << scale << " in " << area.w << ": '" << text.text << "' is cut";
                for (const ui::TextRecord& text : ui::faint_texts(stage.report, 4.5))
                    ADD_FAILURE() << scale << " in " << area.w << ": '" << text.text << "' is faint";
            }
        }
    }
}

}  // namespace
}  // namespace texelscope
