#include "core/measure/timing.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/assert.h"

namespace texelscope {

Timing timing_of(std::vector<double> milliseconds) {
    TEXELSCOPE_ASSERT(!milliseconds.empty());
    std::sort(milliseconds.begin(), milliseconds.end());
    const std::size_t middle = milliseconds.size() / 2;
    const double below = milliseconds[milliseconds.size() % 2 == 0 ? middle - 1 : middle];
    return {.median_ms = (below + milliseconds[middle]) / 2, .least_ms = milliseconds.front()};
}

std::string timing_line(const TimedWork& work, const Timing& timing) {
    const auto millions_a_second = [&](std::uint64_t count) {
        return timing.median_ms > 0 ? static_cast<double>(count) / timing.median_ms / 1e3 : 0.0;
    };
    return fmt::format("{},t{},{},{:.4f},{:.4f},{:.2f},{:.3f}", work.method, work.threads, work.name, timing.median_ms,
                       timing.least_ms, millions_a_second(work.samples), millions_a_second(work.triangles));
}

}  // namespace texelscope
