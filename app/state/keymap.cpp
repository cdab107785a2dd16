#include "app/state/keymap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/state/lesson_cursor.h"
#include "app/state/lesson_table.h"

namespace texelscope {
namespace {

using ui::Key;

// clang-format off
constexpr std::array kBindings{
    Binding{{Key::down}, Command::next_lesson_in_list, KeyPlace::lesson_list},
    Binding{{Key::up}, Command::previous_lesson_in_list, KeyPlace::lesson_list},
    Binding{{Key::right}, Command::lesson_column_right, KeyPlace::lesson_list},
    Binding{{Key::left}, Command::lesson_column_left, KeyPlace::lesson_list},
    Binding{{Key::enter}, Command::open_chosen_lesson, KeyPlace::lesson_list},
    Binding{{Key::b}, Command::blank, KeyPlace::presenting},
    Binding{{Key::period}, Command::blank, KeyPlace::presenting},
    Binding{{Key::right}, Command::step_forward}, Binding{{Key::left}, Command::step_back},
    Binding{{Key::page_down}, Command::advance}, Binding{{Key::page_up}, Command::go_back},
    Binding{{Key::down}, Command::finer}, Binding{{Key::up}, Command::coarser},
    Binding{{Key::enter}, Command::step_in}, Binding{{Key::backspace}, Command::finish_unit},
    Binding{{Key::space}, Command::play},
    Binding{{Key::left_bracket}, Command::slower}, Binding{{Key::right_bracket}, Command::faster},
    Binding{{Key::home}, Command::first_step}, Binding{{Key::end}, Command::last_step},
    Binding{{Key::g, true}, Command::go_to},
    Binding{{Key::m}, Command::bookmark},
    Binding{{Key::left, true}, Command::previous_bookmark}, Binding{{Key::right, true}, Command::next_bookmark},
    Binding{{Key::v}, Command::move_vertex}, Binding{{Key::i}, Command::inspect_pixel},
    Binding{{Key::o}, Command::turn_solid}, Binding{{Key::f}, Command::move_texture},
    Binding{{Key::h}, Command::hits}, Binding{{Key::d}, Command::difference}, Binding{{Key::k}, Command::palette},
    Binding{{Key::x}, Command::variant}, Binding{{Key::w}, Command::array_passes}, Binding{{Key::c}, Command::plain_code},
    Binding{{Key::p}, Command::predict},
    Binding{{Key::z, true}, Command::undo}, Binding{{Key::y, true}, Command::redo}, Binding{{Key::z, true, true}, Command::redo},
    Binding{{Key::r}, Command::reset},
    Binding{{Key::s, true}, Command::save}, Binding{{Key::o, true}, Command::open_file},
    Binding{{Key::e, true}, Command::export_picture},
    Binding{{Key::c, true}, Command::copy_link}, Binding{{Key::v, true}, Command::paste},
    Binding{{Key::q, true}, Command::quit},
    Binding{{Key::f5}, Command::present},
    Binding{{Key::equal, true}, Command::larger_text}, Binding{{Key::equal, true, true}, Command::larger_text},
    Binding{{Key::minus, true}, Command::smaller_text}, Binding{{Key::n0, true}, Command::usual_text},
    Binding{{Key::t}, Command::theme}, Binding{{Key::l}, Command::lessons}, Binding{{Key::f1}, Command::keys},
    Binding{{Key::escape}, Command::escape},
};

constexpr std::array kHelp{
    KeyHelp{"Steps", "→ ←", "one step on, one back"},
    KeyHelp{"Steps", "PgDn PgUp", "the lesson's next beat, the one before"},
    KeyHelp{"Steps", "↓ ↑", "finer steps, coarser steps"},
    KeyHelp{"Steps", "Enter", "step in"},
    KeyHelp{"Steps", "Backspace", "finish this unit"},
    KeyHelp{"Steps", "Space", "play and pause"},
    KeyHelp{"Steps", "[ ]", "slower, faster"},
    KeyHelp{"Steps", "Home End", "first step, last step"},
    KeyHelp{"Steps", "Ctrl+G", "go to a step or a pixel"},
    KeyHelp{"Steps", "M", "set a bookmark here, or take it away"},
    KeyHelp{"Steps", "Ctrl+← →", "the bookmark before, the next one"},
    KeyHelp{"Look and change", "V + arrows", "move a corner; Shift 1/16 px, Ctrl 8 px"},
    KeyHelp{"Look and change", "V + 1 to 9", "choose the corner"},
    KeyHelp{"Look and change", "V + − = D", "its depth, farther or nearer; the other diagonal"},
    KeyHelp{"Look and change", "O + arrows A Z", "turn a solid by 5°; Shift 1°, Ctrl 15°"},
    KeyHelp{"Look and change", "O + 1 to 9", "choose the solid"},
    KeyHelp{"Look and change", "O + − =", "the camera's focal length, a jelly cube's size"},
    KeyHelp{"Look and change", "F", "move textures, or stop them"},
    KeyHelp{"Look and change", "I + arrows", "inspect a pixel; Ctrl 8 px"},
    KeyHelp{"Look and change", "H", "how often each pixel was written"},
    KeyHelp{"Look and change", "K", "the palette of the texture"},
    KeyHelp{"Look and change", "D", "where another method differs, and why"},
    KeyHelp{"Look and change", "X", "as printed or corrected"},
    KeyHelp{"Look and change", "W", "work in arrays, or pixel by pixel"},
    KeyHelp{"Look and change", "C", "plain code, or with its trace"},
    KeyHelp{"Look and change", "P", "check the prediction"},
    KeyHelp{"Look and change", "Ctrl+Z Y", "undo, redo"},
    KeyHelp{"Look and change", "R", "reset the lesson"},
    KeyHelp{"Lessons and files", "L, then 1-9, a-l", "open a lesson"},
    KeyHelp{"Lessons and files", "Ctrl+S O E", "save, open, export the picture"},
    KeyHelp{"Lessons and files", "Ctrl+C V", "copy this state as a line, paste one"},
    KeyHelp{"Lessons and files", "Ctrl+Q", "quit"},
    KeyHelp{"The screen", "F6", "next panel; with Shift the one before"},
    KeyHelp{"The screen", "Tab", "next control; with Shift the one before"},
    KeyHelp{"The screen", "Esc", "close, let go, back to the canvas"},
    KeyHelp{"The screen", "F5", "present; B or . blanks the screen"},
    KeyHelp{"The screen", "Ctrl + − 0", "larger, smaller, usual text"},
    KeyHelp{"The screen", "T", "dark or light"},
    KeyHelp{"The screen", "F1", "this list"},
};
// clang-format on

constexpr std::string_view kNoSolid = "This scene has no solid to turn.", kStill = "No texture of this scene moves.";
constexpr std::string_view kNoArrays = "{} has no array passes, only its loops over pixels.";
constexpr std::string_view kArrays = "arrays";  ///< the quirk that has the passes
constexpr float kKeymapLeastScale = 1, kKeymapMostScale = 2.5F;
constexpr std::array kKeymapScales{1.0F, 1.25F, 1.5F, 2.0F, 2.5F};
constexpr int kRepeatGesture = -1;  ///< moves by a held key are one entry for undo
constexpr int kColumn = 11;         ///< lessons in the list's left column

[[nodiscard]] float next_scale(float scale, int direction) {
    constexpr float kSame = .01F;
    if (direction > 0) {
        const auto at =
            std::find_if(kKeymapScales.begin(), kKeymapScales.end(), [&](float s) { return s > scale + kSame; });
        return at == kKeymapScales.end() ? kKeymapMostScale : *at;
    }
    const auto at =
        std::find_if(kKeymapScales.rbegin(), kKeymapScales.rend(), [&](float s) { return s < scale - kSame; });
    return at == kKeymapScales.rend() ? kKeymapLeastScale : *at;
}

[[nodiscard]] bool is_letter_key(Key key) { return (key >= Key::a && key <= Key::z) || key >= Key::n0; }

class Reader {
public:
    Reader(const ui::Input& input, const State& state, const Derived& derived, std::span<const Lesson> lessons)
        : input_(input), state_(state), derived_(derived), lessons_(lessons) {}

