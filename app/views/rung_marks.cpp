#include "app/views/rung_marks.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/views/race_table.h"

namespace texelscope {
namespace {

using ui::Role;

constexpr std::string_view kAllRight = "all of {} pixels right", kOfFirst = "; first {} triangles";
constexpr float kRingsUpTo = 40;  ///< so few wrong pixels are ringed, to be found
constexpr float kVeil = .55F;     ///< over what is right, so that marks stand out
constexpr float kMarksFrom = 4;   ///< window pixels per pixel: from here each pixel has its mark

struct VerdictInfo {
    PixelVerdict verdict;
    Role role;
    std::string_view name;
    Integer RungPicture::*count;
};
constexpr std::array<VerdictInfo, 3> kShown{{
    {PixelVerdict::wrong, Role::error, "wrong texel", &RungPicture::wrong},
    {PixelVerdict::missing, Role::section_1, "missing", &RungPicture::missing},
    {PixelVerdict::extra, Role::section_2, "extra", &RungPicture::extra},
}};

[[nodiscard]] const VerdictInfo* info_of(PixelVerdict verdict) {
    for (const VerdictInfo& info : kShown)
        if (info.verdict == verdict) return &info;
    return nullptr;
}

/// A dot, a minus, a plus.
void draw_mark(ImDrawList& list, PixelVerdict verdict, const ui::Area& at, ui::Color color) {
    const glm::vec2 c = at.centre();
    const float r = at.w * .3F, pen = std::max(1.0F, at.w / 7);
    if (verdict == PixelVerdict::wrong) return list.AddCircleFilled(ui::to_im(c), std::max(1.0F, at.w * .2F), color, 8);
    ui::line(list, {c.x - r, c.y}, {c.x + r, c.y}, pen, color);
    if (verdict == PixelVerdict::extra) ui::line(list, {c.x, c.y - r}, {c.x, c.y + r}, pen, color);
}

}  // namespace

void draw_rung_legend(const ViewContext& context, const ui::Area& row, const Rung& rung) {
    ui::Ui& ui = context.ui;
    const RungPicture& picture = context.derived.rung_picture(rung);
    const ui::Font& font = ui.font(ui::Face::title);
    const float baseline = ui::baseline_at_middle(font, row.centre().y),
                side = std::max(ui.px(12), std::round(font.em * .7F));
    float x = row.x;
    const auto say = [&](ui::Face face, Role role, const std::string& text) {
        x += ui.text_within(face, {x, baseline}, std::max(0.0F, row.right() - x), role, text) + ui.px(6);
    };
    const bool right = picture.wrong + picture.missing + picture.extra == 0;
    if (right) say(ui::Face::title, Role::muted, fmt::format(kAllRight, grouped(static_cast<double>(picture.right))));
    for (const VerdictInfo& info : kShown) {
        if (right || x + side > row.right()) break;
        const ui::Area swatch{x, std::round(row.centre().y - side / 2), side, side};
        ui::fill(ui.list(), swatch, ui.theme()[info.role]);
        draw_mark(ui.list(), info.verdict, swatch, ui.theme().outline);
        x += side + ui.px(6);
        say(ui::Face::title, Role::muted, std::string(info.name));
        say(ui::Face::code, Role::text, grouped(static_cast<double>(picture.*info.count)));
        x += ui.px(8);
    }
    const std::size_t all = front_scene_of(context.derived.scene()).triangles();
    if (picture.triangles < all) say(ui::Face::title, Role::muted, fmt::format(kOfFirst, picture.triangles));
}

namespace canvas {

void draw_rung_marks(const Sheet& sheet) {
    const Rung* const rung = find_rung(sheet.ctx.state.look.rung);
    if (rung == nullptr) return;
    const RungPicture& picture = sheet.ctx.derived.rung_picture(*rung);
    const bool few = static_cast<float>(picture.wrong + picture.missing + picture.extra) <= kRingsUpTo;
    const Rect& frame = picture.frame;
    ui::fill(sheet.list(), sheet.map.place_of(frame), ui::with_alpha(sheet.ui().theme().canvas, kVeil));
    for (int y = frame.y0; y < frame.y1; ++y)
        for (int x = frame.x0; x < frame.x1; ++x) {
            const VerdictInfo* const info = info_of(picture.pixels.at(x - frame.x0, y - frame.y0));
            if (info == nullptr) continue;
            const ui::Area at = ui::grown_to(sheet.map.place_of(glm::ivec2(x, y)), 2);
            if (!sheet.map.area.contains(at.centre())) continue;
            ui::fill(sheet.list(), at, sheet.color(info->role));
            if (sheet.map.zoom >= double{kMarksFrom})
                draw_mark(sheet.list(), info->verdict, at, sheet.ui().theme().outline);
            if (!few) continue;
            for (const auto& [width, color] :
                 {std::pair{3.5F, sheet.ui().theme().outline}, {1.5F, sheet.color(Role::now)}})
                sheet.list().AddCircle(ui::to_im(at.centre()), sheet.ui().px(8), color, 24, width);
        }
}

}  // namespace canvas
}  // namespace texelscope
