#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/measure/dice.h"
#include "core/measure/family_makers.h"

namespace texelscope::family {
namespace {

using glm::vec2;
using Corners = std::array<vec2, 3>;

constexpr Rect kFrame{0, 0, 40, 32};
constexpr vec2 kLow{-6, -6}, kHigh{46, 38};  ///< a little beyond the frame

[[nodiscard]] Vertex vertex(Dice& dice, vec2 p) {
    Vertex v{.x = p.x, .y = p.y, .z = dice.share(), .w = dice.within(1, 4)};
    v.u = dice.within(-8, 72), v.v = dice.within(-8, 72);
    return v;
}
[[nodiscard]] HardShape shape_of(Dice& dice, const Corners& corners, const Rect& frame = kFrame) {
    HardShape shape{.vertices = {}, .frame = frame};
    for (const vec2& p : corners) shape.vertices.push_back(vertex(dice, p));
    return shape;
}
[[nodiscard]] Corners corners_on_screen(Dice& dice) {
    const vec2 a = dice.place(kLow, kHigh), b = dice.place(kLow, kHigh);
    return {a, b, dice.place(kLow, kHigh)};
}
[[nodiscard]] HardShape ordinary(Dice& dice) { return shape_of(dice, corners_on_screen(dice)); }

[[nodiscard]] vec2 centre(Dice& dice) {
    const int x = dice.whole(-4, 44);
    return {static_cast<float>(x) + .5F, static_cast<float>(dice.whole(-4, 36)) + .5F};
}
/// A step from one centre to another.
[[nodiscard]] vec2 lattice(Dice& dice, int most) {
    while (true) {
        const int x = dice.whole(-most, most), y = dice.whole(-most, most);
        if (x != 0 || y != 0) return {static_cast<float>(x), static_cast<float>(y)};
    }
}
/// u and v of whole texels.
void make_whole(HardShape& shape) {
    for (Vertex& v : shape.vertices) v.u = std::floor(v.u), v.v = std::floor(v.v);
}

}  // namespace

HardShape random(std::uint64_t seed) {
    Dice dice(seed);
    return ordinary(dice);
}
HardShape on_a_grid(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float unit = dice.one_of({1.0F, 2.0F, 4.0F, 16.0F});
    for (Vertex& v : shape.vertices)
        for (float Vertex::*a : {&Vertex::x, &Vertex::y, &Vertex::u, &Vertex::v}) v.*a = std::floor(v.*a * unit) / unit;
    return shape;
}
HardShape on_centres(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 a = centre(dice), b = centre(dice);
    HardShape shape = shape_of(dice, {a, b, centre(dice)});
    if (dice.chance(.5F)) make_whole(shape);
    return shape;
}
HardShape through_centres(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 from = centre(dice), along = lattice(dice, 6);
    const float a = dice.within(-4, 0), b = dice.within(0, 4);
    // In quarters the side stays on the line: nothing is rounded.
    return shape_of(dice, {from + along * (std::floor(a * 4) / 4), from + along * (std::ceil(b * 4 + .25F) / 4),
                           dice.place(kLow, kHigh)});
}
HardShape near_ties(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 a = centre(dice), b = centre(dice);
    HardShape shape = shape_of(dice, {a, b, centre(dice)});
    make_whole(shape);
    for (Vertex& v : shape.vertices)
        for (float Vertex::*a_ : {&Vertex::x, &Vertex::y, &Vertex::u, &Vertex::v, &Vertex::w})
            if (dice.chance(.5F)) v.*a_ = dice.nudged(v.*a_, 3);
    return shape;
}
/// Corners on centres, slopes n/size: texels begin on samples, and double does not know which n/48 is whole.
HardShape ratios(std::uint64_t seed) {
    Dice dice(seed);
    const int size = dice.one_of({12, 24, 24, 48, 20});
    const float s = static_cast<float>(size), x = static_cast<float>(dice.whole(0, 3)) + .5F,
                y = static_cast<float>(dice.whole(0, 3)) + .5F;
    HardShape shape = shape_of(dice, {vec2(x, y), vec2(x + s, y), vec2(x, y + s)}, {0, 0, 54, 54});
    make_whole(shape);
    return shape;
}
HardShape denormal(std::uint64_t seed) {
    Dice dice(seed);
    const auto size = static_cast<float>(dice.one_of({8, 16, 32}));
    const auto tiny = [&] {
        return dice.either(std::numeric_limits<float>::denorm_min() * static_cast<float>(dice.whole(0, 3)));
    };
    HardShape shape = shape_of(dice, {vec2(0, 0), vec2(size, size), vec2(0, size)});
    for (Vertex& v : shape.vertices) {
        v.x += tiny();
        v.y += tiny();
    }
    if (dice.chance(.5F)) make_whole(shape);
    if (dice.chance(.3F)) shape.vertices[0].u = tiny();
    if (dice.chance(.3F)) shape.vertices[2].v = tiny();
    return shape;
}
/// A line through centres, opened by 1e-7 to 1e-1 px.
HardShape opened_lines(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 from = centre(dice), along = lattice(dice, 5);
    vec2 end = from + along * static_cast<float>(dice.whole(2, 8));
    const float open = dice.either(dice.scale(-23, -4));
    (dice.chance(.5F) ? end.x : end.y) += open;
    return shape_of(dice, {from, end, from + along * static_cast<float>(dice.whole(1, 9))});
}
HardShape thin(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 way = dice.direction(), across{-way.y, way.x}, middle = dice.place({0, 0}, {40, 32});
    const float length = dice.scale(4, 11), width = dice.scale(-10, 1), start = dice.within(-.7F, -.3F) * length;
    return shape_of(dice,
                    {middle + way * start, middle + way * start + across * width, middle + way * (start + length)});
}
HardShape tiny(std::uint64_t seed) {
    Dice dice(seed);
    const float size = dice.scale(-20, 0);
    const vec2 middle = dice.chance(.7F) ? centre(dice) : dice.place(kLow, kHigh);
    const auto near = [&] { return middle + dice.place({-size, -size}, {size, size}); };
    const vec2 a = near(), b = near();
    return shape_of(dice, {a, b, near()});
}
/// Corners in line but for a few units in the last place, up to 2^20 px out.
HardShape nearly_in_line(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 middle = centre(dice), way = dice.chance(.5F) ? lattice(dice, 5) : dice.direction();
    const float far = dice.scale(3, 17);
    Corners p{middle - way * far, middle + way * far, middle + way * dice.within(-20, 20)};
    for (vec2& corner : p) corner = {dice.nudged(corner.x, 2), dice.nudged(corner.y, 2)};
    return shape_of(dice, p);
}
HardShape without_area(std::uint64_t seed) {
    Dice dice(seed);
    const float unit = dice.one_of({.25F, 1.0F});
    const vec2 from = centre(dice), along = lattice(dice, 5) * unit;
    const auto on_line = [&] { return from + along * static_cast<float>(dice.whole(-6, 6)); };
    const vec2 a = on_line(), b = on_line();
    return shape_of(dice, {a, b, dice.chance(.3F) ? a : on_line()});
}
HardShape truncated(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    for (Vertex& v : shape.vertices) v.u = dice.within(-3, 2), v.v = dice.within(-3, 2);
    return shape;
}
HardShape not_finite(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    auto& bad = shape.vertices[static_cast<std::size_t>(dice.whole(0, 2))];
    float Vertex::*const where = dice.one_of({&Vertex::x, &Vertex::y, &Vertex::u, &Vertex::v});
    bad.*where = dice.one_of({kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()});
    return shape;
}
HardShape huge(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    for (Vertex& v : shape.vertices)
        for (float Vertex::*a : {&Vertex::x, &Vertex::y})
            if (dice.chance(.6F)) v.*a = dice.either(dice.chance(.1F) ? 3e38F : dice.scale(20, 126));
    return shape;
}
HardShape long_legs(std::uint64_t seed) {
    Dice dice(seed);
    const auto leg = [&] { return dice.step(dice.within(181, 4096)); };
    const vec2 middle = dice.place({0, 0}, {24, 16}), along = leg();  // a side crosses the frame
    return shape_of(dice, {middle - along, middle + along * dice.within(.1F, 1), middle + leg()}, {0, 0, 24, 16});
}
namespace {

/// 3 to 9 px large, u over 256 texels, `far` px from the origin.
[[nodiscard]] HardShape small_at(Dice& dice, vec2 origin, const Rect& frame) {
    const float size = dice.within(3, 9);
    const auto near = [&] { return origin + dice.place({2, 2}, {2 + size, 2 + size}); };
    const vec2 a = near(), b = near();
    HardShape shape = shape_of(dice, {a, b, near()}, frame);
    shape.texture_width = shape.texture_height = 256;
    for (Vertex& v : shape.vertices) v.u = dice.within(0, 256), v.v = dice.within(0, 256);
    return shape;
}

}  // namespace

HardShape offset(std::uint64_t seed) {
    Dice dice(seed);
    const int far = 1 << dice.whole(8, 12);
    const bool right = dice.chance(.5F);
    const Rect frame = right ? Rect{0, 0, far + 16, 16} : Rect{0, 0, 16, far + 16};
    return small_at(dice, right ? vec2(static_cast<float>(far), 0) : vec2(0, static_cast<float>(far)), frame);
}
HardShape far_offset(std::uint64_t seed) {
    Dice dice(seed);
    const int x = 1 << dice.whole(8, 20), y = dice.chance(.5F) ? x : -(1 << dice.whole(8, 20));
    return small_at(dice, {static_cast<float>(x), static_cast<float>(y)}, {x, y, x + 16, y + 16});
}
/// Rows of up to 3840 px, a slope of at most 2 texels a pixel.
HardShape long_rows(std::uint64_t seed) {
    Dice dice(seed);
    const int width = dice.one_of({64, 320, 640, 1920, 3840});
    const float right = static_cast<float>(width);
    const vec2 a = dice.place({-8, -2}, {8, 0}), b = dice.place({right - 8, -1}, {right + 8, 3});
    HardShape shape = shape_of(dice, {a, b, dice.place({0, 2}, {right, 5})}, {0, 0, width, 2});
    const float most = std::min(1024.0F, 2 * right);
    for (Vertex& v : shape.vertices) v.u = dice.within(0, most), v.v = dice.within(0, most);
    return shape;
}

namespace {

/// Where tiles of the fast rasterizer begin and end, now and then.
[[nodiscard]] float at_tile(float at, float from) { return std::floor((at - from) / 16) * 16 + from + .5F; }

void set_depths(Dice& dice, HardShape& shape, int low, int high) {
    for (Vertex& v : shape.vertices) v.w = dice.scale(low, high);
}

}  // namespace

/// In one of eight frames: those of each are drawn together.
HardShape layers(std::uint64_t seed) {
    Dice dice(seed);
    const int place = dice.whole(0, 7), left = 37 * place - 100, top = 11 * place;
    const Rect frame{left, top, left + 120, top + 90 + 2 * place};
    const vec2 origin(frame.x0, frame.y0), low = origin - vec2(60, 45), high = origin + vec2(180, 135);
    Corners corners{};
    for (vec2& p : corners) p = dice.place(low, high);
    if (dice.chance(.25F))
        for (vec2& p : corners) p = vec2(at_tile(p.x, origin.x), at_tile(p.y, origin.y));
    HardShape shape = shape_of(dice, corners, frame);
    if (dice.chance(.25F)) make_whole(shape);
    return shape;
}

HardShape steep(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    set_depths(dice, shape, -10, 9);
    return shape;
}
HardShape extreme_depths(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    set_depths(dice, shape, -149, 126);
    if (dice.chance(.3F)) shape.vertices[0].w = dice.one_of({1e-45F, 3e38F});
    return shape;
}
HardShape equal_depths(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float w = dice.one_of({.1F, 3.0F, 1e-3F, 7e20F, 1e-42F});
    for (Vertex& v : shape.vertices) v.w = w;
    if (dice.chance(.5F)) make_whole(shape);
    return shape;
}
HardShape nearly_equal_depths(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float w = dice.scale(-4, 4), spread = dice.scale(-20, -4);
    for (Vertex& v : shape.vertices) v.w = w * (1 + spread * dice.share());
    if (dice.chance(.3F)) shape.vertices[2].w = std::nextafter(shape.vertices[1].w = shape.vertices[0].w, 1e9F);
    return shape;
}
/// Ties in perspective: corners on centres, w small whole numbers.
HardShape whole_depths(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 a = centre(dice), b = centre(dice);
    HardShape shape = shape_of(dice, {a, b, centre(dice)});
    make_whole(shape);
    for (Vertex& v : shape.vertices) v.w = static_cast<float>(dice.whole(1, 4));
    return shape;
}

HardShape big_indices(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    shape.texture_width = 1024, shape.texture_height = 4;
    const float from = dice.either(dice.scale(20, 40)), most = dice.chance(.5F) ? 4096.0F : std::abs(from);
    for (Vertex& v : shape.vertices) v.u = from + dice.within(-most, most), v.v = from + dice.within(-most, most);
    return shape;
}
HardShape any_texture(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    shape.texture_width = dice.whole(1, 100), shape.texture_height = dice.whole(1, 100);
    return shape;
}
HardShape small_textures(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    shape.texture_width = 1 << dice.whole(0, 3), shape.texture_height = 1 << dice.whole(0, 3);
    return shape;
}
HardShape minified(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float most = dice.scale(8, 16);
    for (Vertex& v : shape.vertices) v.u = dice.within(-most, most), v.v = dice.within(-most, most);
    return shape;
}
HardShape magnified(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float most = dice.scale(-20, 0), u = static_cast<float>(dice.whole(-3, 3)),
                v0 = static_cast<float>(dice.whole(0, 64));
    for (Vertex& v : shape.vertices) v.u = u + dice.within(-most, most), v.v = v0 + dice.within(-most, most);
    return shape;
}
HardShape level_texture(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const bool whole = dice.chance(.5F), both = dice.chance(.3F);
    for (Vertex& v : shape.vertices) v.u = whole ? 17.0F : shape.vertices[0].u, v.v = both ? -5.0F : v.v;
    return shape;
}
HardShape borders(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    for (Vertex& v : shape.vertices) {
        const float right = dice.either(dice.scale(-30, -5)), down = dice.either(dice.scale(-30, -5));
        if (dice.chance(.5F)) v.x = dice.one_of({0.0F, 40.0F, -0.0F}) + right;
        if (dice.chance(.5F)) v.y = dice.one_of({0.0F, 32.0F, 0.5F}) + down;
    }
    return shape;
}
/// Where number classes end: 2^-6, 2^13 and 2^21 px.
HardShape class_limits(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    for (Vertex& v : shape.vertices)
        for (float Vertex::*a : {&Vertex::x, &Vertex::y})
            if (dice.chance(.5F)) v.*a = dice.either(dice.nudged(dice.one_of({0x1p-6F, 0x1p13F, 0x1p21F, 0x1p-8F}), 2));
    return shape;
}
/// One triangle in its six orders.
HardShape orders(std::uint64_t seed) {
    Dice dice(seed);
    const HardShape one = dice.chance(.5F) ? near_ties(seed) : dice.chance(.5F) ? thin(seed) : ordinary(dice);
    HardShape shape = one;
    shape.vertices.clear();
    for (const auto& order : {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}})
        for (const int n : order) shape.vertices.push_back(one.vertices[static_cast<std::size_t>(n)]);
    return shape;
}

}  // namespace texelscope::family
