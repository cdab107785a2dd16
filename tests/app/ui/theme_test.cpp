#include "app/ui/theme.h"

#include <vector>

#include <gtest/gtest.h>

namespace texelscope::ui {
namespace {

constexpr ThemeName kThemes[] = {ThemeName::dark, ThemeName::light, ThemeName::presenting};

TEST(Theme, LettersOnEveryGroundReachTheContrast) {
    for (const ThemeName name : kThemes) {
        const Theme t = make_theme(name);
        const Color now = t[Role::now];
        for (const Color ground : {t.bg, t.panel, t.raise, t.canvas, over(now, alpha::kChosenRow, t.panel),
                                   over(now, alpha::kMark, t.panel)}) {
            for (std::size_t r = 0; r < kRoleCount; ++r)
                EXPECT_GE(contrast(letter_color(t, static_cast<Role>(r), ground), ground), t.text_contrast())
                    << "theme " << static_cast<int>(name) << ", role " << r;
        }
    }
}

TEST(Theme, TextRolesKeepTheirOwnColorOnPanels) {
    for (const ThemeName name : kThemes) {
        const Theme t = make_theme(name);
        for (const Role r : {Role::text, Role::muted, Role::keyword, Role::comment, Role::now, Role::u, Role::v})
            EXPECT_EQ(letter_color(t, r, t.panel), t[r]) << static_cast<int>(name) << ' ' << static_cast<int>(r);
    }
}

TEST(Theme, TextOnNowIsLegibleAndWeakLettersTurnToIt) {
    for (const ThemeName name : kThemes) {
        const Theme t = make_theme(name);
        EXPECT_GE(contrast(t[Role::on_now], t[Role::now]), 4.5);
        EXPECT_GE(contrast(letter_color(t, Role::u, t[Role::now]), t[Role::now]), 4.5) << static_cast<int>(name);
    }
}

TEST(Theme, LinesAndHandlesReachThree) {
    for (const ThemeName name : kThemes) {
        const Theme t = make_theme(name);
        for (const Role r : {Role::now, Role::edge_a, Role::edge_b, Role::edge_c, Role::faint, Role::error}) {
            EXPECT_GE(contrast(t[r], t.panel), 3) << static_cast<int>(name) << ' ' << static_cast<int>(r);
            EXPECT_GE(contrast(t[r], t.canvas), 3) << static_cast<int>(name) << ' ' << static_cast<int>(r);
        }
    }
}

TEST(Theme, RolesOfASetDifferToEverySight) {
    const std::vector<std::vector<Role>> sets{
        {Role::edge_a, Role::edge_b, Role::edge_c},
        {Role::now, Role::u, Role::v},
        {Role::section_1, Role::section_2, Role::section_3, Role::section_4, Role::section_5},
        {Role::covered, Role::rejected},
    };
    for (const ThemeName name : kThemes) {
        const Theme t = make_theme(name);
        for (const auto& set : sets)
            for (std::size_t i = 0; i < set.size(); ++i)
                for (std::size_t j = i + 1; j < set.size(); ++j)
                    for (const Sight sight : kSights)
                        EXPECT_GE(difference(seen(t[set[i]], sight), seen(t[set[j]], sight)), 20)
                            << "theme " << static_cast<int>(name) << ", roles " << static_cast<int>(set[i]) << " and "
                            << static_cast<int>(set[j]) << ", sight " << static_cast<int>(sight);
    }
}

TEST(Theme, DarkHasTheMeasuredContrasts) {
    const Theme t = make_theme(ThemeName::dark);
    EXPECT_NEAR(contrast(t[Role::text], t.panel), 14.1, 0.05);
    EXPECT_NEAR(contrast(t[Role::muted], t.panel), 6.9, 0.05);
    EXPECT_NEAR(contrast(t[Role::v], over(t[Role::now], alpha::kChosenRow, t.panel)), 3.6, 0.05);
}

}  // namespace
}  // namespace texelscope::ui
