// The palette of the texture: its colours in a grid of 16 x 16, by index, and who uses the one that is looked at.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/canvas_values.h"
#include "app/views/terms.h"

namespace texelscope::canvas::palette_view {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kTitle = "Palette", kNote = "{}, {} of 256";
constexpr std::string_view kNone =
    "This texture has no palette: each texel is three bytes of its own. `\"palette\": 256` behind the texture's file "
    "in "
    "the scene reduces it to 256 colours.";
constexpr std::string_view kTip = "**{}**: red {}, green {}, blue {}. {} and {} have this colour";
constexpr std::string_view kIndex = "index {}", kNothing = "Point at a colour, or pin a texel.";
constexpr std::string_view kTexel = "texel", kTexels = "texels", kPixel = "pixel", kPixels = "pixels";
constexpr int kSide = 16;
constexpr float kWide = 1.5F;  ///< width over height from which on the caption stands beside the grid
constexpr float kLines = 2;    ///< of the caption below the grid

[[nodiscard]] std::string count_of(Integer n, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// The grid, and the numbers of its rows and columns.
struct Sheet {
    Area area;  ///< of the cells
    float cell = 1;

    [[nodiscard]] Area place_of(int index) const {
        const int column = index % kSide, row = index / kSide;
        return {area.x + static_cast<float>(column) * cell, area.y + static_cast<float>(row) * cell, cell, cell};
    }
};

class PaletteView {
public:
    PaletteView(const ViewContext& context, const Area& area)
        : context_(context),
          ui_(context.ui),
          texture_(context.derived.texture()),
          use_(context.derived.palette_use()),
          caption_(pitch(context.ui, 18, Face::code)) {
        const ui::Font& font = ui_.font(Face::count);
        const float left = std::ceil(ui::text_width(font, "240")) + ui_.px(6), top = std::ceil(font.em * 1.3F);
        beside_ = area.w >= kWide * area.h;
        const float width = area.w - left - ui_.px(3);
        const float height = area.h - top - ui_.px(4) - (beside_ ? 0 : kLines * caption_);
        sheet_.cell = std::max(2.0F, std::floor(std::min(width, height) / kSide));
        sheet_.area = {area.x + left, area.y + top, kSide * sheet_.cell, kSide * sheet_.cell};
        area_ = area;
    }

    void draw() {
        take_input();
        draw_numbers();
        draw_cells();
        mark(index_at(context_.hover, context_.state.hover), 1);
        mark(index_at(context_.pinned, context_.state.pinned), 2);
        const std::optional<int> current = index_of(context_.derived.texel());
        if (current)
            ui::pixel_ring(ui_.list(), sheet_.place_of(*current), ui_.theme()[Role::now], ui_.theme().outline, 2.5F);
        draw_caption();
    }

private:
    [[nodiscard]] std::optional<int> index_of(std::optional<glm::ivec2> texel) const {
        const bool inside = texel && Rect{0, 0, texture_.width(), texture_.height()}.contains(texel->x, texel->y);
        return inside ? std::optional<int>(texture_.indices.at(texel->x, texel->y)) : std::nullopt;
    }
    /// The colour that a selection is about.
    [[nodiscard]] std::optional<int> index_at(const Highlight& links, const Selection& what) const {
        if (what.kind == Selection::Kind::colour) return what.colour;
        if (what.kind == Selection::Kind::pixel) {
            const Rect frame = context_.derived.scene().framebuffer.rect();
            if (!frame.contains(what.at.x, what.at.y)) return std::nullopt;
            const int shown = use_.shown.at(what.at.x - frame.x0, what.at.y - frame.y0);
            return shown < 0 ? std::nullopt : std::optional<int>(shown);
        }
        return links.texels.empty() || what.kind != Selection::Kind::texel ? std::nullopt
                                                                           : index_of(links.texels.front());
    }
    [[nodiscard]] int colours() const { return static_cast<int>(texture_.palette.size()); }

    void take_input() {
        const glm::vec2 in = ui_.input().mouse - glm::vec2(sheet_.area.x, sheet_.area.y);
        const bool inside = sheet_.area.contains(ui_.input().mouse) && ui_.clip().contains(ui_.input().mouse);
        const int at = inside ? static_cast<int>(in.y / sheet_.cell) * kSide + static_cast<int>(in.x / sheet_.cell) : 0;
        const bool on_colour = inside && at < colours();
        const ui::Control grid = ui_.control({.name = "palette",
                                              .area = sheet_.area,
                                              .kind = ui::Kind::region,
                                              .label = kTitle,
                                              .tip = on_colour ? tip_of(at) : std::string()});
        const Selection here{.kind = Selection::Kind::colour, .colour = at};
        tell_hover(context_, sheet_.area, on_colour && grid.hovered, here);
        if (grid.clicked && !grid.by_key && on_colour) context_.act(action::Pin{here});
        take_keys(grid.id);
    }
    /// Arrows pin the next colour.
    void take_keys(ui::Id id) {
        const auto shown = index_at(context_.pinned, context_.state.pinned);
        const int from = shown.value_or(index_of(context_.derived.texel()).value_or(0));
        int to = from;
        while (ui_.take_key(id, ui::Key::right)) ++to;
        while (ui_.take_key(id, ui::Key::left)) --to;
        while (ui_.take_key(id, ui::Key::down)) to += kSide;
        while (ui_.take_key(id, ui::Key::up)) to -= kSide;
        if (to == from || to < 0 || to >= colours()) return;
        context_.act(action::Pin{{.kind = Selection::Kind::colour, .colour = to}});
    }
    [[nodiscard]] std::string tip_of(int index) const {
        const auto n = static_cast<std::size_t>(index);
        const Rgb& c = texture_.palette[n];
        return fmt::format(kTip, index, c.r, c.g, c.b, count_of(use_.texels[n], kTexel, kTexels),
                           count_of(use_.pixels[n], kPixel, kPixels));
    }

    /// 0 to 15 above, 0, 16, 32 … at the left; every fourth where cells are small.
    void draw_numbers() {
        const ui::Font& font = ui_.font(Face::count);
        const auto number = [&](float right, float baseline, int n) {
            ui_.text_right(Face::count, {right, baseline}, Role::muted, fmt::format("{}", n));
        };
        const int down = sheet_.cell >= font.em * 1.1F ? 1 : 4;
        const int across = sheet_.cell >= ui::text_width(font, "15") + ui_.px(4) ? 1 : 4;
        for (int n = 0; n < kSide; n += across) {
            const Area cell = sheet_.place_of(n);
            const float width = ui::text_width(font, fmt::format("{}", n));
            number(cell.centre().x + width / 2, sheet_.area.y - ui_.px(3), n);
        }
        for (int n = 0; n < kSide; n += down) {
            const Area cell = sheet_.place_of(n * kSide);
            number(sheet_.area.x - ui_.px(4), ui::baseline_at_middle(font, cell.centre().y), n * kSide);
        }
    }
    void draw_cells() {
        ui::fill(ui_.list(), sheet_.area, ui_.theme().canvas);
        for (int n = 0; n < colours(); ++n) {
            const Rgb& c = texture_.palette[static_cast<std::size_t>(n)];
            const Area cell = sheet_.place_of(n);
            const float gap = sheet_.cell >= 6 ? 1 : 0;
            ui::fill(ui_.list(), {cell.x, cell.y, cell.w - gap, cell.h - gap}, IM_COL32(c.r, c.g, c.b, 255));
        }
        ui::frame(ui_.list(), sheet_.area.inset(-1, -1), ui_.theme().hairline);
    }
    void mark(std::optional<int> index, float width) {
        if (!index || *index >= colours()) return;
        ui::pixel_ring(ui_.list(), sheet_.place_of(*index), ui_.theme()[Role::now], ui_.theme().outline, width);
    }

    /// The colour looked at: its index and bytes; its users. In two lines below the grid, or in four beside it.
    void draw_caption() {
        std::optional<int> index = index_at(context_.hover, context_.state.hover);
        if (!index) index = index_at(context_.pinned, context_.state.pinned);
        if (!index) index = index_of(context_.derived.texel());
        const float left = beside_ ? sheet_.area.right() + ui_.px(16) : area_.x;
        const float y = beside_ ? sheet_.area.y : sheet_.area.bottom() + ui_.px(4);
        const auto line = [&](int n, Face face, float x, Role role, std::string_view text) {
            const float top = y + static_cast<float>(n) * caption_;
            return ui_.text_within(face, {x, ui::baseline_at_middle(ui_.font(face), top + caption_ / 2)},
                                   std::max(0.0F, area_.right() - x), role, text);
        };
        if (!index || *index >= colours()) {
            line(0, Face::title, left, Role::muted, kNothing);
            return;
        }
        const auto n = static_cast<std::size_t>(*index);
        const Rgb& c = texture_.palette[n];
        const float side = std::round(caption_ * .6F);
        ui::fill(ui_.list(), {left, y + std::round((caption_ - side) / 2), side, side}, IM_COL32(c.r, c.g, c.b, 255));
        float x = left + side + ui_.px(6);
        const std::string bytes = fmt::format("{} {} {}", c.r, c.g, c.b);
        const std::string texels = count_of(use_.texels[n], kTexel, kTexels),
                          pixels = count_of(use_.pixels[n], kPixel, kPixels);
        x += line(0, Face::code, x, Role::text, fmt::format(kIndex, *index)) + ui_.px(10);
        if (beside_) {
            line(1, Face::code, left, Role::muted, bytes);
            line(2, Face::code, left, Role::muted, texels), line(3, Face::code, left, Role::muted, pixels);
        } else {
            line(0, Face::code, x, Role::muted, bytes);
            line(1, Face::code, left, Role::muted, fmt::format("{}, {}", texels, pixels));
        }
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    const Texture& texture_;
    const PaletteUse& use_;
    float caption_;  ///< height of a line
    bool beside_ = false;
    Area area_;
    Sheet sheet_;
};

void draw(const ViewContext& context, const Area& place) {
    const Texture& texture = context.derived.texture();
    const std::string note =
        texture.palette.empty() ? std::string() : fmt::format(kNote, texture.name, texture.palette.size());
    const Area area = begin_view(context, "palette", place, kTitle, note);
    if (texture.palette.empty()) {
        draw_empty(context, area, kNone);
    } else {
        context.ui.begin_clip(area);
        PaletteView(context, area).draw();
        context.ui.end_clip();
    }
    context.ui.end_panel();
}

constexpr View kView{"palette", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::canvas::palette_view
