#include "core/fast/bands.h"

#include <algorithm>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace texelscope {

void run_stages(int threads, std::initializer_list<Stage> stages) {
    tbb::task_arena(std::min(threads, tbb::this_task_arena::max_concurrency())).execute([&] {
        for (const Stage& stage : stages) tbb::parallel_for(0, stage.parts, stage.work, tbb::simple_partitioner());
    });
}

}  // namespace texelscope
