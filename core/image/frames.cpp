#include "core/image/frames.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace texelscope {

Result<std::vector<Image>> cut_frames(const Image& strip, int count) {
    const int width = strip.width(), height = strip.height();
    const bool below = height % count == 0, beside = width % count == 0;
    if (!below && !beside)
        return Error{"", "is " + std::to_string(width) + " x " + std::to_string(height) + ", expected a side of " +
                             std::to_string(count) + " equal frames"};
    const auto is_nearer_to_square = [](double w1, double h1, double w2, double h2) {
        return std::max(w1 / h1, h1 / w1) < std::max(w2 / h2, h2 / w2);
    };
    const bool sideways = beside && (!below || is_nearer_to_square(static_cast<double>(width) / count, height, width,
                                                                   static_cast<double>(height) / count));
    const int columns = sideways ? width / count : width, rows = sideways ? height : height / count;
    std::vector<Image> frames;
    for (int n = 0; n < count; ++n) {
        Image frame(columns, rows);
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x)
                frame.at(x, y) = sideways ? strip.at(n * columns + x, y) : strip.at(x, n * rows + y);
        frames.push_back(std::move(frame));
    }
    return frames;
}

}  // namespace texelscope
