#include "app/views/layout.h"

#include <array>
#include <functional>

#include <gtest/gtest.h>

namespace texelscope {
namespace {

using ui::Area;

constexpr std::array kSizes{glm::vec2{800, 600},   glm::vec2{1024, 768},  glm::vec2{1280, 720},
                            glm::vec2{1366, 768},  glm::vec2{1600, 1200}, glm::vec2{1920, 1080},
                            glm::vec2{2560, 1080}, glm::vec2{3840, 2160}, glm::vec2{900, 1400}};
constexpr std::array kScales{1.0F, 1.25F, 1.5F, 2.0F, 2.5F};

/// Every size, scale, cut and mode.
void for_each_layout(const std::function<void(glm::vec2, const Look&, const ScreenLayout&)>& check) {
    for (const glm::vec2 size : kSizes) {
        for (const float scale : kScales) {
            for (const bool presenting : {false, true}) {
                for (const SideCut cut : {SideCut::usual, SideCut::face}) {
                    Look look;
                    look.scale = scale, look.presenting = presenting;
                    SCOPED_TRACE(testing::Message() << size.x << "x" << size.y << " scale " << scale << " presenting "
                                                    << presenting << " face " << (cut == SideCut::face));
                    check(size, look, layout_screen(size, look, cut));
                }
            }
        }
    }
}

TEST(Layout, PanelsNeverOverlap) {
    for_each_layout([](glm::vec2, const Look&, const ScreenLayout& at) {
        const std::vector<Area> all = at.panels();
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t k = i + 1; k < all.size(); ++k) {
                EXPECT_TRUE(intersection(all[i], all[k]).empty()) << i << " and " << k;
            }
        }
    });
}

TEST(Layout, PanelsCoverTheWindowExactly) {
    for_each_layout([](glm::vec2 size, const Look&, const ScreenLayout& at) {
        float area = 0;
        for (const Area& a : at.panels()) {
            EXPECT_TRUE((Area{0, 0, size.x, size.y}.covers(a)));
            area += a.w * a.h;
        }
        EXPECT_EQ(area, size.x * size.y);
    });
}

TEST(Layout, PlacesAreWholePixels) {
    for_each_layout([](glm::vec2, const Look&, const ScreenLayout& at) {
        for (const Area& a : at.panels()) {
            for (const float v : {a.x, a.y, a.w, a.h}) EXPECT_EQ(v, std::floor(v));
        }
    });
}

TEST(Layout, TheCanvasPanelHasItsShareOfTheWindow) {
    for_each_layout([](glm::vec2 size, const Look&, const ScreenLayout& at) {
        EXPECT_GE(at.canvas.w * at.canvas.h, kCanvasShare * size.x * size.y);
    });
}

TEST(Layout, CanvasTimelineAndHeaderNeverVanish) {
    for_each_layout([](glm::vec2, const Look&, const ScreenLayout& at) {
        for (const Area& a : {at.canvas, at.timeline, at.header}) {
            EXPECT_GE(a.w, 64);
            EXPECT_GE(a.h, 32);
        }
    });
}

TEST(Layout, TheLessonIsAlwaysSomewhere) {
    for_each_layout([](glm::vec2, const Look&, const ScreenLayout& at) {
        EXPECT_TRUE(!at.lesson.empty() || (at.tabbed && !at.tab.empty()));
    });
}

TEST(Layout, LargeTextMakesTheSideOneTabbedColumn) {
    for (const float scale : {1.6F, 2.0F, 2.5F}) {
        Look look;
        look.scale = scale;
        EXPECT_TRUE(layout_screen({3840, 2160}, look).tabbed);
    }
}

TEST(Layout, TinyWindowsHaveNoNegativePlaces) {
    for (const glm::vec2 size : {glm::vec2{1, 1}, glm::vec2{20, 300}, glm::vec2{300, 20}, glm::vec2{0, -5}}) {
        for (const float scale : kScales) {
            Look look;
            look.scale = scale;
            for (const Area& a : layout_screen(size, look).panels())
                EXPECT_TRUE(a.x >= 0 && a.y >= 0 && a.w > 0 && a.h > 0);
        }
    }
}

TEST(Layout, TheReferenceIsLooksTable) {
    const ScreenLayout at = layout_screen({1280, 720}, {});
    EXPECT_EQ(at.header, (Area{0, 0, 1280, 40}));
    EXPECT_EQ(at.canvas, (Area{0, 40, 656, 496}));
    EXPECT_EQ(at.slots[0], (Area{656, 40, 208, 208}));
    EXPECT_EQ(at.slots[1], (Area{864, 40, 416, 208}));
    EXPECT_EQ(at.slots[2], (Area{656, 248, 624, 288}));
    EXPECT_EQ(at.side, (Area{656, 40, 624, 496}));
    EXPECT_EQ(at.variables, (Area{0, 536, 656, 96}));
    EXPECT_EQ(at.lesson, (Area{656, 536, 624, 96}));
    EXPECT_EQ(at.timeline, (Area{0, 632, 1280, 88}));
}

TEST(Layout, LessonFourteenHasALargerFace) {
    const ScreenLayout at = layout_screen({1280, 720}, {}, SideCut::face);
    EXPECT_EQ(at.slots[0], (Area{656, 40, 248, 264}));
    EXPECT_EQ(at.slots[1], (Area{904, 40, 376, 264}));
    EXPECT_EQ(at.slots[2], (Area{656, 304, 624, 232}));
}

TEST(Layout, PresentingIsLooksTable) {
    Look look;
    look.presenting = true;
    const ScreenLayout at = layout_screen({1280, 720}, look);
    EXPECT_EQ(at.header, (Area{0, 0, 1280, 56}));
    EXPECT_EQ(at.canvas, (Area{0, 56, 656, 496}));
    EXPECT_EQ(at.tabs, (Area{656, 56, 624, 56}));
    EXPECT_EQ(at.tab, (Area{656, 112, 624, 440}));
    EXPECT_EQ(at.caption, (Area{0, 552, 1280, 72}));
    EXPECT_EQ(at.timeline, (Area{0, 624, 1280, 96}));
}

TEST(Layout, WhilePresentingTextGrowsWithTheWindowAlone) {
    Look look;
    look.presenting = true;
    EXPECT_EQ(text_scale({1280, 720}, look), 1);
    EXPECT_EQ(text_scale({1920, 1080}, look), 1.5F);
    EXPECT_EQ(text_scale({2560, 1080}, look), 1.5F);
    look.scale = 1.5F;
    EXPECT_EQ(text_scale({1280, 720}, look), 1);
    look.presenting = false;
    EXPECT_EQ(text_scale({1920, 1080}, look), 1.5F);
    EXPECT_GE(layout_screen({1920, 1080}, look).header.h, 1.25F * 40);
}

TEST(Layout, LargerTextKeepsTheLessonInSight) {
    Look look;
    look.scale = 1.5F;
    EXPECT_FALSE(layout_screen({1280, 720}, look).lesson.empty());
}

TEST(Layout, FullHdShowsThirtyPixelsAPixel) {
    const ScreenLayout at = layout_screen({1920, 1080}, {});
    EXPECT_GE(at.canvas.w - 16, 960);
    EXPECT_GE(at.canvas.h - 16, 720);
    EXPECT_LT(at.canvas.w - 16, 1024);
    EXPECT_FALSE(at.tabbed);
}

}  // namespace
}  // namespace texelscope
