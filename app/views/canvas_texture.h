// A texture with what a shape does to it: where texels lie in a panel, and the marks that texels.cpp and face.cpp
// share.
#pragma once

#include <string>

#include "app/views/view.h"

namespace texelscope::canvas {

/// Texels in the window. Outside the texture its repetitions are in view as far as the shape reaches.
struct TexelMap {
    ui::Area area;    ///< what the texture and its arrows may cover
    Rect range;       ///< texels in view, those of repetitions too
    Rect texture;     ///< (0, 0) to its size
    double zoom = 1;  ///< window pixels per texel
    glm::vec2 at{0};  ///< of the range's top left corner

    [[nodiscard]] glm::vec2 to_window(glm::dvec2 uv) const {
        return at + glm::vec2((uv - glm::dvec2(range.x0, range.y0)) * zoom);
    }
    [[nodiscard]] glm::dvec2 to_texel(glm::vec2 window) const {
        return glm::dvec2(range.x0, range.y0) + glm::dvec2(window - at) / zoom;
    }
    [[nodiscard]] ui::Area place_of(const Rect& texels) const;
    [[nodiscard]] ui::Area place_of(glm::ivec2 texel) const {
        return place_of(Rect{texel.x, texel.y, texel.x + 1, texel.y + 1});
    }
};

/// Leaves room for the arrows at the left and at the top of `area`.
[[nodiscard]] TexelMap make_texel_map(const ui::Ui& ui, const ui::Area& area, const Texture& texture,
                                      std::span<const Vertex> corners);

/// The corners of the cursor's shape; none without one.
[[nodiscard]] std::span<const Vertex> corners_of(const Derived& derived);
/// "16 × 16, mask".
[[nodiscard]] std::string texture_note(const Texture& texture);

void draw_texture(const ViewContext& ctx, const TexelMap& map, std::string_view key);
void draw_uv_arrows(const ViewContext& ctx, const TexelMap& map);
/// The sides in their styles, or a polygon's white outline, over black.
void draw_texture_outline(const ViewContext& ctx, const TexelMap& map);
/// Rings at the corners; where the lesson allows, controls that move (u, v).
void draw_texture_corners(const ViewContext& ctx, const TexelMap& map);
/// Rings around the current texel, those hovered and pinned, and those that answer.
void draw_texel_marks(const ViewContext& ctx, const TexelMap& map);
/// Hovering, pinning and answering.
void take_texel_input(const ViewContext& ctx, const TexelMap& map, std::string_view name);

}  // namespace texelscope::canvas
