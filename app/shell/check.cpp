#include "app/shell/check.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/shell/check_beat.h"
#include "app/shell/headless.h"
#include "app/state/lesson_cursor.h"
#include "app/views/screen.h"
#include "core/method/drawing.h"

namespace texelscope {
namespace {

constexpr std::array kCheckScales{1.0F, 1.25F, 1.5F, 2.0F, 2.5F};
constexpr std::array kCheckSizes{glm::vec2(1280, 720), glm::vec2(1920, 1080)};

/// Whether the code view has the line, whole.
[[nodiscard]] bool is_line_shown(const ui::FrameReport& report, int line) {
    const std::string name = fmt::format("code/line{}", line);
    return std::any_of(report.controls.begin(), report.controls.end(), [&](const ui::ControlRecord& control) {
        return control.name == name && control.clip.covers(control.area, 1);
    });
}

class Checker {
public:
    Checker(const std::filesystem::path& file, LessonCheck& check) : file_(file), check_(check) {}

    void run(bool screens) {
        auto document = open_document(file_.string());
        if (!document) return check_.faults.push_back(document.error());
        document_ = *document;
        check_.beats = static_cast<int>(lesson().beats.size());
        check_views();
        check_beats();
        check_there_and_back();
        check_quirks();
        if (screens) check_screens();
    }

private:
    [[nodiscard]] const Lesson& lesson() const { return *document_->lesson; }
    void fault(int line, std::string what) {
        check_.faults.push_back({fmt::format("{}:{}", lesson().file.string(), line), std::move(what)});
    }

    void check_views() {
        const Method* method = find_method(lesson().method);
        const auto check = [&](const std::vector<std::string>& views, int line) {
            for (const std::string& view : views) {
                for (const std::string& what : {view_fault(view, *method), view_fault(view, document_->scene)})
                    if (!what.empty()) fault(line, what);
            }
        };
        check(lesson().views, lesson().lines.of("views"));
        std::vector<std::string> views = lesson().views;
        for (const Beat& beat : lesson().beats) {
            if (beat.set.method) method = find_method(*beat.set.method);
            if (!beat.set.views.empty()) views = beat.set.views;
            const KeyLines& lines = beat.set.lines;
            if (beat.set.method || !beat.set.views.empty())
                check(views, lines.of(lines.has("views") ? "views" : "method"));
        }
    }

    void check_beats() {
        Store store(opened(document_, State{}));
        for (int n = 0; n < check_.beats; ++n) {
            if (n > 0) store.dispatch(action::Advance{});
            for (BeatFault& found : beat_faults(store)) fault(found.line, std::move(found.what));
            check_.predictions += lesson().beats[static_cast<std::size_t>(n)].prediction.has_value();
        }
    }

    void check_there_and_back() {
        Store store(opened(document_, State{}));
        std::vector<std::pair<Work, Cursor>> seen;
        for (int n = 0; n < check_.beats; ++n) {
            seen.emplace_back(store.state().work, store.state().cursor);
            store.dispatch(action::Advance{});
        }
        for (int n = check_.beats - 1; n >= 0; --n) {
            if (std::pair(store.state().work, store.state().cursor) != seen[static_cast<std::size_t>(n)]) {
                fault(lesson().beats[static_cast<std::size_t>(n)].line,
                      "this beat looks different when it is reached backward");
            }
            store.dispatch(action::Advance{-1});
        }
    }

    /// All samples of the scene, as one text to compare.
    [[nodiscard]] std::string samples_with(QuirkSet quirks) const {
        std::string all;
        const Method* method = find_method(lesson().method);
        const NumberFormat format = number_format(lesson().format).value_or(NumberFormat::f64);
        const Drawing drawing(document_->scene, {method, format, quirks, {}});
        each_sample(drawing, 0, drawing.shape_count(), {document_->scene.framebuffer.rect(), 1},
                    [&](int, const Sample& s) {
                        if (s.fate == Fate::written)
                            all += fmt::format("{} {} {} {} {}\n", s.x, s.y, s.colour.r, s.colour.g, s.colour.b);
                    });
        return all;
    }

    void check_quirks() {
        const Method* method = find_method(lesson().method);
        const int line = lesson().lines.of("quirks");
        for (const std::string& id : lesson().quirks) {
            const int n = quirk_index(*method, id);
            const QuirkSet bit = QuirkSet{1} << n;
            bool changes = method->quirks[static_cast<std::size_t>(n)].kind == QuirkKind::form;
            for (const VariantInfo& variant : method->variants)
                changes = changes || samples_with(variant.quirks | bit) != samples_with(variant.quirks & ~bit);
            if (!changes) fault(line, fmt::format("the quirk '{}' changes no pixel of this scene", id));
            const std::string pin = fmt::format("line quirk.{}", method->quirks[static_cast<std::size_t>(n)].field);
            const bool named = std::any_of(lesson().beats.begin(), lesson().beats.end(),
                                           [&](const Beat& b) { return b.set.pin == pin; });
            if (!named && method->quirks[static_cast<std::size_t>(n)].kind != QuirkKind::form)
                fault(line, fmt::format("no beat pins the guilty line of '{}' (pin = \"{}\")", id, pin));
        }
    }

    void check_screens() {
        for (const glm::vec2 size : kCheckSizes) {
            for (const Theme theme : {Theme::dark, Theme::light}) {
                for (const float scale : kCheckScales)
                    check_screen({.theme = theme, .scale = scale, .reduced_motion = true}, size);
            }
            check_screen({.presenting = true, .reduced_motion = true}, size);
        }
    }

    void check_screen(const Look& look, glm::vec2 size) {
        State state;
        state.look = look;
        auto app = Headless::start(opened(document_, state), size);
        if (!app) return fault(1, app.error().text());
        for (int n = 0; n < check_.beats; ++n) {
            if (n > 0) (*app)->store().dispatch(action::Advance{});
            (*app)->frame();
            (*app)->frame();
            ++check_.screens;
            const auto where = fmt::format("{}x{}, text {} %, {}", size.x, size.y, look.scale * 100,
                                           look.presenting             ? "presenting"
                                           : look.theme == Theme::dark ? "dark"
                                                                       : "light");
            const int line = lesson().beats[static_cast<std::size_t>(n)].line;
            for (const ui::TextRecord& text : ui::texts_cut((*app)->shell().report()))
                fault(line, fmt::format("'{}' does not fit its place at {:.0f}, {:.0f} ({})", text.text, text.area.x,
                                        text.area.y, where));
            const Selection& pin = (*app)->state().pinned;
            if (pin.kind == Selection::Kind::line && !layout_of((*app)->state(), size).tabbed &&
                !is_line_shown((*app)->shell().report(), pin.line))
                fault(lesson().beats[static_cast<std::size_t>(n)].set.lines.of("pin"),
                      fmt::format("the pinned line {} is not to be seen ({})", pin.line, where));
            for (const ui::ControlRecord& control : ui::small_targets((*app)->shell().report()))
                fault(line, fmt::format("the target '{}' is too small ({})", control.name, where));
        }
    }

    std::filesystem::path file_;
    LessonCheck& check_;
    std::shared_ptr<const Document> document_;
};

}  // namespace

LessonCheck check_lesson(const std::filesystem::path& file, bool screens) {
    LessonCheck check;
    Checker(file, check).run(screens);
    return check;
}

}  // namespace texelscope
