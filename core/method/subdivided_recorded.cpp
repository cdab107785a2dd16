#include "core/method/run.h"
#include "core/method/subdivided_quirks.h"

namespace texelscope {

Visit visit_subdivided(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<Subdivided, kSubdividedFields>(format, job, path);
}

}  // namespace texelscope
