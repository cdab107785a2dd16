#include "app/state/pose.h"

#include <gtest/gtest.h>

#include "app/state/store.h"
#include "tests/app/state/fixture.h"
#include "tests/app/state/sampling_fixture.h"

namespace texelscope {
namespace {

TEST(Pose, OfAPosedShapeIsThatPose) {
    for (const double degrees : {-170.0, -90.0, 0.0, 30.0, 75.0, 180.0}) {
        for (const double scale : {.25, 1.0, 1.5}) {
            const Scene scene = turned_scene(64, 16, degrees, scale);
            const Pose pose = pose_of(scene.polygons[0].vertices);
            EXPECT_NEAR(std::abs(std::remainder(pose.degrees - degrees, 360)), 0, 1e-3);
            EXPECT_NEAR(pose.scale, scale, 1e-5);
            EXPECT_NEAR(pose.centre.x, 60, 1e-4);
            EXPECT_NEAR(pose.centre.y, 60, 1e-4);
        }
    }
}

TEST(Pose, OfNothingOrOfOnePointIsNoDivisionByZero) {
    EXPECT_EQ(pose_of({}), Pose{});
    const std::vector<Vertex> same(4);
    EXPECT_EQ(pose_of(same).scale, 1);
}

TEST(Store, AShapeMovesWholeAndAsOneUndoEntryForEachGesture) {
    Store store(opened(quad_document(), State{}));
    const Work before = store.state().work;
    const std::vector<glm::vec2> first{{5, 3}, {20, 5}, {18, 20}, {5, 17}}, second{{6, 3}, {21, 5}, {19, 20}, {6, 17}};
    store.dispatch(action::MoveShape{0, first, 7});
    store.dispatch(action::MoveShape{0, second, 7});
    EXPECT_EQ(store.derived().scene().polygons[0].vertices[1].x, 21);
    store.dispatch(action::Undo{});
    EXPECT_EQ(store.state().work, before);
    store.dispatch(action::Redo{});
    EXPECT_EQ(store.derived().scene().polygons[0].vertices[3].x, 6);
}

TEST(Store, AShapeDoesNotMoveToTooFewCornersOrToNoPlace) {
    Store store(opened(quad_document(), State{}));
    const Work before = store.state().work;
    store.dispatch(action::MoveShape{0, {{1, 1}, {2, 2}}, 0});
    store.dispatch(action::MoveShape{5, {{1, 1}}, 0});
    store.dispatch(action::MoveShape{0, {{1, 1}, {2, 2}, {3, NAN}, {4, 4}}, 0});
    EXPECT_EQ(store.state().work, before);
}

TEST(Store, AllQuirksAtOnceAreOneUndoEntry) {
    Store store(opened(quad_document(), State{}));
    const Work before = store.state().work;
    store.dispatch(action::SetQuirks{0b11});
    EXPECT_EQ(store.state().work.quirks, 0b11U);
    store.dispatch(action::Undo{});
    EXPECT_EQ(store.state().work, before);
}

}  // namespace
}  // namespace texelscope
