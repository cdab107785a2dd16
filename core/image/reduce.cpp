#include "core/image/reduce.h"

#include <array>
#include <cstdint>

namespace texelscope {
namespace {

constexpr std::array<unsigned, 4> kWeights{1, 3, 3, 1};

/// The weights of the four samples from 2 * i - 1 on that lie inside [0, size).
std::array<unsigned, 4> weights_at(int i, int size) {
    std::array<unsigned, 4> weights{};
    for (int tap = 0; tap < 4; ++tap) {
        const int sample = 2 * i - 1 + tap;
        if (sample >= 0 && sample < size)
            weights[static_cast<std::size_t>(tap)] = kWeights[static_cast<std::size_t>(tap)];
    }
    return weights;
}

struct Sum {
    unsigned r = 0, g = 0, b = 0, weight = 0;
    void add(Rgb colour, unsigned w) { r += w * colour.r, g += w * colour.g, b += w * colour.b, weight += w; }
    [[nodiscard]] std::uint8_t mean(unsigned channel) const {
        return static_cast<std::uint8_t>((2 * channel + weight) / (2 * weight));
    }
};

}  // namespace

Image reduced_by_2(const Image& image) {
    Image small((image.width() + 1) / 2, (image.height() + 1) / 2);
    for (int y = 0; y < small.height(); ++y) {
        const auto down = weights_at(y, image.height());
        for (int x = 0; x < small.width(); ++x) {
            const auto across = weights_at(x, image.width());
            Sum sum;
            for (int tap = 0; tap < 16; ++tap) {
                const unsigned w = down[static_cast<std::size_t>(tap / 4)] * across[static_cast<std::size_t>(tap % 4)];
                if (w != 0) sum.add(image.at(2 * x - 1 + tap % 4, 2 * y - 1 + tap / 4), w);
            }
            small.at(x, y) = {sum.mean(sum.r), sum.mean(sum.g), sum.mean(sum.b)};
        }
    }
    return small;
}

}  // namespace texelscope
