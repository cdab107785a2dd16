#include "core/fast/bands.h"

#include <algorithm>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace texelscope {

void for_each_band(int bands, int height, const std::function<void(int band, int first, int last)>& draw) {
    constexpr int kRows = 16;
    const int all = (height + kRows - 1) / kRows;
    const auto row = [&](int band) { return std::min(height, band * all / bands * kRows); };
    tbb::task_arena(std::min(bands, tbb::this_task_arena::max_concurrency())).execute([&] {
        tbb::parallel_for(
            0, bands,
            [&](int band) {
                if (row(band) < row(band + 1)) draw(band, row(band), row(band + 1));
            },
            tbb::static_partitioner());
    });
}

}  // namespace texelscope
