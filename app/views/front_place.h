// The prediction `error-place` in the plot of the front: three bands of error, one of which is to be clicked, while the
// point that is asked about is hidden.
#pragma once

#include <array>
#include <span>
#include <string>

#include "app/views/view.h"
#include "core/measure/front.h"

namespace texelscope {

class FrontPlace {
public:
    explicit FrontPlace(const State& state);

    /// The rung that is asked about, while the answer is open; else empty.
    [[nodiscard]] const std::string& secret() const { return secret_; }
    /// Over a plot that was drawn in `area` with `points`: the bands as controls. Nothing where nothing is asked.
    void draw(const ViewContext& context, const ui::Area& area, std::span<const FrontPoint> points) const;

private:
    std::string secret_;
    std::array<std::string, 2> beside_;  ///< the two rungs between, above or below which it lies
    int chosen_ = -1;
};

}  // namespace texelscope
