// Frames, focus and controls. Text is in ui_text.cpp, panels and scrolling in ui_places.cpp.
#include "app/ui/ui.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace texelscope::ui {
namespace {

constexpr double kFadeTime = 0.120;  ///< [s]

bool takes_focus(const ControlRecord& c) { return c.enabled && c.focusable; }

bool hits(const ControlRecord& c, glm::vec2 mouse, const Area& area) {
    if (!c.clip.contains(mouse) || !area.contains(mouse)) return false;
    return !c.round || glm::distance(area.centre(), mouse) <= std::min(area.w, area.h) / 2;
}

}  // namespace

Ui::Ui(UiMemory& memory, const Input& input, const Fonts& fonts, const Theme& theme, ImDrawList& list,
       const UiOptions& options)
    : memory_(memory),
      input_(input),
      fonts_(fonts),
      theme_(theme),
      list_(list),
      options_(options),
      used_keys_(input.keys.size(), false),
      ground_(theme.bg) {
    push_clip({0, 0, input.size.x, input.size.y}, false);
    memory_.focus_moved = false;
    memory_.cancelled_field = 0;
    if (!input_.down[0] && !input_.released[0]) memory_.active = 0;
    find_hot();
    if (input_.pressed[1]) ++memory_.right_presses, memory_.right_press = input_.mouse;
    if (input_.pressed[0]) {
        ++memory_.presses;
        memory_.active = memory_.hot;
        memory_.press = input_.mouse;
        // A click leaves the arrow keys and Space to stepping and playing; only a field wants keys at once.
        const auto hot = std::find_if(memory_.controls.begin(), memory_.controls.end(),
                                      [&](const ControlRecord& c) { return c.id == memory_.hot; });
        set_focus(hot != memory_.controls.end() && hot->kind == Kind::field ? memory_.hot : 0, false);
    }
    move_focus();
}

void Ui::find_hot() {
    Id hot = 0;
    // The latest drawn lies on top. An area that was only grown to the least target yields to a drawn one below.
    for (const bool as_drawn : {true, false}) {
        for (auto c = memory_.controls.rbegin(); c != memory_.controls.rend() && hot == 0; ++c)
            if ((!as_drawn || c->kind != Kind::region) && hits(*c, input_.mouse, as_drawn ? c->area : c->hit))
                hot = c->id;
    }
    for (auto c = memory_.controls.rbegin(); c != memory_.controls.rend() && wheel_target_ == 0; ++c)
        if (memory_.scroll.count(c->id) != 0 && c->clip.contains(input_.mouse) && c->area.contains(input_.mouse))
            wheel_target_ = c->id;
    if (memory_.active != 0 && hot != memory_.active) hot = 0;
    if (hot != memory_.hot) memory_.hot_since = input_.time;
    memory_.hot = hot;
}

void Ui::set_focus(Id id, bool ring) {
    Id target = 0;
    for (const ControlRecord& c : memory_.controls)
        if (c.id == id && takes_focus(c)) target = id;
    memory_.focus_moved = target != memory_.focus;
    memory_.focus = target;
    memory_.ring = ring;
}

void Ui::move_focus() {
    const std::vector<ControlRecord>& all = memory_.controls;
    for (std::size_t k = 0; k < input_.keys.size(); ++k) {
        const KeyPress& key = input_.keys[k];
        if (key.key == Key::escape && memory_.focus != 0) {
            used_keys_[k] = true;
            memory_.cancelled_field = std::exchange(memory_.field, 0);
            set_focus(0, false);
        }
        const bool by_panel = key.key == Key::f6;
        if ((key.key != Key::tab && !by_panel) || key.ctrl || key.alt) continue;
        std::vector<Id> stops;
        Id panel_of_focus = 0;
        for (const ControlRecord& c : all)
            if (c.id == memory_.focus) panel_of_focus = c.panel;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto same_panel = [&](const ControlRecord& c) { return c.panel == all[i].panel && takes_focus(c); };
            const auto before = all.begin() + static_cast<std::ptrdiff_t>(i);
            if (!takes_focus(all[i]) || (by_panel && std::any_of(all.begin(), before, same_panel))) continue;
            stops.push_back(all[i].id);
            if (by_panel && memory_.focus != 0 && all[i].panel == panel_of_focus) memory_.focus = all[i].id;
        }
        if (stops.empty()) continue;
        used_keys_[k] = true;
        const auto at = std::find(stops.begin(), stops.end(), memory_.focus);
        const std::size_t n = stops.size(), now = static_cast<std::size_t>(at - stops.begin());
        std::size_t next = key.shift ? n - 1 : 0;
        if (at != stops.end()) next = (now + (key.shift ? n - 1 : 1)) % n;
        const Id before = memory_.focus;
        set_focus(stops[next], true);
        memory_.focus_moved = before != memory_.focus || n == 1;
    }
}

