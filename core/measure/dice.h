// Random numbers that are the same everywhere: the standard's engines are, its distributions are not, nor are sine and
// cosine. Never call it twice in one argument list or operand list: compilers differ in the order.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>

#include <glm/vec2.hpp>

namespace texelscope {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    /// 24 bits of [0, 1).
    [[nodiscard]] float share() { return static_cast<float>(engine_() >> 40) * 0x1p-24F; }
    [[nodiscard]] float within(float low, float high) { return low + (high - low) * share(); }
    /// In [low, high].
    [[nodiscard]] int whole(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    [[nodiscard]] bool chance(float odds) { return share() < odds; }
    /// From 2^low up to 2^(high + 1), each power as likely as the others.
    [[nodiscard]] float scale(int low, int high) {
        const float digits = 1 + share();
        return std::ldexp(digits, whole(low, high));
    }
    /// `value` or its negative.
    [[nodiscard]] float either(float value) { return chance(.5F) ? value : -value; }
    template <class T>
    [[nodiscard]] T one_of(std::initializer_list<T> all) {
        return all.begin()[static_cast<std::size_t>(whole(0, static_cast<int>(all.size()) - 1))];
    }
    [[nodiscard]] glm::vec2 place(glm::vec2 low, glm::vec2 high) {
        const float x = within(low.x, high.x);
        return {x, within(low.y, high.y)};
    }
    /// Of length 1, any way with the same chance.
    [[nodiscard]] glm::vec2 direction() {
        while (true) {
            const glm::vec2 p = place({-1, -1}, {1, 1});
            const float square = p.x * p.x + p.y * p.y;
            if (square > .01F && square <= 1) return p / std::sqrt(square);
        }
    }
    /// Of that length, any way.
    [[nodiscard]] glm::vec2 step(float length) { return direction() * length; }
    /// Up to `most` floats further up or down.
    [[nodiscard]] float nudged(float value, int most) {
        const int steps = whole(-most, most);
        for (int n = 0; n < std::abs(steps); ++n) value = std::nextafter(value, steps < 0 ? -INFINITY : INFINITY);
        return value;
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace texelscope
