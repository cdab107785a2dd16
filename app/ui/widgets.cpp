#include "app/ui/widgets.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/ui/text.h"

namespace texelscope::ui {
namespace {

/// Ground and border by state; sets the ground that the label is read against. @return the label's role.
Role draw_ground(Ui& ui, const Area& area, const Control& c, const ButtonStyle& style) {
    const Theme& theme = ui.theme();
    const float radius = size::kRadius;
    if (!style.enabled) {
        if (!style.quiet) frame(ui.list(), area, theme.hairline, 1, radius);
        return Role::muted;
    }
    if (style.chosen || (c.held && c.hovered)) {
        fill(ui.list(), area, theme[Role::now], radius);
        ui.set_ground(theme[Role::now]);
        return Role::on_now;
    }
    if (!style.quiet) {
        fill(ui.list(), area, theme.raise, radius);
        ui.set_ground(theme.raise);
    }
    if (c.hovered || !style.quiet) frame(ui.list(), area, c.hovered ? theme[Role::now] : theme.hairline, 1, radius);
    return Role::text;
}

class GroundScope {
public:
    explicit GroundScope(Ui& ui) : ui_(ui), ground_(ui.ground()) {}
    ~GroundScope() { ui_.set_ground(ground_); }
    GroundScope(const GroundScope&) = delete;
    GroundScope& operator=(const GroundScope&) = delete;

private:
    Ui& ui_;
    Color ground_;
};

void draw_label(Ui& ui, const Area& area, std::string_view label, Face face, Role role) {
    if (label.find('$') == std::string_view::npos) {
        ui.text_centred(face, area.inset(ui.px(2), 0), role, label);
        return;
    }
    const float room = area.w - 2 * ui.px(2), x = area.x + (area.w - std::min(room, ui.rich_width(face, label))) / 2;
    ui.rich_within(face, {x, baseline_at_middle(ui.font(face), area.centre().y)}, room + 1, role, label);
}

}  // namespace

float button_width(const Ui& ui, std::string_view label, Face face) {
    return std::ceil(ui.rich_width(face, label)) + 2 * ui.px(10);
}

Control button(Ui& ui, std::string_view name, const Area& area, std::string_view label, std::string_view tip,
               const ButtonStyle& style) {
    const GroundScope keep(ui);
    const Control c = ui.control({name, area, style.kind, label, tip, style.enabled});
    const Role role = draw_ground(ui, area, c, style);
    draw_label(ui, area, label, style.face, role);
    return c;
}

Control icon_button(Ui& ui, std::string_view name, const Area& area, Icon icon, std::string_view label,
                    std::string_view tip, const ButtonStyle& style) {
    const GroundScope keep(ui);
    const Control c = ui.control({name, area, style.kind, label, tip.empty() ? label : tip, style.enabled});
    Role role = draw_ground(ui, area, c, style);
    if (icon == Icon::play && role == Role::text) role = Role::now;
    draw_icon(ui.list(), icon, area, ui.theme()[role]);
    return c;
}

Control toggle(Ui& ui, std::string_view name, const Area& area, std::string_view label, bool on, std::string_view tip,
               bool enabled) {
    ButtonStyle style;
    style.chosen = on;
    style.enabled = enabled;
    style.kind = Kind::toggle;
    return button(ui, name, area, label, tip, style);
}

std::optional<int> segments(Ui& ui, std::string_view name, const Area& area, std::span<const std::string_view> labels,
                            int chosen, std::span<const std::string_view> tips, Face face) {
    std::optional<int> picked;
    const GroundScope keep(ui);
    fill(ui.list(), area, ui.theme().raise, size::kRadius);
    frame(ui.list(), area, ui.theme().hairline, 1, size::kRadius);
    const float width = area.w / static_cast<float>(std::max<std::size_t>(1, labels.size()));
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const float left = std::round(area.x + width * static_cast<float>(i));
        const float right = std::round(area.x + width * static_cast<float>(i + 1));
        ui.set_ground(ui.theme().raise);
        ButtonStyle style;
        style.face = face;
        style.chosen = static_cast<int>(i) == chosen;
        style.quiet = true;
        style.kind = Kind::choice;
        const Area place{left, area.y, right - left, area.h};
        if (button(ui, fmt::format("{}/{}", name, i), place, labels[i], i < tips.size() ? tips[i] : "", style).clicked)
            picked = static_cast<int>(i);
    }
    return picked;
}

std::optional<int> tabs(Ui& ui, std::string_view name, const Area& area, std::span<const std::string_view> labels,
                        int chosen) {
    std::optional<int> picked;
    const float pad = ui.px(16);
    float natural = 0;
    for (const std::string_view label : labels) natural += text_width(ui.font(Face::title), label) + 2 * pad;
    float x = area.x;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        float width = text_width(ui.font(Face::title), labels[i]) + 2 * pad;
        if (natural > area.w) width = area.w / static_cast<float>(labels.size());
        const Area place{std::round(x), area.y, std::round(x + width) - std::round(x), area.h};
        x += width;
        const bool here = static_cast<int>(i) == chosen;
        const Control c = ui.control({fmt::format("{}/{}", name, i), place, Kind::tab, labels[i]});
        if (c.clicked) picked = static_cast<int>(i);
        ui.text_centred(Face::title, place.inset(ui.px(2), 0), here || c.hovered ? Role::text : Role::muted, labels[i]);
        const float bar = std::max(2.0F, ui.px(3));
        if (here) fill(ui.list(), {place.x + pad / 2, place.bottom() - bar, place.w - pad, bar}, ui.theme()[Role::now]);
    }
    hairline(ui, {area.x, area.bottom()}, area.w);
    return picked;
}

