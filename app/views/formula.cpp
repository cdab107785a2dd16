// The formula under work: how it is defined, the numbers in their place, and above it what it was made from.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/formula_blocks.h"
#include "app/views/terms.h"

namespace texelscope::formula_view {
namespace {

constexpr std::string_view kTitle = "Formula";
constexpr std::string_view kNothing = "Nothing is computed at this step. Step forward, or into the unit with Enter.";
constexpr std::string_view kNoShape = "The scene has no shape. Open a scene, or a lesson with L.";

/// Column, row and colour of the texel that the unit reads, as far as the step has come.
struct TexelLine {
    std::int32_t column = -1, row = -1, r = -1, g = -1, b = -1;
};

[[nodiscard]] TexelLine texel_line(const Visit& visit, const Cursor& cursor, std::int32_t now) {
    TexelLine line;
    for (const std::int32_t n : visit.unit().expressions) {
        if (cursor.step.at_expression() && n > now) break;
        const std::string name = visit.tape.names[static_cast<std::size_t>(n)].name.text();
        if (name == "column") line.column = n;
        if (name == "row") line.row = n;
        if (name == "r") line.r = n;
        if (name == "g") line.g = n;
        if (name == "b") line.b = n;
    }
    return line;
}

[[nodiscard]] ui::MathBox index_box(const ui::Fonts& fonts, const Tape& tape, std::int32_t named) {
    const TapeMath math = math_of(tape, named);
    ui::Expr chain = math.leaf ? math.value : ui::relation(math.symbols, "=", math.value);
    const ui::Expr name = ui::linked(ui::word(tape.names[static_cast<std::size_t>(named)].name.text()), link_of(named));
    return ui::set_math(ui::sequence({name, std::move(chain)}), {.fonts = &fonts, .size = ui::MathSize::note});
}

[[nodiscard]] int channel(const Tape& tape, std::int32_t named) {
    const Operation& o =
        tape.operations[static_cast<std::size_t>(tape.names[static_cast<std::size_t>(named)].operation)];
    return static_cast<int>(std::clamp(approximate(o.value), 0.0, 255.0));
}

/// Draws a swatch and its colour in figures. @return the width.
float draw_swatch(ui::Ui& ui, glm::vec2 pen, int r, int g, int b) {
    const float side = std::max(ui.px(17), std::round(ui.font(ui::Face::code_note).em * 1.3F));
    const ui::Area swatch{pen.x, std::round(pen.y - side * .76F), side, side};
    ui::fill(ui.list(), swatch, ui::hex(static_cast<std::uint32_t>(r << 16 | g << 8 | b)), ui::size::kBadgeRadius);
    ui::frame(ui.list(), swatch, ui.theme()[ui::Role::text], 1, ui::size::kBadgeRadius);
    const std::string digits = fmt::format("#{:02x}{:02x}{:02x}", r, g, b);
    return side + ui.px(8) + ui.text(ui::Face::code_note, {pen.x + side + ui.px(8), pen.y}, ui::Role::muted, digits);
}

struct FooterItem {
    ui::MathBox box;
    bool swatch = false;
};

class FormulaView {
public:
    FormulaView(const ViewContext& context, const ui::Area& area)
        : context_(context),
          ui_(context.ui),
          visit_(context.derived.visit()),
          area_(area),
          now_(current_name(context.derived)) {}

    void draw() {
        std::vector<FormulaBlock> blocks;
        std::size_t lead = 0;
        const float width = area_.w - ui_.px(4);
        gather_footer(width);
        if (shows_list(visit_, context_.state.cursor))
            blocks = formula_list(ui_.fonts(), visit_.tape, listed_names(visit_), now_, width);
        if (blocks.empty()) {
            const FormulaBlock main = formula_block(ui_.fonts(), visit_.tape, now_, true, width);
            blocks = setup_blocks(main, width);
            lead = blocks.size();
            blocks.push_back(main);
        }
        place(blocks, lead);
    }

private:
    [[nodiscard]] float least_gap() const { return ui_.px(9); }
    /// How far formulas stand from the clip, so that the ring of a first term is inside of it.
    [[nodiscard]] float inset_of(const std::vector<FormulaBlock>& blocks) const {
        float widest = 0;
        for (const FormulaBlock& block : blocks) widest = std::max(widest, block.box.width);
        return std::floor(std::clamp(area_.w - widest, 0.0F, ui_.px(4)));
    }

    /// As many of the formulas that the main one uses as there is room for.
    [[nodiscard]] std::vector<FormulaBlock> setup_blocks(const FormulaBlock& main, float width) const {
        std::vector<FormulaBlock> blocks;
        float left = area_.h - main.box.height() - footer_height_ - 3 * least_gap();
        for (const std::int32_t n : setup_names(visit_, now_)) {
            FormulaBlock block = formula_line(ui_.fonts(), visit_.tape, n, false, width);
            if (block.box.height() + least_gap() > left) continue;
            left -= block.box.height() + least_gap();
            blocks.push_back(std::move(block));
        }
        return blocks;
    }

