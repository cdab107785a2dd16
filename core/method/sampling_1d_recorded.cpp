#include "core/method/run.h"
#include "core/method/sampling_1d_quirks.h"

namespace texelscope {

Visit visit_sampling_1d(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<Sampling1d, kSampling1dFields>(format, job, path);
}

}  // namespace texelscope
