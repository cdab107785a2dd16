// The list of lessons: groups in two columns where there is room, and what the chosen one is about.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/screen_parts.h"
#include "app/views/terms.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kLessonListTitle = "Lessons", kThen = "then", kLessonKeys = "1-9, a-l",
                           kLessonListClose = "close", kLessonListCloseTip = "Close the list (Esc)";
constexpr std::string_view kAbsent = "Not in this version.", kOpen = "open", kLessonListChoose = "choose",
                           kArrows = "↑ ↓";

struct Group {
    std::string_view title;
    std::vector<int> entries;
};

[[nodiscard]] std::vector<Group> groups_of(std::span<const LessonEntry> entries) {
    std::vector<Group> groups;
    for (std::size_t n = 0; n < entries.size(); ++n) {
        const auto same = [&](const Group& g) { return g.title == entries[n].group; };
        auto at = std::find_if(groups.begin(), groups.end(), same);
        if (at == groups.end()) at = groups.insert(groups.end(), Group{entries[n].group, {}});
        at->entries.push_back(static_cast<int>(n));
    }
    return groups;
}

class ListDrawer {
public:
    ListDrawer(const ViewContext& c, std::span<const LessonEntry> entries, const Area& area)
        : c_(c),
          entries_(entries),
          area_(area),
          row_(std::max(c.ui.px(32), std::round(c.ui.font(Face::prose).em * 1.7F))),
          heading_(std::round(row_ * .97F)) {}

    /// Scrolls to the chosen lesson when another is chosen.
    void draw() {
        place();
        const int chosen = c_.state.chosen_lesson;
        for (const Line& line : lines_) {
            if (line.entry != chosen) continue;
            const float above = line.first ? heading_ : 0;  // its group's name is worth seeing, too
            follow(c_.ui, kScroll, area_.h, height_, line.at.y - above, line.at.bottom(),
                   static_cast<float>(chosen) + 1);
        }
        const Area inner = c_.ui.begin_scroll(kScroll, area_);
        for (Line& line : lines_) {
            line.at = line.at.moved(inner.x, inner.y);
            const bool whole = line.at.y > area_.y - 1 && line.at.bottom() < area_.bottom() + 1;
            if (line.entry >= 0)
                draw_entry(line.entry, line.at, whole);
            else if (whole)
                draw_heading(line.group, line.at);
        }
        c_.ui.end_scroll(height_);
    }

private:
    static constexpr std::string_view kScroll = "lessons/scroll";
    struct Line {
        Area at;  ///< in the content
        int entry = -1;
        std::string_view group;
        bool first = false;  ///< of its group
    };

