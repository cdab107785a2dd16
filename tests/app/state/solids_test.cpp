// Solids that are turned, the camera, and textures that move, as parts of the state.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "app/platform/scripted_input.h"
#include "app/shell/headless.h"
#include "app/state/keymap.h"
#include "app/state/link.h"
#include "app/state/store.h"
#include "tests/app/state/fixture.h"

namespace texelscope {
namespace {

using ui::Key;

/// A cube and jelly cubes; the cube's texture has three frames.
std::shared_ptr<const Document> solids_document() {
    auto document = std::make_shared<Document>(*quad_document());
    document->id = "solids.json";
    Scene& scene = document->scene;
    scene.framebuffer = {64, 48, 0, 0, {}};
    scene.cull = Cull::back;
    scene.polygons.clear();
    Animation moves{.texture = 0, .frames = {scene.textures[0]}};
    for (const Pattern pattern : {Pattern::uv, Pattern::checker}) {
        Texture frame = *scene.textures[0];
        frame.texels = make_pattern(pattern, 16, 16, 1);
        moves.frames.push_back(std::make_shared<const Texture>(std::move(frame)));
    }
    scene.animations = {moves};
    scene.meshes.resize(2);
    scene.meshes[0].rotate = {20, 30, 0}, scene.meshes[0].move = {-1.5F, 0, 8};
    scene.meshes[1].shape = Shape3d::jelly_cubes, scene.meshes[1].move = {2, 0, 8}, scene.meshes[1].half = true;
    scene.meshes[1].rotate = {10, 20, 0}, scene.meshes[1].rotate2 = {40, 35, 10};
    place_meshes(scene);
    return document;
}

class SolidsTest : public testing::Test {
protected:
    [[nodiscard]] const MeshPlacement& mesh(int n) {
        return store.derived().scene().meshes[static_cast<std::size_t>(n)];
    }
    [[nodiscard]] const Polygon& polygon() {
        const Derived& derived = store.derived();
        return derived.scene().polygons[static_cast<std::size_t>(derived.drawing().polygon_of(derived.shape()))];
    }
    void press(Key key, bool repeat = false, bool shift = false) {
        ui::Input input;
        input.keys = {{.key = key, .shift = shift, .repeat = repeat}};
        input.held = {Key::o};
        for (const Action& a : actions_for(input, input.keys, false, store.state(), store.derived(), {}).actions)
            store.dispatch(a);
    }
    /// Stands on the first shape made of a face.
    void go_to_face(int of_mesh, int face) {
        const auto& polygons = store.derived().scene().polygons;
        for (int n = 0; n < static_cast<int>(polygons.size()); ++n) {
            const Polygon& p = polygons[static_cast<std::size_t>(n)];
            if (p.mesh == of_mesh && p.face == face)
                store.dispatch(action::StepTo{Path{{{'t', store.derived().drawing().first_shape_of(n)}}}});
        }
        ASSERT_EQ(polygon().mesh, of_mesh);
        ASSERT_EQ(polygon().face, face);
    }
    Store store{opened(solids_document(), State{})};
};

TEST_F(SolidsTest, ADragIsOneUndoEntryAndResetTakesAllBack) {
    const Work before = store.state().work;
    for (int n = 0; n < 30; ++n) store.dispatch(action::Turn{{0}, 1, 2, -5});
    EXPECT_NE(mesh(0).rotate, glm::vec3(20, 30, 0));
    const Work after = store.state().work;
    store.dispatch(action::Undo{});
    EXPECT_EQ(store.state().work, before);
    EXPECT_EQ(mesh(0).rotate, glm::vec3(20, 30, 0));
    EXPECT_FALSE(store.can_undo());
    store.dispatch(action::Redo{});
    EXPECT_EQ(store.state().work, after);
    store.dispatch(action::SetFocal{90, 1});
    store.dispatch(action::SetRatio{1, 1.1F, 2});
    store.dispatch(action::SetFrame{2, 3});
    store.dispatch(action::Reset{});
    EXPECT_EQ(store.state().work, before);
}

TEST_F(SolidsTest, TheQuirkOfJellyCubesIsASwitchThatUndoTakesBack) {
    store.dispatch(action::SetRatio{1, 0.75F, 0});
    const std::vector<Polygon> right = store.derived().scene().polygons;
    store.dispatch(action::SetSizeTwice{true});
    EXPECT_TRUE(store.derived().scene().size_twice);
    EXPECT_NE(store.derived().scene().polygons, right);
    store.dispatch(action::ChooseTurning{{1}});
    ASSERT_NE(store.derived().jelly(), nullptr);
    EXPECT_EQ(store.derived().faces().size(), 6 + store.derived().jelly()->pieces.size());
    store.dispatch(action::Undo{});
    EXPECT_FALSE(store.derived().scene().size_twice);
    EXPECT_EQ(store.derived().scene().polygons, right);
}

TEST_F(SolidsTest, TurningMakesThePolygonsAnew) {
    store.dispatch(action::Turn{{0}, 2, 15, 0});
    Scene expected = solids_document()->scene;
    expected.meshes[0].rotate = turned_angles({20, 30, 0}, 2, 15);
    place_meshes(expected);
    EXPECT_EQ(store.derived().scene().polygons, expected.polygons);
    EXPECT_EQ(store.derived().faces().size(), place_meshes(expected).size());
}

TEST_F(SolidsTest, TheCursorStaysOnItsFaceWhileThatIsDrawn) {
    for (int n = 0; n < 72; ++n) {
        SCOPED_TRACE(n);
        const Polygon before = polygon();
        store.dispatch(action::Turn{{0}, n % 3, 5, 0});
        const auto& now = store.derived().scene().polygons;
        const bool still = std::any_of(
            now.begin(), now.end(), [&](const Polygon& p) { return p.mesh == before.mesh && p.face == before.face; });
        EXPECT_EQ(polygon().mesh, before.mesh);
        if (still) {
            EXPECT_EQ(polygon().face, before.face);
        }
        EXPECT_EQ(store.derived().steps().nearest(store.state().cursor.step, store.state().cursor.level),
                  store.state().cursor.step);
    }
}

TEST_F(SolidsTest, TheNearestStepIsSaidWhereTheFaceIsGone) {
    go_to_face(0, polygon().mesh == 0 ? polygon().face : 5);
    const int face = polygon().face;
    for (int n = 0; n < 40 && polygon().face == face; ++n) {
        EXPECT_TRUE(store.state().message.text.empty());
        store.dispatch(action::Turn{{0}, 1, 5, 0});
    }
    EXPECT_NE(polygon().face, face);
    EXPECT_EQ(polygon().mesh, 0);
    EXPECT_FALSE(store.state().message.text.empty());
}

TEST_F(SolidsTest, ALinkBringsTheSolidsBack) {
    store.dispatch(action::Turn{{0}, 1, 77.77, 0});
    store.dispatch(action::Turn{{1}, 0, -33.33, 0});
    store.dispatch(action::Turn{{1, true}, 2, 123.45, 0});
    store.dispatch(action::SetRatio{1, 0.73F, 0});
    store.dispatch(action::SetFocal{77.7F, 0});
    store.dispatch(action::SetFrame{2, 0});
    const std::string line = print_link(store.state());
    EXPECT_LE(line.size(), 400U) << line;
    const auto link = parse_link(line);
    ASSERT_TRUE(link) << link.error().text();
    EXPECT_EQ(link->work, store.state().work);
    EXPECT_EQ(link->cursor, store.state().cursor);
}

TEST_F(SolidsTest, ALinkWithFourTurnedSolidsStaysShort) {
    State state = store.state();
    for (int n = 0; n < 4; ++n)
        state.work.meshes.push_back({n, {-123.45F, -67.89F, -101.23F}, {-123.45F, -67.89F, -101.23F}, 0.73F});
    state.work.focal = 1234.5F, state.work.frame = 9;
    EXPECT_LE(print_link(state).size(), 400U) << print_link(state);
}

TEST_F(SolidsTest, DamagedMeshesInALinkAreRefused) {
    for (const char* field : {"r=0,1,2", "r=0,1,2,nan", "r=0,1,2,3,4,5,6,0", "c=-1", "c=inf", "f=-1", "f=x"}) {
        State state = store.state();
        const std::string line = print_link(state);
        const std::string fields = line.substr(13, line.size() - 13 - 9);
        EXPECT_TRUE(parse_link(with_checksum(fields)));
        EXPECT_FALSE(parse_link(with_checksum(fields + ";" + field))) << field;
    }
}

TEST_F(SolidsTest, OWithArrowsTurnsTheFrontThatWay) {
    go_to_face(0, polygon().mesh == 0 ? polygon().face : 5);
    const auto front = [&] {  // where the point nearest to the eye goes
        return rotation(mesh(0).rotate) * glm::transpose(rotation(glm::vec3(20, 30, 0))) * glm::dvec3(0, 0, -1);
    };
    press(Key::right);
    EXPECT_GT(front().x, 0.08);
    press(Key::left);
    press(Key::down);
    EXPECT_LT(front().y, -0.08);  // y is up
    press(Key::up);
    press(Key::z, false, true);
    const glm::dvec3 right =
        rotation(mesh(0).rotate) * glm::transpose(rotation(glm::vec3(20, 30, 0))) * glm::dvec3(1, 0, 0);
    EXPECT_NEAR(right.y, -std::sin(glm::radians(1.0)), 1e-3);
}

TEST_F(SolidsTest, OWithANumberChoosesAndAHeldKeyIsFewEntriesForUndo) {
    press(Key::n3);
    EXPECT_EQ(store.state().turning, (Turning{1, true}));
    const glm::vec3 big = mesh(1).rotate, small = mesh(1).rotate2;
    press(Key::right);
    for (int n = 0; n < 10; ++n) press(Key::right, true);
    EXPECT_EQ(mesh(1).rotate, big);
    EXPECT_NE(mesh(1).rotate2, small);
    press(Key::equal);
    EXPECT_FLOAT_EQ(mesh(1).ratio, 0.81F);
    for (int n = 0; n < 3; ++n) store.dispatch(action::Undo{});
    EXPECT_FALSE(store.can_undo());
    EXPECT_EQ(mesh(1).rotate2, small);
}

TEST_F(SolidsTest, FramesGoRoundAndAreOneUndoEntry) {
    const auto shown = [&] { return store.derived().scene().textures[0]; };
    const auto first = shown();
    EXPECT_EQ(store.derived().frames().count, 3);
    store.dispatch(action::PlayFrames{true});
    for (int n = 1; n <= 4; ++n) store.dispatch(action::SetFrame{store.state().work.frame + 1, -2});
    EXPECT_EQ(store.derived().frames().current, 1);
    EXPECT_NE(shown(), first);
    store.dispatch(action::Undo{});
    EXPECT_FALSE(store.state().moving) << "or the next frame would leave nothing to redo";
    EXPECT_EQ(shown(), first);
    EXPECT_FALSE(store.can_undo());
    store.dispatch(action::SetFrame{-1, 0});
    EXPECT_EQ(store.derived().frames().current, 2);
}

TEST_F(SolidsTest, CornersOfASolidAreNotMoved) {
    const auto before = store.derived().scene().polygons;
    store.dispatch(action::MoveVertex{{0, 0, false}, {3, 3}, 0});
    EXPECT_EQ(store.derived().scene().polygons, before);
    EXPECT_FALSE(store.state().message.text.empty());
}

TEST_F(SolidsTest, ThePictureOfHalfTransparentPiecesIsTheSameAllOver) {
    for (int n = 0; n < 6; ++n) {
        store.dispatch(action::Turn{{1, n % 2 == 1}, n % 3, 25, 0});
        store.dispatch(action::StepEnd{true});
        const Image& picture = store.derived().final_picture();
        const CanvasPicture& canvas = store.derived().canvas({store.derived().scene().framebuffer.rect(), 1});
        for (std::size_t i = 0; i < picture.size(); ++i) {
            ASSERT_EQ(canvas.cells.data()[i].now, picture.data()[i]) << n << ", pixel " << i;
            ASSERT_EQ(canvas.cells.data()[i].later, picture.data()[i]) << n << ", pixel " << i;
        }
        // From any shape on the rest is drawn over what stands there.
        store.dispatch(action::StepTo{Path{{{'t', store.derived().drawing().shape_count() * n / 6}}}});
        store.dispatch(action::Turn{{1}, 0, 3, 0});
        const Image& again = store.derived().final_picture();
        const CanvasPicture& now = store.derived().canvas({store.derived().scene().framebuffer.rect(), 1});
        for (std::size_t i = 0; i < again.size(); ++i)
            ASSERT_EQ(now.cells.data()[i].later, again.data()[i]) << n << ", pixel " << i;
    }
}

/// Of a scene without a lesson; how long a frame takes is for the window alone.
TEST(SolidsScreen, AnySceneWithASolidShowsItAndOnlyAWindowItsTime) {
    for (const bool timed : {false, true}) {
        auto app = Headless::start(opened(solids_document(), State{}), {1280, 720}, {.timed = timed});
        ASSERT_TRUE(app) << app.error().text();
        (*app)->settle();
        const ui::FrameReport& report = (*app)->shell().report();
        EXPECT_TRUE(std::any_of(report.controls.begin(), report.controls.end(),
                                [](const ui::ControlRecord& c) { return c.name == "solids/focal"; }));
        EXPECT_EQ(std::any_of(report.texts.begin(), report.texts.end(),
                              [](const ui::TextRecord& t) { return t.text.find(" ms") != std::string::npos; }),
                  timed);
    }
}

TEST(SolidsScreen, TheCutViewNamesTheLineOfItsQuirk) {
    auto app = Headless::start(*state_of("16-jelly-cubes", {.reduced_motion = true}), {1280, 720});
    ASSERT_TRUE(app) << app.error().text();
    (*app)->settle();
    const auto names_it = [&] {
        std::string all;
        for (const ui::TextRecord& t : (*app)->shell().report().texts) all += t.text;
        return all.find("size_twice?1/own") != std::string::npos;
    };
    EXPECT_FALSE(names_it());
    (*app)->store().dispatch(action::SetSizeTwice{true});
    (*app)->settle();
    EXPECT_TRUE(names_it());
}

/// The right button, pressed on the cube, dragged and let go.
TEST(SolidsMouse, ADragOnTheCanvasTurnsTheSolidUnderIt) {
    auto app = Headless::start(*state_of("15-solids", {.reduced_motion = true}), {1280, 720});
    ASSERT_TRUE(app) << app.error().text();
    (*app)->settle();
    const Work before = (*app)->state().work;
    const auto run = [&](glm::vec2 from, glm::vec2 to) {
        for (const ui::Input& input : drag((*app)->input, from, to, 6, 1)) (*app)->input = input, (*app)->frame();
    };
    run({150, 150}, {230, 180});  // the cube stands at the top left
    ASSERT_EQ((*app)->state().work.meshes.size(), 1U);
    EXPECT_EQ((*app)->state().work.meshes[0].mesh, 0);
    const Work once = (*app)->state().work;
    run({428, 458}, {410, 440});  // the torus at the bottom right
    ASSERT_EQ((*app)->state().work.meshes.size(), 2U);
    EXPECT_EQ((*app)->state().work.meshes[1].mesh, 3);
    (*app)->store().dispatch(action::Undo{});
    EXPECT_EQ((*app)->state().work, once);
    (*app)->store().dispatch(action::Undo{});
    EXPECT_EQ((*app)->state().work, before);
    EXPECT_FALSE((*app)->store().can_undo());
    run({900, 300}, {940, 300});  // beside the canvas
    EXPECT_EQ((*app)->state().work, before);
}

/// A window asks for frames only while textures move.
TEST(SolidsMouse, FramesRunByTheClockAndAnIdleWindowAsksForNone) {
    auto app = Headless::start(*state_of("15-solids", {.reduced_motion = true}), {1280, 720});
    ASSERT_TRUE(app) << app.error().text();
    (*app)->settle();
    const auto seconds = [&](double time) {
        const double end = (*app)->input.time + time;
        while ((*app)->input.time < end) (*app)->input = next_frame((*app)->input), (*app)->frame();
    };
    seconds(1);
    EXPECT_EQ((*app)->state().work.frame, 0);
    (*app)->input = press_key((*app)->input, {ui::Key::f});
    (*app)->frame();
    EXPECT_TRUE((*app)->state().moving);
    seconds(1);
    EXPECT_NEAR((*app)->state().work.frame, 8, 1);
    (*app)->input = press_key((*app)->input, {ui::Key::f});
    (*app)->frame();
    const int frame = (*app)->state().work.frame;
    seconds(1);
    EXPECT_EQ((*app)->state().work.frame, frame);
}

TEST_F(SolidsTest, NoNumberBreaksIt) {
    const float bad[] = {0, -1, 1e30F, INFINITY, -INFINITY, NAN};
    for (const float b : bad) {
        store.dispatch(action::Turn{{0}, 1, double{b}, 0});
        store.dispatch(action::SetRatio{1, b, 0});
        store.dispatch(action::SetRatio{0, b, 0});
        store.dispatch(action::SetFocal{b, 0});
        for (const int mesh : {-1, 2, 1 << 30}) {
            store.dispatch(action::Turn{{mesh}, 1, 5, 0});
            store.dispatch(action::ChooseTurning{{mesh}});
            store.dispatch(action::SetRatio{mesh, 1, 0});
            EXPECT_GE(store.derived().turning().mesh, 0);
        }
        for (const int axis : {-1, 3}) store.dispatch(action::Turn{{0}, axis, 5, 0});
        for (const int frame : {-1, 1 << 30, -(1 << 30)}) store.dispatch(action::SetFrame{frame, 0});
        EXPECT_TRUE(parse_link(print_link(store.state())));
    }
}

}  // namespace
}  // namespace texelscope
