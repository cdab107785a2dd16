#include "app/shell/shell.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "app/state/keymap.h"
#include "app/state/link.h"
#include "app/views/layout.h"
#include "app/views/screen.h"
#include "core/base/file.h"
#include "core/image/load.h"

namespace texelscope {
namespace {

constexpr double kPollEvery = 0.25;  ///< files of the open document are looked at this often [s]
constexpr double kShowAgain = 0.15;  ///< frames go on for so long after new type was baked [s]
constexpr int kFramesGesture = -2;   ///< frames that follow one another are one entry for undo
constexpr std::string_view kCopied = "The state is in the clipboard, as one line.";
constexpr std::string_view kNothingToPaste = "The clipboard holds no Texelscope state.";
constexpr std::string_view kDropHint = "Drop a scene, a lesson or an image on the window to open it.";
constexpr std::string_view kReloaded = "The file was saved: this is how it reads now.";
constexpr std::string_view kNotHere = "This lesson is not in this version.";

[[nodiscard]] ui::ThemeName theme_of(const Look& look) {
    if (look.presenting) return ui::ThemeName::presenting;
    return look.theme == Theme::light ? ui::ThemeName::light : ui::ThemeName::dark;
}

[[nodiscard]] ui::FontSpec fonts_of(const Look& look, glm::vec2 window) {
    return {text_scale(window, look), look.presenting};
}

/// Every frame needs the same large buffers: what one has freed is kept for the next. To get their pages from the
/// system each time took a quarter of a frame in which a solid turns.
void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int kLargestKept = 32 << 20, kMostKept = 128 << 20;  // [bytes]
    mallopt(M_MMAP_THRESHOLD, kLargestKept);
    mallopt(M_TRIM_THRESHOLD, kMostKept);
#endif
}

[[nodiscard]] std::string short_name(const State& state) {
    return state.document ? std::filesystem::path(state.document->id).stem().string() : "texelscope";
}

}  // namespace

Shell::Shell(Host& host, State state, std::vector<Lesson> lessons, ShellOptions options)
    : host_(host), store_(std::move(state)), lessons_(std::move(lessons)), options_(std::move(options)) {}

Result<std::unique_ptr<Shell>> Shell::start(Host& host, State state, std::vector<Lesson> lessons,
                                            ShellOptions options) {
    keep_freed_memory();
    std::unique_ptr<Shell> shell(new Shell(host, std::move(state), std::move(lessons), std::move(options)));
    if (!shell->bake_fonts()) return Error{"", shell->font_error_};
    shell->remember_times();
    return shell;
}

bool Shell::bake_fonts() {
    const ui::FontSpec wanted = fonts_of(state().look, window_);
    if (fonts_ && fonts_->spec() == wanted) return true;
    auto baked = ui::Fonts::bake(wanted);
    if (!baked) {
        font_error_ = baked.error().text();
        return false;
    }
    old_fonts_ = std::move(fonts_);  // the frame in progress still draws with it
    fonts_ = std::make_unique<ui::Fonts>(*std::move(baked));
    host_.set_fonts(fonts_->atlas());
    return true;
}

void Shell::frame(const ui::Input& input) {
    window_ = input.size;
    const ui::Theme theme = ui::make_theme(theme_of(state().look));
    ui::UiOptions options = options_.ui;
    options.reduced_motion = options.reduced_motion || state().look.reduced_motion;
    ui::Ui ui(memory_, input, *fonts_, theme, *ImGui::GetBackgroundDrawList(), options);
    std::vector<Action> actions;
    std::vector<ShellRequest> requests;
    Derived& derived = store_.derived();
    ViewContext context{.ui = ui,
                        .state = state(),
                        .derived = derived,
                        .textures = host_.textures(),
                        .lessons = lessons_,
                        .actions = actions,
                        .can_undo = store_.can_undo(),
                        .can_redo = store_.can_redo(),
                        .timed = options_.timed,
                        .hover = derived.highlight(state().hover),
                        .pinned = derived.highlight(state().pinned),
                        .requests = &requests};
    draw_screen(context);
    ui.end();
    KeyOutcome keys = actions_for(input, ui.unused_keys(), ui.typing(), state(), derived, lessons_);
    actions.insert(actions.end(), keys.actions.begin(), keys.actions.end());
    requests.insert(requests.end(), keys.requests.begin(), keys.requests.end());
    const bool animated = ui.wants_frame();
    report_ = ui.report();
    act(input, actions, requests);
    keep_time(input, animated);
}

void Shell::act(const ui::Input& input, const std::vector<Action>& actions, const std::vector<ShellRequest>& requests) {
    const auto hovers = [](const Action& a) { return std::holds_alternative<action::Hover>(a); };
    if (std::none_of(actions.begin(), actions.end(), hovers) && state().hover != Selection{})
        store_.dispatch(action::Hover{});
    for (const Action& action : actions) store_.dispatch(action);
    for (const ShellRequest& request : requests) fulfil(request, input);
    for (const std::string& file : input.dropped) drop(file);
    const ui::FontSpec before = fonts_->spec();
    if (!bake_fonts()) say(font_error_, true);
    // The window's size may have changed them, without any action that would draw again.
    if (fonts_->spec() != before) host_.wants_frames_until(input.time + kShowAgain);
}

