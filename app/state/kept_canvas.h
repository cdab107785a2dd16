// The canvas around one shape, kept from one drawing to the next: only what changed is drawn again.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/state/derived.h"
#include "core/method/layer.h"

namespace texelscope {

class KeptCanvas {
public:
    /// Takes over that the drawing is another one: what they have in common stays.
    void change(const Drawing& from, const Drawing& to);
    void forget() { whole_.reset(); }

    /// The canvas before the first sample of a shape (-1: of a scene without one), and which samples it will visit.
    [[nodiscard]] const CanvasPicture& before(const Drawing& drawing, int shape, const Window& window);
    /// What stands in between: begin_step() makes it equal to what before() gave last, cell by cell it goes on.
    void begin_step();
    [[nodiscard]] CanvasCell& step_in(const Sample& s);
    void finish_step(std::uint64_t version) { step_.version = version; }
    [[nodiscard]] const CanvasPicture& step() const { return step_; }

    /// Cells drawn so far, in all: each drawing of a cell counts once, whatever lies in it.
    [[nodiscard]] std::int64_t cells_drawn() const { return cells_drawn_; }

private:
    void draw(const Drawing& drawing, const Rect& pixels);

    int shape_ = -1;
    std::optional<Layer> whole_;  ///< the end of the drawing, over the window; empty: everything is to be drawn
    std::vector<Rect> changed_;   ///< pixels to be drawn again
    CanvasPicture before_, step_;
    std::vector<Rect> stale_;  ///< cells in which step_ is not what before_ is
    Rect stepped_;             ///< the same, of the step
    std::int64_t cells_drawn_ = 0;
};

}  // namespace texelscope
