// Buttons that choose the run with which the view `difference` compares: its method, variant and number format.
#pragma once

#include "app/state/state.h"
#include "app/views/view.h"

namespace texelscope::canvas {

class RunChoice {
public:
    /// @param width  of its place [px]: where it is small there are two lines.
    RunChoice(const ViewContext& context, float width);

    [[nodiscard]] float height() const { return line_ * (one_line_ ? 1.0F : 2.0F); }
    void draw(const ui::Area& bar) const;

private:
    void draw_method(const ui::Area& bar, const ComparedRun& now, ComparedRun& next) const;
    void draw_variant_and_number(const ui::Area& bar, const ComparedRun& now, ComparedRun& next) const;

    const ViewContext& ctx_;
    ui::Ui& ui_;
    float line_, side_;               ///< height of a line, size of a button [px]
    float variant_ = 0, number_ = 0;  ///< as wide as any of their labels, so that buttons stay where they are [px]
    bool one_line_ = true;
};

}  // namespace texelscope::canvas
