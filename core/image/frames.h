// A strip of pictures, as the pictures of a moving texture come in one file.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"

namespace texelscope {

/// The strip cut into `count` equal pictures that lie one below the other or side by side: whichever way gives whole
/// pixels and, of two such ways, the pictures nearer to squares (of two equally near, one below the other). Fails if
/// neither side can be divided by `count`. Requires count >= 1 and a strip that is not empty.
Result<std::vector<Image>> cut_frames(const Image& strip, int count);

}  // namespace texelscope