std::optional<double> slider(Ui& ui, std::string_view name, const Area& area, double value, const SliderRange& range,
                             std::string_view label, std::string_view tip) {
    const Control c = ui.control({name, area, Kind::slider, label, tip});
    const double span = std::max(range.high - range.low, 1e-300);
    const float knob = ui.px(6), left = area.x + knob, width = std::max(1.0F, area.w - 2 * knob);
    double next = value;
    if (c.held) {
        const double at = std::clamp(static_cast<double>((ui.input().mouse.x - left) / width), 0.0, 1.0);
        next = range.low + (range.step > 0 ? std::round(at * span / range.step) * range.step : at * span);
    }
    KeyPress press;
    const auto stride = [&] { return range.step * (press.ctrl ? 10 : press.shift ? 1.0 / 16 : 1); };
    while (ui.take_key(c.id, Key::right, &press)) next += stride();
    while (ui.take_key(c.id, Key::left, &press)) next -= stride();
    while (ui.take_key(c.id, Key::home, &press)) next = range.low;
    while (ui.take_key(c.id, Key::end, &press)) next = range.high;
    next = std::clamp(next, range.low, range.low + span);

    const float y = std::round(area.centre().y), track = ui.px(4);
    const float x = left + width * static_cast<float>(std::clamp((next - range.low) / span, 0.0, 1.0));
    const Theme& theme = ui.theme();
    fill(ui.list(), {left, y - track / 2, width, track}, theme.raise, track / 2);
    frame(ui.list(), {left, y - track / 2, width, track}, theme[Role::faint], 1, track / 2);
    fill(ui.list(), {left, y - track / 2, x - left, track}, theme[Role::now], track / 2);
    ui.list().AddCircleFilled({x, y}, knob, c.held ? theme[Role::now] : theme.raise);
    ui.list().AddCircle({x, y}, knob - .75F, theme[c.hovered || c.held ? Role::now : Role::muted], 0, 1.5F);
    return next != value ? std::optional(next) : std::nullopt;
}

Area badge(Ui& ui, Face face, glm::vec2 left_middle, std::string_view s, BadgeLook look) {
    const GroundScope keep(ui);
    const Theme& theme = ui.theme();
    const float pad = ui.px(5), h = std::round(ui.font(face).em * 1.5F);
    const Area area{std::round(left_middle.x), std::round(left_middle.y - h / 2),
                    std::ceil(ui.rich_width(face, s)) + 2 * pad, h};
    const bool filled = look == BadgeLook::filled;
    ui.set_ground(filled ? theme[Role::now] : theme.raise);
    fill(ui.list(), area, ui.ground(), size::kBadgeRadius);
    if (!filled) {
        const Color border = look == BadgeLook::outlined ? theme[Role::now] : theme.hairline;
        frame(ui.list(), area, border, 1, size::kBadgeRadius);
    }
    ui.rich(face, {area.x + pad, baseline_at_middle(ui.font(face), area.centre().y)},
            filled ? Role::on_now : Role::text, s);
    return area;
}

void current_row(Ui& ui, const Area& area) {
    const Color now = ui.theme()[Role::now];
    fill(ui.list(), area, with_alpha(now, alpha::kChosenRow), size::kRadius);
    fill(ui.list(), {area.x, area.y, ui.px(3), area.h}, now);
}

void hairline(Ui& ui, glm::vec2 from, float length, bool vertical) {
    const float x = std::round(from.x), y = std::round(from.y);
    fill(ui.list(), vertical ? Area{x, y, 1, length} : Area{x, y, length, 1}, ui.theme().hairline);
}

void sign_badge(Ui& ui, int edge, bool positive, const Area& area) {
    const Theme& theme = ui.theme();
    const Color color = theme[edge_role(edge)];
    const glm::vec2 c = area.centre();
    const float arm = std::round(area.w * .28F), thick = std::max(1.5F, area.w * .11F);
    fill(ui.list(), area, positive ? color : theme.canvas, size::kBadgeRadius);
    if (!positive) frame(ui.list(), area, color, 1.5F, size::kBadgeRadius);
    const Color ink = !positive                                                            ? color
                      : contrast(color, theme.canvas) > contrast(color, theme[Role::text]) ? theme.canvas
                                                                                           : theme[Role::text];
    line(ui.list(), {c.x - arm, c.y}, {c.x + arm, c.y}, thick, ink);
    if (positive) line(ui.list(), {c.x, c.y - arm}, {c.x, c.y + arm}, thick, ink);
}

}  // namespace texelscope::ui
