#include "app/views/screen.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/screen_parts.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::array<std::string_view, 3> kUsualViews{"texels", "formula", "code"},
    kSolidsViews{"texels", "solids", "code"};
constexpr std::string_view kCanvas = "canvas", kVariables = "variables", kScreenLesson = "lesson",
                           kLessonTab = "Lesson", kPalette = "palette", kDifference = "difference",
                           kValuesTab = "Values";
constexpr std::string_view kNoView = "There is no view \"{}\" in this version.";
constexpr std::string_view kNothingOpen = "Nothing is open. L lists the lessons, Ctrl+O opens a scene.";

void draw_view(const ViewContext& c, std::string_view name, const Area& place) {
    if (place.empty()) return;
    if (name == kScreenLesson) return draw_lesson_panel(c, place);
    if (const View* view = find_view(name)) return view->draw(c, place);
    const Area content = c.ui.begin_panel(fmt::format("absent/{}", name), place, name);
    static_cast<void>(c.ui.prose("absent", content, ui::spans_of(fmt::format(kNoView, name), Role::muted)));
    c.ui.end_panel();
}

/// What each of the side's places shows: with fewer views than places the last grow.
void draw_slots(const ViewContext& c, const ScreenLayout& at) {
    const std::vector<std::string_view> names = side_views(c.state);
    if (names.size() == 1) return draw_view(c, names[0], at.side);
    if (names.size() == 2) {
        const float top = at.slots[0].h;
        draw_view(c, names[0], {at.side.x, at.side.y, at.side.w, top});
        return draw_view(c, names[1], at.slots[2]);
    }
    for (std::size_t n = 0; n < at.slots.size(); ++n) draw_view(c, names[n], at.slots[n]);
}

/// The tabs' views, most looked at first.
[[nodiscard]] std::vector<std::string_view> tab_views(const State& state, const ScreenLayout& at) {
    std::vector<std::string_view> names = side_views(state);
    if (names.size() >= 3) std::rotate(names.begin(), names.begin() + 1, names.begin() + 3);
    const auto palette = std::find(names.begin(), names.end(), kPalette);
    if (state.look.palette && palette != names.end()) std::rotate(names.begin(), palette, palette + 1);
    if (state.look.difference) {  // what was asked for is the tab that is open
        const auto asked = std::find(names.begin(), names.end(), kDifference);
        std::rotate(names.begin(), asked, asked + 1);
    }
    if (at.variables.empty()) names.push_back(kVariables);
    if (at.lesson.empty()) names.push_back(kScreenLesson);
    return names;
}

[[nodiscard]] std::string_view tab_title(std::string_view name) {
    if (name == kScreenLesson) return kLessonTab;
    if (name == kVariables) return kValuesTab;
    const View* view = find_view(name);
    return view != nullptr ? view->title : name;
}

void draw_tabs(const ViewContext& c, const ScreenLayout& at) {
    const std::vector<std::string_view> names = tab_views(c.state, at);
    std::vector<std::string_view> titles;
    for (const std::string_view name : names) titles.push_back(tab_title(name));
    const int chosen = std::clamp(c.state.look.tab, 0, static_cast<int>(names.size()) - 1);
    static_cast<void>(c.ui.begin_panel("tabs", at.tabs));
    if (const auto picked =
            ui::tabs(c.ui, "tab", {at.tabs.x + 1, at.tabs.y, at.tabs.w - 1, at.tabs.h - 1}, titles, chosen)) {
        Look look = c.state.look;
        look.tab = *picked;
        c.act(action::SetLook{look});
    }
    c.ui.end_panel();
    draw_view(c, names[static_cast<std::size_t>(chosen)], at.tab);
}

