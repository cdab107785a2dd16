#include "core/method/edge_walk_quirks.h"
#include "core/method/run.h"

namespace texelscope {

Visit visit_edge_walk(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<EdgeWalk, kEdgeWalkFields>(format, job, path);
}

}  // namespace texelscope