    void read(const ui::KeyPress& press, bool typing, std::span<const Binding> keymap) {
        if (typing && !press.ctrl && press.key != Key::escape && (press.key < Key::f1 || press.key > Key::f12)) return;
        if (read_held(press) || read_lesson_key(press)) return;
        const bool plain_letter = is_letter_key(press.key) && !press.ctrl;
        if (press.alt || (plain_letter && !state_.look.letter_keys && state_.overlay != Overlay::lessons)) return;
        for (const Binding& b : keymap) {
            if (!in_place(b.place) || !(b.chord == Chord{press.key, press.ctrl, press.shift})) continue;
            run(b.command, press);
            return;
        }
    }
    [[nodiscard]] KeyOutcome take() { return std::move(out_); }

private:
    void act(Action action) { out_.actions.push_back(std::move(action)); }
    void ask(ShellRequest::What what, int lesson = 0) { out_.requests.push_back({what, lesson}); }
    [[nodiscard]] bool held(Key key) const {
        return std::find(input_.held.begin(), input_.held.end(), key) != input_.held.end();
    }
    [[nodiscard]] bool in_place(KeyPlace place) const {
        return place == KeyPlace::anywhere || (place == KeyPlace::lesson_list && state_.overlay == Overlay::lessons) ||
               (place == KeyPlace::presenting && state_.look.presenting);
    }

