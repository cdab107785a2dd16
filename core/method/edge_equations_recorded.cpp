#include "core/method/edge_equations_quirks.h"
#include "core/method/run.h"

namespace texelscope {

Visit visit_edge_equations(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<EdgeEquations, kEdgeEquationsFields>(format, job, path);
}

}  // namespace texelscope
