// Hierarchical z: the farthest depth of each 16 x 16 tile, brought up to date only where somebody asks.
#pragma once

#include <algorithm>
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
          tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>((target.height + kSide - 1) / kSide)) {}

    /// Nothing that is `nearest` or farther passes LESS anywhere in the box.
    [[nodiscard]] bool hides(const PixelBox& box, float nearest) {
        for (int y = box.y0 / kSide; y <= (box.y1 - 1) / kSide; ++y)
            for (int x = box.x0 / kSide; x <= (box.x1 - 1) / kSide; ++x)
                if (!hides(x, y, nearest)) return false;
        return true;
    }
    /// Depths in the box have become nearer.
    void touch(const PixelBox& box) {
        for (int y = box.y0 / kSide; y <= (box.y1 - 1) / kSide; ++y)
            for (int x = box.x0 / kSide; x <= (box.x1 - 1) / kSide; ++x) at(x, y).stale = true;
    }

private:
    static constexpr int kSide = 16;
    struct Tile {
        float farthest = std::numeric_limits<float>::infinity();  ///< or farther, where stale
        bool stale = true;
    };
    [[nodiscard]] Tile& at(int x, int y) {
        return tiles_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
    }

    [[nodiscard]] bool hides(int x, int y, float nearest) {
        Tile& tile = at(x, y);
        if (nearest >= tile.farthest) return true;
        if (!tile.stale) return false;
        float farthest = -std::numeric_limits<float>::infinity();
        const int x1 = std::min((x + 1) * kSide, target_.width), y1 = std::min((y + 1) * kSide, target_.height);
        for (int row = y * kSide; row < y1; ++row) {
            const float* const line = target_.depth + row * target_.pitch;
            for (int column = x * kSide; column < x1; ++column) farthest = std::max(farthest, line[column]);
        }
        tile = {farthest, false};
        return nearest >= farthest;
    }

    RasterTarget target_;
    int columns_;
    std::vector<Tile> tiles_;
};

}  // namespace texelscope
