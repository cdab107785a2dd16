// The colours of the screen by role, and the lengths that do not depend on what is shown.
#pragma once

#include <array>
#include <cstdint>

#include "app/ui/color.h"

namespace texelscope::ui {

/// What a coloured thing means. One role has one colour on the canvas, in formulas, code and tables.
// clang-format off
enum class Role : std::uint8_t {
    text, muted, keyword, comment, faint, now, on_now, edge_a, edge_b, edge_c, u, v, covered, rejected,
    section_1, section_2, section_3, section_4, section_5, error,
};
// clang-format on
inline constexpr std::size_t kRoleCount = 20;

/// `presenting` is dark with the contrasts a projector needs (7:1); there is no light one.
enum class ThemeName : std::uint8_t { dark, light, presenting };

struct Theme {
    ThemeName name = ThemeName::dark;
    Color bg = 0, panel = 0, raise = 0, canvas = 0;  ///< grounds: header and timeline, panels, buttons, the canvas
    Color hairline = 0, grid = 0;                    ///< borders; lines between pixels
    Color outline = 0;  ///< inside `now` rings and around marks on textures; near black in every theme
    std::array<Color, kRoleCount> role{};

    [[nodiscard]] Color operator[](Role r) const { return role[static_cast<std::size_t>(r)]; }
    /// Least contrast of text.
    [[nodiscard]] double text_contrast() const { return name == ThemeName::presenting ? 7.0 : 4.5; }
};

[[nodiscard]] Theme make_theme(ThemeName name);

[[nodiscard]] constexpr Role edge_role(int edge) {
    return edge == 0 ? Role::edge_a : edge == 1 ? Role::edge_b : Role::edge_c;
}
/// @param section  from 0; five colours, then again from the first.
[[nodiscard]] constexpr Role section_role(int section) {
    return static_cast<Role>(static_cast<int>(Role::section_1) + section % 5);
}

/// `r`'s colour for letters on `ground` (opaque), or, where that is too weak to read, the text colour (on a
/// fill of `now`, text-on-now).
[[nodiscard]] Color letter_color(const Theme& theme, Role r, Color ground);

/// Alpha of `now` where it tints.
namespace alpha {
inline constexpr float kRowBand = .10F, kChosenRow = .13F, kMark = .16F, kFunnel = .14F, kFunnelEdge = .60F;
inline constexpr float kRowBorder = .55F, kCoarseLane = .45F;
inline constexpr float kNotYet = .20F;      ///< of a pixel's own colour, before it is drawn
inline constexpr float kLaneFuture = .38F;  ///< of a lane's cell, after the current tick
inline constexpr float kSectionFill = .50F, kSectionHatch = .85F;
}  // namespace alpha

/// Lengths at 100 % [px].
namespace size {
inline constexpr float kGrid = 8, kPadding = 12, kTitleBaseline = 17, kContentTop = 24, kHairline = 1;
inline constexpr float kRadius = 4, kBadgeRadius = 3;
inline constexpr float kHeaderButton = 24, kAnswerButton = 28, kTransport = 32, kTransportPitch = 34;
inline constexpr float kPresentingButton = 48;
inline constexpr float kLeastTarget = 24, kVertexGrab = 16, kVertexRing = 7.5F, kVertexRingPresenting = 9.5F;
inline constexpr float kEdge = 2.2F, kEdgePresenting = 3.4F, kHalo = 2.4F;
inline constexpr float kFocusRing = 2, kFocusOutset = 2;
}  // namespace size

}  // namespace texelscope::ui