void draw_side(const ViewContext& c, const ScreenLayout& at, std::span<const LessonEntry> entries) {
    if (at.side.empty()) return;
    if (c.state.overlay == Overlay::keys) return draw_keys_panel(c, at.side);
    if (c.state.overlay == Overlay::lessons) {
        // Beside tabs there is too little room for both: rows of the list are worth more than a summary.
        const float height = at.tabbed && !at.lesson.empty() ? at.lesson.bottom() - at.side.y : at.side.h;
        return draw_lesson_list(c, {at.side.x, at.side.y, at.side.w, height}, entries);
    }
    if (at.tabbed)
        draw_tabs(c, at);
    else
        draw_slots(c, at);
}

void draw_nothing_open(const ViewContext& c) {
    const glm::vec2 size = c.ui.input().size;
    c.ui.set_ground(c.ui.theme().bg);
    c.ui.text_centred(Face::prose, {0, 0, size.x, size.y}, Role::muted, kNothingOpen);
}

}  // namespace

std::vector<std::string_view> side_views(const State& state) {
    std::vector<std::string_view> names;
    if (state.document && state.document->lesson) {
        const Lesson& lesson = *state.document->lesson;
        names.assign(lesson.views.begin(), lesson.views.end());
        const int last = std::min(state.cursor.beat, static_cast<int>(lesson.beats.size()) - 1);
        for (int n = 0; n <= last; ++n) {
            const std::vector<std::string>& set = lesson.beats[static_cast<std::size_t>(n)].set.views;
            if (!set.empty()) names.assign(set.begin(), set.end());
        }
    }
    names.erase(std::remove(names.begin(), names.end(), kCanvas), names.end());
    if (names.empty()) {
        const bool solids = state.document && !state.document->lesson && !state.document->scene.meshes.empty();
        const auto& usual = solids ? kSolidsViews : kUsualViews;
        names.assign(usual.begin(), usual.end());
    }
    if (state.look.palette && std::find(names.begin(), names.end(), kPalette) == names.end()) {
        if (names.size() == kMaxViews) names.erase(names.begin());
        names.insert(names.begin(), kPalette);
    }
    const bool shown = std::find(names.begin(), names.end(), kDifference) != names.end();
    if (state.look.difference && !shown) names.back() = kDifference;
    return names;
}

ScreenLayout layout_of(const State& state, glm::vec2 window) {
    const std::vector<std::string_view> names = side_views(state);
    const bool ring = names.size() >= 3 && names[1] == "ring";
    return layout_screen(window, state.look, ring ? SideCut::face : SideCut::usual);
}

void draw_screen(const ViewContext& c) {
    ui::Ui& ui = c.ui;
    const glm::vec2 size = ui.input().size;
    if (c.state.look.blank) return ui::fill(ui.list(), {0, 0, size.x, size.y}, ui::hex(0x000000));
    ui::fill(ui.list(), {0, 0, size.x, size.y}, ui.theme().bg);
    const ScreenLayout at = layout_of(c.state, size);
    const std::vector<LessonEntry> entries =
        c.state.overlay == Overlay::lessons ? lesson_entries(c.lessons) : std::vector<LessonEntry>{};
    if (!c.state.document) {
        if (c.state.overlay == Overlay::lessons || c.state.overlay == Overlay::keys)
            draw_side(c, at, entries);
        else
            draw_nothing_open(c);
        draw_message(c, at.canvas);
        return;
    }
    const bool presenting = c.state.look.presenting;
    if (presenting)
        draw_presenter_header(c, at.header);
    else
        draw_header(c, at.header);
    draw_view(c, kCanvas, at.canvas);
    draw_side(c, at, entries);
    draw_view(c, kVariables, at.variables);
    if (c.state.overlay != Overlay::lessons)
        draw_lesson_panel(c, at.lesson);
    else if (!at.tabbed)
        draw_lesson_summary(c, at.lesson, entries);
    if (presenting)
        draw_caption(c, at.caption), draw_presenter_timeline(c, at.timeline);
    else
        draw_timeline(c, at.timeline);
    draw_message(c, at.canvas);
    if (!presenting) draw_header_list(c, at);
}

}  // namespace texelscope
