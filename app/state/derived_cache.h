// What Derived keeps, by what it depends on; and the larger computations, a file each.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/state/derived.h"
#include "app/state/kept_canvas.h"
#include "app/state/lockstep.h"
#include "core/method/two_pass_buffer.h"

namespace texelscope {

struct Derived::Cache {
    State state;
    std::unique_ptr<Scene> scene;
    std::vector<PlacedFace> faces;
    /// Of a mesh of the scene, made when first asked for.
    struct Jelly {
        int mesh = -1;
        JellyCubes cubes;
    };
    std::optional<Jelly> jelly;
    std::optional<std::vector<Bill>> bills;                    ///< of the scene, whatever draws it
    std::optional<std::pair<std::string, RungPicture>> rung;   ///< of which rung
    std::optional<std::pair<std::uint32_t, SkipCount>> skips;  ///< with which skips
    std::unique_ptr<Drawing> drawing;
    std::unique_ptr<Steps> steps;
    Listing listing;

    /// Holds as long as the drawing does.
    struct OfDrawing {
        std::optional<Image> final_picture;
        double frame_time = 0;  ///< that it took [ms]
        std::optional<std::vector<Notice>> notices;
        struct Hits {
            Window window;
            Grid<std::uint8_t> count;
        };
        std::optional<Hits> hits;
        std::optional<ErrorMap> errors;
        std::optional<std::pair<int, Decisions>> decisions;  ///< of which shape
        std::optional<Difference> difference;
        std::optional<std::pair<const Texture*, PaletteUse>> palette;    ///< of which texture
        std::map<std::pair<int, Integer>, std::vector<TickKind>> rows;   ///< of a shape's stage
        std::optional<std::pair<int, std::vector<WalkedRow>>> walked;    ///< of a shape
        std::optional<std::pair<int, std::optional<ShapeError>>> error;  ///< of a shape
        std::optional<std::pair<int, TwoPassBuffer>> buffer;             ///< of which shape
    };
    /// Holds as long as the cursor stays.
    struct OfStep {
        std::shared_ptr<Visit> visit;
        std::optional<std::vector<Variable>> variables;
        std::optional<LineCounts> counts;
        std::optional<std::vector<Sample>> row;
        std::optional<RowError> row_error;
        bool canvas = false;  ///< the canvas is as the step has it
        std::optional<std::vector<Lane>> lanes;
        std::optional<std::vector<MethodCost>> costs;
        std::optional<Lockstep> lockstep;
    };
    OfDrawing of_drawing;
    OfStep of_step;
    KeptCanvas canvas;
    Window in_view;  ///< what the canvas was last asked for
    std::uint64_t version = 0;
};

/// The last of the tape's names that has its value at `step`, which lies in the visit's unit; -1 where there is none.
/// A unit's run goes on to the end of the shape: what comes after the unit is not known yet.
[[nodiscard]] std::int32_t last_known(const Visit& visit, const Path& step);
[[nodiscard]] std::vector<Variable> make_variables(const Visit& visit, const Named* now, const Cursor& cursor,
                                                   Steps& steps);

}  // namespace texelscope
