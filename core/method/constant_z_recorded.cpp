#include "core/method/constant_z_quirks.h"
#include "core/method/run.h"

namespace texelscope {

Visit visit_constant_z(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<ConstantZ, kConstantZFields>(format, job, path);
}

}  // namespace texelscope
