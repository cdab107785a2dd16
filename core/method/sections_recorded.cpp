#include "core/method/run.h"
#include "core/method/sections_quirks.h"

namespace texelscope {

Visit visit_sections(NumberFormat format, const Job& job, const Path& path) {
    return run::visit<Sections, kSectionsFields>(format, job, path);
}

}  // namespace texelscope
