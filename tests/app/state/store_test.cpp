#include "app/state/store.h"

#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "app/state/link.h"
#include "tests/app/state/fixture.h"

namespace texelscope::store_test {
namespace {

Store open_quad() { return Store(opened(quad_document(), State{})); }

TEST(Store, OpensASceneAtItsFirstStep) {
    Store store = open_quad();
    EXPECT_EQ(store.state().cursor.step, *store.derived().steps().first(Level::pixel));
    EXPECT_FALSE(store.can_undo());
}

TEST(Store, StepsForwardAndBackMeetAgainAtEveryLevel) {
    for (int level = 0; level < kLevels; ++level) {
        Store store = open_quad();
        store.dispatch(action::SetLevel{static_cast<Level>(level)});
        const Cursor before = store.state().cursor;
        const int steps = level == 0 ? 1 : 5;
        store.dispatch(action::Step{steps});
        EXPECT_NE(store.state().cursor, before) << level;
        store.dispatch(action::Step{-steps});
        EXPECT_EQ(store.state().cursor, before) << level;
    }
}

TEST(Store, ADragIsOneUndoEntry) {
    Store store = open_quad();
    const Work before = store.state().work;
    for (int n = 0; n < 20; ++n)
        store.dispatch(action::MoveVertex{{0, 1, false}, {20.0F + static_cast<float>(n), 5}, 7});
    const Work after = store.state().work;
    store.dispatch(action::Undo{});
    EXPECT_EQ(store.state().work, before);
    EXPECT_FALSE(store.can_undo());
    store.dispatch(action::Redo{});
    EXPECT_EQ(store.state().work, after);
}

TEST(Store, UndoThenRedoRestoresWorkAndCursor) {
    Store store = open_quad();
    store.dispatch(action::SetFormat{NumberFormat::f32});
    store.dispatch(action::Step{3});
    store.dispatch(action::MoveVertex{{0, 0, false}, {2, 2}, 1});
    store.dispatch(action::MoveVertex{{0, 0, true}, {3, 3}, 2});
    store.dispatch(action::SetVariant{"as-printed"});
    store.dispatch(action::SetQuirk{2, false});
    store.dispatch(action::Reset{});
    const Work work = store.state().work;
    const Cursor cursor = store.state().cursor;
    int undone = 0;
    while (store.can_undo()) store.dispatch(action::Undo{}), ++undone;
    EXPECT_EQ(undone, 6);
    EXPECT_EQ(store.state().work, opened(quad_document(), State{}).work);
    for (int n = 0; n < undone; ++n) store.dispatch(action::Redo{});
    EXPECT_EQ(store.state().work, work);
    EXPECT_EQ(store.state().cursor, cursor);
}

TEST(Store, AnEditKeepsTheStepWhereItStillExists) {
    Store store = open_quad();
    const Path step = *parse_path("t0/s5/y9/x12");
    store.dispatch(action::StepTo{step});
    store.dispatch(action::MoveVertex{{0, 2, false}, {18.5F, 20.5F}, 1});
    EXPECT_EQ(store.state().cursor.step, step);
    EXPECT_TRUE(store.state().message.text.empty());
}

TEST(Store, AnEditThatRemovesTheStepGoesToAnEarlierOneAndSaysSo) {
    Store store = open_quad();
    store.dispatch(action::StepTo{*parse_path("t0/s5/y18/x17")});
    store.dispatch(action::MoveVertex{{0, 2, false}, {18, 10}, 1});
    const Cursor& cursor = store.state().cursor;
    EXPECT_EQ(store.derived().steps().nearest(cursor.step, cursor.level), cursor.step);
    EXPECT_FALSE(store.state().message.text.empty());
}

TEST(Store, TheCanvasAfterTheLastStepIsTheUntracedPicture) {
    for (const Method* method : methods()) {
        for (const VariantInfo& variant : method->variants) {
            Store store = open_quad();
            store.dispatch(action::SetMethod{std::string(method->id)});
            store.dispatch(action::SetVariant{std::string(variant.id)});
            store.dispatch(action::StepEnd{true});
            const Rect frame = store.derived().scene().framebuffer.rect();
            const CanvasPicture& canvas = store.derived().canvas({frame, 1});
            for (int y = 0; y < frame.height(); ++y) {
                for (int x = 0; x < frame.width(); ++x) {
                    ASSERT_EQ(canvas.cells.at(x, y).now, store.derived().final_picture().at(x, y))
                        << method->id << ' ' << x << ' ' << y;
                }
            }
        }
    }
}

TEST(Store, ScrubbingToAStepEqualsSteppingThere) {
    Store walked = open_quad(), jumped = open_quad();
    walked.dispatch(action::Step{117});
    jumped.dispatch(action::StepTo{walked.state().cursor.step});
    EXPECT_EQ(jumped.state().cursor, walked.state().cursor);
    const Window all{walked.derived().scene().framebuffer.rect(), 1};
    const auto& a = walked.derived().canvas(all).cells;
    const auto& b = jumped.derived().canvas(all).cells;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) ASSERT_EQ(a.at(x, y).now, b.at(x, y).now);
    }
}