    /// V, O or I held with an arrow or a number.
    bool read_held(const ui::KeyPress& press) {
        if (!state_.look.letter_keys || state_.overlay == Overlay::lessons) return false;
        const glm::ivec2 way{(press.key == Key::right) - (press.key == Key::left),
                             (press.key == Key::down) - (press.key == Key::up)};
        if (held(Key::o) && read_turn(press, way)) return true;
        if (held(Key::v) && press.key >= Key::n1 && press.key <= Key::n9) {
            choose_corner(static_cast<int>(press.key) - static_cast<int>(Key::n1));
            return true;
        }
        if (held(Key::v) && press.key == Key::d) {
            if (!press.repeat) act(action::TurnRing{corner().polygon});
            return true;
        }
        const int depth = (press.key == Key::equal) - (press.key == Key::minus);
        if (held(Key::v) && depth != 0) return deepen(depth, press), true;
        if (way == glm::ivec2(0)) return false;
        if (held(Key::v)) return move_corner(way, press), true;
        if (held(Key::i)) return move_pin(way * (press.ctrl ? 8 : 1)), true;
        return false;
    }

    /// The corner under the keys, else the first one of the cursor's shape.
    [[nodiscard]] Handle corner() const {
        if (state_.handle.polygon >= 0) return state_.handle;
        const int shape = derived_.shape();
        return shape < 0 ? Handle{} : Handle{derived_.drawing().polygon_of(shape), 0, false};
    }
    void choose_corner(int vertex) {
        Handle handle = corner();
        if (handle.polygon < 0) return;
        const auto& polygon = derived_.scene().polygons[static_cast<std::size_t>(handle.polygon)];
        if (vertex >= static_cast<int>(polygon.vertices.size())) return;
        handle.vertex = vertex;
        act(action::ChooseHandle{handle});
    }
    void move_corner(glm::ivec2 way, const ui::KeyPress& press) {
        const Handle handle = corner();
        if (handle.polygon < 0 || handle.polygon >= static_cast<int>(derived_.scene().polygons.size())) return;
        const float length = press.shift ? 1.0F / 16 : press.ctrl ? 8.0F : 1.0F;
        const glm::vec2 to = position_of(derived_.scene(), handle) + length * glm::vec2(way);
        act(action::MoveVertex{handle, to, press.repeat ? kRepeatGesture : 0});
    }
    /// Eight presses double the depth of the corner, or halve it: with Shift 64, with Ctrl one.
    void deepen(int way, const ui::KeyPress& press) {
        const Handle handle = corner();
        const Vertex* vertex = vertex_of(derived_.scene(), handle);
        if (vertex == nullptr || !(vertex->w > 0)) return;
        const float steps = press.shift ? 64.0F : press.ctrl ? 1.0F : 8.0F;  // to an octave
        const float octaves = std::round(std::log2(vertex->w) * steps + static_cast<float>(way)) / steps;
        act(action::SetDepth{handle, std::exp2(octaves), press.repeat ? kRepeatGesture : 0});
    }
    /// The solids that there are to turn, in order: of jelly cubes each.
    [[nodiscard]] std::vector<Turning> turnings() const {
        std::vector<Turning> all;
        const auto& meshes = derived_.scene().meshes;
        for (int n = 0; n < static_cast<int>(meshes.size()); ++n) {
            all.push_back({n});
            if (meshes[static_cast<std::size_t>(n)].shape == Shape3d::jelly_cubes) all.push_back({n, true});
        }
        return all;
    }
    /// O held: the front of the solid goes where the arrow points, A and Z turn it on the screen.
    bool read_turn(const ui::KeyPress& press, glm::ivec2 way) {
        const Turning what = derived_.turning();
        if (what.mesh < 0) return false;
        if (press.key >= Key::n1 && press.key <= Key::n9) {
            const std::vector<Turning> all = turnings();
            const auto n = static_cast<std::size_t>(press.key) - static_cast<std::size_t>(Key::n1);
            if (n < all.size()) act(action::ChooseTurning{all[n]});
            return true;
        }
        const int gesture = press.repeat ? kRepeatGesture : 0;
        const double degrees = press.shift ? 1 : press.ctrl ? 15 : 5;
        if (way.x != 0) return act(action::Turn{what, 1, -degrees * way.x, gesture}), true;
        if (way.y != 0) return act(action::Turn{what, 0, degrees * way.y, gesture}), true;
        const int spin = (press.key == Key::z) - (press.key == Key::a);
        if (spin != 0) return act(action::Turn{what, 2, degrees * spin, gesture}), true;
        const int size = (press.key == Key::equal) - (press.key == Key::minus);
        if (size != 0) return resize(what, size, gesture), true;
        return false;
    }
    void resize(const Turning& what, int way, int gesture) {
        const MeshPlacement& mesh = derived_.scene().meshes[static_cast<std::size_t>(what.mesh)];
        constexpr float kRatioStep = 0.01F, kFocalFactor = 1.0625F;
        if (mesh.shape == Shape3d::jelly_cubes) {
            const float hundredths = std::round(mesh.ratio / kRatioStep) + static_cast<float>(way);
            return act(action::SetRatio{what.mesh, hundredths * kRatioStep, gesture});
        }
        const auto focal = static_cast<float>(view_of(derived_.scene()).focal);
        act(action::SetFocal{way > 0 ? focal * kFocalFactor : focal / kFocalFactor, gesture});
    }
    void move_pin(glm::ivec2 way) {
        const Rect frame = derived_.scene().framebuffer.rect();
        if (frame.empty()) return;
        const glm::ivec2 middle{(frame.x0 + frame.x1) / 2, (frame.y0 + frame.y1) / 2};
        const bool pinned = state_.pinned.kind == Selection::Kind::pixel;
        glm::ivec2 at = (pinned ? state_.pinned.at : derived_.pixel().value_or(middle)) + way;
        at = {std::clamp(at.x, frame.x0, frame.x1 - 1), std::clamp(at.y, frame.y0, frame.y1 - 1)};
        if (pinned && at == state_.pinned.at) return;
        Selection selection;
        selection.kind = Selection::Kind::pixel, selection.at = at;
        act(action::Pin{selection});
    }

