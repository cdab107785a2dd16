#include "app/ui/formula_parts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "app/ui/paint.h"
#include "app/ui/text.h"

namespace texelscope::ui {
namespace {

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }

/// How far letters reach from the baseline [em]; by kind and not by glyph, so that changing figures move nothing.
struct Reach {
    float up = 0, down = 0;
};
Reach reach_of(std::string_view text) {
    Reach r;
    for (const char c : text) {
        const bool low = std::string_view("acegmnopqrsuvwxyz.,").find(c) != std::string_view::npos;
        const bool deep = std::string_view("gjpqyQ;,").find(c) != std::string_view::npos;
        const bool bracket = std::string_view("()[]/").find(c) != std::string_view::npos;
        r.up = std::max(r.up, bracket ? .75F : low ? .45F : .69F);
        r.down = std::max(r.down, bracket ? .25F : deep ? .21F : .01F);
    }
    return r;
}

MathBox text_box(const Font& font, std::string_view text, Role role) {
    const Reach reach = reach_of(text);
    MathBox box{text_width(font, text), reach.up * font.em, reach.down * font.em, {}, {}, {}};
    box.texts.push_back({{0, 0}, &font, role, false, false, std::string(text)});
    return box;
}

constexpr float kStrutUp = .72F, kStrutDown = .24F;
constexpr float kSubscriptDrop = .19F;

}  // namespace

void put(MathBox& into, const MathBox& part, glm::vec2 at) {
    for (MathText t : part.texts) {
        t.at += at;
        into.texts.push_back(std::move(t));
    }
    for (MathInk ink : part.inks) {
        ink.area = ink.area.moved(at.x, at.y);
        into.inks.push_back(ink);
    }
    for (MathLink link : part.links) {
        link.area = link.area.moved(at.x, at.y);
        into.links.push_back(link);
    }
    into.width = std::max(into.width, at.x + part.width);
    into.ascent = std::max(into.ascent, part.ascent - at.y);
    into.descent = std::max(into.descent, part.descent + at.y);
}

void append(MathBox& into, const MathBox& part) { put(into, part, {into.width, 0}); }

void put_mark_under(MathBox& box, const Area& area) {
    box.inks.insert(box.inks.begin(), {area, MathShape::mark, Role::now});
    const glm::vec2 slack{1, 1};
    for (MathText& t : box.texts)
        if (area.inset(-slack.x, -slack.y).contains(t.at)) t.on_mark = true;
    for (MathInk& ink : box.inks)
        if (ink.shape != MathShape::mark && area.contains(ink.area.centre())) ink.on_mark = true;
    box.ascent = std::max(box.ascent, -area.y);
    box.descent = std::max(box.descent, area.bottom());
}

MathKit::MathKit(const MathSetting& setting)
    : fonts_(setting.fonts), size_(setting.size), em_(setting.fonts->math(setting.size, MathStyle::upright).em) {}

float MathKit::rule() const { return std::max(1.0F, std::round(.055F * em_)); }
float MathKit::axis() const { return std::round(em_ * .25F); }

MathBox MathKit::text(MathStyle style, std::string_view text, Role role) const {
    MathBox box = text_box(fonts_->math(size_, style), text, role);
    box.texts.front().subscript = style == MathStyle::sub_italic || style == MathStyle::sub_upright;
    return box;
}

MathBox MathKit::word(std::string_view s, Role role) const {
    return text_box(fonts_->face(size_ == MathSize::note ? Face::note : Face::prose), s, role);
}

MathBox MathKit::upright(std::string_view s, Role role) const {
    return s.empty() ? MathBox{} : text(MathStyle::upright, s, role);
}

MathBox MathKit::subscript(std::string_view s, Role role) const {
    MathBox out;
    for (std::size_t at = 0; at < s.size();) {
        std::size_t end = at + 1;
        const bool lower = is_lower(s[at]);
        while (end < s.size() && is_lower(s[end]) == lower) ++end;
        const bool italic = lower && end - at == 1;
        append(out, text(italic ? MathStyle::sub_italic : MathStyle::sub_upright, s.substr(at, end - at), role));
        at = end;
    }
    return out;
}

