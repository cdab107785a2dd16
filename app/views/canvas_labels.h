// Finds room for plates on the canvas: none lies over another, and none leaves the panel.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/ui/geometry.h"

namespace texelscope::canvas {

class LabelPlaces {
public:
    explicit LabelPlaces(const ui::Area& bounds) : bounds_(bounds) {}

    /// Nothing is placed over `area` from now on.
    void block(const ui::Area& area) { taken_.push_back(area); }
    [[nodiscard]] bool is_free(const ui::Area& area) const;

    /// A free place of `size` at least `gap` from `anchor`: in the direction `away` where there is room, else turned
    /// from it as little as needed, else further off. It is taken from then on. Nothing where all is full.
    /// @param suits  what else a place must fulfil; empty for nothing.
    std::optional<ui::Area> place(glm::vec2 anchor, glm::vec2 size, glm::vec2 away, float gap,
                                  const std::function<bool(const ui::Area&)>& suits = {});

private:
    ui::Area bounds_;
    std::vector<ui::Area> taken_;
};

}  // namespace texelscope::canvas
