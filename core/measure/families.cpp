#include "core/measure/families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/geometry/snap.h"
#include "core/measure/dice.h"

namespace texelscope {
namespace {

using glm::vec2;
using Corners = std::array<vec2, 3>;

constexpr Rect kFrame{0, 0, 40, 32};
constexpr vec2 kLow{-6, -6}, kHigh{46, 38};  ///< a little beyond the frame
constexpr int kSnapBits = 8;

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

[[nodiscard]] HardShape random(std::uint64_t seed) {
    Dice dice(seed);
    return ordinary(dice);
}
[[nodiscard]] HardShape on_a_grid(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float unit = dice.one_of({1.0F, 2.0F, 4.0F, 16.0F});
    for (Vertex& v : shape.vertices)
        for (float Vertex::*a : {&Vertex::x, &Vertex::y, &Vertex::u, &Vertex::v}) v.*a = std::floor(v.*a * unit) / unit;
    return shape;
}
[[nodiscard]] HardShape on_centres(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 a = centre(dice), b = centre(dice);
    HardShape shape = shape_of(dice, {a, b, centre(dice)});
    if (dice.chance(.5F)) make_whole(shape);
    return shape;
}
[[nodiscard]] HardShape through_centres(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 from = centre(dice), along = lattice(dice, 6);
    const float a = dice.within(-4, 0), b = dice.within(0, 4);
    // In quarters the side stays on the line: nothing is rounded.
    return shape_of(dice, {from + along * (std::floor(a * 4) / 4), from + along * (std::ceil(b * 4 + .25F) / 4),
                           dice.place(kLow, kHigh)});
}
[[nodiscard]] HardShape near_ties(std::uint64_t seed) {
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
[[nodiscard]] HardShape ratios(std::uint64_t seed) {
    Dice dice(seed);
    const int size = dice.one_of({12, 24, 24, 48, 20});
    const float s = static_cast<float>(size), x = static_cast<float>(dice.whole(0, 3)) + .5F,
                y = static_cast<float>(dice.whole(0, 3)) + .5F;
    HardShape shape = shape_of(dice, {vec2(x, y), vec2(x + s, y), vec2(x, y + s)}, {0, 0, 54, 54});
    make_whole(shape);
    return shape;
}
/// A rectangle over all the frame, one texel for a pixel or a simple ratio, cut along a diagonal.
[[nodiscard]] HardShape blit(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape{.vertices = {}, .frame = {0, 0, 24, 20}, .closed = true};
    const auto ratio = [&] {
        const int top = dice.whole(1, 4);
        return dice.sign() * static_cast<float>(top) / static_cast<float>(dice.one_of({1, 1, 1, 2, 3, 4, 8, 48}));
    };
    const float u_x = ratio(), v_y = ratio(), shift = dice.one_of({0.0F, 0.0F, .5F, .25F});
    const float left = -static_cast<float>(dice.whole(0, 3)) - shift,
                top = -static_cast<float>(dice.whole(0, 3)) - shift;
    const float right = 24 + static_cast<float>(dice.whole(0, 24)) + shift,
                bottom = 20 + static_cast<float>(dice.whole(0, 24)) + shift;
    const auto at = [&](float x, float y) {
        return Vertex{.x = x, .y = y, .w = 1, .u = (x - left) * u_x, .v = (y - top) * v_y};
    };
    shape.vertices = {at(left, top), at(right, top),    at(right, bottom),
                      at(left, top), at(right, bottom), at(left, bottom)};
    return shape;
}

[[nodiscard]] HardShape denormal(std::uint64_t seed) {
    Dice dice(seed);
    const float size = static_cast<float>(dice.one_of({8, 16, 32})), bit = std::numeric_limits<float>::denorm_min();
    const auto tiny = [&] { return dice.sign() * bit * static_cast<float>(dice.whole(0, 3)); };
    HardShape shape = shape_of(dice, {vec2(tiny(), tiny()), vec2(size + tiny(), size + tiny()), vec2(tiny(), size)});
    if (dice.chance(.5F)) make_whole(shape);
    if (dice.chance(.3F)) shape.vertices[0].u = tiny(), shape.vertices[2].v = tiny();
    return shape;
}
/// A line through centres, opened by 1e-7 to 1e-1 px.
[[nodiscard]] HardShape opened_lines(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 from = centre(dice), along = lattice(dice, 5);
    vec2 end = from + along * static_cast<float>(dice.whole(2, 8));
    const float open = dice.scale(-23, -4) * dice.sign();
    (dice.chance(.5F) ? end.x : end.y) += open;
    return shape_of(dice, {from, end, from + along * static_cast<float>(dice.whole(1, 9))});
}
[[nodiscard]] HardShape thin(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 way = dice.direction(), across{-way.y, way.x}, middle = dice.place({0, 0}, {40, 32});
    const float length = dice.scale(4, 11), width = dice.scale(-10, 1), start = dice.within(-.7F, -.3F) * length;
    return shape_of(dice,
                    {middle + way * start, middle + way * start + across * width, middle + way * (start + length)});
}
[[nodiscard]] HardShape tiny(std::uint64_t seed) {
    Dice dice(seed);
    const float size = dice.scale(-20, 0);
    const vec2 middle = dice.chance(.7F) ? centre(dice) : dice.place(kLow, kHigh);
    const auto near = [&] { return middle + dice.place({-size, -size}, {size, size}); };
    const vec2 a = near(), b = near();
    return shape_of(dice, {a, b, near()});
}
/// Corners in line but for a few units in the last place, up to 2^20 px out.
[[nodiscard]] HardShape nearly_in_line(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 middle = centre(dice), way = dice.chance(.5F) ? lattice(dice, 5) : dice.direction();
    const float far = dice.scale(3, 17);
    Corners p{middle - way * far, middle + way * far, middle + way * dice.within(-20, 20)};
    for (vec2& corner : p) corner = {dice.nudged(corner.x, 2), dice.nudged(corner.y, 2)};
    return shape_of(dice, p);
}
[[nodiscard]] HardShape without_area(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 from = centre(dice), along = lattice(dice, 5) * dice.one_of({.25F, 1.0F});
    const auto on_line = [&] { return from + along * static_cast<float>(dice.whole(-6, 6)); };
    const vec2 a = on_line(), b = on_line();
    return shape_of(dice, {a, b, dice.chance(.3F) ? a : on_line()});
}
[[nodiscard]] HardShape truncated(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    for (Vertex& v : shape.vertices) v.u = dice.within(-3, 2), v.v = dice.within(-3, 2);
    return shape;
}
[[nodiscard]] HardShape not_finite(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    auto& bad = shape.vertices[static_cast<std::size_t>(dice.whole(0, 2))];
    (bad.*dice.one_of({&Vertex::x, &Vertex::y, &Vertex::u, &Vertex::v})) =
        dice.one_of({kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()});
    return shape;
}
[[nodiscard]] HardShape huge(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    for (Vertex& v : shape.vertices)
        for (float Vertex::*a : {&Vertex::x, &Vertex::y})
            if (dice.chance(.6F)) v.*a = dice.sign() * (dice.chance(.1F) ? 3e38F : dice.scale(20, 126));
    return shape;
}
[[nodiscard]] HardShape long_legs(std::uint64_t seed) {
    Dice dice(seed);
    const auto leg = [&] { return dice.direction() * dice.within(181, 4096); };
    const vec2 from = leg();
    const vec2 to = from + leg();
    return shape_of(dice, {from, to, to + leg()}, {0, 0, 24, 16});
}
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
[[nodiscard]] HardShape offset(std::uint64_t seed) {
    Dice dice(seed);
    const int far = 1 << dice.whole(8, 12);
    const bool right = dice.chance(.5F);
    const Rect frame = right ? Rect{0, 0, far + 16, 16} : Rect{0, 0, 16, far + 16};
    return small_at(dice, right ? vec2(static_cast<float>(far), 0) : vec2(0, static_cast<float>(far)), frame);
}
[[nodiscard]] HardShape far_offset(std::uint64_t seed) {
    Dice dice(seed);
    const int x = 1 << dice.whole(8, 20), y = dice.chance(.5F) ? x : -(1 << dice.whole(8, 20));
    return small_at(dice, {static_cast<float>(x), static_cast<float>(y)}, {x, y, x + 16, y + 16});
}
/// Rows of up to 3840 px, a slope of at most 2 texels a pixel.
[[nodiscard]] HardShape long_rows(std::uint64_t seed) {
    Dice dice(seed);
    const int width = dice.one_of({64, 320, 640, 1920, 3840});
    const float right = static_cast<float>(width);
    const vec2 a = dice.place({-8, -2}, {8, 0}), b = dice.place({right - 8, -1}, {right + 8, 3});
    HardShape shape = shape_of(dice, {a, b, dice.place({0, 2}, {right, 5})}, {0, 0, width, 2});
    const float most = std::min(1024.0F, 2 * right);
    for (Vertex& v : shape.vertices) v.u = dice.within(0, most), v.v = dice.within(0, most);
    return shape;
}

void set_depths(Dice& dice, HardShape& shape, int low, int high) {
    for (Vertex& v : shape.vertices) v.w = dice.scale(low, high);
}
[[nodiscard]] HardShape steep(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    set_depths(dice, shape, -10, 9);
    return shape;
}
[[nodiscard]] HardShape extreme_depths(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    set_depths(dice, shape, -149, 126);
    if (dice.chance(.3F)) shape.vertices[0].w = dice.one_of({1e-45F, 3e38F});
    return shape;
}
[[nodiscard]] HardShape equal_depths(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float w = dice.one_of({.1F, 3.0F, 1e-3F, 7e20F, 1e-42F});
    for (Vertex& v : shape.vertices) v.w = w;
    if (dice.chance(.5F)) make_whole(shape);
    return shape;
}
[[nodiscard]] HardShape nearly_equal_depths(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float w = dice.scale(-4, 4), spread = dice.scale(-20, -4);
    for (Vertex& v : shape.vertices) v.w = w * (1 + spread * dice.share());
    if (dice.chance(.3F)) shape.vertices[2].w = std::nextafter(shape.vertices[1].w = shape.vertices[0].w, 1e9F);
    return shape;
}
/// Ties in perspective: corners on centres, w small whole numbers.
[[nodiscard]] HardShape whole_depths(std::uint64_t seed) {
    Dice dice(seed);
    const vec2 a = centre(dice), b = centre(dice);
    HardShape shape = shape_of(dice, {a, b, centre(dice)});
    make_whole(shape);
    for (Vertex& v : shape.vertices) v.w = static_cast<float>(dice.whole(1, 4));
    return shape;
}

[[nodiscard]] HardShape big_indices(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    shape.texture_width = 1024, shape.texture_height = 4;
    const float from = dice.sign() * dice.scale(20, 40), most = dice.chance(.5F) ? 4096.0F : std::abs(from);
    for (Vertex& v : shape.vertices) v.u = from + dice.within(-most, most), v.v = from + dice.within(-most, most);
    return shape;
}
[[nodiscard]] HardShape any_texture(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    shape.texture_width = dice.whole(1, 100), shape.texture_height = dice.whole(1, 100);
    return shape;
}
[[nodiscard]] HardShape small_textures(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    shape.texture_width = 1 << dice.whole(0, 3), shape.texture_height = 1 << dice.whole(0, 3);
    return shape;
}
[[nodiscard]] HardShape minified(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float most = dice.scale(8, 16);
    for (Vertex& v : shape.vertices) v.u = dice.within(-most, most), v.v = dice.within(-most, most);
    return shape;
}
[[nodiscard]] HardShape magnified(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const float most = dice.scale(-20, 0), u = static_cast<float>(dice.whole(-3, 3)),
                v0 = static_cast<float>(dice.whole(0, 64));
    for (Vertex& v : shape.vertices) v.u = u + dice.within(-most, most), v.v = v0 + dice.within(-most, most);
    return shape;
}
[[nodiscard]] HardShape level_texture(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    const bool whole = dice.chance(.5F), both = dice.chance(.3F);
    for (Vertex& v : shape.vertices) v.u = whole ? 17.0F : shape.vertices[0].u, v.v = both ? -5.0F : v.v;
    return shape;
}
[[nodiscard]] HardShape borders(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    for (Vertex& v : shape.vertices) {
        if (dice.chance(.5F)) v.x = dice.one_of({0.0F, 40.0F, -0.0F}) + dice.sign() * dice.scale(-30, -5);
        if (dice.chance(.5F)) v.y = dice.one_of({0.0F, 32.0F, 0.5F}) + dice.sign() * dice.scale(-30, -5);
    }
    return shape;
}
/// Where number classes end: 2^-6, 2^13 and 2^21 px.
[[nodiscard]] HardShape class_limits(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape = ordinary(dice);
    for (Vertex& v : shape.vertices)
        for (float Vertex::*a : {&Vertex::x, &Vertex::y})
            if (dice.chance(.5F))
                v.*a = dice.sign() * dice.nudged(dice.one_of({0x1p-6F, 0x1p13F, 0x1p21F, 0x1p-8F}), 2);
    return shape;
}
/// One triangle in its six orders.
[[nodiscard]] HardShape orders(std::uint64_t seed) {
    Dice dice(seed);
    const HardShape one = dice.chance(.5F) ? near_ties(seed) : dice.chance(.5F) ? thin(seed) : ordinary(dice);
    HardShape shape = one;
    shape.vertices.clear();
    for (const auto& order : {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}})
        for (const int n : order) shape.vertices.push_back(one.vertices[static_cast<std::size_t>(n)]);
    return shape;
}

/// A plane of the texture over the screen, so that a mesh has no seams in it.
struct Laid {
    vec2 along, offset;
    explicit Laid(Dice& dice) : along(dice.direction() * dice.scale(-1, 0)), offset(dice.place({0, 0}, {64, 64})) {}
    [[nodiscard]] Vertex at(vec2 p) const {
        return {.x = p.x,
                .y = p.y,
                .u = offset.x + along.x * p.x - along.y * p.y,
                .v = offset.y + along.y * p.x + along.x * p.y};
    }
};
void add(HardShape& shape, Dice& dice, std::array<Vertex, 3> corners) {
    if (dice.chance(.5F)) std::swap(corners[0], corners[2]);
    if (dice.chance(.5F)) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    shape.vertices.insert(shape.vertices.end(), corners.begin(), corners.end());
}
/// Triangles round a point, out to a square ring beyond the frame.
[[nodiscard]] HardShape fan(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape{.vertices = {}, .frame = {0, 0, 24, 16}, .closed = true};
    const Laid laid(dice);
    const vec2 middle = dice.chance(.5F) ? vec2(11.5F, 7.5F) : dice.place({2, 2}, {22, 14});
    const float far = dice.scale(5, 8);
    std::vector<Vertex> ring;
    for (const auto& [from, to] : {std::pair{vec2(-far, -far), vec2(far, -far)},
                                   {vec2(far, -far), vec2(far, far)},
                                   {vec2(far, far), vec2(-far, far)},
                                   {vec2(-far, far), vec2(-far, -far)}}) {
        ring.push_back(laid.at(middle + from));
        float t = 0;
        for (int n = dice.whole(0, 4); n > 0; --n) {
            t += dice.within(.02F, .2F);
            ring.push_back(laid.at(middle + from + (to - from) * t));
        }
    }
    for (Vertex& v : ring) v.w = dice.within(1, 4);
    Vertex hub = laid.at(middle);
    hub.w = dice.within(1, 4);
    for (std::size_t n = 0; n < ring.size(); ++n) add(shape, dice, {hub, ring[n], ring[(n + 1) % ring.size()]});
    return shape;
}
[[nodiscard]] HardShape mesh(Dice& dice, float step, float shake) {
    constexpr int kWidth = 16, kHeight = 12;
    HardShape shape{.vertices = {}, .frame = {0, 0, kWidth, kHeight}, .closed = true};
    const Laid laid(dice);
    const int columns = static_cast<int>(kWidth / step) + 4, rows = static_cast<int>(kHeight / step) + 4;
    std::vector<Vertex> nodes;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const vec2 p = vec2(static_cast<float>(x) - 1.5F, static_cast<float>(y) - 1.5F) * step;
            nodes.push_back(laid.at(p + dice.place({-shake, -shake}, {shake, shake}) * step));
            nodes.back().w = dice.within(1, 4);
        }
    for (int y = 0; y + 1 < rows; ++y)
        for (int x = 0; x + 1 < columns; ++x) {
            const auto node = [&](int right, int down) {
                return nodes[static_cast<std::size_t>((y + down) * columns + x + right)];
            };
            const bool other = dice.chance(.5F);
            add(shape, dice,
                other ? std::array{node(0, 0), node(1, 0), node(0, 1)}
                      : std::array{node(0, 0), node(1, 0), node(1, 1)});
            add(shape, dice,
                other ? std::array{node(1, 0), node(1, 1), node(0, 1)}
                      : std::array{node(0, 0), node(1, 1), node(0, 1)});
        }
    return shape;
}
[[nodiscard]] HardShape grid(std::uint64_t seed) {
    Dice dice(seed);
    return mesh(dice, dice.one_of({3.0F, 4.0F, 5.3F}), dice.one_of({0.0F, .2F, .3F}));
}
[[nodiscard]] HardShape fine_grid(std::uint64_t seed) {
    Dice dice(seed);
    return mesh(dice, dice.one_of({.7F, 1.0F, 1.5F, 2.0F}), dice.one_of({0.0F, .2F, .3F}));
}

constexpr std::array kFamilies{
    Family{"random", "corners anywhere on the screen", random},
    Family{"grid-aligned", "corners and texels on whole, half, quarter and sixteenth parts", on_a_grid},
    Family{"on-centres", "corners on samples", on_centres},
    Family{"through-centres", "a side runs through samples", through_centres},
    Family{"near-ties", "corners on samples, at whole texels, then up to 3 floats off", near_ties},
    Family{"ratios", "corners on samples, slopes n/12 to n/48 texels a pixel: texels begin on samples", ratios, 4},
    Family{"blits", "rectangles over the frame, 1:1 and simple ratios", blit},
    Family{"denormal", "a denormal coordinate decides a tie", denormal},
    Family{"opened-lines", "a line through samples, opened by 1e-7 to 1e-1 px", opened_lines},
    Family{"slivers", "16 to 4,000 px long, 1e-3 to 4 px wide", thin},
    Family{"tiny", "1e-6 to 2 px large, most of them at a sample", tiny},
    Family{"nearly-in-line", "corners in line but for 2 floats, up to 2^18 px out", nearly_in_line},
    Family{"without-area", "corners in line or in one place: nothing is drawn", without_area},
    Family{"truncation", "u and v between -3 and 2", truncated},
    Family{"not-finite", "NaN and infinities: nothing is drawn", not_finite},
    Family{"huge", "coordinates of 1e6 to 3e38 px", huge},
    Family{"long-legs", "sides of 181 to 4,096 px: 32-bit edge functions overflow", long_legs},
    Family{"offset", "3 to 9 px large, 2^8 to 2^12 px from the origin along one axis", offset},
    Family{"far-offset", "3 to 9 px large, 2^8 to 2^20 px from the origin, the frame there, too", far_offset},
    Family{"long-rows", "rows of 64 to 3,840 px, up to 2 texels a pixel", long_rows, 8},
    Family{"big-indices", "u and v from 2^20 to 2^41 texels out, 1,024 texels wide", big_indices},
    Family{"any-texture", "textures of 1 to 100 texels each way", any_texture},
    Family{"small-textures", "textures of 1, 2, 4 and 8 texels each way", small_textures},
    Family{"minified", "up to thousands of texels a pixel", minified},
    Family{"magnified", "1e-6 to 1 texel over the triangle, round a whole one", magnified},
    Family{"level-texture", "u, or u and v, the same at all corners", level_texture},
    Family{"borders", "corners up to 1e-9 px from the screen's borders", borders},
    Family{"class-limits", "coordinates at 2^-8, 2^-6, 2^13 and 2^21 px", class_limits},
    Family{"orders", "one triangle in the six orders of its corners", orders, 6},
    Family{"fans", "closed: triangles round a point", fan, 12},
    Family{"grids", "closed: a shaken grid, cells of 3 to 5 px", grid, 80},
    Family{"fine-grids", "closed: a shaken grid, cells of 0.7 to 2 px", fine_grid, 800},
    Family{"steep", "w from 1e-3 to 1e3", steep, 1, true},
    Family{"extreme-depths", "w from 1e-45 to 3e38", extreme_depths, 1, true},
    Family{"equal-depths", "the same w, not 1, at all corners", equal_depths, 1, true},
    Family{"nearly-equal-depths", "w apart by 1e-6 to 0.1 of itself, or by one float", nearly_equal_depths, 1, true},
    Family{"whole-depths", "corners on samples, at whole texels, w from 1 to 4", whole_depths, 1, true},
};

}  // namespace

std::span<const Family> families() { return kFamilies; }

const Family* find_family(std::string_view name) {
    const auto at = std::find_if(kFamilies.begin(), kFamilies.end(), [=](const Family& f) { return f.name == name; });
    return at == kFamilies.end() ? nullptr : &*at;
}

HardShape in_mode(HardShape shape, StressMode mode) {
    for (Vertex& v : shape.vertices) {
        if (mode.snapped) v.x = snap(v.x, kSnapBits), v.y = snap(v.y, kSnapBits);
        if (!mode.perspective) v.w = 1;
    }
    return shape;
}

std::uint64_t seed_of(std::uint64_t seed, const Family& family, int n) {
    std::uint64_t mixed = seed;
    const auto mix = [&](std::uint64_t more) {  // splitmix64
        mixed += more + 0x9E3779B97F4A7C15;
        mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
        mixed ^= mixed >> 31;
    };
    for (const char letter : family.name) mix(static_cast<unsigned char>(letter));
    mix(static_cast<std::uint64_t>(n));
    return mixed;
}

}  // namespace texelscope
