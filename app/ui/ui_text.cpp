// Text and formulas of ui.h: every piece is drawn and entered in the report.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/ui.h"

namespace texelscope::ui {

void Ui::record(const Font& font, glm::vec2 pen, float width, Color color, std::string_view s, bool subscript) {
    if (!options_.record_texts || s.empty()) return;
    const Area area{pen.x, std::round(pen.y) - font.cap, width, font.cap + .16F * font.em};
    report_.texts.push_back({area, clip(), font.em, clips_.back().scrolls, subscript, color, ground_, std::string(s)});
}

float Ui::text(Face face, glm::vec2 pen, Role role, std::string_view s) {
    const Color color = letter_color(theme_, role, ground_);
    pen.x = std::round(pen.x);
    const float width = draw_text(list_, font(face), pen, color, s);
    record(font(face), pen, width, color, s);
    return width;
}

float Ui::text_right(Face face, glm::vec2 pen, Role role, std::string_view s) {
    const float width = text_width(font(face), s);
    return text(face, {pen.x - width, pen.y}, role, s);
}

float Ui::text_within(Face face, glm::vec2 pen, float width, Role role, std::string_view s) {
    return text(face, pen, role, elided(font(face), s, width));
}

void Ui::text_centred(Face face, const Area& area, Role role, std::string_view s) {
    const std::string shown = elided(font(face), s, area.w);
    const float x = area.x + (area.w - text_width(font(face), shown)) / 2;
    text(face, {x, baseline_at_middle(font(face), area.centre().y)}, role, shown);
}

void Ui::formula(const MathBox& box, glm::vec2 pen) {
    pen = {std::round(pen.x), std::round(pen.y)};
    draw_math(list_, theme_, box, pen, ground_);
    const Color plain = ground_;
    for (const MathText& t : box.texts) {
        if (t.on_mark) ground_ = over(theme_[Role::now], alpha::kMark, plain);
        record(*t.font, pen + t.at, text_width(*t.font, t.text), letter_color(theme_, t.role, ground_), t.text,
               t.subscript);
        ground_ = plain;
    }
}

std::optional<Ui::LinkEvent> Ui::formula(std::string_view name, const MathBox& box, glm::vec2 pen) {
    pen = {std::round(pen.x), std::round(pen.y)};
    std::optional<LinkEvent> event;
    for (std::size_t i = 0; i < box.links.size(); ++i) {
        const MathLink& link = box.links[i];
        const Area area = link.area.moved(pen.x, pen.y);
        const std::string full = fmt::format("{}/{}", name, i);
        const Control c = control({full, area, Kind::link, full});
        if (c.hovered || c.held || (c.focused && !event)) {
            event = LinkEvent{link.id, c};
            const Area plate = area.inset(-px(2), -px(2));
            frame(list_, plate, theme_[Role::now], 1, size::kBadgeRadius);
        }
    }
    formula(box, pen);
    return event;
}

void Ui::draw_layout(const ProseLayout& layout, glm::vec2 at, Role role) {
    for (const ProseItem& item : layout.items) {
        const glm::vec2 pen = glm::vec2(std::round(at.x + item.at.x), std::round(at.y + item.at.y));
        if (item.font == nullptr) {
            formula(item.math, pen);
            continue;
        }
        const Color color = letter_color(theme_, item.role == Role::text ? role : item.role, ground_);
        draw_text(list_, *item.font, pen, color, item.text);
        record(*item.font, pen, item.width, color, item.text);
    }
}

namespace {

/// Which formulas and which code go with text in `face`.
ProseStyle style_of(Face face) {
    ProseStyle style;
    style.face = face;
    if (face == Face::note || face == Face::title) {
        style.math = MathSize::note;
        style.strong = Face::title;
        style.code = Face::line_number;
    }
    return style;
}

constexpr float kUnbroken = 1e9F;

/// Cuts the only line of `layout` to `width` and ends it with an ellipsis, if there is room for one.
void shorten(ProseLayout& layout, const Font& font, float width) {
    const float dots = text_width(font, kEllipsis);
    std::vector<ProseItem>& items = layout.items;
    while (!items.empty() && items.back().at.x + items.back().width + dots > width) items.pop_back();
    const float end = items.empty() ? 0 : items.back().at.x + items.back().width;
    layout.width = end;
    if (end + dots > width) return;
    ProseItem rest;
    rest.at = {end, layout.baseline};
    rest.width = dots;
    rest.font = &font;
    rest.text = std::string(kEllipsis);
    items.push_back(std::move(rest));
    layout.width += dots;
}

}  // namespace

float Ui::rich(Face face, glm::vec2 pen, Role role, std::string_view s) {
    if (s.find_first_of("$*`\\") == std::string_view::npos) return text(face, pen, role, s);
    const std::vector<Span> spans = spans_of(s);
    const ProseLayout layout = layout_prose(fonts_, spans, kUnbroken, style_of(face));
    draw_layout(layout, {pen.x, pen.y - layout.baseline}, role);
    return layout.width;
}

float Ui::rich_within(Face face, glm::vec2 pen, float width, Role role, std::string_view s) {
    if (s.find_first_of("$*`\\") == std::string_view::npos) return text_within(face, pen, width, role, s);
    const std::vector<Span> spans = spans_of(s);
    ProseLayout layout = layout_prose(fonts_, spans, kUnbroken, style_of(face));
    if (layout.width > width) shorten(layout, font(face), width);
    draw_layout(layout, {pen.x, pen.y - layout.baseline}, role);
    return layout.width;
}

float Ui::rich_width(Face face, std::string_view s) const {
    if (s.find_first_of("$*`\\") == std::string_view::npos) return text_width(font(face), s);
    return layout_prose(fonts_, spans_of(s), kUnbroken, style_of(face)).width;
}

float Ui::prose(std::string_view name, const Area& area, std::span<const Span> spans, const ProseStyle& style,
                LinkId* hovered, LinkId* clicked) {
    const ProseLayout layout = layout_prose(fonts_, spans, area.w, style);
    for (std::size_t i = 0; i < layout.items.size(); ++i) {
        const ProseItem& item = layout.items[i];
        if (item.link == 0) continue;
        const Font& face = item.font != nullptr ? *item.font : font(style.face);
        const Area place{area.x + item.at.x, area.y + item.at.y - face.cap - px(3), item.width, face.cap + px(7)};
        const std::string full = fmt::format("{}/{}", name, i);
        const Control c = control({full, place, Kind::link, item.text});
        if ((c.hovered || c.focused) && hovered != nullptr) *hovered = item.link;
        if (c.clicked && clicked != nullptr) *clicked = item.link;
        const float y = area.y + item.at.y + px(3);
        fill(list_, {place.x, y, place.w, 1}, c.hovered ? theme_[Role::now] : theme_[Role::faint]);
    }
    draw_layout(layout, {area.x, area.y}, Role::text);
    return layout.height;
}

}  // namespace texelscope::ui
