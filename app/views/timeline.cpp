// The timeline: transport, where the cursor stands, the levels, and the lanes.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/screen_parts.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Icon;
using ui::Role;

constexpr std::array<std::string_view, kLevels> kTimelineLetters{"T", "G", "S", "P", "E"};
constexpr std::array<std::string_view, kLevels> kTimelineLevelTips{
    "Triangles: one step draws a whole shape", "Stages: one step is a part of a shape's work",
    "Scanlines: one step is a row", "Pixels: one step is a sample", "Expressions: one step is a value"};
constexpr std::string_view kFirst = "First step (Home)", kTimelinePrevious = "One step back (Left)",
                           kTimelinePlay = "Play (Space)", kTimelinePause = "Pause (Space)",
                           kTimelineNext = "One step on (Right)", kLast = "Last step (End)";

constexpr std::string_view kWidestCount = "000/000";

[[nodiscard]] std::size_t level_at(int n) { return static_cast<std::size_t>(n); }

void draw_transport(const ViewContext& c, const Area& place) {
    struct Button {
        std::string_view name;
        Icon icon;
        std::string_view tip;
        Action action;
    };
    const bool playing = c.state.playing;
    const std::array<Button, 5> buttons{
        Button{"timeline/first", Icon::first, kFirst, action::StepEnd{false}},
        Button{"timeline/previous", Icon::previous, kTimelinePrevious, action::Step{-1}},
        Button{"timeline/play", playing ? Icon::pause : Icon::play, playing ? kTimelinePause : kTimelinePlay,
               action::Play{!playing}},
        Button{"timeline/next", Icon::next, kTimelineNext, action::Step{1}},
        Button{"timeline/last", Icon::last, kLast, action::StepEnd{true}}};
    float x = place.x;
    const float pitch = (place.w + place.h * 2 / 32) / 5, side = std::floor(std::min(place.h, pitch - 2));
    for (const Button& b : buttons) {
        if (ui::icon_button(c.ui, b.name, {std::round(x), place.y, side, side}, b.icon, b.tip, b.tip).clicked)
            c.act(b.action);
        x += pitch;
    }
}

void draw_level_column(const ViewContext& c, const Area& place, float pitch, float count_right) {
    const std::vector<Lane> lanes = c.derived.lanes();
    for (int n = 0; n < kLevels && level_at(n) < lanes.size(); ++n) {
        const Lane& lane = lanes[level_at(n)];
        const Area row = lane_place({place.x, place.y, place.w, place.h}, pitch, n);
        const bool here = static_cast<int>(c.state.cursor.level) == n;
        const Area letter{place.x, row.y - pitch * .17F, std::round(pitch), pitch};
        const ui::Control control =
            c.ui.control({fmt::format("timeline/level/{}", kTimelineLetters[level_at(n)]), letter, ui::Kind::choice,
                          kTimelineLevelTips[level_at(n)], kTimelineLevelTips[level_at(n)]});
        if (control.clicked) c.act(action::SetLevel{static_cast<Level>(n)});
        const float baseline = ui::baseline_at_middle(c.ui.font(Face::code_strong), row.centre().y);
        c.ui.text(Face::title, {letter.x, baseline}, here || control.hovered ? Role::now : Role::text,
                  kTimelineLetters[level_at(n)]);
        if (lane.count <= 0) continue;
        const std::string count =
            lane.current < 0 ? fmt::format("−/{}", lane.count) : fmt::format("{}/{}", lane.current + 1, lane.count);
        const float room =
            count_right - letter.x - ui::text_width(c.ui.font(Face::title), kTimelineLetters[level_at(n)]) - 3;
        const bool fits = ui::text_width(c.ui.font(Face::count), count) <= room;
        const std::string shown =
            fits ? count : ui::elided(c.ui.font(Face::count), std::to_string(lane.current + 1), room);
        c.ui.text_right(Face::count, {count_right, baseline}, Role::muted, shown);
    }
}

/// Whether first, current and last row of the box are the same range: then pixels count through all of it.
[[nodiscard]] bool rows_are_equal(const Derived& derived, const Path& row, const Lane& rows) {
    Steps& steps = derived.steps();
    const std::optional<Loop> here = steps.at(row).unit().loop;
    for (const Integer n : {Integer{0}, rows.count / 2, rows.count - 1}) {
        const Visit& visit = steps.at(row.prefix(2).child(rows.letter, rows.first + n * rows.step));
        if (!visit.found || visit.unit().loop != here) return false;
    }
    return here.has_value();
}

}  // namespace

Position position_of_cursor(const State& state, const Derived& derived) {
    const std::vector<Lane> lanes = derived.lanes();
    const Lane& lane = lanes[static_cast<std::size_t>(state.cursor.level)];
    if (state.cursor.step.empty()) return {"no shape", "nothing to step through"};
    const bool triangles = derived.method().triangles;
    const std::string_view shape = triangles ? "triangle" : "polygon";
    const auto counted = [](Integer n, Integer of) {
        return n < 0 ? fmt::format("− of {}", of) : fmt::format("{} of {}", n + 1, of);
    };
    const Lane& rows = lanes[2];
    const Lane& pixels = lanes[3];
    switch (state.cursor.level) {
        case Level::triangle: return {fmt::format("{} of the scene", shape), counted(lane.current, lane.count)};
        case Level::stage: return {fmt::format("stage of the {}", shape), counted(lane.current, lane.count)};
        case Level::scanline: return {"row of the stage", counted(lane.current, lane.count)};
        case Level::pixel:
            if (pixels.current >= 0 && rows.current >= 0 && rows_are_equal(derived, state.cursor.step.prefix(3), rows))
                return {"pixel of the box",
                        counted(rows.current * pixels.count + pixels.current, rows.count * pixels.count)};
            return {"pixel of the row", counted(pixels.current, pixels.count)};
        default: return {"value of the step", counted(lane.current, lane.count)};
    }
}

void draw_timeline(const ViewContext& c, const Area& place) {
    ui::Ui& ui = c.ui;
    ui.begin_panel("timeline", place, {}, {}, ui.theme().bg);
    const float pad = ui.px(ui::size::kPadding), pitch = std::floor((place.h - 3) / kLevels);
    const float side = std::min({ui.px(ui::size::kTransport), place.h * .4F, place.w * .03F + 8});
    const Area transport{place.x + pad, place.y + std::round(place.h * .136F), side * 5 + ui.px(2) * 4, side};
    draw_transport(c, transport);

    const float letters = transport.right() + ui.px(6);
    const float counts = letters + std::ceil(ui::text_width(ui.font(Face::count), kWidestCount)) + ui.px(6);
    const float lanes = std::round(counts + ui.px(8));
    const float top = place.y + std::round((place.h - pitch * kLevels) / 2) + std::round(pitch * .2F);

    const Position position = position_of_cursor(c.state, c.derived);
    const float line = ui.font(Face::note).em * 1.36F, bottom = place.bottom() - std::round(ui.px(9));
    if (transport.bottom() + 2 * line < bottom + line) {
        ui.text_within(Face::note, {transport.x, bottom - line}, transport.w, Role::muted, position.unit);
        ui.text_within(Face::line_number, {transport.x, bottom}, transport.w, Role::text, position.count);
    }
    draw_level_column(c, {letters, top, counts - letters, place.h}, pitch, counts);
    const Area area{lanes, top, place.right() - ui.px(17) - lanes, place.bottom() - top};
    draw_lanes(c, area, {true, pitch});
    ui.end_panel();
}

}  // namespace texelscope
