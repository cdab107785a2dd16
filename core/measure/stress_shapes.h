// What both halves of stress do with a family's shapes. For them alone.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/image/image.h"
#include "core/measure/reference.h"
#include "core/measure/stress.h"

namespace texelscope {

using Samples = std::vector<DecidedSample>;

[[nodiscard]] inline std::span<const Vertex, 3> triangle_of(const HardShape& shape, std::size_t n) {
    return std::span<const Vertex, 3>(&shape.vertices[3 * n], 3);
}
[[nodiscard]] inline std::size_t triangles_of(const HardShape& shape) { return shape.vertices.size() / 3; }

[[nodiscard]] inline bool is_drawable(std::span<const Vertex> corners) {
    return std::all_of(corners.begin(), corners.end(), [](const Vertex& v) { return is_drawable(v); });
}

[[nodiscard]] inline HardShape shape_at(const Family& family, StressMode mode, std::uint64_t seed, int n) {
    return in_mode(family.make(seed_of(seed, family, n)), mode);
}

/// How often each sample of a closed shape's frame was drawn.
class Coverage {
public:
    explicit Coverage(const HardShape& shape)
        : closed_(shape.closed),
          frame_(shape.frame),
          counts_(closed_ ? frame_.width() : 0, closed_ ? frame_.height() : 0) {}
    void add(Integer x, Integer y) {
        if (closed_) ++counts_.at(static_cast<int>(x) - frame_.x0, static_cast<int>(y) - frame_.y0);
    }
    void finish(StressRow& row) const {
        if (!closed_) return;
        bool leaky = false;
        for (const int* n = counts_.data(); n != counts_.data() + counts_.size(); ++n)
            row.twice += std::max(0, *n - 1), leaky = leaky || *n != 1;
        ++row.meshes, row.leaky += leaky ? 1 : 0;
    }

private:
    bool closed_;
    Rect frame_;
    Grid<int> counts_;
};

}  // namespace texelscope
