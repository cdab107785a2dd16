// Frames in which nothing has changed draw no cell of a canvas again, in any lesson.
#include <gtest/gtest.h>

#include "app/shell/headless.h"

namespace texelscope {
namespace {

TEST(Idle, FramesDrawNoCellAgain) {
    std::vector<Error> faults;
    for (const Lesson& lesson : built_in_lessons(faults)) {
        auto app = Headless::start(*state_of(lesson.id, {.reduced_motion = true}), {1280, 720});
        ASSERT_TRUE(app) << lesson.id << ": " << app.error().text();
        (*app)->settle();
        const std::int64_t drawn = (*app)->store().derived().cells_drawn();
        for (int n = 0; n < 5; ++n) (*app)->frame();
        EXPECT_EQ((*app)->store().derived().cells_drawn(), drawn) << lesson.id;
    }
    EXPECT_TRUE(faults.empty());
}

}  // namespace
}  // namespace texelscope
