// Panels, clipping, scrolling, the focus ring and tips of ui.h.
#include <algorithm>
#include <cmath>

#include "app/ui/text.h"
#include "app/ui/ui.h"

namespace texelscope::ui {
namespace {

constexpr float kScrollBar = 4, kScrollRoom = 8, kTipWidth = 300, kWheelLines = 3;

const ControlRecord* find(const std::vector<ControlRecord>& controls, Id id) {
    const auto it = std::find_if(controls.begin(), controls.end(), [id](const ControlRecord& c) { return c.id == id; });
    return it == controls.end() ? nullptr : &*it;
}

}  // namespace

void Ui::push_clip(const Area& area, bool scrolls) {
    const bool outer = !clips_.empty();
    const Area inside = outer ? intersection(area, clip()) : area;
    clips_.push_back({inside, scrolls || (outer && clips_.back().scrolls)});
    list_.PushClipRect({inside.x, inside.y}, {inside.right(), inside.bottom()});
}

void Ui::begin_clip(const Area& area) { push_clip(area, false); }

void Ui::end_clip() {
    if (clips_.size() < 2) return;
    clips_.pop_back();
    list_.PopClipRect();
}

Area Ui::begin_panel(std::string_view name, const Area& area, std::string_view title, std::string_view note,
                     std::optional<Color> ground) {
    panel_ = id_of(name);
    ground_ = ground.value_or(theme_.panel);
    report_.panels.push_back({panel_, std::string(name), area});
    begin_clip(area);
    fill(list_, area, ground_);
    if (area.x > 0) fill(list_, {area.x, area.y, 1, area.h}, theme_.hairline);
    if (area.y > 0) fill(list_, {area.x, area.y, area.w, 1}, theme_.hairline);
    const float pad = px(size::kPadding), baseline = area.y + px(size::kTitleBaseline);
    if (title.empty() && note.empty()) return area.inset(pad, pad);
    const float note_width = std::min(note.empty() ? 0 : rich_width(Face::note, note), (area.w - 3 * pad) * .6F);
    const float title_room = area.w - 2 * pad - (note.empty() ? 0 : note_width + pad);
    text_within(Face::title, {area.x + pad, baseline}, title_room, Role::muted, title);
    rich_within(Face::note, {area.right() - pad - note_width, baseline}, note_width + 1, Role::muted, note);
    const float top = px(size::kContentTop);
    return {area.x + pad, area.y + top, std::max(0.0F, area.w - 2 * pad), std::max(0.0F, area.h - top)};
}

void Ui::end_panel() {
    end_clip();
    panel_ = 0;
    ground_ = theme_.bg;
}

Area Ui::begin_scroll(std::string_view name, const Area& area) {
    const Id id = id_of(name);
    UiMemory::Scroll& s = memory_.scroll[id];
    const bool overflows = s.content > area.h + 1;
    control({name, area, Kind::region, name, {}, overflows, overflows});
    const float line = font(Face::prose).em * 1.5F, page = area.h - line;
    if (wheel_target_ == id) s.offset -= input_.wheel.y * line * kWheelLines;
    while (take_key(id, Key::down)) s.offset += line;
    while (take_key(id, Key::up)) s.offset -= line;
    while (take_key(id, Key::page_down)) s.offset += page;
    while (take_key(id, Key::page_up)) s.offset -= page;
    while (take_key(id, Key::home)) s.offset = 0;
    while (take_key(id, Key::end)) s.offset = s.content;
    s.offset = std::round(std::clamp(s.offset, 0.0F, std::max(0.0F, s.content - area.h)));
    scrolls_.push_back({id, area, report_.controls.size()});
    push_clip(area, overflows);
    return {area.x, area.y - s.offset, std::max(0.0F, area.w - (overflows ? px(kScrollRoom) : 0)), area.h};
}

void Ui::end_scroll(float content_height) {
    if (scrolls_.empty()) return;
    const ScrollState state = scrolls_.back();
    scrolls_.pop_back();
    UiMemory::Scroll& s = memory_.scroll[state.id];
    if (s.content != content_height) wants_frame_ = true;
    s.content = content_height;
    if (memory_.focus_moved) {
        for (std::size_t i = state.first_control; i < report_.controls.size(); ++i) {
            const ControlRecord& c = report_.controls[i];
            if (c.id != memory_.focus || state.area.covers(c.area)) continue;
            const float margin = px(8), above = state.area.y + margin - c.area.y;
            const float below = c.area.bottom() + margin - state.area.bottom();
            s.offset += below > 0 && above <= 0 ? below : -above;
            wants_frame_ = true;
        }
    }
    const float least = 0, most = std::max(0.0F, content_height - state.area.h);
    s.offset = std::clamp(s.offset, least, most);
    end_clip();
    if (most <= 1) return;
    const float h = std::max(px(24), state.area.h * state.area.h / content_height);
    const float y = state.area.y + (state.area.h - h) * s.offset / most;
    const bool hot = memory_.focus == state.id;
    fill(list_, {state.area.right() - px(kScrollBar), std::round(y), px(kScrollBar), std::round(h)},
         theme_[hot ? Role::now : Role::faint], px(kScrollBar) / 2);
}

void Ui::scroll_to(std::string_view name, float from, float to) {
    const Id id = id_of(name);
    const ControlRecord* region = find(memory_.controls, id);
    if (region == nullptr) return;
    UiMemory::Scroll& s = memory_.scroll[id];
    const float before = s.offset;
    if (to > s.offset + region->area.h) s.offset = to - region->area.h;
    if (from < s.offset) s.offset = from;
    if (s.offset != before) wants_frame_ = true;
}

void Ui::draw_ring() {
    const ControlRecord* c = find(report_.controls, memory_.focus);
    if (c == nullptr || !memory_.ring) return;
    const float out = size::kFocusOutset + size::kFocusRing;
    const Area window{0, 0, input_.size.x, input_.size.y};
    const Area ring = intersection(c->area.inset(-out, -out), window);
    list_.PushClipRectFullScreen();
    if (c->round) {
        list_.AddCircle(to_im(c->area.centre()), std::min(c->area.w, c->area.h) / 2 + out, theme_[Role::now], 0,
                        size::kFocusRing);
    } else {
        frame(list_, ring, theme_[Role::now], size::kFocusRing, size::kRadius);
    }
    list_.PopClipRect();
}

void Ui::draw_tip() {
    const bool by_key = memory_.ring && memory_.focus != 0;
    const Id id = memory_.hot != 0 && memory_.active == 0 ? memory_.hot : by_key ? memory_.focus : 0;
    const auto tip = tips_.find(id);
    const ControlRecord* c = find(report_.controls, id);
    if (tip == tips_.end() || c == nullptr) return;
    if (id == memory_.hot && input_.time - memory_.hot_since < options_.tip_delay) {
        wants_frame_ = true;
        return;
    }
    const float pad = px(8), gap = px(6);
    const float width = std::min(px(kTipWidth) * (presenting() ? 1.8F : 1), input_.size.x - 4 * pad);
    const ProseLayout layout = layout_prose(fonts_, spans_of(tip->second), width);
    Area box{c->area.x, c->area.bottom() + gap, std::ceil(layout.width) + 2 * pad, layout.height + pad};
    if (c->kind == Kind::region || c->area.h > input_.size.y / 3)
        box.x = input_.mouse.x, box.y = input_.mouse.y + px(18);
    if (box.bottom() > input_.size.y) box.y = std::max(0.0F, std::min(c->area.y, input_.mouse.y) - gap - box.h);
    box.x = std::round(std::clamp(box.x, gap, std::max(gap, input_.size.x - box.w - gap)));
    box.y = std::round(box.y);
    clips_.push_back({{0, 0, input_.size.x, input_.size.y}, false});
    list_.PushClipRectFullScreen();
    fill(list_, box, theme_.raise, size::kRadius);
    frame(list_, box, theme_[Role::faint], 1, size::kRadius);
    ground_ = theme_.raise;
    draw_layout(layout, {box.x + pad, box.y + pad / 2}, Role::text);
    list_.PopClipRect();
    clips_.pop_back();
}

}  // namespace texelscope::ui
