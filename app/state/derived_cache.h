// What Derived keeps, by what it depends on; and the larger computations, a file each.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/state/derived.h"

namespace texelscope {

struct Derived::Cache {
    State state;
    std::unique_ptr<Scene> scene;
    std::unique_ptr<Drawing> drawing;
    std::unique_ptr<Steps> steps;
    Listing listing;

    /// Holds as long as the drawing does.
    struct OfDrawing {
        std::optional<Image> final_picture;
        std::optional<std::vector<Notice>> notices;
        std::optional<CanvasPicture> whole;  ///< the end of the drawing, over the canvas' window
        std::map<std::pair<int, Integer>, std::vector<TickKind>> rows;  ///< of a shape's stage
    };
    /// Holds as long as the cursor stays.
    struct OfStep {
        std::shared_ptr<Visit> visit;
        std::optional<std::vector<Variable>> variables;
        std::optional<LineCounts> counts;
        std::optional<std::vector<Sample>> row;
        std::optional<CanvasPicture> canvas;
        std::optional<std::vector<Lane>> lanes;
    };
    OfDrawing of_drawing;
    OfStep of_step;
    std::uint64_t version = 0;
};

[[nodiscard]] std::vector<Variable> make_variables(const Visit& visit, const Named* now, const Cursor& cursor,
                                                   Steps& steps);

}  // namespace texelscope