MathBox MathKit::symbol(std::string_view base, std::string_view sub, Role role) const {
    const bool letter = base.size() == 1 && (is_lower(base[0]) || is_upper(base[0]));
    MathBox out = text(letter ? MathStyle::italic : MathStyle::upright, base, role);
    if (sub.empty()) return out;
    // An italic capital leans over its subscript: E_A keeps closer than its advance.
    const float gap = letter && is_upper(base[0]) ? -.02F : .03F;
    put(out, subscript(sub, role), {out.width + em_ * gap, std::round(em_ * kSubscriptDrop)});
    out.width += em_ * .04F;
    return out;
}

MathBox MathKit::row(std::vector<MathBox> boxes, float gap) const {
    MathBox out;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (i > 0) out.width += gap;
        append(out, boxes[i]);
    }
    return out;
}

MathBox MathKit::with_sign(MathBox left, std::string_view sign, float gap, Role role) const {
    left.width += gap;
    append(left, sign == "&" ? text_box(fonts_->face(Face::code), sign, Role::muted) : upright(sign, role));
    left.width += gap;
    return left;
}

MathBox MathKit::fraction(const MathBox& above, const MathBox& below) const {
    MathBox out;
    const float width = std::max(above.width, below.width) + em_ * .16F, thick = rule();
    const float top = -axis() - std::round(thick / 2);
    put(out, above, {(width - above.width) / 2, std::floor(top - px(3.5F) - above.descent)});
    put(out, below, {(width - below.width) / 2, std::ceil(top + thick + px(4.5F) + below.ascent)});
    out.inks.push_back({{0, top, width, thick}, MathShape::rule, Role::text});
    out.width = width;
    return out;
}

MathBox MathKit::determinant(int columns, std::vector<MathBox> cells) const {
    const auto per_row = static_cast<std::size_t>(columns);
    const std::size_t rows = (cells.size() + per_row - 1) / per_row;
    std::vector<float> widths(per_row, 0), ups(rows, em_ * kStrutUp), downs(rows, em_ * kStrutDown);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        widths[i % per_row] = std::max(widths[i % per_row], cells[i].width);
        ups[i / per_row] = std::max(ups[i / per_row], cells[i].ascent);
        downs[i / per_row] = std::max(downs[i / per_row], cells[i].descent);
    }
    float height = px(3) * static_cast<float>(rows == 0 ? 0 : rows - 1);
    for (std::size_t r = 0; r < rows; ++r) height += ups[r] + downs[r];
    height = std::ceil(height);

    MathBox out;
    const float thick = rule(), pad = px(4.5F), top = -axis() - std::round(height / 2);
    float y = top;
    for (std::size_t r = 0; r < rows; ++r) {
        float x = thick + pad;
        y += ups[r];
        for (std::size_t c = 0; c < per_row && r * per_row + c < cells.size(); ++c) {
            const MathBox& cell = cells[r * per_row + c];
            put(out, cell, {x + (widths[c] - cell.width) / 2, std::round(y)});
            x += widths[c] + px(12);
        }
        y += downs[r] + px(3);
    }
    float width = 2 * (thick + pad) + px(12) * static_cast<float>(per_row - 1);
    for (const float w : widths) width += w;
    out.inks.push_back({{0, top, thick, height}, MathShape::rule, Role::text});
    out.inks.push_back({{width - thick, top, thick, height}, MathShape::rule, Role::text});
    out.width = width;
    out.ascent = -top;
    out.descent = top + height;
    return out;
}

MathBox MathKit::matrix(int columns, std::vector<MathBox> cells) const {
    MathBox out = determinant(columns, std::move(cells));
    const float thick = rule(), hook = std::round(px(4));
    const Area left = out.inks[out.inks.size() - 2].area, right = out.inks.back().area;
    for (const float y : {left.y, left.bottom() - thick}) {
        out.inks.push_back({{left.x, y, hook, thick}, MathShape::rule, Role::text});
        out.inks.push_back({{right.right() - hook, y, hook, thick}, MathShape::rule, Role::text});
    }
    return out;
}