    void place() {
        const std::vector<Group> groups = groups_of(entries_);
        constexpr float kLeastColumn = 268;
        const bool two = area_.w >= 2 * kLeastColumn * (row_ / 32);
        const float gap = c_.ui.px(8), width = two ? std::floor((area_.w - gap) / 2) : area_.w;
        const auto rows = [&](const Group& g) { return heading_ + row_ * static_cast<float>(g.entries.size()); };
        float all = 0, x = 0, y = 0, done = 0;
        for (const Group& g : groups) all += rows(g);
        bool right = !two;
        for (const Group& g : groups) {
            if (!right && done >= all / 2 - row_) right = true, x += width + gap, y = 0;
            lines_.push_back({{x, y, width, heading_}, -1, g.title, false});
            y += heading_;
            for (const int n : g.entries) {
                lines_.push_back({{x, y, width, row_}, n, {}, n == g.entries.front()});
                y += row_;
            }
            done += rows(g);
            height_ = std::max(height_, y);
        }
    }
    void draw_heading(std::string_view title, const Area& at) const {
        ui::Ui& ui = c_.ui;
        const float baseline = ui::baseline_at_middle(ui.font(Face::title), at.centre().y);
        const float x = at.x + ui.px(8),
                    end =
                        x + ui.text_within(Face::title, {x, baseline}, at.w - ui.px(16), Role::muted, title) + ui.px(9);
        if (end < at.right() - ui.px(8)) ui::hairline(ui, {end, at.centre().y}, at.right() - ui.px(8) - end);
    }
    void draw_entry(int n, const Area& at, bool whole) const {
        ui::Ui& ui = c_.ui;
        const State& state = c_.state;
        const LessonEntry& entry = entries_[static_cast<std::size_t>(n)];
        const bool absent = entry.lesson == nullptr, chosen = n == state.chosen_lesson;
        const bool open =
            !absent && state.document && state.document->lesson && state.document->lesson->id == entry.lesson->id;
        const Area box{at.x, at.y + 1, at.w, at.h - 2};
        const ui::Control control =
            ui.control({fmt::format("lesson/{}", entry.number), box, ui::Kind::button, entry.title});
        const bool moved = whole && ui.input().mouse != ui.memory().mouse;
        if (((control.hovered && moved) || control.focused) && !chosen) c_.act(action::ChooseLesson{n});
        if (!whole) return;  // no half a row at the end of the panel
        if (control.clicked) c_.request({ShellRequest::What::open_lesson, entry.number});
        if (open) ui::current_row(ui, box);
        if (chosen || control.hovered) ui::frame(ui.list(), box, ui.theme()[Role::now], 1, ui::size::kRadius);
        ui.set_ground(open ? ui::over(ui.theme()[Role::now], ui::alpha::kChosenRow, ui.theme().panel)
                           : ui.theme().panel);

        const float middle = box.centre().y, side = std::round(row_ * .7F), tick = std::round(row_ * .4F);
        if (std::count(state.done.begin(), state.done.end(), entry.number) > 0)
            ui::draw_icon(ui.list(), ui::Icon::tick, {at.x + ui.px(2), std::round(middle - tick / 2), tick, tick},
                          ui.theme()[Role::muted]);
        float x = at.x + ui.px(8) + tick;
        draw_lesson_icon(ui, entry.number, {std::round(x), std::round(middle - side / 2), side, side}, absent);
        x += side + ui.px(9);
        const float right = draw_right(entry, open, at);
        ui.text_within(Face::prose, {x, ui::baseline_at_middle(ui.font(Face::prose), middle)}, right - x,
                       absent ? Role::muted : Role::text, entry.title);
        ui.set_ground(ui.theme().panel);
    }
    /// The key, and the beat of the open lesson. @return where they begin.
    [[nodiscard]] float draw_right(const LessonEntry& entry, bool open, const Area& at) const {
        ui::Ui& ui = c_.ui;
        float right = at.right() - ui.px(6);
        const std::string cap = key_cap_of_lesson(entry.number);
        if (!cap.empty()) {
            const float width = ui::text_width(ui.font(Face::line_number), cap) + 2 * ui.px(5);
            right -= std::ceil(width);
            static_cast<void>(ui::badge(ui, Face::line_number, {right, at.centre().y}, cap));
            right -= ui.px(9);
        }
        if (!open) return right;
        const std::string beat = fmt::format("{}/{}", c_.state.cursor.beat + 1, beat_count(c_.state));
        return right - ui.text_right(Face::line_number,
                                     {right, ui::baseline_at_middle(ui.font(Face::line_number), at.centre().y)},
                                     Role::now, beat);
    }

    const ViewContext& c_;
    std::span<const LessonEntry> entries_;
    Area area_;
    float row_, heading_, height_ = 0;
    std::vector<Line> lines_;
};

