// What the trace, the quirks and the choice of a number type cost where nobody watches: each method in double, its
// Method::render and its template with NoTrace, against the same loops written by hand. Rounds are interleaved and
// the median of their ratios is printed. Exits with 1 if a ratio is above the limit, or a picture differs.
//   trace_overhead [limit = 1.03 [origin = 0]]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

#include "core/image/patterns.h"
#include "core/method/edge_equations.h"
#include "core/method/run.h"
#include "core/method/sections.h"
#include "tests/bench/by_hand.h"

namespace texelscope {
namespace {

constexpr int kFrame = 1024, kRounds = 101;
constexpr double kSamplesPerRound = 2e5;

using Shapes = std::vector<std::vector<Vertex>>;
using Draw = void (*)(const Shapes&, const Rect& frame, const Texture&, Image&);

/// Regular polygons of `size` px across, turned and placed at random, most of them inside the frame.
Shapes shapes_of(int corners, int size) {
    std::mt19937 random(static_cast<unsigned>(7 * size + corners));
    const auto within = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    Shapes shapes(static_cast<std::size_t>(std::max(1.0, kSamplesPerRound / (0.5 * size * size + 16))));
    for (auto& shape : shapes) {
        const double x = within(size / 2.0, kFrame - size / 2.0), y = within(size / 2.0, kFrame - size / 2.0);
        const double turn = within(0, 7), side = within(0, 1) < 0.5 ? -1 : 1;
        for (int n = 0; n < corners; ++n) {
            const double angle = turn + side * 6.283185307179586 * n / corners;
            shape.push_back({.x = static_cast<float>(x + size / 2.0 * std::cos(angle)),
                             .y = static_cast<float>(y + size / 2.0 * std::sin(angle)),
                             .u = static_cast<float>(within(-64, 320)),
                             .v = static_cast<float>(within(-64, 320))});
        }
    }
    return shapes;
}

void triangles_by_hand(const Shapes& shapes, const Rect& frame, const Texture& texture, Image& picture) {
    for (const auto& shape : shapes) by_hand::triangle(picture, frame, texture, shape);
}
void polygons_by_hand(const Shapes& shapes, const Rect& frame, const Texture& texture, Image& picture) {
    for (const auto& shape : shapes) by_hand::polygon(picture, frame, texture, shape);
}
template <template <class, class> class M>
[[gnu::flatten]] void inlined(const Shapes& shapes, const Rect& frame, const Texture& texture, Image& picture) {
    const Integer width = picture.width();
    Rgb* const first = picture.data();
    for (const auto& shape : shapes) {
        const M<double, NoTrace> method{frame, texture, 1, false, {}, {}, {}};
        method.draw(shape, [=, x0 = frame.x0, y0 = frame.y0](Integer x, Integer y, const auto& pixel) {
            if (pixel.fate == Fate::written) first[(y - y0) * width + (x - x0)] = run::colour_of(pixel.texel);
        });
    }
}
template <const char* id>
void registered(const Shapes& shapes, const Rect& frame, const Texture& texture, Image& picture) {
    const Method& method = *find_method(id);
    Job job;
    job.texture = &texture;
    job.frame = frame;
    for (const auto& shape : shapes) {
        job.corners = shape;
        method.render(NumberFormat::f64, job, picture);
    }
}

double seconds(Draw draw, const Shapes& shapes, const Rect& frame, const Texture& texture, Image& picture) {
    const std::clock_t start = std::clock();  // of this process alone: others may be running
    draw(shapes, frame, texture, picture);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + kRounds / 2, values.end());
    return values[kRounds / 2];
}

/// One line of the table; whether both ratios are within the limit and the pictures equal.
bool compare(const char* name, int corners, int size, const Rect& frame, double limit, Draw by_hand, Draw render,
             Draw templated) {
    const Shapes shapes = shapes_of(corners, size);
    Texture texture;
    texture.texels = make_pattern(Pattern::address, 256, 256, 1);
    Image expected(kFrame, kFrame), picture = expected, inline_picture = expected;
    std::vector<double> through_method, through_template, times;
    for (int round = 0; round < kRounds; ++round) {
        const double hand = seconds(by_hand, shapes, frame, texture, expected);
        through_method.push_back(seconds(render, shapes, frame, texture, picture) / hand);
        through_template.push_back(seconds(templated, shapes, frame, texture, inline_picture) / hand);
        times.push_back(hand);
    }
    const double method_ratio = median(through_method), template_ratio = median(through_template);
    const bool equal = expected == picture && expected == inline_picture;
    std::printf("%-15s %5d px  %8.3f ms by hand  render x %.3f  template x %.3f%s\n", name, size, median(times) * 1e3,
                method_ratio, template_ratio, equal ? "" : "  PICTURES DIFFER");
    return equal && method_ratio <= limit && template_ratio <= limit;
}

constexpr char kEdgeEquations[] = "edge-equations", kSections[] = "sections";

}  // namespace
}  // namespace texelscope

int main(int argc, char** argv) {
    using namespace texelscope;
    const double limit = argc > 1 ? std::atof(argv[1]) : 1.03;
    const int origin = argc > 2 ? std::atoi(argv[2]) : 0;  // not known to the compiler, as in any program
    const Rect frame{origin, origin, origin + kFrame, origin + kFrame};
    bool fine = true;
    for (const int size : {8, 16, 32, 64, 128, 256, 512, 1000}) {
        fine &= compare("edge-equations", 3, size, frame, limit, triangles_by_hand, registered<kEdgeEquations>,
                        inlined<EdgeEquations>);
        fine &= compare("sections", 6, size, frame, limit, polygons_by_hand, registered<kSections>, inlined<Sections>);
    }
    std::printf(fine ? "all within %.2f\n" : "NOT all within %.2f\n", limit);
    return fine ? 0 : 1;
}