void Shell::fulfil(const ShellRequest& request, const ui::Input& input) {
    using What = ShellRequest::What;
    switch (request.what) {
        case What::open_lesson: {
            const auto found = std::find_if(lessons_.begin(), lessons_.end(),
                                            [&](const Lesson& l) { return l.number == request.lesson; });
            if (found == lessons_.end()) return say(std::string(kNotHere), false);
            auto document = open_document(found->file.string());
            if (!document) return say(document.error().text(), true);
            store_.dispatch(action::Open{*document});
            return remember_times();
        }
        case What::open_file: return say(std::string(kDropHint), false);
        case What::save: return save(".texelscope", print_link(state()) + "\n");
        case What::export_picture: {
            const auto png = encode_png(store_.derived().final_picture());
            return png ? save(".png", std::string(png->begin(), png->end())) : say(png.error().text(), true);
        }
        case What::copy_link: host_.set_clipboard(print_link(state())); return say(std::string(kCopied), false);
        case What::quit: return host_.close(0);
        case What::paste: return paste(input.pasted.empty() ? host_.clipboard() : input.pasted);
    }
}

void Shell::drop(const std::string& file) {
    const std::filesystem::path path(file);
    const std::string kind = path.extension().string();
    if (kind == ".texelscope") {
        const auto text = read_file(path, 1 << 16);
        return text ? paste(*text) : say(text.error().text(), true);
    }
    if (kind == ".json" || kind == ".md") {
        auto document = open_document(file);
        if (!document) return say(document.error().text(), true);
        store_.dispatch(action::Open{*document});
        return remember_times();
    }
    auto texture = open_texture(path);
    if (!texture) return say(texture.error().text(), true);
    store_.dispatch(action::SetTexture{file, *texture});
}

void Shell::paste(const std::string& text) {
    if (!looks_like_link(text)) return say(std::string(kNothingToPaste), true);
    auto pasted = open_state(text, state());
    if (!pasted) return say(pasted.error().text(), true);
    if (!state().document || pasted->document->id != state().document->id) {
        store_.dispatch(action::Open{pasted->document});
        remember_times();
    }
    const Look& look = pasted->look;
    store_.dispatch(action::Restore{pasted->work, pasted->cursor, look.other, look.difference, look.rung, look.skips});
}

void Shell::save(const std::string& suffix, const std::string& bytes) {
    const std::filesystem::path file = options_.save_folder / (short_name(state()) + suffix);
    const auto error = write_file_atomically(file, bytes_of(bytes));
    error ? say(error->text(), true) : say("Saved as " + file.string() + ".", false);
}

void Shell::say(std::string text, bool error) { store_.dispatch(action::Say{{std::move(text), error}}); }

void Shell::remember_times() {
    times_.clear();
    if (!state().document) return;
    for (const auto& file : state().document->files) {
        std::error_code missing;
        times_.push_back(std::filesystem::last_write_time(file, missing));
    }
}

bool Shell::poll() {
    const auto before = times_;
    remember_times();
    if (times_ == before || !state().document) return false;
    auto document = open_document(state().document->files.front().string());
    if (!document) {
        say(document.error().text(), true);  // the lesson as it was goes on; the fault is shown with its line
        return true;
    }
    store_.dispatch(action::Reload{*document});
    remember_times();  // it may bring in other files
    say(std::string(kReloaded), false);
    return true;
}

double Shell::due(double now, double rate, double next, const Action& action) {
    if (next <= 0 || next > now + 2) next = now + 1 / rate;
    if (now < next) return next;
    store_.dispatch(action);
    return std::max(next + 1 / rate, now);
}

void Shell::keep_time(const ui::Input& input, bool animated) {
    if (const auto lap = racer_.advance(state(), store_.derived().scene())) store_.dispatch(*lap);
    if (const auto found = measurer_.advance(state(), store_.derived().scene())) store_.dispatch(*found);
    if (animated || state().race.running || state().measure.running) host_.wants_frames_until(input.time + 0.15);
    next_step_ = state().playing ? due(input.time, double{state().look.speed}, next_step_, action::Step{1}) : 0;
    const action::SetFrame next_frame{state().work.frame + 1, kFramesGesture};
    next_frame_ = state().moving ? due(input.time, double{state().look.frame_rate}, next_frame_, next_frame) : 0;
    const double next =
        next_step_ > 0 && next_frame_ > 0 ? std::min(next_step_, next_frame_) : next_step_ + next_frame_;
    if (next > 0) host_.wake_at(next);
    host_.poll_every(state().document && !state().document->files.empty() ? kPollEvery : 0);
    const std::string title =
        (state().document && state().document->lesson ? state().document->lesson->title : short_name(state())) +
        " — Texelscope";
    if (title != title_) host_.set_title(title_ = title);
    if (host_.fullscreen() != state().look.presenting) host_.set_fullscreen(state().look.presenting);
}

}  // namespace texelscope