TEST(Store, PixelAndTexelSelectTheirPartners) {
    Store store = open_quad();
    store.dispatch(action::StepEnd{true});
    const Highlight pixel = store.derived().highlight({.kind = Selection::Kind::pixel, .at = {8, 14}});
    ASSERT_EQ(pixel.texels.size(), 1U);
    const Highlight texel = store.derived().highlight({.kind = Selection::Kind::texel, .at = pixel.texels.front()});
    EXPECT_NE(std::find(texel.pixels.begin(), texel.pixels.end(), glm::ivec2(8, 14)), texel.pixels.end());
}

TEST(Store, ADepthStaysPositiveAndFiniteAndIsOneUndoEntry) {
    Store store(opened(quad_document(), State{}));
    const auto depth = [&] { return store.derived().scene().polygons[0].vertices[1].w; };
    for (const float w : {2.0F, 3.0F, 4.0F}) store.dispatch(action::SetDepth{{0, 1, false}, w, 7});
    EXPECT_EQ(depth(), 4);
    store.dispatch(action::Undo{});
    EXPECT_EQ(depth(), 1);
    for (const float w : {0.0F, -5.0F, 1e30F}) {
        store.dispatch(action::SetDepth{{0, 1, false}, w});
        EXPECT_TRUE(depth() > 0 && depth() <= 64) << w;
    }
    const State before = store.state();
    store.dispatch(action::SetDepth{{0, 1, false}, std::numeric_limits<float>::quiet_NaN()});
    store.dispatch(action::SetDepth{{0, 9, false}, 2});
    store.dispatch(action::SetDepth{{-1, 0, false}, 2});
    EXPECT_EQ(store.state().work, before.work);
}

TEST(Store, ATurnedRingIsCutAlongTheOtherDiagonal) {
    Store store(opened(quad_document(), State{}));
    const std::vector<Vertex> ring = store.derived().scene().polygons[0].vertices;
    const auto diagonal = [&] {  // the corners that both triangles have
        const auto a = store.derived().drawing().corners(0), b = store.derived().drawing().corners(1);
        std::set<std::pair<float, float>> shared;
        for (const Vertex& p : a)
            for (const Vertex& q : b)
                if (p == q) shared.emplace(p.x, p.y);
        return shared;
    };
    using Ends = std::set<std::pair<float, float>>;
    EXPECT_EQ(diagonal(), (Ends{{ring[0].x, ring[0].y}, {ring[2].x, ring[2].y}}));
    store.dispatch(action::ChooseHandle{{0, 0, false}});
    store.dispatch(action::TurnRing{0});
    EXPECT_EQ(diagonal(), (Ends{{ring[1].x, ring[1].y}, {ring[3].x, ring[3].y}}));
    EXPECT_EQ(store.state().handle.vertex, 3);  // the same corner
    const auto link = parse_link(print_link(store.state()));
    ASSERT_TRUE(link);
    EXPECT_EQ(link->work, store.state().work);
    store.dispatch(action::Undo{});
    EXPECT_EQ(store.derived().scene().polygons[0].vertices, ring);
    for (int n = 0; n < 4; ++n) store.dispatch(action::TurnRing{0});
    EXPECT_EQ(store.derived().scene().polygons[0].vertices, ring);
    store.dispatch(action::TurnRing{1});
    EXPECT_EQ(store.derived().scene().polygons[0].vertices, ring);
}

TEST(Store, TheListOfLessonsOpensAtTheOpenLesson) {
    auto document = std::make_shared<Document>(*quad_document());
    document->lesson = Lesson{};
    document->lesson->number = 9;
    document->lesson->method = "edge-equations", document->lesson->variant = "corrected";
    document->lesson->beats.resize(1);
    Store store(opened(document, State{}));
    store.dispatch(action::Show{Overlay::lessons});
    EXPECT_EQ(store.state().chosen_lesson, 8);
    store.dispatch(action::ChooseLesson{3});
    store.dispatch(action::Show{Overlay::none});
    EXPECT_EQ(store.state().chosen_lesson, 3);
}

}  // namespace
}  // namespace texelscope::store_test