MathBox MathKit::in_parentheses(const MathBox& inner) const {
    // Letters may stand out a little before brackets grow: TeX lets a tenth.
    constexpr float kReachUp = .95F, kReachDown = .5F;
    if (inner.ascent <= em_ * kReachUp && inner.descent <= em_ * kReachDown)
        return row({upright("(", Role::text), inner, upright(")", Role::text)}, 0);
    MathBox out;
    const float wide = px(6), bearing = px(2), above = inner.ascent + px(1), below = inner.descent + px(1);
    const Area side{bearing, -above, wide, above + below};
    out.inks.push_back({side, MathShape::left_parenthesis, Role::text});
    put(out, inner, {side.right() + px(1.5F), 0});
    out.inks.push_back({side.moved(out.width + px(1.5F) - bearing, 0), MathShape::right_parenthesis, Role::text});
    out.width += px(1.5F) + wide + bearing;
    out.ascent = above;
    out.descent = below;
    return out;
}

MathBox MathKit::floor(const MathBox& inner) const {
    MathBox out;
    const float foot = std::round(px(4)), thick = std::max(1.0F, std::round(px(1))), gap = px(1.5F);
    const float up = std::ceil(std::max(inner.ascent, em_ * .66F) + px(1)),
                down = std::ceil(std::max(inner.descent, em_ * .16F) + px(1));
    const auto rule_at = [&](float x, float y, float w, float h) {
        out.inks.push_back({{x, y, w, h}, MathShape::rule, Role::text});
    };
    const float lead = px(1.5F);
    rule_at(lead, -up, thick, up + down);
    rule_at(lead, down - thick, foot, thick);
    put(out, inner, {lead + thick + gap + px(1), 0});
    const float right = out.width + gap + px(1);
    rule_at(right, -up, thick, up + down);
    rule_at(right + thick - foot, down - thick, foot, thick);
    out.width = right + thick + lead;
    out.ascent = up;
    out.descent = down;
    return out;
}

MathBox MathKit::marked(MathBox inner) const {
    MathBox out;
    const float pad = px(4);
    put(out, inner, {pad, 0});
    out.width += pad;
    const float up = std::max(inner.ascent, em_ * .70F) + px(3), down = std::max(inner.descent, em_ * .2F) + px(4);
    put_mark_under(out, {0, -up, out.width, up + down});
    return out;
}

void draw_math(ImDrawList& list, const Theme& theme, const MathBox& box, glm::vec2 pen, Color ground) {
    pen.y = std::round(pen.y);
    const Color mark = over(theme[Role::now], alpha::kMark, ground);
    for (const MathInk& ink : box.inks) {
        const Area at = ink.area.moved(pen.x, pen.y);
        const Color color = letter_color(theme, ink.role, ink.on_mark ? mark : ground);
        const float x0 = std::round(at.x), y0 = std::round(at.y);
        if (ink.shape == MathShape::rule) {
            const float w = at.w > at.h ? std::round(at.right()) - x0 : std::round(at.w);
            fill(list, {x0, y0, std::max(1.0F, w), std::max(1.0F, std::round(at.h))}, color);
        } else if (ink.shape == MathShape::mark) {
            const float bottom = std::round(at.bottom()), bar = 2 * std::max(1.0F, std::round(at.w / 200));
            const Area tint{x0, y0, std::round(at.right()) - x0, bottom - y0};
            list.AddRectFilled({tint.x, tint.y}, {tint.right(), tint.bottom()},
                               with_alpha(theme[Role::now], alpha::kMark), size::kRadius, ImDrawFlags_RoundCornersTop);
            fill(list, {tint.x, bottom - bar, tint.w, bar}, theme[Role::now]);
        } else {
            const bool left = ink.shape == MathShape::left_parenthesis;
            const float tip = left ? at.right() - 1 : at.x + 1,
                        belly = left ? at.x - at.w * .45F : at.right() + at.w * .45F;
            list.PathLineTo({tip, at.y});
            list.PathBezierCubicCurveTo({belly, at.y + at.h * .28F}, {belly, at.y + at.h * .72F}, {tip, at.bottom()},
                                        24);
            list.PathStroke(color, 0, std::max(1.2F, at.w * .22F));
        }
    }
    for (const MathText& t : box.texts) {
        const Color color = letter_color(theme, t.role, t.on_mark ? mark : ground);
        draw_text(list, *t.font, pen + t.at, color, t.text);
    }
}

}  // namespace texelscope::ui