    /// With the list open a digit or a letter opens a lesson.
    bool read_lesson_key(const ui::KeyPress& press) {
        if (state_.overlay != Overlay::lessons || press.ctrl || press.alt) return false;
        const auto number = lesson_of_key(press.key);
        if (!number) return false;
        ask(ShellRequest::What::open_lesson, *number);
        return true;
    }
    void move_in_list(int by) {
        const int count = static_cast<int>(lesson_entries(lessons_).size());
        act(action::ChooseLesson{std::clamp(state_.chosen_lesson + by, 0, count - 1)});
    }
    void open_chosen() {
        const std::vector<LessonEntry> entries = lesson_entries(lessons_);
        const auto at =
            static_cast<std::size_t>(std::clamp(state_.chosen_lesson, 0, static_cast<int>(entries.size()) - 1));
        ask(ShellRequest::What::open_lesson, entries[at].number);
    }

    void set_look(auto change) {
        Look look = state_.look;
        change(look);
        act(action::SetLook{look});
    }
    /// Opens the list at the lesson that is open, or closes it.
    void show_lessons() {
        if (state_.overlay != Overlay::lessons && state_.document && state_.document->lesson)
            act(action::ChooseLesson{state_.document->lesson->number - 1});
        act(action::Show{Overlay::lessons});
    }
    void next_variant() {
        const auto variants = derived_.method().variants;
        const auto at = std::find_if(variants.begin(), variants.end(),
                                     [&](const VariantInfo& v) { return v.id == state_.work.variant; });
        const std::size_t now = at == variants.end() ? 0 : static_cast<std::size_t>(at - variants.begin());
        act(action::SetVariant{std::string(variants[(now + 1) % variants.size()].id)});
    }

