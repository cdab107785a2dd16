// The front as a picture: for each scene time against error, both on logarithmic scales, with the published bounds and
// what is beaten in both. The command line draws it into a PNG, a view into its panel.
#pragma once

#include <span>
#include <string_view>

#include "app/ui/ui.h"
#include "core/measure/front.h"

namespace texelscope {

/// A panel a scene, in the order in which they first appear, and a key at the right where there is room for it.
/// @param chosen  id of a rung that is ringed in every panel; empty for none.
/// @return        the point under the mouse, among `points`; null where there is none.
const FrontPoint* draw_front_plot(ui::Ui& ui, const ui::Area& area, std::span<const FrontPoint> points,
                                  std::string_view chosen = {});

/// What stands at the point: the label of a rung of the ladder, or two letters for a method, as the key has them.
[[nodiscard]] std::string front_mark(const FrontPoint& point);

/// "0", "2.9e-08", "0.0147", "5.6": as few digits as tell errors apart [texels].
[[nodiscard]] std::string front_number(double value);

}  // namespace texelscope
