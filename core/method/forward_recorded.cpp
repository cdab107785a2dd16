#include "core/method/forward_quirks.h"
#include "core/method/run.h"

namespace texelscope {

Visit visit_forward(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<Forward, kForwardFields>(format, job, path);
}

}  // namespace texelscope
