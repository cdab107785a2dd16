#include "app/views/view.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace texelscope {
namespace {

TEST(Views, AreInOrderOfTheirNamesWhichDiffer) {
    const auto all = views();
    const auto not_below = [](const View* a, const View* b) { return a->name >= b->name; };
    EXPECT_EQ(std::adjacent_find(all.begin(), all.end(), not_below), all.end());
}

TEST(Views, AreFoundByNameWithATitleAndSomethingToDraw) {
    for (const std::string_view name : {"formula", "code", "variables", "ring", "passes", "owners"}) {
        const View* view = find_view(name);
        ASSERT_NE(view, nullptr) << name;
        EXPECT_EQ(view->name, name);
        EXPECT_FALSE(view->title.empty()) << name;
        EXPECT_NE(view->draw, nullptr) << name;
    }
}

TEST(Views, OfAnotherNameAreNone) { EXPECT_EQ(find_view("nothing of the kind"), nullptr); }

}  // namespace
}  // namespace texelscope
