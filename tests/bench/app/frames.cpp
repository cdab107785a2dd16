// What a frame costs, presenting left out: at 1920x1080 dragging a vertex in each lesson, or steps in all its beats
// where none may be dragged; and dragging, and steps anywhere, in a 4096x4096 scene of 10,000 polygons, with the
// picture as it stands there.
//   frames
//   frames turning    only the solids
//   frames 10         only the lessons whose id begins so
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <random>

#include "app/platform/scripted_input.h"
#include "app/shell/headless.h"
#include "core/image/patterns.h"

namespace texelscope {
namespace {

constexpr glm::vec2 kScreen{1920, 1080};
constexpr int kDragFrames = 200, kSide = 4096, kPolygons = 10000, kSteps = 60;

/// Of this process alone, so that what else runs on the machine does not count.
double milliseconds(auto&& work) {
    const std::clock_t start = std::clock();
    work();
    return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void report(const char* what, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    std::printf("%-48s median %7.2f ms  p95 %7.2f ms  max %7.2f ms\n", what, times[times.size() / 2],
                times[times.size() * 95 / 100], times.back());
}

/// Drags a vertex round a small circle.
void drag(Headless& app, const char* what, const Handle& handle) {
    app.settle();
    const glm::vec2 from = position_of(app.store().derived().scene(), handle);
    std::vector<double> times;
    for (int n = 0; n < kDragFrames; ++n) {
        const auto angle = static_cast<float>(n) * 0.1F;
        times.push_back(milliseconds([&] {
            app.store().dispatch(
                action::MoveVertex{handle, from + glm::vec2(std::cos(angle), std::sin(angle)) * 2.0F, 1});
            app.frame();
        }));
    }
    report(what, times);
}

void drag_in(const Lesson& lesson) {
    auto app = Headless::start(*state_of(lesson.id, {}), kScreen);
    if (!app) return void(std::printf("%s: %s\n", lesson.id.c_str(), app.error().text().c_str()));
    drag(**app, ("drag in " + lesson.id).c_str(), {0, 0, false});
}

/// Steps forward and back in each beat of a lesson.
void step_in(const Lesson& lesson) {
    auto app = Headless::start(*state_of(lesson.id, {}), kScreen);
    if (!app) return void(std::printf("%s: %s\n", lesson.id.c_str(), app.error().text().c_str()));
    std::vector<double> times;
    for (std::size_t beat = 0; beat < lesson.beats.size(); ++beat) {
        (*app)->settle();
        for (int n = 0; n < kDragFrames / 8; ++n) {
            times.push_back(milliseconds([&] {
                (*app)->store().dispatch(action::Step{n % 2 == 0 ? 1 : -1});
                (*app)->frame();
            }));
        }
        (*app)->store().dispatch(action::Advance{1});
    }
    report(("steps in " + lesson.id).c_str(), times);
}

/// A scene of 640x480 by edge equations in double; a turn of one solid and its picture in each frame.
void turn_in(const char* what, Shape3d shape, float scale) {
    auto document = std::make_shared<Document>();
    document->id = "solid.json";
    Scene& scene = document->scene;
    scene.framebuffer = {640, 480, 0, 0, {}};
    auto texture = std::make_shared<Texture>();
    texture->texels = make_pattern(Pattern::uv, 64, 64, 1);
    scene.textures = {texture};
    scene.meshes.resize(1);
    scene.meshes[0].shape = shape, scene.meshes[0].scale = scale, scene.meshes[0].move = {0, 0, 6};
    scene.meshes[0].half = shape == Shape3d::jelly_cubes;
    scene.cull = scene.meshes[0].half ? Cull::none : Cull::back;
    place_meshes(scene);
    auto app = Headless::start(opened(document, State{}), kScreen);
    if (!app) return void(std::printf("%s\n", app.error().text().c_str()));
    (*app)->settle();
    std::vector<double> times;
    for (int n = 0; n < kDragFrames; ++n) {
        times.push_back(milliseconds([&] {
            (*app)->store().dispatch(action::Turn{{0}, n % 3, 2, -5});
            (*app)->frame();
        }));
    }
    report(what, times);
}

std::shared_ptr<const Document> large_document() {
    std::mt19937 random(1);
    const auto within = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
    auto document = std::make_shared<Document>();
    document->id = "large.json";
    document->scene.framebuffer = {kSide, kSide, 0, 0, {}};
    auto texture = std::make_shared<Texture>();
    texture->texels = make_pattern(Pattern::uv, 256, 256, 1);
    document->scene.textures = {texture};
    for (int n = 0; n < kPolygons; ++n) {
        const glm::vec2 centre(within(0, kSide), within(0, kSide));
        const float size = within(20, 400);
        Polygon polygon;
        for (int k = 0; k < 5; ++k) {
            const float angle = 6.2831853F * (static_cast<float>(k) + within(0, 0.7F)) / 5;
            polygon.vertices.push_back({centre.x + size * std::cos(angle), centre.y + size * std::sin(angle), 0, 1,
                                        within(0, 256), within(0, 256)});
        }
        document->scene.polygons.push_back(std::move(polygon));
    }
    return document;
}

void steps_in_large_scene(const char* what, float zoom) {
    auto app = Headless::start(opened(large_document(), State{}), kScreen);
    if (!app) return void(std::printf("%s\n", app.error().text().c_str()));
    Store& store = (*app)->store();
    std::mt19937 random(2);
    std::vector<double> values, pictures, frames;
    for (int n = 0; n < kSteps; ++n) {
        const int shapes = store.derived().drawing().shape_count();
        const auto below = [&](int count) {
            return static_cast<int>(random() % static_cast<unsigned>(std::max(1, count)));
        };
        const int shape = below(shapes);
        const Rect reach = store.derived().drawing().reach(shape);
        const auto found =
            store.derived().steps().at_pixel(shape, reach.x0 + below(reach.width()), reach.y0 + below(reach.height()));
        if (!found) continue;
        const Path& step = *found;
        Look look = store.state().look;
        look.zoom = zoom;
        look.centre = {static_cast<float>(step.index_of('x').value_or(0)),
                       static_cast<float>(step.index_of('y').value_or(0))};
        store.dispatch(action::SetLook{look});
        values.push_back(milliseconds([&] {
            store.dispatch(action::StepTo{step});
            static_cast<void>(store.derived().variables().size());
        }));
        pictures.push_back(milliseconds([&] { (*app)->frame(); }));
        store.dispatch(action::Step{1});
        frames.push_back(milliseconds([&] { (*app)->frame(); }));
    }
    std::printf("%s\n", what);
    report("  a step's values", values);
    report("  its picture, from another shape", pictures);
    report("  the next step's picture", frames);
}

/// All of it in view, with the cursor on another polygon.
void drag_in_large_scene() {
    auto app = Headless::start(opened(large_document(), State{}), kScreen);
    if (!app) return void(std::printf("%s\n", app.error().text().c_str()));
    drag(**app, "drag in 4096x4096, 10,000 polygons", {kPolygons / 2, 0, false});
}

}  // namespace
}  // namespace texelscope

int main(int argc, char** argv) {
    using namespace texelscope;
    const bool only_turning = argc > 1 && std::strcmp(argv[1], "turning") == 0;
    const std::string_view wanted = argc > 1 && !only_turning ? argv[1] : "";
    std::vector<Error> faults;
    if (!only_turning)
        for (const Lesson& lesson : built_in_lessons(faults))
            if (lesson.id.starts_with(wanted)) lesson.drag == "none" ? step_in(lesson) : drag_in(lesson);
    if (!wanted.empty()) return faults.empty() ? 0 : 1;
    turn_in("turning a cube, 640x480", Shape3d::cube, 1.2F);
    turn_in("turning a dodecahedron, 640x480", Shape3d::dodecahedron, 2.4F);
    turn_in("turning a torus, 640x480", Shape3d::torus, 1.2F);
    turn_in("turning jelly cubes, half-transparent, 640x480", Shape3d::jelly_cubes, 1.4F);
    if (only_turning) return 0;
    drag_in_large_scene();
    steps_in_large_scene("4096x4096, 10,000 polygons, 16 window pixels a pixel", 16);
    steps_in_large_scene("4096x4096, 10,000 polygons, all in view", 0);
    return faults.empty() ? 0 : 1;
}
