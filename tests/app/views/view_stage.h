// A state over a small scene and a window without a window, for tests of single views.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>

#include "app/platform/software.h"
#include "app/views/view.h"
#include "core/image/patterns.h"

namespace texelscope {

/// The triangle of the target pictures of lessons 5 and 9, or the pentagon of lesson 14, over 32 x 24 pixels.
[[nodiscard]] inline Scene stage_scene(bool pentagon) {
    Scene scene;
    scene.framebuffer.width = 32;
    scene.framebuffer.height = 24;
    Texture texture{.name = "address", .texels = make_pattern(Pattern::address, 16, 16, 1), .wrap = Wrap::mask};
    scene.textures.push_back(std::make_shared<const Texture>(std::move(texture)));
    Polygon polygon;
    const auto corner = [&](float x, float y, float u, float v) {
        Vertex vertex;
        vertex.x = x, vertex.y = y, vertex.u = u, vertex.v = v;
        polygon.vertices.push_back(vertex);
    };
    if (pentagon) {
        corner(14, 2, 8, .5F), corner(27, 7, 15.5F, 6), corner(24, 19, 12.75F, 15), corner(9, 22, 3.25F, 15);
        corner(4, 10, .5F, 6);
    } else {
        corner(3.5F, 20.25F, 1, 12), corner(11.25F, 1.75F, 5, 1), corner(29.75F, 15.25F, 15, 15);
    }
    scene.polygons.push_back(std::move(polygon));
    return scene;
}

struct StageSpec {
    std::string method = "edge-equations", variant = "corrected", step = "t0/s5/y11/x16";
    NumberFormat format = NumberFormat::f64;
    Level level = Level::pixel;
    ui::FontSpec fonts;
    ui::ThemeName theme = ui::ThemeName::dark;
};

/// Baked once for each size.
[[nodiscard]] inline const ui::Fonts& stage_fonts(const ui::FontSpec& spec) {
    static std::vector<std::unique_ptr<ui::Fonts>> all;
    for (const auto& fonts : all) {
        if (fonts->spec() == spec) return *fonts;
    }
    Result<ui::Fonts> fonts = ui::Fonts::bake(spec);
    if (!fonts) ADD_FAILURE() << fonts.error().text();
    return *all.emplace_back(std::make_unique<ui::Fonts>(std::move(*fonts)));
}

/// Runs frames of one view.
class ViewStage {
public:
    explicit ViewStage(const StageSpec& spec = {}, std::shared_ptr<const Document> document = nullptr)
        : fonts_(stage_fonts(spec.fonts)), theme_(ui::make_theme(spec.theme)) {
        platform.set_fonts(fonts_.atlas());
        if (!document) {
            auto made = std::make_shared<Document>();
            made->scene = stage_scene(spec.method == "sections");
            document = made;
        }
        state.document = document;
        state.work.method = spec.method;
        state.work.variant = spec.variant;
        state.work.format = spec.format;
        state.work.quirks = quirks_of(*find_method(spec.method), spec.variant);
        state.cursor.level = spec.level;
        go(spec.step);
    }

    void go(const std::string& step) {
        const auto path = parse_path(step);
        if (!path)
            ADD_FAILURE() << step;
        else
            state.cursor.step = *path;
    }
    /// A frame with every view of `names` in a place of its own.
    void frame(const std::vector<std::pair<std::string, ui::Area>>& places) {
        input.time += 1;
        actions.clear();
        derived.update(state);
        platform.frame(input, [&] {
            ui::Ui ui(memory, input, fonts_, theme_, *ImGui::GetBackgroundDrawList());
            ui::fill(ui.list(), {0, 0, input.size.x, input.size.y}, theme_.bg);
            const ViewContext context{.ui = ui,
                                      .state = state,
                                      .derived = derived,
                                      .textures = platform.textures(),
                                      .lessons = {},
                                      .actions = actions,
                                      .hover = derived.highlight(state.hover),
                                      .pinned = derived.highlight(state.pinned)};
            for (const auto& [name, area] : places) {
                const View* view = find_view(name);
                if (view == nullptr)
                    ADD_FAILURE() << name;
                else
                    view->draw(context, area);
            }
            ui.end();
            report = ui.report();
            wants_frame = ui.wants_frame();
        });
        input.keys.clear();
        input.pressed = input.released = {};
        input.wheel = {0, 0};
    }
    void frame(const std::string& view, const ui::Area& area) { frame({{view, area}}); }

    [[nodiscard]] const ui::ControlRecord* control(const std::string& label) const {
        for (const ui::ControlRecord& c : report.controls) {
            if (c.label == label) return &c;
        }
        return nullptr;
    }
    [[nodiscard]] bool shows(const std::string& text) const {
        for (const ui::TextRecord& t : report.texts) {
            if (t.text.find(text) != std::string::npos) return true;
        }
        return false;
    }
    template <class A>
    [[nodiscard]] const A* done() const {
        for (const Action& action : actions) {
            if (const A* a = std::get_if<A>(&action)) return a;
        }
        return nullptr;
    }

    State state;
    Derived derived;
    SoftwarePlatform platform;
    ui::UiMemory memory;
    ui::Input input;
    ui::FrameReport report;
    std::vector<Action> actions;
    bool wants_frame = false;

private:
    const ui::Fonts& fonts_;
    ui::Theme theme_;
};

}  // namespace texelscope
