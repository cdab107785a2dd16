// The face of a polygon drawn in sections: the same sections as on the canvas, on the texture.
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/ui/text.h"
#include "app/views/canvas_sections.h"
#include "app/views/canvas_texture.h"
#include "app/views/canvas_values.h"

namespace texelscope::canvas::face_view {
namespace {

using ui::Role;

constexpr std::string_view kTitle = "Face";
constexpr float kVeil = .45F, kHatchStep = 6, kAheadFill = .22F, kAheadHatch = .45F;

using Quad = std::array<glm::vec2, 4>;

[[nodiscard]] Quad quad_of(const TexelMap& map, const SectionShape& s) {
    const auto at = [&](const RingPoint& p) { return map.to_window({p.u, p.v}); };
    return {at(s.left_top), at(s.right_top), at(s.right_bottom), at(s.left_bottom)};
}

void draw_region(const ViewContext& ctx, const Quad& quad, int index, bool begun) {
    const ui::Color color = ctx.ui.theme()[ui::section_role(index)];
    ui::fill_convex(ctx.ui.list(), quad, ui::with_alpha(color, begun ? ui::alpha::kSectionFill : kAheadFill));
    ui::draw_hatch(ctx.ui.list(), quad, ui::section_degrees(index), ctx.ui.px(kHatchStep), quad[0], 1.4F,
                   ui::with_alpha(color, begun ? ui::alpha::kSectionHatch : kAheadHatch));
}

void draw_border(const ViewContext& ctx, const Quad& above) {
    static constexpr std::array<float, 2> kDashes{5, 4};
    const std::array<glm::vec2, 2> path{above[3], above[2]};
    ui::draw_dashed(ctx.ui.list(), path, {}, 3, ctx.ui.theme().outline);
    ui::draw_dashed(ctx.ui.list(), path, kDashes, 1.4F, IM_COL32(255, 255, 255, 230));
}

void draw_number(const ViewContext& ctx, const Quad& quad, int index, const ui::Area& within) {
    ui::Ui& ui = ctx.ui;
    const float side = std::round(ui.font(ui::Face::code_strong).em * 1.6F);
    const glm::vec2 middle = (quad[0] + quad[1] + quad[2] + quad[3]) / 4.0F;
    const glm::vec2 low(within.x, within.y), high(within.right() - side, within.bottom() - side);
    const glm::vec2 at = glm::round(glm::clamp(middle - side / 2, low, glm::max(low, high)));
    const ui::Area place{at.x, at.y, side, side};
    const ui::Color plain = ui.ground();
    ui.set_ground(ui.theme().outline);
    ui::fill(ui.list(), place, ui.ground(), ui::size::kRadius);
    ui::frame(ui.list(), place, ui.theme()[ui::section_role(index)], 1.5F, ui::size::kRadius);
    const bool light = ui.theme().name == ui::ThemeName::light;
    ui.text_centred(ui::Face::code_strong, place, light ? Role::on_now : Role::text, fmt::format("{}", index + 1));
    ui.set_ground(plain);
}

/// The letter of a row's end, further out than the end.
void draw_end(const ViewContext& ctx, glm::vec2 end, glm::vec2 outward, std::string_view name, const ui::Area& within) {
    ui::Ui& ui = ctx.ui;
    const ui::MathBox letter =
        ui::set_math(ui::coloured(ui::symbol(name), Role::now), {.fonts = &ui.fonts(), .size = ui::MathSize::prose});
    const float em = ui.font(ui::Face::prose).em;
    const glm::vec2 size{std::ceil(letter.width) + ui.px(8), std::round(1.25F * em)};
    const glm::vec2 low(within.x, within.y), high = glm::vec2(within.right(), within.bottom()) - size;
    const glm::vec2 middle = end + outward * (ui.px(8) + size.x / 2);
    const glm::vec2 at = glm::round(glm::clamp(middle - size / 2.0F, low, glm::max(low, high)));
    ui::fill(ui.list(), {at.x, at.y, size.x, size.y}, ui.theme().canvas, ui::size::kBadgeRadius);
    ui.formula(letter, {std::round(at.x + (size.x - letter.width) / 2), std::round(at.y + size.y / 2 + .33F * em)});
}

/// The current row from its left end to its right one, as traced.
void draw_row(const ViewContext& ctx, const TexelMap& map) {
    const auto ul = number_of(ctx.derived, "u_l"), vl = number_of(ctx.derived, "v_l");
    const auto ur = number_of(ctx.derived, "u_r"), vr = number_of(ctx.derived, "v_r");
    if (!ctx.derived.row() || !ul || !vl || !ur || !vr) return;
    const glm::vec2 a = map.to_window({*ul, *vl}), b = map.to_window({*ur, *vr});
    ImDrawList& list = ctx.ui.list();
    const ui::Color now = ctx.ui.theme()[Role::now], outline = ctx.ui.theme().outline;
    ui::line(list, a, b, 6, outline);
    ui::line(list, a, b, 3, now);
    for (const glm::vec2 end : {a, b}) {
        list.AddCircleFilled(ui::to_im(end), ctx.ui.px(5.5F), outline);
        list.AddCircleFilled(ui::to_im(end), ctx.ui.px(4), now);
    }
    const glm::vec2 way = b == a ? glm::vec2(1, 0) : glm::normalize(b - a);
    draw_end(ctx, a, -way, "l", map.area);
    draw_end(ctx, b, way, "r", map.area);
}

void draw(const ViewContext& ctx, const ui::Area& place) {
    ui::Ui& ui = ctx.ui;
    const Texture& texture = ctx.derived.texture();
    const ui::Area content = ui.begin_panel("face", place, ui.presenting() ? std::string_view{} : kTitle,
                                            ui.presenting() ? std::string() : texture_note(texture));
    const TexelMap map = make_texel_map(ui, content, texture, corners_of(ctx.derived));
    const SectionPicture picture = sections_of(ctx.derived);
    ui.begin_clip(content.inset(-ui.px(6), -ui.px(4)));
    take_texel_input(ctx, map, "face");
    draw_texture(ctx, map, "face");
    ui::fill(ui.list(), map.place_of(map.range), ui::with_alpha(ui.theme().canvas, kVeil));
    draw_uv_arrows(ctx, map);
    int index = 0;
    for (const SectionShape& section : picture.sections)
        draw_region(ctx, quad_of(map, section), index++, section.begun);
    for (std::size_t n = 0; n + 1 < picture.sections.size(); ++n) draw_border(ctx, quad_of(map, picture.sections[n]));
    draw_texture_outline(ctx, map);
    draw_row(ctx, map);
    index = 0;
    for (const SectionShape& section : picture.sections) {
        if (section.last > section.first) draw_number(ctx, quad_of(map, section), index, map.place_of(map.range));
        ++index;
    }
    draw_texture_corners(ctx, map);
    draw_texel_marks(ctx, map);
    ui.end_clip();
    ui.end_panel();
}

constexpr View kView{"face", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::face_view
