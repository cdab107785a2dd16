// Laws that hold for the running application whatever was done to it.
#pragma once

#include <string>

#include "app/shell/headless.h"

namespace texelscope {

/// The first law that the application breaks now, in words; empty where all hold. Leaves the application unchanged,
/// but for the focus after the Escape law.
[[nodiscard]] std::string broken_law(Headless& app);

}  // namespace texelscope
