// Every lesson of the tree, looked at from all sides.
#include <gtest/gtest.h>

#include "app/platform/scripted_input.h"
#include "app/shell/check.h"
#include "app/state/link.h"
#include "tests/app/shell/laws.h"
#include "tests/cases.h"

namespace texelscope::shell_lessons_test {
namespace {

[[nodiscard]] std::vector<Lesson> lessons() {
    std::vector<Error> faults;
    std::vector<Lesson> found = built_in_lessons(faults);
    for (const Error& fault : faults) ADD_FAILURE() << fault.text();
    return found;
}

TEST(Lessons, AllPassCheck) {
    const std::vector<Lesson> all = lessons();
    ASSERT_FALSE(all.empty());
    for (const Lesson& lesson : all) {
        // Screens of each lesson take minutes under a sanitizer: those of every fourth are drawn there.
        const bool screens = !kSanitized || lesson.number % 4 == 0;
        const LessonCheck check = check_lesson(lesson.file, screens);
        for (const Error& fault : check.faults) ADD_FAILURE() << fault.text();
        EXPECT_EQ(check.beats, static_cast<int>(lesson.beats.size()));
        EXPECT_EQ(check.screens > 0, screens);
    }
}

TEST(Lessons, OpenWithinTwoKeysAndStepWithOneMore) {
    for (const Lesson& lesson : lessons()) {
        auto app = Headless::start(*state_of("1", {.reduced_motion = true}), {1280, 720});
        ASSERT_TRUE(app) << app.error().text();
        const auto press = [&](ui::Key key) {
            (*app)->input = press_key((*app)->input, {key});
            (*app)->frame();
        };
        press(ui::Key::l);
        const int n = lesson.number;
        press(static_cast<ui::Key>(n < 10 ? static_cast<int>(ui::Key::n0) + n : static_cast<int>(ui::Key::a) + n - 10));
        ASSERT_EQ((*app)->state().document->id, lesson.id);
        const Cursor before = (*app)->state().cursor;
        press(ui::Key::right);
        EXPECT_NE((*app)->state().cursor, before) << lesson.id;
    }
}

TEST(Lessons, RunFromStartToEndWithPageDownAlone) {
    for (const Lesson& lesson : lessons()) {
        auto app = Headless::start(*state_of(lesson.id, {.reduced_motion = true}), {1280, 720});
        ASSERT_TRUE(app) << app.error().text();
        for (std::size_t n = 0; n < lesson.beats.size(); ++n) {
            EXPECT_EQ((*app)->state().cursor.beat, static_cast<int>(n)) << lesson.id;
            EXPECT_EQ(broken_law(**app), "") << lesson.id << " beat " << n;
            (*app)->input = press_key((*app)->input, {ui::Key::page_down});
            (*app)->frame();
        }
        EXPECT_EQ((*app)->state().cursor.beat + 1, static_cast<int>(lesson.beats.size())) << lesson.id;
        EXPECT_FALSE((*app)->state().message.text.empty()) << lesson.id;
    }
}

TEST(Lessons, LinkStaysShort) {
    constexpr std::size_t kLongest = 400;
    for (const Lesson& lesson : lessons()) {
        auto state = state_of(lesson.id, {});
        ASSERT_TRUE(state) << state.error().text();
        Store store(*state);
        const auto corners = static_cast<int>(store.derived().scene().polygons.front().vertices.size());
        for (int n = 0; n < corners; ++n) {
            store.dispatch(action::MoveVertex{{0, n, false}, {12.34375F + static_cast<float>(n), 7.5625F}, n + 1});
        }
        EXPECT_LE(print_link(store.state()).size(), kLongest) << print_link(store.state());
    }
}

}  // namespace
}  // namespace texelscope::shell_lessons_test
