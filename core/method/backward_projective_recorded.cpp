#include "core/method/backward_projective_quirks.h"
#include "core/method/run.h"

namespace texelscope {

Visit visit_backward_projective(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<BackwardProjective, kBackwardProjectiveFields>(format, job, path);
}

}  // namespace texelscope
