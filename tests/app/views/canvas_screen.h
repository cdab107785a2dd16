// A window with one view in it, over a scene and a lesson made by hand; frames run as in the program.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/platform/software.h"
#include "app/state/store.h"
#include "app/views/view.h"
#include "core/scene/json.h"

namespace texelscope {

inline std::string scene_path(std::string_view lesson) {
    return std::string(TEXELSCOPE_SOURCE_DIR) + "/lessons/" + std::string(lesson) + "/scene.json";
}

inline const ui::Fonts& canvas_fonts(const ui::FontSpec& spec) {
    static std::vector<std::unique_ptr<ui::Fonts>> all;
    for (const auto& fonts : all)
        if (fonts->spec() == spec) return *fonts;
    Result<ui::Fonts> fonts = ui::Fonts::bake(spec);
    if (!fonts) ADD_FAILURE() << fonts.error().text();
    all.push_back(std::make_unique<ui::Fonts>(std::move(*fonts)));
    return *all.back();
}

class CanvasScreen {
public:
    struct Setup {
        Scene scene;
        std::string method = "edge-equations";
        std::vector<std::string> views{"texels", "formula", "code"};
        std::string step = "t0";
        Level level = Level::pixel;
        std::optional<Prediction> prediction = {};
        std::string drag = "vertices";
    };

    explicit CanvasScreen(const Setup& setup) : store_(initial(setup)) {}

    static Scene load(std::string_view lesson) {
        const Result<LoadedScene> loaded =
            load_scene(scene_path(lesson), std::string(TEXELSCOPE_SOURCE_DIR) + "/assets");
        if (!loaded) ADD_FAILURE() << loaded.error().text();
        return loaded ? loaded->scene : Scene{};
    }

    void add(std::string_view view, const ui::Area& place) { places_.emplace_back(std::string(view), place); }

    /// One frame; its actions are dispatched after it, and nothing is pressed any more.
    void frame() {
        input.time += 0.1;
        const Look& look = store_.state().look;
        const ui::Fonts& fonts = canvas_fonts({look.scale, look.presenting});
        platform_.set_fonts(fonts.atlas());
        const ui::Theme theme = ui::make_theme(look.presenting              ? ui::ThemeName::presenting
                                               : look.theme == Theme::light ? ui::ThemeName::light
                                                                            : ui::ThemeName::dark);
        std::vector<Action> actions;
        platform_.frame(input, [&] {
            ui::Ui ui(memory, input, fonts, theme, *ImGui::GetBackgroundDrawList(), {.reduced_motion = true});
            ViewContext ctx{.ui = ui,
                            .state = store_.state(),
                            .derived = store_.derived(),
                            .textures = platform_.textures(),
                            .lessons = {},
                            .actions = actions};
            ctx.hover = store_.derived().highlight(store_.state().hover);
            ctx.pinned = store_.derived().highlight(store_.state().pinned);
            for (const auto& [view, place] : places_) find_view(view)->draw(ctx, place);
            ui.end();
            report = ui.report();
        });
        last_actions = actions;
        for (const Action& action : actions) store_.dispatch(action);
        input.keys.clear();
        input.pressed = input.released = {};
        input.wheel = {0, 0};
        input.double_clicked = false;
    }
    void move(glm::vec2 to) {
        input.mouse = to;
        frame();
    }
    void press(glm::vec2 at, std::size_t button = 0) {
        move(at);
        input.pressed[button] = input.down[button] = true;
        frame();
    }
    void release(std::size_t button = 0) {
        input.down[button] = false, input.released[button] = true;
        frame();
    }
    void click(glm::vec2 at) {
        press(at);
        release();
    }
    [[nodiscard]] const ui::ControlRecord* control(std::string_view name) const {
        for (const ui::ControlRecord& c : report.controls)
            if (c.name == name) return &c;
        return nullptr;
    }
    [[nodiscard]] bool says(std::string_view text) const {
        for (const ui::TextRecord& t : report.texts)
            if (t.text.find(text) != std::string::npos) return true;
        return false;
    }
    template <class A>
    [[nodiscard]] int count() const {
        int n = 0;
        for (const Action& action : last_actions) n += std::holds_alternative<A>(action);
        return n;
    }
    [[nodiscard]] Store& store() { return store_; }
    [[nodiscard]] const State& state() const { return store_.state(); }
    [[nodiscard]] SoftwarePlatform& platform() { return platform_; }

    ui::Input input;
    ui::UiMemory memory;
    ui::FrameReport report;
    std::vector<Action> last_actions;

private:
    static State initial(const Setup& setup) {
        auto document = std::make_shared<Document>();
        document->scene = setup.scene;
        document->lesson.emplace();
        document->lesson->views = setup.views;
        document->lesson->drag = setup.drag;
        document->lesson->beats.emplace_back();
        document->lesson->beats[0].prediction = setup.prediction;
        State state;
        state.document = document;
        const Method* method = find_method(setup.method);
        state.work.method = setup.method;
        state.work.variant = method->variants.back().id;
        state.work.quirks = method->variants.back().quirks;
        state.cursor.level = setup.level;
        state.cursor.step = parse_path(setup.step).value_or(Path{});
        return state;
    }

    Store store_;
    SoftwarePlatform platform_;
    std::vector<std::pair<std::string, ui::Area>> places_;
};

}  // namespace texelscope
