#include "core/method/backward_affine_quirks.h"
#include "core/method/run.h"

namespace texelscope {

Visit visit_backward_affine(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<BackwardAffine, kBackwardAffineFields>(format, job, path);
}

}  // namespace texelscope
