// The axes of a panel of the front's picture: both logarithmic, with a shelf for no error at all below.
#pragma once

#include <span>
#include <vector>

#include "app/ui/ui.h"
#include "core/measure/front.h"

namespace texelscope::front {

/// A logarithmic scale from `low` to `high` over [from, to] on the screen; what lies beyond is at the end.
struct Scale {
    double low = 1, high = 10;
    float from = 0, to = 1;

    [[nodiscard]] float at(double value) const;
};

class Axes {
public:
    /// Leaves room inside `area` for the ticks and what they count.
    Axes(ui::Ui& ui, const ui::Area& area, std::span<const FrontPoint* const> points);

    [[nodiscard]] const ui::Area& plot() const { return plot_; }
    [[nodiscard]] glm::vec2 place_of(const FrontPoint& point) const;
    /// Of an error: 0 stands on its shelf, infinite ones on theirs.
    [[nodiscard]] float height_of(double error) const;
    void draw() const;

private:
    [[nodiscard]] float unit() const { return ui_.fonts().spec().scale; }
    void draw_times() const;
    void draw_errors() const;
    void power(float right, float middle, int exponent) const;
    void shelf(const ui::Area& area, ui::Role role, std::string_view name, std::span<const float> marks) const;

    ui::Ui& ui_;
    ui::Area area_, plot_;
    Scale time_, error_;
    float line_ = 0;                                  ///< from one line of text to the next
    float shelf_ = 0;                                 ///< how high the place of no error is
    bool endless_ = false;                            ///< some error is infinite
    std::vector<float> exact_marks_, endless_marks_;  ///< where the marks of both shelves are, from left to right
};

}  // namespace texelscope::front
