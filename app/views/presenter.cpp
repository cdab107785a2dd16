// The screen for a lecture hall: fewer things, twice as large.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/screen_parts.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Icon;
using ui::Role;

constexpr std::string_view kLeave = "Stop presenting (F5)", kStepForward = "Step forward",
                           kStepTip = "One step on (Right)";
constexpr std::string_view kPresenterPrevious = "One step back (Left)", kPresenterPlay = "Play (Space)",
                           kPresenterPause = "Pause (Space)", kPresenterNext = "One step on (Right)";
constexpr std::string_view kBeat = "beat {} of {}", kOf = " of ";

}  // namespace

void draw_presenter_header(const ViewContext& c, const Area& place) {
    ui::Ui& ui = c.ui;
    static_cast<void>(ui.begin_panel("header", place, {}, {}, ui.theme().bg));
    const float baseline = ui::baseline_at_middle(ui.font(Face::lesson_title), place.centre().y), pad = ui.px(16);
    const float side = std::min(ui.px(32), place.h - 8);
    const Area leave{place.right() - pad - side, place.y + std::round((place.h - side) / 2), side, side};
    ui::ButtonStyle quiet;
    quiet.quiet = true;
    if (ui::icon_button(ui, "leave", leave, Icon::close, kLeave, kLeave, quiet).clicked) {
        Look look = c.state.look;
        look.presenting = false;
        c.act(action::SetLook{look});
    }
    float right = leave.x - pad;
    const std::vector<Crumb> all = crumbs(c.state, c.derived);
    for (std::size_t n = all.size(); n-- > 0 && n + 2 >= all.size();) {
        const float value = ui.rich_width(Face::code, all[n].value),
                    what = ui::text_width(ui.font(Face::title), all[n].what);
        if (right - value - what < place.x + place.w / 2) break;
        ui.rich(Face::code, {right - value, baseline}, n + 1 == all.size() ? Role::now : Role::text, all[n].value);
        ui.text_right(Face::title, {right - value - ui.px(8), baseline}, Role::muted, all[n].what);
        right -= value + what + ui.px(8) + ui.px(26);
    }
    const State& state = c.state;
    float x = place.x + pad;
    const bool lesson = state.document->lesson.has_value();
    if (lesson)
        x += ui.text(Face::code, {x, baseline}, Role::muted, fmt::format("{:02}", state.document->lesson->number)) +
             ui.px(14);
    ui.text_within(Face::lesson_title, {x, baseline}, right - x, Role::text,
                   lesson ? state.document->lesson->title : state.document->id);
    ui.end_panel();
}

void draw_caption(const ViewContext& c, const Area& place) {
    ui::Ui& ui = c.ui;
    static_cast<void>(ui.begin_panel("caption", place));
    const float pad = ui.px(16), high = std::min(ui.px(44), place.h - 8), wide = std::round(high * 1.2F);
    const float baseline = ui::baseline_at_middle(ui.font(Face::title), place.centre().y);
    const Area button{place.x + pad, place.y + std::round((place.h - high) / 2), wide, high};
    const float label = ui::text_width(ui.font(Face::title), kStepForward);
    const ui::Control control = ui.control({"caption/step",
                                            {button.x, button.y, wide + ui.px(14) + label, high},
                                            ui::Kind::button,
                                            kStepForward,
                                            kStepTip});
    if (control.clicked) c.act(action::Step{1});
    const bool down = control.held && control.hovered;
    const ui::Color now = ui.theme()[Role::now];
    if (down) ui::fill(ui.list(), button, now, ui::size::kRadius);
    ui::frame(ui.list(), button, now, control.hovered ? 3.0F : 2.0F, ui::size::kRadius);
    ui::draw_icon(ui.list(), Icon::arrow_right, button, down ? ui.theme()[Role::on_now] : now);
    float x = button.right() + ui.px(14);
    x += ui.text_within(Face::title, {x, baseline}, place.right() - pad - x, Role::text, kStepForward) + ui.px(14);
    const int count = beat_count(c.state);
    if (count == 0) return ui.end_panel();
    ui::hairline(ui, {x, place.y + place.h * .22F}, place.h * .56F, true);
    x += ui.px(26);
    const std::string beat = fmt::format(kBeat, c.state.cursor.beat + 1, count);
    const float right = place.right() - pad - ui::text_width(ui.font(Face::title), beat) - ui.px(20);
    ui.text_right(Face::title, {place.right() - pad, baseline}, Role::muted, beat);
    if (right - x > ui.px(60)) {
        const Beat& at = c.state.document->lesson->beats[static_cast<std::size_t>(c.state.cursor.beat)];
        ui::ProseStyle style;
        style.lead = 1.28F;
        const std::vector<ui::Span> spans = ui::spans_of(at.lead.empty() ? at.prose : at.lead);
        const float height = ui::layout_prose(ui.fonts(), spans, right - x - ui.px(8), style).height;
        const Area area = ui.begin_scroll("caption/prose", {x, place.y + 1, right - x, place.h - 1});
        const float top = std::max(0.0F, std::round((place.h - height) / 2));
        ui.end_scroll(top +
                      ui.prose("caption/lead", {area.x, area.y + top, right - x - ui.px(8), area.h}, spans, style));
    }
    ui.end_panel();
}

void draw_presenter_timeline(const ViewContext& c, const Area& place) {
    struct Button {
        std::string_view name;
        Icon icon;
        std::string_view tip;
        Action action;
    };
    ui::Ui& ui = c.ui;
    static_cast<void>(ui.begin_panel("timeline", place, {}, {}, ui.theme().bg));
    const bool playing = c.state.playing;
    const std::array<Button, 3> buttons{
        Button{"timeline/previous", Icon::previous, kPresenterPrevious, action::Step{-1}},
        Button{"timeline/play", playing ? Icon::pause : Icon::play, playing ? kPresenterPause : kPresenterPlay,
               action::Play{!playing}},
        Button{"timeline/next", Icon::next, kPresenterNext, action::Step{1}}};
    const float side = std::min(ui.px(ui::size::kPresentingButton), place.h - 16),
                y = place.y + std::round((place.h - side) / 2);
    float x = place.x + ui.px(16);
    for (const Button& b : buttons) {
        if (ui::icon_button(ui, b.name, {x, y, side, side}, b.icon, b.tip, b.tip).clicked) c.act(b.action);
        x += side + ui.px(8);
    }
    x += ui.px(8);
    const std::string counted = position_of_cursor(c.state, c.derived).count;
    const std::size_t of = counted.find(kOf);
    const std::string count = of == std::string::npos
                                  ? counted
                                  : fmt::format("{}/{}", counted.substr(0, of), counted.substr(of + kOf.size()));
    const float room = ui::text_width(ui.font(Face::code), "00000/00000"),
                baseline = ui::baseline_at_middle(ui.font(Face::code), place.centre().y);
    if (place.w > 3 * (x - place.x + room)) {
        const float width = ui.text_within(Face::code, {x, baseline}, room, Role::text, count);
        x += std::max(width, ui::text_width(ui.font(Face::code), "000/000")) + ui.px(26);
    }
    const float pitch = std::floor((place.h - 8) / kLevels);
    draw_lanes(c,
               {std::round(x), place.y + std::round((place.h - pitch * kLevels) / 2 + pitch * .2F),
                place.right() - ui.px(17) - std::round(x), pitch * kLevels},
               {false, pitch});
    ui.end_panel();
}

}  // namespace texelscope
