#include "core/method/run.h"
#include "core/method/two_pass_quirks.h"

namespace texelscope {

Visit visit_two_pass(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<TwoPass, kTwoPassFields>(format, job, path);
}

}  // namespace texelscope
