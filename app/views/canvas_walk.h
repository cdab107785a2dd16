// Rows that are walked along a shape's sides: which of them have been drawn, and which are drawn a second time.
#pragma once

#include <span>

#include "app/views/view.h"

namespace texelscope::canvas {

/// The current shape's rows up to the cursor's; all where its step has passed them. The last is the current one.
[[nodiscard]] std::span<const WalkedRow> rows_so_far(const ViewContext& ctx);
/// Whether an earlier part of the shape has drawn the same row.
[[nodiscard]] bool drawn_before(std::span<const WalkedRow> rows, std::size_t n);

}  // namespace texelscope::canvas
