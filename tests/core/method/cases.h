// What the laws of the methods are tried on: every method in every variant and number format, and random scenes.
// New methods are picked up unasked, since all comes from methods().
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/image/patterns.h"
#include "core/method/drawing.h"

namespace texelscope::laws {

/// A method in one of its variants, or in one with a form switched on.
struct Case {
    DrawSettings settings;
    std::string variant;

    [[nodiscard]] bool corrected() const { return settings.quirks == 0; }
    [[nodiscard]] std::string text() const {
        return std::string(settings.method->id) + " " + variant + " " + std::string(id_of(settings.format));
    }
};

[[nodiscard]] inline DrawSettings settings_of(const Method& method, NumberFormat format, QuirkSet quirks) {
    DrawSettings settings;
    settings.method = &method, settings.format = format, settings.quirks = quirks;
    return settings;
}

/// The quirks that are forms: other loops over the same samples.
[[nodiscard]] inline QuirkSet forms_of(const Method& method) {
    QuirkSet forms = 0;
    for (std::size_t n = 0; n < method.quirks.size(); ++n)
        forms |= method.quirks[n].kind == QuirkKind::form ? QuirkSet{1} << n : 0;
    return forms;
}

/// TEXELSCOPE_CASE in the environment narrows the laws to the cases whose text holds it: to look for a fault.
[[nodiscard]] inline std::vector<Case> every_case() {
    std::vector<Case> cases;
    const char* wanted = std::getenv("TEXELSCOPE_CASE");  // NOLINT(concurrency-mt-unsafe): nobody sets it meanwhile
    const auto add = [&](Case c) {
        if (wanted == nullptr || c.text().find(wanted) != std::string::npos) cases.push_back(std::move(c));
    };
    for (const Method* method : methods()) {
        for (const NumberFormatInfo& format : kNumberFormats) {
            for (const VariantInfo& variant : method->variants) {
                if (&variant != &method->variants.back() && variant.quirks == 0) continue;  // no other than corrected
                add({settings_of(*method, format.format, variant.quirks), std::string(variant.id)});
                const QuirkSet forms = forms_of(*method);
                if ((forms & ~variant.quirks) == 0) continue;
                add({settings_of(*method, format.format, variant.quirks | forms), std::string(variant.id) + "+forms"});
            }
        }
    }
    return cases;
}

class Dice {
public:
    explicit Dice(unsigned seed) : random_(seed) {}
    [[nodiscard]] float within(double a, double b) {
        return static_cast<float>(a + (b - a) * (static_cast<double>(random_()) / 4294967296.0));
    }
    /// In [a, b].
    [[nodiscard]] int whole(int a, int b) { return a + static_cast<int>(random_() % static_cast<unsigned>(b - a + 1)); }
    [[nodiscard]] bool often(double share) { return within(0, 1) < static_cast<float>(share); }

private:
    std::mt19937 random_;  // the same numbers everywhere, unlike the standard distributions
};

enum class Family { any, whole_pixels, quarter_pixels, sliver, tiny, wide, off_screen };
inline constexpr int kFamilies = 7;

[[nodiscard]] inline std::shared_ptr<const Texture> texture_of(int width, int height, Wrap wrap,
                                                               Pattern pattern = Pattern::address) {
    auto texture = std::make_shared<Texture>();
    texture->name = "t";
    texture->texels = make_pattern(pattern, width, height, 1);
    texture->wrap = wrap;
    return texture;
}

/// Corners of a convex polygon, on an ellipse round the middle of the frame or beside it; either winding.
[[nodiscard]] inline std::vector<Vertex> random_corners(Dice& dice, Family family, const Rect& frame, int corners) {
    const double middle_x = dice.within(frame.x0, frame.x1), middle_y = dice.within(frame.y0, frame.y1);
    double far = 0, rx = dice.within(2, frame.width()), ry = dice.within(2, frame.height());
    if (family == Family::sliver) ry = dice.within(0, 0.6);
    if (family == Family::tiny) rx = dice.within(0, 0.9), ry = dice.within(0, 0.9);
    if (family == Family::wide) rx *= 40, ry *= 30;
    if (family == Family::off_screen) far = 4 * frame.width();
    const double turn = dice.within(0, 6.28), way = dice.often(0.5) ? -1 : 1, tilt = dice.within(0, 3);
    std::vector<Vertex> ring;
    for (int n = 0; n < corners; ++n) {
        const double angle = turn + way * 6.2831853 * (n + double{dice.within(0, 0.8)}) / corners;
        const double a = rx * std::cos(angle), b = ry * std::sin(angle);
        Vertex v;
        v.x = static_cast<float>(middle_x + far + a * std::cos(tilt) - b * std::sin(tilt));
        v.y = static_cast<float>(middle_y + a * std::sin(tilt) + b * std::cos(tilt));
        if (family == Family::whole_pixels) v.x = std::nearbyint(v.x), v.y = std::nearbyint(v.y);
        if (family == Family::quarter_pixels)
            v.x = std::nearbyint(v.x * 4.0F) / 4, v.y = std::nearbyint(v.y * 4.0F) / 4;
        v.u = dice.within(-8, 18), v.v = dice.within(-8, 18);
        v.z = dice.within(0, 1), v.w = dice.within(0.5, 4);
        ring.push_back(v);
    }
    return ring;
}

/// A few polygons of one family in a small frame that need not begin at 0.
[[nodiscard]] inline Scene random_scene(unsigned seed) {
    Dice dice(seed);
    Scene scene;
    scene.framebuffer = {.width = dice.whole(9, 17), .height = dice.whole(7, 13), .clear = {9, 8, 7}};
    if (dice.often(0.5)) scene.framebuffer.origin_x = dice.whole(-9, 9), scene.framebuffer.origin_y = dice.whole(-9, 9);
    scene.textures = {texture_of(16, 8, Wrap::repeat), texture_of(16, 16, Wrap::mask, Pattern::uv),
                      texture_of(32, 32, Wrap::clamp)};
    const auto family = static_cast<Family>(seed % kFamilies);
    for (int n = dice.whole(1, 3); n-- > 0;) {
        Polygon polygon;
        polygon.vertices = random_corners(dice, family, scene.framebuffer.rect(), dice.whole(3, 6));
        polygon.texture = dice.whole(0, 2);
        polygon.light = dice.often(0.5) ? 1.0F : dice.within(0, 1.6);
        scene.polygons.push_back(polygon);
    }
    if (dice.often(0.3)) scene.cull = Cull::back;
    return scene;
}

/// The same scene with some polygons half-transparent, at least one, and some more over them.
[[nodiscard]] inline Scene with_half(Scene scene, unsigned seed) {
    Dice dice(seed + 1000);
    const std::vector<Polygon> polygons = scene.polygons;
    scene.polygons.insert(scene.polygons.end(), polygons.rbegin(), polygons.rend());
    for (Polygon& polygon : scene.polygons) polygon.half = dice.often(0.5);
    scene.polygons.back().half = true;
    return scene;
}

/// A wall, 100 pixels long and eight times as far away at its right.
[[nodiscard]] inline Scene steep_scene() {
    Scene scene;
    scene.framebuffer = {.width = 100, .height = 20};
    scene.textures = {texture_of(64, 64, Wrap::repeat)};
    Polygon wall;
    wall.vertices = {{.x = 0, .y = 0, .w = 1, .u = 0, .v = 0},
                     {.x = 100, .y = 9, .w = 8, .u = 64, .v = 0},
                     {.x = 100, .y = 11, .w = 8, .u = 64, .v = 64},
                     {.x = 0, .y = 20, .w = 1, .u = 0, .v = 64}};
    scene.polygons = {wall};
    return scene;
}

/// A triangle of 48 pixels, so far from the origin that float32 has few digits left for its pixels.
[[nodiscard]] inline Scene far_scene() {
    Scene scene;
    scene.framebuffer = {.width = 50, .height = 50, .origin_x = 500000, .origin_y = 500000};
    scene.textures = {texture_of(256, 256, Wrap::repeat)};
    Polygon triangle;
    triangle.vertices = {{.x = 500000.5F, .y = 500000.5F},
                         {.x = 500048.5F, .y = 500000.5F, .u = 256, .v = 0},
                         {.x = 500000.5F, .y = 500048.5F, .u = 0, .v = 256}};
    scene.polygons = {triangle};
    return scene;
}

[[nodiscard]] inline std::vector<std::pair<int, Sample>> all_samples(const Drawing& drawing, const Window& window) {
    std::vector<std::pair<int, Sample>> samples;
    each_sample(drawing, 0, drawing.shape_count(), window,
                [&](int shape, const Sample& s) { samples.emplace_back(shape, s); });
    return samples;
}

[[nodiscard]] inline bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }
[[nodiscard]] inline bool same(const Sample& a, const Sample& b) {
    return a.x == b.x && a.y == b.y && a.fate == b.fate && a.note == b.note && same(a.u, b.u) && same(a.v, b.v) &&
           a.column == b.column && a.row == b.row && a.colour == b.colour;
}
[[nodiscard]] inline bool same(const std::pair<int, Sample>& a, const std::pair<int, Sample>& b) {
    return a.first == b.first && same(a.second, b.second);
}

}  // namespace texelscope::laws
