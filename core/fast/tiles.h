// Hierarchical z: the farthest depth of each 16 x 16 tile, brought up to date only where somebody asks and much has
// been written, or where a triangle covers the tile whole.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "core/fast/raster.h"

namespace texelscope {

/// Pixels [x0, x1) x [y0, y1) of a target.
struct PixelBox {
    int x0, y0, x1, y1;
};

class DepthTiles {
public:
    explicit DepthTiles(const RasterTarget& target)
        : target_(target),
          columns_((target.width + kSide - 1) / kSide),
          farthest_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>((target.height + kSide - 1) / kSide),
                    std::numeric_limits<float>::infinity()),
          of_four_(farthest_),
          written_(farthest_.size(), kEnough) {}

    static constexpr int kBits = 4, kSide = 1 << kBits;  ///< of a tile [px]

    /// No depth of a tile, or of those right of it, below it, and right of that, is farther; row by row, columns() in
    /// each.
    [[nodiscard]] const float* farthest_of_four() const { return of_four_.data(); }
    [[nodiscard]] int columns() const { return columns_; }

    /// Nothing that is `nearest` or farther passes LESS anywhere in the box.
    [[nodiscard]] bool hides(const PixelBox& box, float nearest) {
        for (int y = box.y0 / kSide; y <= (box.y1 - 1) / kSide; ++y)
            for (int x = box.x0 / kSide; x <= (box.x1 - 1) / kSide; ++x)
                if (!hides(x, y, nearest)) return false;
        return true;
    }
    /// The same in one tile.
    [[nodiscard]] bool hides(int x, int y, double nearest) {
        const std::size_t tile = index(x, y);
        if (nearest >= farthest_[tile]) return true;
        if (written_[tile] < kEnough) return false;
        refresh(x, y);
        return nearest >= farthest_[tile];
    }
    /// Depths in the box may have become nearer.
    void touch(const PixelBox& box) {
        const int most = std::min(box.x1 - box.x0, kSide) * std::min(box.y1 - box.y0, kSide);
        for (int y = box.y0 / kSide; y <= (box.y1 - 1) / kSide; ++y)
            for (int x = box.x0 / kSide; x <= (box.x1 - 1) / kSide; ++x) {
                int& written = written_[index(x, y)];
                written = std::min(kEnough, written + most);
            }
    }
    /// All depths of a tile have become at least so near.
    void note_covered(int x, int y, float farthest) {
        if (farthest < farthest_[index(x, y)]) set(x, y, farthest);
    }

private:
    /// So many pixels of boxes drawn over a tile, eight times all it has, are likely to have changed its farthest
    /// depth: measured.
    static constexpr int kEnough = 8 * kSide * kSide;
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }

    void set(int x, int y, float farthest) {
        farthest_[index(x, y)] = farthest;
        const int rows = static_cast<int>(farthest_.size()) / columns_;
        for (int top = std::max(0, y - 1); top <= y; ++top)
            for (int left = std::max(0, x - 1); left <= x; ++left) {
                const int right = std::min(left + 1, columns_ - 1), bottom = std::min(top + 1, rows - 1);
                of_four_[index(left, top)] =
                    std::max({farthest_[index(left, top)], farthest_[index(right, top)], farthest_[index(left, bottom)],
                              farthest_[index(right, bottom)]});
            }
    }
    void refresh(int x, int y) {
        std::array<float, kSide> columns;  // of which compilers make vectors
        columns.fill(-std::numeric_limits<float>::infinity());
        const int width = std::min(kSide, target_.width - x * kSide), y1 = std::min((y + 1) * kSide, target_.height);
        for (int row = y * kSide; row < y1; ++row) {
            const float* const line = target_.depth + row * target_.pitch + x * kSide;
            if (width == kSide)
                for (int n = 0; n < kSide; ++n)
                    columns[static_cast<std::size_t>(n)] = std::max(columns[static_cast<std::size_t>(n)], line[n]);
            else
                for (int n = 0; n < width; ++n)
                    columns[static_cast<std::size_t>(n)] = std::max(columns[static_cast<std::size_t>(n)], line[n]);
        }
        set(x, y, *std::max_element(columns.begin(), columns.end()));
        written_[index(x, y)] = 0;
    }

    RasterTarget target_;
    int columns_;
    std::vector<float> farthest_, of_four_;
    std::vector<int> written_;  ///< pixels drawn over a tile since its farthest depth was found, at most
};

}  // namespace texelscope
