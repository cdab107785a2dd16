// Threads, behind one file: a target is cut into bands of rows, one for each.
#pragma once

#include <functional>

namespace texelscope {

/// Calls draw(first row, last row) for `bands` bands of [0, height), as many at once as the machine has
/// cores. Bands begin at multiples of 16 rows.
void for_each_band(int bands, int height, const std::function<void(int band, int first, int last)>& draw);

}  // namespace texelscope
