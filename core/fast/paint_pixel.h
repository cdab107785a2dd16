// Integer arithmetic on single pixels and rows of one colour, for core/fast/paint.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/image/image.h"
#include "core/image/rgba.h"

namespace texelscope {

/// round(x / 255), exact for 0 <= x <= 65025; the quotient never lies halfway, as 255 is odd.
[[nodiscard]] constexpr std::uint32_t divide_255(std::uint32_t x) noexcept { return (x + 128 + ((x + 128) >> 8)) >> 8; }

[[nodiscard]] constexpr std::uint8_t modulate(std::uint32_t a, std::uint32_t b) noexcept {
    return static_cast<std::uint8_t>(divide_255(a * b));
}

[[nodiscard]] constexpr Rgba modulate(const Rgba& a, const Rgba& b) noexcept {
    return {modulate(a.r, b.r), modulate(a.g, b.g), modulate(a.b, b.b), modulate(a.a, b.a)};
}

[[nodiscard]] constexpr std::uint8_t mix(std::uint32_t source, std::uint32_t target, std::uint32_t alpha) noexcept {
    return static_cast<std::uint8_t>(divide_255(source * alpha + target * (255 - alpha)));
}

constexpr void put(Rgb& target, const Rgba& source) noexcept { target = {source.r, source.g, source.b}; }
constexpr void put(Rgba& target, const Rgba& source) noexcept { target = source; }

constexpr void blend(Rgb& target, const Rgba& source) noexcept {
    target = {mix(source.r, target.r, source.a), mix(source.g, target.g, source.a), mix(source.b, target.b, source.a)};
}
constexpr void blend(Rgba& target, const Rgba& source) noexcept {
    target = {mix(source.r, target.r, source.a), mix(source.g, target.g, source.a), mix(source.b, target.b, source.a),
              mix(255, target.a, source.a)};
}

/// `blend`, with the two ends, which need no arithmetic, taken first.
template <class Pixel>
constexpr void over(Pixel& target, const Rgba& source) noexcept {
    if (source.a == 0) return;
    if (source.a == 255) return put(target, source);
    blend(target, source);
}

/// One opaque colour into `count` pixels, by copying what is already there in doubling lengths.
template <class Pixel>
void fill_row(Pixel* row, int count, const Rgba& colour) noexcept {
    constexpr int kSeed = 16;
    const int seed = std::min(count, kSeed);
    for (int i = 0; i < seed; ++i) put(row[i], colour);
    for (int done = seed; done < count;) {
        const int more = std::min(done, count - done);
        std::memcpy(row + done, row, static_cast<std::size_t>(more) * sizeof(Pixel));
        done += more;
    }
}

/// One colour over `count` pixels. Long rows go in blocks, bytes side by side, whose sums all fit 16 bits.
template <class Pixel>
void blend_row(Pixel* row, int count, const Rgba& colour) noexcept {
    if (colour.a == 0) return;
    if (colour.a == 255) return fill_row(row, count, colour);
    constexpr int kBlock = 16, kBytes = kBlock * static_cast<int>(sizeof(Pixel));
    int done = 0;
    if (count >= 2 * kBlock) {
        const std::array<std::uint8_t, 4> channels{colour.r, colour.g, colour.b, 255};
        std::array<std::uint16_t, kBytes> source{};
        for (std::size_t i = 0; i < source.size(); ++i) {
            source[i] = static_cast<std::uint16_t>(channels[i % sizeof(Pixel)] * colour.a + 128);
        }
        const auto rest = static_cast<std::uint16_t>(255 - colour.a);
        for (; done + kBlock <= count; done += kBlock) {
            auto* const bytes = reinterpret_cast<std::uint8_t*>(row + done);
            for (std::size_t i = 0; i < source.size(); ++i) {
                const auto sum = static_cast<std::uint16_t>(source[i] + bytes[i] * rest);
                bytes[i] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(sum + (sum >> 8)) >> 8);
            }
        }
    }
    for (; done < count; ++done) blend(row[done], colour);
}

}  // namespace texelscope
