// Which triangle is the last to cover a tile whole: what earlier ones draw there, nobody sees.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/fast/raster.h"

namespace texelscope {

/// Of each tile, the last triangle known to cover it.
class LastCovers {
public:
    // Narrower ones leave out more, and what is left is in more pieces: measured.
    static constexpr int kWidthBits = 3, kWidth = 1 << kWidthBits;     ///< of a tile [px]
    static constexpr int kHeightBits = 4, kHeight = 1 << kHeightBits;  ///< of a tile [px]
    static constexpr int kMost = 64;                                   ///< tiles that are looked at together
    static constexpr int kVector = 16;                                 ///< numbers that are read at once, at most

    explicit LastCovers(const RasterTarget& target)
        : pitch_(((target.width + kWidth - 1) >> kWidthBits) + kVector),
          last_(at((target.height + kHeight - 1) >> kHeightBits, 0), -1) {}

    /// Triangle `index`, which is drawn after all noted so far, covers tiles [first, end) of a row of them.
    void note(int row, int first, int end, std::int32_t index) {
        std::int32_t* const tiles = last_.data() + at(row, 0);
        std::fill(tiles + first, tiles + end, index);
    }
    [[nodiscard]] const std::int32_t* from(int row, int column) const { return last_.data() + at(row, column); }

private:
    [[nodiscard]] std::size_t at(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(pitch_) + static_cast<std::size_t>(column);
    }

    int pitch_;
    std::vector<std::int32_t> last_;
};

}  // namespace texelscope
