#include "core/measure/timing.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/assert.h"

namespace texelscope {

double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n == 0 ? 0 : (values[(n - 1) / 2] + values[n / 2]) / 2;
}

Timing timing_of(std::vector<double> milliseconds) {
    TEXELSCOPE_ASSERT(!milliseconds.empty());
    const double least = *std::min_element(milliseconds.begin(), milliseconds.end());
    return {.median_ms = median_of(std::move(milliseconds)), .least_ms = least};
}

std::string timing_line(const TimedWork& work, const Timing& timing) {
    const auto millions_a_second = [&](std::uint64_t count) {
        return timing.median_ms > 0 ? static_cast<double>(count) / timing.median_ms / 1e3 : 0.0;
    };
    return fmt::format("{},t{},{},{:.4f},{:.4f},{:.2f},{:.3f}", work.method, work.threads, work.name, timing.median_ms,
                       timing.least_ms, millions_a_second(work.samples), millions_a_second(work.triangles));
}

}  // namespace texelscope
