// Pixels in memory: row-major from the top left, 8 bits a channel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/assert.h"

namespace texelscope {

inline constexpr int kMaxSize = 16384;  ///< the greatest width or height of a framebuffer or texture [px]

struct Rgb {
    std::uint8_t r = 0, g = 0, b = 0;
    friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

/// A row-major grid of `Pixel`. Copying copies the pixels.
template <class Pixel>
class Grid {
public:
    Grid() = default;
    Grid(int width, int height, Pixel fill = {})
        : width_(width),
          height_(height),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool empty() const { return pixels_.empty(); }
    [[nodiscard]] const Pixel* data() const { return pixels_.data(); }
    [[nodiscard]] Pixel* data() { return pixels_.data(); }
    [[nodiscard]] std::size_t size() const { return pixels_.size(); }
    /// Requires 0 <= x < width, 0 <= y < height.
    [[nodiscard]] const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }
    [[nodiscard]] Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
    friend bool operator==(const Grid&, const Grid&) = default;

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        TEXELSCOPE_ASSERT(x >= 0 && x < width_ && y >= 0 && y < height_);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_ = 0, height_ = 0;
    std::vector<Pixel> pixels_;
};

using Image = Grid<Rgb>;

}  // namespace texelscope
