#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/state/compared_run.h"
#include "tests/app/views/view_stage.h"

namespace texelscope::difference_test {
namespace {

const ui::Area kLarge{0, 0, 624, 288};

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

[[nodiscard]] std::unique_ptr<ViewStage> stage_of(const std::string& method, float far) {
    return std::make_unique<ViewStage>(StageSpec{.method = method, .step = "t0"}, face_document(far));
}
void click(ViewStage& stage, glm::vec2 at) {
    stage.input.mouse = at;
    stage.frame("difference", kLarge);
    stage.input.pressed[0] = true, stage.input.down[0] = true;
    stage.frame("difference", kLarge);
    stage.input.released[0] = true, stage.input.down[0] = false;
    stage.frame("difference", kLarge);
}

TEST(DifferenceView, MethodVariantAndNumberAreChosenThere) {
    const auto made = stage_of("backward-projective", 2);
    ViewStage& stage = *made;
    stage.frame("difference", kLarge);
    EXPECT_TRUE(stage.shows("against Barycentric weights"));
    EXPECT_TRUE(stage.shows("both read the same texel everywhere"));
    const auto press = [&](const std::string& label) {
        const ui::ControlRecord* control = stage.control(label);
        ASSERT_NE(control, nullptr) << label;
        click(stage, control->area.centre());
        const auto* look = stage.done<action::SetLook>();
        ASSERT_NE(look, nullptr) << label;
        stage.state.look = look->look;
        stage.frame("difference", kLarge);
    };
    press("previous method");
    EXPECT_EQ(text_of(stage.state.look.other), "backward-projective corrected f64");  // its own, run otherwise
    EXPECT_TRUE(stage.shows("both read the same texel everywhere"));
    press("corrected");
    EXPECT_EQ(text_of(stage.state.look.other), "backward-projective as-printed f64");
    EXPECT_TRUE(stage.shows("as printed, f64"));
    press("f64");
    EXPECT_EQ(text_of(stage.state.look.other), "backward-projective as-printed f32");
    press("next method");
    EXPECT_EQ(text_of(stage.state.look.other), "barycentric corrected f32");
    press("previous method"), press("previous method");
    EXPECT_EQ(text_of(stage.state.look.other), "backward-affine corrected f32");
    EXPECT_TRUE(stage.shows("warp"));
}

TEST(DifferenceView, AClickOnAnyOfTheThreePicturesPinsThePixel) {
    const auto made = stage_of("backward-projective", 2);
    ViewStage& stage = *made;
    for (int picture = 0; picture < 3; ++picture) {
        stage.frame("difference", kLarge);
        const auto found = std::find_if(stage.report.controls.begin(), stage.report.controls.end(),
                                        [&](const auto& c) { return c.name == fmt::format("difference/{}", picture); });
        ASSERT_NE(found, stage.report.controls.end());
        click(stage, found->area.centre());
        const auto* pin = stage.done<action::Pin>();
        ASSERT_NE(pin, nullptr) << picture;
        EXPECT_EQ(pin->what.kind, Selection::Kind::pixel);
        EXPECT_LE(std::abs(pin->what.at.x - 20) + std::abs(pin->what.at.y - 15), 1);
    }
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
}  // namespace texelscope::difference_test