/// The keys at the top right. @return where they begin.
float draw_list_keys(const ViewContext& c, const Area& place, float middle) {
    ui::Ui& ui = c.ui;
    const Face face = Face::line_number;
    const float pad = ui.px(5), gap = ui.px(9), esc = ui::text_width(ui.font(face), "Esc") + 2 * pad;
    const float close = ui::text_width(ui.font(Face::note), kLessonListClose),
                baseline = ui::baseline_at_middle(ui.font(Face::note), middle);
    float x = place.right() - ui.px(ui::size::kPadding) - close - ui.px(7) - esc;
    const float high = std::min(place.h, ui.font(Face::note).em * 1.8F + 6);
    const Area button{x - ui.px(3), middle - high / 2, place.right() - ui.px(6) - x, high};
    const ui::Control control =
        ui.control({"lessons/close", button, ui::Kind::button, kLessonListClose, kLessonListCloseTip});
    if (control.clicked) c.act(action::Show{Overlay::none});
    static_cast<void>(ui::badge(ui, face, {x, middle}, "Esc"));
    ui.text(Face::note, {x + esc + ui.px(7), baseline}, control.hovered ? Role::text : Role::muted, kLessonListClose);
    const float then = ui::text_width(ui.font(Face::note), kThen),
                keys = ui::text_width(ui.font(face), kLessonKeys) + 2 * pad;
    const float l = ui::text_width(ui.font(face), "L") + 2 * pad;
    const float start = x - 2 * gap - keys - gap - then - gap - l;
    if (start < place.x + ui.px(80)) return x;
    static_cast<void>(ui::badge(ui, face, {x - 2 * gap - keys, middle}, kLessonKeys));
    ui.text(Face::note, {x - 2 * gap - keys - gap - then, baseline}, Role::muted, kThen);
    static_cast<void>(ui::badge(ui, face, {start, middle}, "L", ui::BadgeLook::filled));
    return start;
}

}  // namespace

void draw_lesson_list(const ViewContext& c, const Area& place, std::span<const LessonEntry> entries) {
    ui::Ui& ui = c.ui;
    static_cast<void>(ui.begin_panel("lessons", place));
    const float pad = ui.px(ui::size::kPadding), head = std::max(ui.px(37), std::round(ui.font(Face::title).em * 1.7F));
    const float middle = place.y + head / 2, keys = draw_list_keys(c, place, middle);
    const float x = place.x + pad;
    ui.text_within(Face::title, {x, ui::baseline_at_middle(ui.font(Face::title), middle)}, keys - x, Role::muted,
                   kLessonListTitle);
    ListDrawer(c, entries, {x, place.y + head, place.w - 2 * pad, place.h - head - 2}).draw();
    ui.end_panel();
}

void draw_lesson_summary(const ViewContext& c, const Area& place, std::span<const LessonEntry> entries) {
    if (place.empty() || entries.empty()) return;
    ui::Ui& ui = c.ui;
    const auto chosen =
        static_cast<std::size_t>(std::clamp(c.state.chosen_lesson, 0, static_cast<int>(entries.size()) - 1));
    const LessonEntry& entry = entries[chosen];
    const std::string note = fmt::format("{} of {} done", c.state.done.size(), entries.size());
    const Area content = ui.begin_panel("lesson", place, fmt::format("{:02}  {}", entry.number, entry.title), note);
    const float keys = std::max(ui.px(28), ui.font(Face::note).em * 1.9F);
    const Area prose =
        ui.begin_scroll("lesson/prose", {content.x, content.y, content.w, std::max(0.0F, content.h - keys)});
    const std::string text = entry.lesson == nullptr ? fmt::format("**{}** {}", kAbsent, entry.summary) : entry.summary;
    ui.end_scroll(ui.prose("lesson/summary",
                           {prose.x, prose.y, std::min(prose.w, ui.px(520) * (ui.presenting() ? 2 : 1)), prose.h},
                           ui::spans_of(text)));
    float x = content.x;
    const float middle = content.bottom() - keys / 2, baseline = ui::baseline_at_middle(ui.font(Face::note), middle);
    const auto key = [&](std::string_view cap, std::string_view what) {
        if (x > content.right() - ui.px(60)) return;
        x = ui::badge(ui, Face::line_number, {x, middle}, cap).right() + ui.px(9);
        x += ui.text_within(Face::note, {x, baseline}, content.right() - x, Role::muted, what) + ui.px(22);
    };
    key("Enter", kOpen);
    key(kArrows, kLessonListChoose);
    ui.end_panel();
}

}  // namespace texelscope
