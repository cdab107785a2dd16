// Where every panel stands: a pure function of the window and of how it is looked at.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "app/state/state.h"
#include "app/ui/geometry.h"

namespace texelscope {

/// How the side's three places are cut.
enum class SideCut : std::uint8_t {
    usual,  ///< texels 208 wide beside the formula, code below
    face,   ///< lesson 14's: the face 248 wide beside the ring, both 264 high
};

/// Share of the window that the canvas panel has at least.
inline constexpr float kCanvasShare = .35F;
/// Text scale above which the side panels become one tabbed column. Narrow windows have it earlier.
inline constexpr float kTabbedAbove = 1.5F;

/// How much larger than in the reference text is: the person's choice, and while presenting the window's size.
/// @return  [1, 2.5]; while presenting in steps of 1/8, so that a window being resized bakes few sizes of type.
[[nodiscard]] float text_scale(glm::vec2 window, const Look& look);

/// Places in whole pixels. One with no area is not shown.
struct ScreenLayout {
    ui::Area header, canvas, timeline;  ///< always there
    ui::Area side;                      ///< all right of the canvas but the lesson's place: lists stand here
    std::array<ui::Area, 3> slots;      ///< small, wide, large; empty where the side has tabs
    ui::Area variables, lesson;         ///< empty where they are tabs
    ui::Area tabs, tab;                 ///< the strip, and what the chosen tab shows
    ui::Area caption;                   ///< while presenting
    bool tabbed = false;

    /// Those that are shown side by side: they cover the window and none overlaps another.
    [[nodiscard]] std::vector<ui::Area> panels() const;
};

/// @param window  [px], at least 1 x 1.
[[nodiscard]] ScreenLayout layout_screen(glm::vec2 window, const Look& look, SideCut cut = SideCut::usual);

}  // namespace texelscope
