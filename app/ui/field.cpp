// The text field of widgets.h.
#include <algorithm>
#include <cmath>

#include "app/ui/text.h"
#include "app/ui/widgets.h"

namespace texelscope::ui {
namespace {

constexpr std::size_t kFieldLongest = 256;

/// `text` without control characters and without bytes that are no UTF-8.
std::string printable(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t from = at;
        const char32_t c = next_code_point(text, at);
        const bool bad = c == 0xFFFD && text.substr(from, at - from) != "\xEF\xBF\xBD";
        if (c >= 0x20 && c != 0x7F && !bad) out += text.substr(from, at - from);
    }
    return out;
}

void insert(UiMemory& m, std::string_view typed) {
    const std::string s = printable(typed);
    if (m.field_text.size() + s.size() > kFieldLongest) return;
    m.field_text.insert(m.caret, s);
    m.caret += s.size();
}

std::size_t next_start(std::string_view text, std::size_t at) {
    if (at < text.size()) static_cast<void>(next_code_point(text, at));
    return at;
}

void edit(Ui& ui, Id id) {
    UiMemory& m = ui.memory();
    insert(m, ui.input().text);
    insert(m, ui.input().pasted);
    while (ui.take_key(id, Key::left)) m.caret = previous_code_point(m.field_text, m.caret);
    while (ui.take_key(id, Key::right)) m.caret = next_start(m.field_text, m.caret);
    while (ui.take_key(id, Key::home)) m.caret = 0;
    while (ui.take_key(id, Key::end)) m.caret = m.field_text.size();
    while (ui.take_key(id, Key::backspace)) {
        const std::size_t from = previous_code_point(m.field_text, m.caret);
        m.field_text.erase(from, m.caret - from);
        m.caret = from;
    }
    while (ui.take_key(id, Key::del)) m.field_text.erase(m.caret, next_start(m.field_text, m.caret) - m.caret);
    // What was typed must not be a command as well.
    for (const KeyPress& press : ui.unused_keys()) {
        const bool letter = press.key >= Key::a && !press.alt && (!press.ctrl || press.key == Key::v);
        if (letter || press.key == Key::space || press.key == Key::up || press.key == Key::down)
            static_cast<void>(ui.take_key(id, press.key));
    }
}

void draw(Ui& ui, const Area& area, const Control& c, std::string_view shown, std::string_view hint, Face face) {
    const Theme& theme = ui.theme();
    const UiMemory& m = ui.memory();
    const bool editing = m.field == c.id;
    const Color before = ui.ground();
    fill(ui.list(), area, theme.canvas, size::kRadius);
    frame(ui.list(), area, editing || c.hovered ? theme[Role::now] : theme.hairline, 1, size::kRadius);
    ui.set_ground(theme.canvas);
    const float pad = ui.px(6), baseline = baseline_at_middle(ui.font(face), area.centre().y);
    const Area inside = area.inset(pad, 0);
    const float before_caret = editing ? text_width(ui.font(face), shown.substr(0, m.caret)) : 0;
    const float shift = std::max(0.0F, before_caret + 2 - inside.w);
    if (!editing) {
        ui.text_within(face, {inside.x, baseline}, inside.w, shown.empty() ? Role::muted : Role::text,
                       shown.empty() ? hint : shown);
    } else {
        ui.list().PushClipRect({inside.x, area.y}, {inside.right() + 1, area.bottom()}, true);
        draw_text(ui.list(), ui.font(face), {inside.x - shift, baseline}, theme[Role::text], shown);
        const float x = std::round(inside.x + before_caret - shift), up = std::round(ui.font(face).em * .9F);
        fill(ui.list(), {x, baseline - up, std::max(1.0F, ui.px(1)), up * 1.3F}, theme[Role::now]);
        ui.list().PopClipRect();
    }
    ui.set_ground(before);
}

}  // namespace

FieldResult field(Ui& ui, std::string_view name, const Area& area, std::string_view value, std::string_view hint,
                  std::string_view tip, Face face) {
    UiMemory& m = ui.memory();
    const Control c = ui.control({name, area, Kind::field, hint.empty() ? name : hint, tip});
    FieldResult result;
    result.cancelled = m.cancelled_field == c.id;
    if (m.field == c.id && !c.focused) {
        result.committed = m.field_text != value;
        m.field = 0;
    } else if (c.focused && m.field != c.id && m.field != 0) {
        ui.request_frame();  // the field that was left is yet to hand over its text
    } else if (c.focused && m.field == 0 && !c.held) {
        m.field = c.id;
        m.field_text = std::string(value);
        m.caret = m.field_text.size();
    }
    if (m.field == c.id) {
        edit(ui, c.id);
        if (ui.take_key(c.id, Key::enter)) {
            result.committed = true;
            m.field = 0;
            ui.set_focus(0, false);
        }
    }
    result.editing = m.field == c.id;
    result.text = result.editing || result.committed ? m.field_text : std::string(value);
    draw(ui, area, c, result.text, hint, face);
    return result;
}

}  // namespace texelscope::ui
