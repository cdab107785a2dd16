// What the marks of the front's picture mean.
#pragma once

#include <span>

#include "app/ui/ui.h"
#include "core/measure/front.h"

namespace texelscope::front {

void draw_key(ui::Ui& ui, const ui::Area& area, std::span<const FrontPoint> points);

}  // namespace texelscope::front
