// Squares of texels for tests of forward and backward mapping and of two passes.
#pragma once

#include <cmath>
#include <memory>

#include "app/state/pose.h"
#include "core/image/patterns.h"
#include "core/method/steps.h"

namespace texelscope {

/// `w` x `h` texels turned and scaled about (60, 60), on 120 x 120 pixels.
[[nodiscard]] inline Scene turned_scene(int w, int h, double degrees, double scale) {
    Texture texture;
    texture.name = "t";
    texture.texels = make_pattern(Pattern::address, 64, 64, 1);
    Scene scene;
    scene.framebuffer.width = scene.framebuffer.height = 120;
    scene.textures.push_back(std::make_shared<const Texture>(std::move(texture)));
    const auto u = static_cast<float>(w), v = static_cast<float>(h);
    std::vector<Vertex> corners{{0, 0, 0, 1, 0, 0}, {0, 0, 0, 1, u, 0}, {0, 0, 0, 1, u, v}, {0, 0, 0, 1, 0, v}};
    const std::vector<glm::vec2> at = posed(corners, {{60, 60}, degrees, scale});
    for (std::size_t n = 0; n < corners.size(); ++n) corners[n].x = at[n].x, corners[n].y = at[n].y;
    scene.polygons.push_back({.vertices = corners, .texture = 0, .light = 1});
    return scene;
}

/// A scene with a drawing of it and its steps.
struct DrawnScene {
    DrawnScene(Scene made, std::string_view method, std::string_view variant = "corrected")
        : scene(std::make_unique<Scene>(std::move(made))) {
        const Method& found = *find_method(method);
        drawing =
            std::make_unique<Drawing>(*scene, DrawSettings{&found, NumberFormat::f64, quirks_of(found, variant), {}});
        steps = std::make_unique<Steps>(*drawing);
    }
    std::unique_ptr<Scene> scene;
    std::unique_ptr<Drawing> drawing;
    std::unique_ptr<Steps> steps;
};

}  // namespace texelscope
