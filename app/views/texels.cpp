// The texture, with the shape as it is mapped onto it and the way of the current row through it.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/views/canvas_texture.h"
#include "app/views/canvas_values.h"

namespace texelscope::canvas::texels_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Texels";
constexpr std::size_t kMostDots = 400;  ///< samples of a row that are drawn as dots; more would be a line
constexpr float kRoomy = 9;             ///< samples so far apart have full dots [px at 100 %]
constexpr float kLeastApart = 3.2F;     ///< nearer ones are the line alone [px]

/// Whether a sample of the current row lies before or at the cursor's.
[[nodiscard]] std::size_t done_count(const Derived& derived, const std::vector<Sample>& samples) {
    const auto pixel = derived.pixel();
    if (!pixel) return samples.size();
    const auto at = std::find_if(samples.begin(), samples.end(),
                                 [&](const Sample& s) { return s.x == pixel->x && s.y == pixel->y; });
    return static_cast<std::size_t>(at - samples.begin()) + (at != samples.end() ? 1 : 0);
}

/// A sample of the row on the texture.
struct Stop {
    glm::vec2 at;
    bool done;
};

/// Dots that would run into a bar: smaller ones, each apart from the next, those to come in grey.
void draw_close(ImDrawList& list, const std::vector<Stop>& path, float away, ui::Color now) {
    const float radius = std::max(1.0F, away * .3F);
    ui::line(list, path.front().at, path.back().at, 2 * radius + 3, IM_COL32(0, 0, 0, 255));
    for (const Stop& stop : path)
        list.AddCircleFilled(ui::to_im(stop.at), radius, stop.done ? now : IM_COL32(150, 150, 150, 255), 12);
}

void draw_path(const ViewContext& ctx, const TexelMap& map) {
    const std::vector<Sample>& samples = ctx.derived.row_samples();
    const std::size_t done = done_count(ctx.derived, samples);
    std::vector<Stop> path;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const Sample& s = samples[n];
        if (s.fate != Fate::written || !std::isfinite(s.u) || !std::isfinite(s.v)) continue;
        if (std::abs(s.u) < 1e5 && std::abs(s.v) < 1e5) path.push_back({map.to_window({s.u, s.v}), n < done});
    }
    ImDrawList& list = ctx.ui.list();
    const ui::Color black = IM_COL32(0, 0, 0, 255), now = ctx.ui.theme().name == ui::ThemeName::light
                                                              ? IM_COL32(255, 255, 255, 255)
                                                              : ctx.ui.theme()[Role::now];
    if (path.size() > 1) {
        ui::line(list, path.front().at, path.back().at, 4, black);
        ui::line(list, path.front().at, path.back().at, 1.4F, now);
    }
    if (path.size() > kMostDots) return;
    const float away = path.size() > 1
                           ? glm::length(path.back().at - path.front().at) / static_cast<float>(path.size() - 1)
                           : ctx.ui.px(kRoomy);
    if (away < kLeastApart) return;
    if (away < ctx.ui.px(kRoomy)) return draw_close(list, path, away, now);
    const float radius = ctx.ui.px(2.6F);
    for (const Stop& stop : path) {
        list.AddCircleFilled(ui::to_im(stop.at), radius + 1, black, 12);
        list.AddCircleFilled(ui::to_im(stop.at), radius, now, 12);
        if (!stop.done) list.AddCircleFilled(ui::to_im(stop.at), radius - 1.1F, black, 12);
    }
}

void draw(const ViewContext& ctx, const ui::Area& place) {
    ui::Ui& ui = ctx.ui;
    const Texture& texture = ctx.derived.texture();
    const ui::Area content = ui.begin_panel("texels", place, ui.presenting() ? std::string_view{} : kTitle,
                                            ui.presenting() ? std::string() : texture_note(texture));
    const TexelMap map = make_texel_map(ui, content, texture, corners_of(ctx.derived));
    ui.begin_clip(content.inset(-ui.px(6), -ui.px(4)));
    take_texel_input(ctx, map, "texels");
    draw_texture(ctx, map, "texels");
    draw_uv_arrows(ctx, map);
    draw_texture_outline(ctx, map);
    draw_path(ctx, map);
    draw_texture_corners(ctx, map);
    draw_texel_marks(ctx, map);
    ui.end_clip();
    ui.end_panel();
}

constexpr View kView{"texels", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::texels_view
