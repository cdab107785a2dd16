#include "app/shell/check.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/shell/headless.h"
#include "app/state/lesson_cursor.h"
#include "core/method/drawing.h"

namespace texelscope {
namespace {

constexpr std::array kScales{1.0F, 1.25F, 1.5F, 2.0F, 2.5F};
constexpr std::array kSizes{glm::vec2(1280, 720), glm::vec2(1920, 1080)};

class Checker {
public:
    Checker(const std::filesystem::path& file, LessonCheck& check) : file_(file), check_(check) {}

    void run() {
        auto document = open_document(file_.string());
        if (!document) return check_.faults.push_back(document.error());
        document_ = *document;
        check_.beats = static_cast<int>(lesson().beats.size());
        check_beats();
        check_there_and_back();
        check_quirks();
        check_screens();
    }

private:
    [[nodiscard]] const Lesson& lesson() const { return *document_->lesson; }
    void fault(int line, std::string what) {
        check_.faults.push_back({fmt::format("{}:{}", file_.string(), line), std::move(what)});
    }

    void check_beats() {
        Store store(opened(document_, State{}));
        for (int n = 0; n < check_.beats; ++n) {
            const Beat& beat = lesson().beats[static_cast<std::size_t>(n)];
            if (n > 0) store.dispatch(action::Advance{});
            const State& state = store.state();
            if (beat.set.step &&
                state.cursor.step != store.derived().steps().at_level(*beat.set.step, state.cursor.level)) {
                fault(beat.line, fmt::format("there is no step {}, expected one of this scene and variant",
                                             beat.set.step->text()));
            }
            if (beat.set.pin) check_pin(beat, store);
            check_.predictions += beat.prediction.has_value();
        }
    }

    void check_pin(const Beat& beat, Store& store) {
        const Selection& pin = store.state().pinned;
        const Highlight light = store.derived().highlight(pin);
        const auto& names = store.derived().visit().tape.names;
        const bool named =
            pin.kind != Selection::Kind::name ||
            std::any_of(names.begin(), names.end(), [&](const Named& n) { return n.name.text() == pin.name; });
        const bool found =
            pin.kind != Selection::Kind::none && named && (pin.kind != Selection::Kind::line || pin.line > 0);
        if (!found) fault(beat.line, fmt::format("pin '{}' points at nothing here", *beat.set.pin));
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
        for (const std::string& id : lesson().quirks) {
            const int n = quirk_index(*method, id);
            const QuirkSet bit = QuirkSet{1} << n;
            bool changes = method->quirks[static_cast<std::size_t>(n)].form;
            for (const VariantInfo& variant : method->variants)
                changes = changes || samples_with(variant.quirks | bit) != samples_with(variant.quirks & ~bit);
            if (!changes) fault(1, fmt::format("the quirk '{}' changes no pixel of this scene", id));
            const std::string pin = fmt::format("line quirk.{}", method->quirks[static_cast<std::size_t>(n)].field);
            const bool named = std::any_of(lesson().beats.begin(), lesson().beats.end(),
                                           [&](const Beat& b) { return b.set.pin == pin; });
            if (!named && !method->quirks[static_cast<std::size_t>(n)].form)
                fault(1, fmt::format("no beat pins the guilty line of '{}' (pin = \"{}\")", id, pin));
        }
    }

    void check_screens() {
        for (const glm::vec2 size : kSizes) {
            for (const Theme theme : {Theme::dark, Theme::light}) {
                for (const float scale : kScales)
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
            for (const ui::ControlRecord& control : ui::small_targets((*app)->shell().report()))
                fault(line, fmt::format("the target '{}' is too small ({})", control.name, where));
        }
    }

    std::filesystem::path file_;
    LessonCheck& check_;
    std::shared_ptr<const Document> document_;
};

}  // namespace

LessonCheck check_lesson(const std::filesystem::path& file) {
    LessonCheck check;
    Checker(file, check).run();
    return check;
}

}  // namespace texelscope