    void gather_footer(float width) {
        const TexelLine line = texel_line(visit_, context_.state.cursor, now_);
        for (const std::int32_t n : {line.column, line.row}) {
            if (n >= 0 && n != now_) footer_.push_back({index_box(ui_.fonts(), visit_.tape, n)});
        }
        if (line.r >= 0 && line.g >= 0 && line.b >= 0) footer_.push_back({.swatch = true}), colours_ = line;
        rows_ = footer_.empty() ? 0 : 1;
        float x = 0;
        for (const FooterItem& item : footer_) {
            const float w = item_width(item);
            if (x > 0 && x + w > width) x = 0, ++rows_;
            x += w + footer_gap();
        }
        footer_height_ = static_cast<float>(rows_) * footer_pitch();
    }
    [[nodiscard]] float footer_gap() const { return ui_.px(22); }
    [[nodiscard]] float footer_pitch() const {
        return std::round(ui_.fonts().math(ui::MathSize::note, ui::MathStyle::upright).em * 1.8F);
    }
    [[nodiscard]] float item_width(const FooterItem& item) const {
        if (!item.swatch) return item.box.width;
        const ui::Font& font = ui_.font(ui::Face::code_note);
        return std::max(ui_.px(17), std::round(font.em * 1.3F)) + ui_.px(8) + ui::text_width(font, "#000000");
    }

    void place(const std::vector<FormulaBlock>& blocks, std::size_t lead) {
        const float inset = inset_of(blocks);
        float used = footer_height_;
        for (const FormulaBlock& block : blocks) used += block.box.height();
        const auto gaps = static_cast<float>(blocks.size() + (rows_ > 0 ? 1 : 0));
        const float gap =
            std::floor(std::clamp((area_.h - used) / (gaps + .6F), least_gap(), ui_.px(lead > 0 ? 16 : 20)));
        std::vector<float> tops;
        float y = std::round(gap * .5F), now_top = 0, now_bottom = 0;
        for (const FormulaBlock& block : blocks) {
            tops.push_back(y);
            if (block.named == now_) now_top = y - gap / 2, now_bottom = y + block.box.height() + gap / 2;
            y = std::round(y + block.box.height() + gap);
        }
        if (now_bottom > area_.h) {  // from the top of a formula on, so that none is cut
            for (const float top : tops) {
                if (now_bottom - (top - gap / 2) > area_.h) continue;
                now_top = top - gap / 2;
                now_bottom = now_top + area_.h;
                break;
            }
        }
        const float content = std::max(y + footer_height_, now_bottom);
        const auto key = static_cast<float>(now_) + static_cast<float>(visit_.path.depth()) / 8;
        follow(ui_, "formula/scroll", area_.h, content, now_top, now_bottom, key);
        const ui::Area inner = ui_.begin_scroll("formula/scroll", area_);
        for (std::size_t n = 0; n < blocks.size(); ++n) {
            const float top = inner.y + tops[n], height = blocks[n].box.height();
            const bool whole = top > area_.y - 1 && top + height < area_.bottom() + 1;
            if (!whole && height <= area_.h) continue;  // no half a formula at the end of the panel
            if (n == lead && lead > 0)
                ui::fill(ui_.list(), {inner.x, std::round(top - gap / 2), inner.w, 1}, ui_.theme().hairline);
            draw_terms(context_, fmt::format("formula/{}", n), visit_.tape, blocks[n].box,
                       {inner.x + inset, top + blocks[n].box.ascent});
        }
        draw_footer({inner.x + inset, inner.y + y});
        ui_.end_scroll(content);
    }

    void draw_footer(glm::vec2 at) {
        float x = at.x, y = at.y + std::round(footer_pitch() * .62F);
        for (std::size_t n = 0; n < footer_.size(); ++n) {
            const float w = item_width(footer_[n]);
            if (x > at.x && x + w > area_.right()) x = at.x, y += footer_pitch();
            if (footer_[n].swatch) {
                draw_swatch(ui_, {x, y}, channel(visit_.tape, colours_.r), channel(visit_.tape, colours_.g),
                            channel(visit_.tape, colours_.b));
            } else {
                draw_terms(context_, fmt::format("formula/texel{}", n), visit_.tape, footer_[n].box, {x, y});
            }
            x += w + footer_gap();
        }
    }

    const ViewContext& context_;
    ui::Ui& ui_;
    const Visit& visit_;
    ui::Area area_;
    std::int32_t now_;
    std::vector<FooterItem> footer_;
    TexelLine colours_;
    int rows_ = 0;
    float footer_height_ = 0;
};

void draw(const ViewContext& context, const ui::Area& place) {
    const std::int32_t now = current_name(context.derived);
    const NumberFormat format = context.derived.drawing().settings().format;
    std::string title(kTitle);
    if (format != NumberFormat::f64) title += fmt::format(" · {}", id_of(format));
    const ui::Area area = begin_view(context, "formula", place, title, formula_note(context.derived, now));
    if (context.derived.shape() < 0)
        draw_empty(context, area, kNoShape);
    else if (now < 0)
        draw_empty(context, area, kNothing);
    else
        FormulaView(context, area).draw();
    context.ui.end_panel();
}

constexpr View kView{"formula", kTitle, draw};
const RegisterView kRegistered(kView);

}  // namespace
}  // namespace texelscope::formula_view