float Ui::px(float at_100) const {
    const float scaled = std::round(at_100 * fonts_.spec().scale);
    return at_100 > 0 ? std::max(1.0F, scaled) : scaled;
}

std::vector<KeyPress> Ui::unused_keys() const {
    std::vector<KeyPress> out;
    for (std::size_t k = 0; k < used_keys_.size(); ++k)
        if (!used_keys_[k]) out.push_back(input_.keys[k]);
    return out;
}

bool Ui::take_key(Id id, Key key, KeyPress* press) {
    if (id == 0 || memory_.focus != id) return false;
    for (std::size_t k = 0; k < used_keys_.size(); ++k) {
        if (used_keys_[k] || input_.keys[k].key != key || input_.keys[k].alt) continue;
        used_keys_[k] = true;
        if (press != nullptr) *press = input_.keys[k];
        return true;
    }
    return false;
}

Control Ui::control(const ControlSpec& spec) {
    const Id id = id_of(spec.name);
    const Area hit = grown_to(spec.area, size::kLeastTarget);
    report_.controls.push_back({id, panel_, spec.kind, spec.area, hit, clip(), spec.enabled, spec.focusable, spec.round,
                                std::string(spec.name), std::string(spec.label)});
    if (!spec.tip.empty()) tips_[id] = std::string(spec.tip);
    Control c;
    c.id = id;
    c.hovered = memory_.hot == id;
    if (!spec.enabled) return c;
    c.focused = memory_.focus == id;
    c.held = memory_.active == id && (input_.down[0] || input_.released[0]);
    c.pressed = c.held && input_.pressed[0];
    c.double_clicked = c.hovered && input_.double_clicked;
    if (c.held) {
        c.drag_total = input_.mouse - memory_.press;
        c.drag = c.pressed ? c.drag_total : input_.mouse - memory_.mouse;
        c.dragging = c.drag_total != glm::vec2(0);
        c.clicked = input_.released[0] && c.hovered;
    }
    const bool has_command = spec.kind != Kind::field && spec.kind != Kind::region && spec.kind != Kind::slider;
    if (c.focused && has_command && (take_key(id, Key::enter) || take_key(id, Key::space))) c.clicked = c.by_key = true;
    return c;
}

float Ui::fade(std::string_view name, bool on) {
    const Id id = id_of(name);
    const auto [entry, fresh] = memory_.fades.try_emplace(id, UiMemory::Fade{on ? 1.0F : 0.0F, input_.time});
    UiMemory::Fade& f = entry->second;
    const float goal = on ? 1.0F : 0.0F;
    const auto step = static_cast<float>(std::max(0.0, input_.time - f.time) / kFadeTime);
    f.time = input_.time;
    const float off = f.value - goal, left = std::max(0.0F, std::abs(off) - step);
    f.value = options_.reduced_motion ? goal : goal + std::copysign(left, off);
    if (f.value != goal) wants_frame_ = true;
    return f.value;
}

float Ui::glow(std::string_view name, std::uint64_t what) {
    const auto [entry, fresh] = memory_.glows.try_emplace(id_of(name), UiMemory::Glow{what, -kFadeTime});
    UiMemory::Glow& g = entry->second;
    if (g.what != what) g = {what, input_.time};
    const double left = 1 - (input_.time - g.since) / kFadeTime;
    if (left <= 0 || options_.reduced_motion) return 0;
    wants_frame_ = true;
    return static_cast<float>(std::min(left, 1.0));
}

void Ui::end() {
    if (input_.released[0] || !input_.down[0]) memory_.active = 0;
    const auto exists = [&](Id id) {
        return std::any_of(report_.controls.begin(), report_.controls.end(),
                           [id](const ControlRecord& c) { return c.id == id && takes_focus(c); });
    };
    if (memory_.focus != 0 && !exists(memory_.focus)) memory_.focus = 0;
    if (memory_.field != 0 && !exists(memory_.field)) memory_.field = 0;
    draw_ring();
    draw_tip();
    memory_.mouse = input_.mouse;
    memory_.controls = report_.controls;
    while (!clips_.empty()) {
        list_.PopClipRect();
        clips_.pop_back();
    }
}

}  // namespace texelscope::ui
