#include "app/state/keymap.h"

#include <set>

#include <gtest/gtest.h>

#include "app/state/lesson_table.h"
#include "tests/app/state/fixture.h"

namespace texelscope::keymap_test {
namespace {

using ui::Key;
using ui::KeyPress;

class KeymapTest : public testing::Test {
protected:
    [[nodiscard]] KeyOutcome press(const KeyPress& key, std::vector<Key> held = {}, bool typing = false) {
        ui::Input input;
        input.keys = {key};
        input.held = std::move(held);
        return actions_for(input, input.keys, typing, store.state(), store.derived(), {});
    }
    /// The only action that came of it.
    template <class A>
    [[nodiscard]] A only(const KeyOutcome& out) {
        EXPECT_EQ(out.actions.size(), 1U);
        EXPECT_TRUE(out.requests.empty());
        const A* a = out.actions.empty() ? nullptr : std::get_if<A>(&out.actions[0]);
        EXPECT_NE(a, nullptr);
        return a != nullptr ? *a : A{};
    }
    Store store{opened(quad_document(), {})};
};

TEST_F(KeymapTest, NoChordHasTwoCommandsInOnePlace) {
    std::set<std::tuple<Key, bool, bool, KeyPlace>> seen;
    for (const Binding& b : default_keymap()) {
        EXPECT_TRUE(seen.insert({b.chord.key, b.chord.ctrl, b.chord.shift, b.place}).second)
            << static_cast<int>(b.command);
    }
}

TEST_F(KeymapTest, EveryCommandHasAKey) {
    std::set<Command> bound;
    for (const Binding& b : default_keymap()) bound.insert(b.command);
    EXPECT_EQ(bound.size(), static_cast<std::size_t>(Command::escape) + 1);
}

TEST_F(KeymapTest, ArrowsStepAndChangeTheLevel) {
    EXPECT_EQ(only<action::Step>(press({Key::right})).count, 1);
    EXPECT_EQ(only<action::Step>(press({Key::left})).count, -1);
    EXPECT_EQ(only<action::Finer>(press({Key::down})).count, 1);
    EXPECT_EQ(only<action::Finer>(press({Key::up})).count, -1);
}

TEST_F(KeymapTest, ClickersGoThroughTheLesson) {
    EXPECT_EQ(only<action::Advance>(press({Key::page_down})).count, 1);
    EXPECT_EQ(only<action::Advance>(press({Key::page_up})).count, -1);
}

TEST_F(KeymapTest, WhileTextIsTypedLettersDoNothing) {
    for (int k = static_cast<int>(Key::a); k <= static_cast<int>(Key::right_bracket); ++k) {
        const KeyOutcome out = press({static_cast<Key>(k)}, {}, true);
        EXPECT_TRUE(out.actions.empty() && out.requests.empty()) << k;
    }
    EXPECT_TRUE(press({Key::right}, {}, true).actions.empty());
}

TEST_F(KeymapTest, WExchangesArrayPassesAndPixelLoop) {
    const QuirkSet before = store.state().work.quirks;
    const auto w = only<action::SetQuirk>(press({Key::w}));
    EXPECT_EQ(store.derived().method().quirks[static_cast<std::size_t>(w.index)].field, "arrays");
    EXPECT_TRUE(w.on);
    store.dispatch(w);
    EXPECT_NE(store.state().work.quirks, before);
    const auto back = only<action::SetQuirk>(press({Key::w}));
    EXPECT_EQ(back.index, w.index);
    EXPECT_FALSE(back.on);
    store.dispatch(action::Undo{});
    EXPECT_EQ(store.state().work.quirks, before);
}

TEST_F(KeymapTest, WSaysSoWhereTheMethodHasNoArrays) {
    store.dispatch(action::SetMethod{"sections"});
    const auto said = only<action::Say>(press({Key::w}));
    EXPECT_NE(said.message.text.find("no array passes"), std::string::npos);
    EXPECT_FALSE(said.message.error);
}

TEST_F(KeymapTest, SingleLettersCanBeSwitchedOff) {
    Look look;
    look.letter_keys = false;
    store.dispatch(action::SetLook{look});
    for (const Key key : {Key::h, Key::x, Key::r, Key::t, Key::p, Key::m, Key::l})
        EXPECT_TRUE(press({key}).actions.empty());
    EXPECT_EQ(press({Key::z, true}).actions.size(), 1U);
}

TEST_F(KeymapTest, DShowsTheDifferenceInTheTabThatIsOpenAndTakesItAway) {
    Look look = store.state().look;
    look.tab = 2;
    store.dispatch(action::SetLook{look});
    store.dispatch(only<action::SetLook>(press({Key::d})));
    EXPECT_TRUE(store.state().look.difference);
    EXPECT_EQ(store.state().look.tab, 0);
    store.dispatch(only<action::SetLook>(press({Key::d})));
    EXPECT_FALSE(store.state().look.difference);
    EXPECT_FALSE(store.can_undo());
}

TEST_F(KeymapTest, VWithPlusAndMinusDoublesADepthInEightPresses) {
    store.dispatch(action::ChooseHandle{{0, 2, false}});
    const auto depth = [&] { return store.derived().scene().polygons[0].vertices[2].w; };
    for (int n = 0; n < 8; ++n) store.dispatch(only<action::SetDepth>(press({Key::equal}, {Key::v})));
    EXPECT_EQ(depth(), 2);
    for (int n = 0; n < 16; ++n) store.dispatch(only<action::SetDepth>(press({Key::minus}, {Key::v})));
    EXPECT_EQ(depth(), .5F);
    store.dispatch(only<action::SetDepth>(press({Key::equal, true}, {Key::v})));
    EXPECT_EQ(depth(), 1);
    store.dispatch(action::Undo{});
    EXPECT_EQ(depth(), .5F);
}

TEST_F(KeymapTest, VWithDTakesTheOtherDiagonal) {
    EXPECT_EQ(only<action::TurnRing>(press({Key::d}, {Key::v})).polygon, 0);
    EXPECT_TRUE(press({.key = Key::d, .repeat = true}, {Key::v}).actions.empty());
}

TEST_F(KeymapTest, KShowsThePaletteInTheFirstTabAndHidesIt) {
    Look look;
    look.tab = 2;
    store.dispatch(action::SetLook{look});
    const Look shown = only<action::SetLook>(press({Key::k})).look;
    EXPECT_TRUE(shown.palette);
    EXPECT_EQ(shown.tab, 0);
    store.dispatch(action::SetLook{shown});
    EXPECT_FALSE(only<action::SetLook>(press({Key::k})).look.palette);
}

TEST_F(KeymapTest, VWithAnArrowMovesACornerByOnePixel) {
    const Handle handle{0, 1, false};
    store.dispatch(action::ChooseHandle{handle});
    const glm::vec2 at = position_of(store.derived().scene(), handle);
    const auto moved = [&](const KeyPress& key) { return only<action::MoveVertex>(press(key, {Key::v})).to - at; };
    EXPECT_EQ(moved({Key::right}), glm::vec2(1, 0));
    EXPECT_EQ(moved({Key::up}), glm::vec2(0, -1));
    EXPECT_EQ(moved({Key::left, false, true}), glm::vec2(-1.0F / 16, 0));
    EXPECT_EQ(moved({Key::down, true}), glm::vec2(0, 8));
}

TEST_F(KeymapTest, VWithANumberChoosesTheCorner) {
    EXPECT_EQ(only<action::ChooseHandle>(press({Key::n3}, {Key::v})).handle, (Handle{0, 2, false}));
    EXPECT_TRUE(press({Key::n9}, {Key::v}).actions.empty()) << "the quad has four corners";
}

TEST_F(KeymapTest, AHeldKeyIsFewEntriesForUndo) {
    store.dispatch(action::ChooseHandle{{0, 0, false}});
    const auto move = [&](bool repeat) {
        for (const Action& a : press({.key = Key::right, .repeat = repeat}, {Key::v}).actions) store.dispatch(a);
    };
    move(false);
    for (int n = 0; n < 20; ++n) move(true);
    EXPECT_EQ(position_of(store.derived().scene(), {0, 0, false}).x, 4 + 21);
    store.dispatch(action::Undo{});
    store.dispatch(action::Undo{});
    EXPECT_FALSE(store.can_undo());
    EXPECT_EQ(position_of(store.derived().scene(), {0, 0, false}).x, 4);
}

TEST_F(KeymapTest, IWithArrowsPinsAPixelInsideTheFrame) {
    Selection pinned;
    pinned.kind = Selection::Kind::pixel, pinned.at = {31, 5};
    store.dispatch(action::Pin{pinned});
    EXPECT_TRUE(press({Key::right}, {Key::i}).actions.empty()) << "at the border already; pinning again would let go";
    EXPECT_EQ(only<action::Pin>(press({Key::left, true}, {Key::i})).what.at, (glm::ivec2{23, 5}));
}

TEST_F(KeymapTest, AnyLessonIsTwoPressesAway) {
    EXPECT_EQ(only<action::Show>(press({Key::l})).overlay, Overlay::lessons);
    store.dispatch(action::Show{Overlay::lessons});
    for (int n = 1; n <= kCurriculum; ++n) {
        const KeyOutcome out = press({*key_of_lesson(n)});
        ASSERT_EQ(out.requests.size(), 1U);
        EXPECT_EQ(out.requests[0], (ShellRequest{ShellRequest::What::open_lesson, n}));
        EXPECT_EQ(lesson_of_key(*key_of_lesson(n)), n);
    }
}

TEST_F(KeymapTest, TheListsArrowsChooseAndEnterOpens) {
    store.dispatch(action::Show{Overlay::lessons});
    store.dispatch(action::ChooseLesson{3});
    EXPECT_EQ(only<action::ChooseLesson>(press({Key::down})).index, 4);
    EXPECT_EQ(only<action::ChooseLesson>(press({Key::up})).index, 2);
    EXPECT_EQ(only<action::ChooseLesson>(press({Key::right})).index, 14);
    EXPECT_EQ(only<action::ChooseLesson>(press({Key::left})).index, 0);
    const KeyOutcome out = press({Key::enter});
    ASSERT_EQ(out.requests.size(), 1U);
    EXPECT_EQ(out.requests[0].lesson, 4);
}

TEST_F(KeymapTest, WithTheListOpenPagesStillGoThroughTheLesson) {
    store.dispatch(action::Show{Overlay::lessons});
    EXPECT_EQ(only<action::Advance>(press({Key::page_down})).count, 1);
}

TEST_F(KeymapTest, BlankingIsForPresenting) {
    EXPECT_TRUE(press({Key::period}).actions.empty());
    Look look;
    look.presenting = true;
    store.dispatch(action::SetLook{look});
    EXPECT_TRUE(only<action::SetLook>(press({Key::period})).look.blank);
    EXPECT_TRUE(only<action::SetLook>(press({Key::b})).look.blank);
}

TEST_F(KeymapTest, TextScalesWithinItsRange) {
    for (int n = 0; n < 10; ++n) store.dispatch(press({Key::equal, true}).actions.at(0));
    EXPECT_EQ(store.state().look.scale, 2.5F);
    for (int n = 0; n < 10; ++n) store.dispatch(press({Key::minus, true}).actions.at(0));
    EXPECT_EQ(store.state().look.scale, 1.0F);
}

TEST_F(KeymapTest, FilesAndTheClipboardAreTheShells) {
    using What = ShellRequest::What;
    const std::vector<std::pair<Key, What>> all{{Key::s, What::save},
                                                {Key::o, What::open_file},
                                                {Key::e, What::export_picture},
                                                {Key::c, What::copy_link},
                                                {Key::v, What::paste}};
    for (const auto& [key, what] : all) {
        const KeyOutcome out = press({key, true});
        ASSERT_EQ(out.requests.size(), 1U);
        EXPECT_EQ(out.requests[0].what, what);
    }
}

TEST_F(KeymapTest, AKeymapCanBeReplaced) {
    ui::Input input;
    input.keys = {{Key::n5}};
    const std::array remapped{Binding{{Key::n5}, Command::step_forward}};
    const KeyOutcome out = actions_for(input, input.keys, false, store.state(), store.derived(), {}, remapped);
    EXPECT_EQ(only<action::Step>(out).count, 1);
}

TEST(LessonTable, HasEveryLessonOnceAndTakesWhatFilesSay) {
    Lesson five, extra;
    five.number = 5, five.title = "Another title", five.id = "05-x";
    extra.number = 30, extra.title = "A lecturer's own", extra.group = "Own";
    const std::array lessons{extra, five};
    const std::vector<LessonEntry> entries = lesson_entries(lessons);
    ASSERT_EQ(entries.size(), 22U);
    for (int n = 0; n < kCurriculum; ++n) {
        const LessonEntry& e = entries[static_cast<std::size_t>(n)];
        EXPECT_EQ(e.number, n + 1);
        EXPECT_FALSE(e.title.empty() || e.group.empty() || e.summary.empty());
        EXPECT_EQ(e.lesson != nullptr, n == 4);
    }
    EXPECT_EQ(entries[4].title, "Another title");
    EXPECT_EQ(entries[21].title, "A lecturer's own");
}

}  // namespace
}  // namespace texelscope::keymap_test
