#include <algorithm>
#include <array>
#include <utility>

#include "core/measure/dice.h"
#include "core/measure/family_makers.h"

namespace texelscope::family {
namespace {

using glm::vec2;

}  // namespace

/// A rectangle over all the frame, one texel for a pixel or a simple ratio, cut along a diagonal.
HardShape blit(std::uint64_t seed) {
    Dice dice(seed);
    HardShape shape{.vertices = {}, .frame = {0, 0, 24, 20}, .closed = true};
    const auto ratio = [&] {
        const auto top = static_cast<float>(dice.whole(1, 4));
        return dice.either(top / static_cast<float>(dice.one_of({1, 1, 1, 2, 3, 4, 8, 48})));
    };
    const float u_x = ratio(), v_y = ratio(), shift = dice.one_of({0.0F, 0.0F, .5F, .25F});
    const float left = -static_cast<float>(dice.whole(0, 3)) - shift;
    const float top = -static_cast<float>(dice.whole(0, 3)) - shift;
    const float right = 24 + static_cast<float>(dice.whole(0, 24)) + shift,
                bottom = 20 + static_cast<float>(dice.whole(0, 24)) + shift;
    const auto at = [&](float x, float y) {
        return Vertex{.x = x, .y = y, .w = 1, .u = (x - left) * u_x, .v = (y - top) * v_y};
    };
    shape.vertices = {at(left, top), at(right, top),    at(right, bottom),
                      at(left, top), at(right, bottom), at(left, bottom)};
    return shape;
}

namespace {

/// A plane of the texture over the screen, so that a mesh has no seams in it.
struct Laid {
    vec2 along, offset;
    explicit Laid(Dice& dice) : along(dice.step(dice.scale(-1, 0))), offset(dice.place({0, 0}, {64, 64})) {}
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

}  // namespace

/// Triangles round a point, out to a square ring beyond the frame.
HardShape fan(std::uint64_t seed) {
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

namespace {

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
                const std::ptrdiff_t place = std::ptrdiff_t{y + down} * columns + x + right;
                return nodes[static_cast<std::size_t>(place)];
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

}  // namespace

HardShape grid(std::uint64_t seed) {
    Dice dice(seed);
    const float step = dice.one_of({3.0F, 4.0F, 5.3F});
    return mesh(dice, step, dice.one_of({0.0F, .2F, .3F}));
}
HardShape fine_grid(std::uint64_t seed) {
    Dice dice(seed);
    const float step = dice.one_of({.7F, 1.0F, 1.5F, 2.0F});
    return mesh(dice, step, dice.one_of({0.0F, .2F, .3F}));
}

}  // namespace texelscope::family
