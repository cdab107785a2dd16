// The few numbers of a TrueType or OpenType file that say how large its letters are.
#pragma once

#include <span>

#include "core/base/result.h"

namespace texelscope::ui {

/// All in em (1 = the nominal size).
struct FontMetrics {
    float ascent = 0, descent = 0;  ///< of the line, both positive; ImGui scales a font so that their sum is its "size"
    float cap = 0, x_height = 0;
};

/// Fails where the bytes are no font with the tables head, hhea and cmap inside the file.
[[nodiscard]] Result<FontMetrics> read_font_metrics(std::span<const unsigned char> file);

}  // namespace texelscope::ui
