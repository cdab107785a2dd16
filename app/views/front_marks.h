// The marks of the front's picture: which colour, shape and letters a point has, and where it lies.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "app/ui/ui.h"
#include "core/measure/front.h"

namespace texelscope::front {

struct NumberKey {
    std::string_view id, title;
    ui::Role role;
};
/// By the numbers that u and v are computed in.
inline constexpr std::array<NumberKey, 5> kNumberKeys{{
    {"f64", "double", ui::Role::edge_a},
    {"f32", "float", ui::Role::u},
    {"fx16.16", "16.16 fixed point", ui::Role::v},
    {"fx8.8", "8.8 fixed point", ui::Role::section_2},
    {"exact", "whole numbers, exact", ui::Role::now},
}};
[[nodiscard]] ui::Role role_of(const FrontPoint& point);

/// `fast` and `exact`, whose marks are larger.
[[nodiscard]] inline bool is_large(const FrontPoint& p) { return p.kind == "fast" || p.kind == "exact"; }
/// A corrected method in a number format that no rung of the ladder is named for.
[[nodiscard]] bool is_plain(const FrontPoint& p);
/// On the front of those that draw pixel by pixel.
[[nodiscard]] inline bool leads(const FrontPoint& p) { return p.behind.empty() && p.kind != "fast"; }

/// "backward-affine" of a method's rung.
[[nodiscard]] std::string_view method_of(const FrontPoint& point);
/// "BA" for backward-affine, "SD" for subdivided: no two methods share theirs.
[[nodiscard]] std::string letters_of(std::string_view method);

/// Half a mark's width [px].
[[nodiscard]] float radius_of(const ui::Ui& ui, std::string_view kind);
struct MarkLook {
    bool filled = false;   ///< not beaten
    bool crossed = false;  ///< samples missing or extra
};
/// A circle for a method, a square for a kernel, a diamond for `fast` and `exact`.
void draw_mark(ui::Ui& ui, glm::vec2 at, std::string_view kind, const MarkLook& look, ui::Color color);

}  // namespace texelscope::front
