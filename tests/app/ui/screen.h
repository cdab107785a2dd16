// A window without a window: frames of ui::Ui over input written by hand.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <imgui.h>

#include "app/ui/widgets.h"

namespace texelscope::ui {

inline const Fonts& test_fonts(const FontSpec& spec = {}) {
    static Result<Fonts> plain = Fonts::bake({}), presenting = Fonts::bake({1, true});
    Result<Fonts>& fonts = spec.presenting ? presenting : plain;
    if (!fonts) ADD_FAILURE() << fonts.error().text();
    return *fonts;
}

class Screen {
public:
    explicit Screen(std::function<void(Ui&)> body, ThemeName name = ThemeName::dark)
        : body_(std::move(body)),
          fonts_(test_fonts({1, name == ThemeName::presenting})),
          theme_(make_theme(name)),
          context_(ImGui::CreateContext(&fonts_.atlas())) {
        ImGui::SetCurrentContext(context_);
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = {1280, 720};
        frame();
    }
    ~Screen() {
        ImGui::SetCurrentContext(context_);
        ImGui::DestroyContext(context_);
    }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// One frame; afterwards nothing is pressed or typed any more.
    void frame() {
        input.time += 1;
        ImGui::SetCurrentContext(context_);
        ImGui::GetIO().DeltaTime = 1.0F / 60;
        ImGui::NewFrame();
        Ui ui(memory, input, fonts_, theme_, *ImGui::GetBackgroundDrawList(), options);
        body_(ui);
        ui.end();
        report = ui.report();
        unused = ui.unused_keys();
        wants_frame = ui.wants_frame();
        ImGui::Render();
        input.keys.clear();
        input.text.clear();
        input.pasted.clear();
        input.pressed = input.released = {};
        input.wheel = {0, 0};
    }
    void press(Key key, bool shift = false) {
        KeyPress k;
        k.key = key;
        k.shift = shift;
        input.keys.push_back(k);
        frame();
    }
    void type(std::string_view s) {
        input.text = s;
        frame();
    }
    void move(glm::vec2 to) {
        input.mouse = to;
        frame();
    }
    void mouse_down(glm::vec2 at) {
        input.mouse = at;
        input.pressed[0] = input.down[0] = true;
        frame();
    }
    void mouse_up() {
        input.down[0] = false;
        input.released[0] = true;
        frame();
    }
    void click(glm::vec2 at) {
        mouse_down(at);
        mouse_up();
    }
    [[nodiscard]] std::string focused() const {
        for (const ControlRecord& c : report.controls)
            if (c.id == memory.focus) return c.name;
        return {};
    }

    UiMemory memory;
    Input input;
    UiOptions options;
    FrameReport report;
    std::vector<KeyPress> unused;
    bool wants_frame = false;

private:
    std::function<void(Ui&)> body_;
    const Fonts& fonts_;
    Theme theme_;
    ImGuiContext* context_;
};

}  // namespace texelscope::ui