    /// Array passes, or one loop over pixels.
    void exchange_arrays(const ui::KeyPress& press) {
        const int quirk = quirk_index(derived_.method(), kArrays);
        if (quirk < 0) return act(action::Say{{fmt::format(kNoArrays, derived_.method().title)}});
        if (!press.repeat) act(action::SetQuirk{quirk, (state_.work.quirks >> quirk & 1U) == 0});
    }

    void run(Command command, const ui::KeyPress& press) {
        if (!run_step(command) && !run_edit(command, press) && !run_request(command)) run_look(command, press);
    }
    bool run_step(Command command) {
        switch (command) {
            case Command::step_forward: act(action::Step{1}); return true;
            case Command::step_back: act(action::Step{-1}); return true;
            case Command::advance: act(action::Advance{1}); return true;
            case Command::go_back: act(action::Advance{-1}); return true;
            case Command::finer: act(action::Finer{1}); return true;
            case Command::coarser: act(action::Finer{-1}); return true;
            case Command::step_in: act(action::StepIn{}); return true;
            case Command::finish_unit: act(action::FinishUnit{}); return true;
            case Command::play: act(action::Play{!state_.playing}); return true;
            case Command::slower: act(action::Speed{.5F}); return true;
            case Command::faster: act(action::Speed{2}); return true;
            case Command::first_step: act(action::StepEnd{false}); return true;
            case Command::last_step: act(action::StepEnd{true}); return true;
            case Command::go_to: act(action::Show{Overlay::go_to}); return true;
            case Command::bookmark: act(action::ToggleBookmark{}); return true;
            case Command::previous_bookmark: act(action::GoToBookmark{-1}); return true;
            case Command::next_bookmark: act(action::GoToBookmark{1}); return true;
            default: return false;
        }
    }
    bool run_edit(Command command, const ui::KeyPress& press) {
        switch (command) {
            case Command::move_vertex:
                if (!press.repeat && state_.handle.polygon < 0) choose_corner(0);
                return true;
            case Command::turn_solid:
                if (derived_.turning().mesh < 0)
                    act(action::Say{{std::string(kNoSolid)}});
                else if (!press.repeat)
                    act(action::ChooseTurning{derived_.turning()});
                return true;
            case Command::move_texture:
                if (press.repeat) return true;
                if (derived_.frames().count == 0)
                    act(action::Say{{std::string(kStill)}});
                else
                    act(action::PlayFrames{!state_.moving});
                return true;
            case Command::inspect_pixel:
                if (!press.repeat && state_.pinned.kind != Selection::Kind::pixel) move_pin({0, 0});
                return true;
            case Command::variant: next_variant(); return true;
            case Command::array_passes: exchange_arrays(press); return true;
            case Command::predict: act(action::Check{}); return true;
            case Command::undo: act(action::Undo{}); return true;
            case Command::redo: act(action::Redo{}); return true;
            case Command::reset: act(action::Reset{}); return true;
            default: return false;
        }
    }
    bool run_request(Command command) {
        switch (command) {
            case Command::save: ask(ShellRequest::What::save); return true;
            case Command::open_file: ask(ShellRequest::What::open_file); return true;
            case Command::export_picture: ask(ShellRequest::What::export_picture); return true;
            case Command::copy_link: ask(ShellRequest::What::copy_link); return true;
            case Command::paste: ask(ShellRequest::What::paste); return true;
            case Command::quit: ask(ShellRequest::What::quit); return true;
            case Command::next_lesson_in_list: move_in_list(1); return true;
            case Command::previous_lesson_in_list: move_in_list(-1); return true;
            case Command::lesson_column_right: move_in_list(kColumn); return true;
            case Command::lesson_column_left: move_in_list(-kColumn); return true;
            case Command::open_chosen_lesson: open_chosen(); return true;
            default: return false;
        }
    }
    void run_look(Command command, const ui::KeyPress& press) {
        if (press.repeat && command != Command::larger_text && command != Command::smaller_text) return;
        switch (command) {
            case Command::hits: return set_look([](Look& l) { l.hits = !l.hits; });
            case Command::palette: return set_look([](Look& l) { l.palette = !l.palette, l.tab = 0; });
            case Command::difference: return set_look([](Look& l) { l.difference = !l.difference, l.tab = 0; });
            case Command::plain_code: return set_look([](Look& l) { l.plain_code = !l.plain_code; });
            case Command::present: return set_look([](Look& l) { l.presenting = !l.presenting, l.blank = false; });
            case Command::blank: return set_look([](Look& l) { l.blank = !l.blank; });
            case Command::larger_text: return set_look([](Look& l) { l.scale = next_scale(l.scale, 1); });
            case Command::smaller_text: return set_look([](Look& l) { l.scale = next_scale(l.scale, -1); });
            case Command::usual_text: return set_look([](Look& l) { l.scale = 1; });
            case Command::theme:
                return set_look([](Look& l) { l.theme = l.theme == Theme::dark ? Theme::light : Theme::dark; });
            case Command::lessons: return show_lessons();
            case Command::keys: return act(action::Show{Overlay::keys});
            default: return act(action::Escape{});
        }
    }

    const ui::Input& input_;
    const State& state_;
    const Derived& derived_;
    std::span<const Lesson> lessons_;
    KeyOutcome out_;
};

}  // namespace

std::span<const Binding> default_keymap() { return kBindings; }
std::span<const KeyHelp> key_help() { return kHelp; }

KeyOutcome actions_for(const ui::Input& input, std::span<const ui::KeyPress> unused, bool typing, const State& state,
                       const Derived& derived, std::span<const Lesson> lessons, std::span<const Binding> keymap) {
    Reader reader(input, state, derived, lessons);
    for (const ui::KeyPress& press : unused) reader.read(press, typing, keymap);
    return reader.take();
}

}  // namespace texelscope
