// What a step costs in a large scene: a visit, the next and the previous step, the tape, and the picture in a small
// window as it stands at a late step.
//   steps [side = 4096 [polygons = 10000]]
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>

#include "core/image/patterns.h"
#include "core/method/steps.h"

namespace texelscope {
namespace {

constexpr int kWindow = 64, kVisits = 200;

Scene large_scene(int side, int polygons) {
    std::mt19937 random(1);
    const auto within = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    Scene scene;
    scene.framebuffer.width = scene.framebuffer.height = side;
    auto texture = std::make_shared<Texture>();
    texture->texels = make_pattern(Pattern::uv, 256, 256, 1);
    scene.textures = {texture};
    for (int n = 0; n < polygons; ++n) {
        const double x = within(0, side), y = within(0, side), size = within(10, side / 16.0);
        Polygon polygon;
        for (int k = 0; k < 5; ++k) {
            const double angle = 6.283185307179586 * (k + within(0, 0.7)) / 5;
            Vertex v;
            v.x = static_cast<float>(x + size * std::cos(angle)), v.y = static_cast<float>(y + size * std::sin(angle));
            v.u = static_cast<float>(within(0, 256)), v.v = static_cast<float>(within(0, 256));
            polygon.vertices.push_back(v);
        }
        scene.polygons.push_back(std::move(polygon));
    }
    return scene;
}

/// Mean time of `count` calls of f(n) [us].
double microseconds(int count, auto&& f) {
    const auto start = std::chrono::steady_clock::now();
    for (int n = 0; n < count; ++n) f(n);
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() / count;
}

std::size_t bytes_of(const Tape& tape) {
    return tape.operations.size() * sizeof(Operation) + tape.names.size() * sizeof(Named);
}

/// A pixel in the middle of a shape's last loops, if it has any on the screen.
std::optional<Path> middle_pixel(Steps& steps, Integer shape) {
    Path path{{{'t', shape}}};
    const auto stages = static_cast<Integer>(steps.at(path).stages.size());
    path = path.child('s', stages / 2);  // of sections the middle one, of edge equations none has a loop but the last
    if (!steps.at(path).unit().loop) path = path.prefix(1).child('s', stages - 1);
    for (int depth = 2; depth < 4; ++depth) {
        const std::optional<Loop> loop = steps.at(path).unit().loop;
        if (!loop || loop->count() == 0) return std::nullopt;
        path = path.child(loop->letter, loop->first + loop->count() / 2 * loop->step);
    }
    return path;
}

void report(const Scene& scene, const Method& method, NumberFormat format) {
    DrawSettings settings;
    settings.method = &method, settings.format = format;
    const Drawing drawing(scene, settings);
    Steps steps(drawing);
    const int shapes = drawing.shape_count();

    std::vector<Path> paths;
    std::mt19937 random(2);
    for (int tried = 0; tried < 100000 && paths.size() < kVisits; ++tried) {
        const auto path = middle_pixel(steps, static_cast<Integer>(random() % static_cast<unsigned>(shapes)));
        if (path) paths.push_back(*path);
    }
    if (paths.empty()) return;
    std::size_t tape = 0, largest = 0;
    const double visited = microseconds(kVisits, [&](int n) {
        const Visit v = visit(drawing, paths[static_cast<std::size_t>(n) % paths.size()]);
        tape = v.tape.operations.size(), largest = std::max(largest, bytes_of(v.tape));
    });
    Path path = paths[0];
    const double next = microseconds(2000, [&](int) { path = steps.next(path, Level::pixel).value_or(paths[0]); });
    const double previous =
        microseconds(2000, [&](int) { path = steps.previous(path, Level::pixel).value_or(paths[0]); });
    const double expression =
        microseconds(2000, [&](int) { path = steps.next(path, Level::expression).value_or(paths[0]); });
    std::optional<Path> late;
    for (int n = shapes; n-- > 0 && !late;) late = middle_pixel(steps, n);
    const int x = static_cast<int>(late->index_of('x').value_or(0)),
              y = static_cast<int>(late->index_of('y').value_or(0));
    int samples = 0;
    const double window = microseconds(format == NumberFormat::exact ? 1 : 10, [&](int) {
        samples = 0;
        each_sample(drawing, 0, shapes - 1, {{x - kWindow / 2, y - kWindow / 2, x + kWindow / 2, y + kWindow / 2}, 1},
                    [&](int, const Sample&) { ++samples; });
    });
    std::printf(
        "%-15s %-8s visit %7.1f us  next %5.2f us  previous %5.2f us  next expression %5.2f us  tape %4zu operations, "
        "at most %5.1f kB  window of %d px at the last shape %6.2f ms, %d samples\n",
        std::string(method.id).c_str(), std::string(id_of(format)).c_str(), visited, next, previous, expression, tape,
        static_cast<double>(largest) / 1024, kWindow, window / 1000, samples);
}

}  // namespace
}  // namespace texelscope

int main(int argc, char** argv) {
    using namespace texelscope;
    const int side = argc > 1 ? std::atoi(argv[1]) : 4096, polygons = argc > 2 ? std::atoi(argv[2]) : 10000;
    if (side < kWindow || side > kMaxSize || polygons < 1 || polygons > 1000000) {
        std::fprintf(stderr, "side %d to %d, polygons 1 to 1000000\n", kWindow, kMaxSize);
        return 1;
    }
    const Scene scene = large_scene(side, polygons);
    for (const Method* method : methods()) {
        for (const NumberFormat format : {NumberFormat::f64, NumberFormat::fx16_16, NumberFormat::exact})
            report(scene, *method, format);
    }
    return 0;
}
