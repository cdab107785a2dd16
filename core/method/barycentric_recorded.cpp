#include "core/method/barycentric_quirks.h"
#include "core/method/run.h"

namespace texelscope {

Visit visit_barycentric(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<Barycentric, kBarycentricFields>(format, job, path);
}

}  // namespace texelscope
