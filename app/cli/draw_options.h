// The options that every drawing subcommand has in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/method/drawing.h"

namespace CLI {
class App;
}

namespace texelscope {

/// As typed; `draw_settings` says what it means.
struct DrawOptions {
    std::string method = "edge-equations", variant = "corrected", number = "f64", overflow = "mark";
    std::vector<std::string> quirks, skips;  ///< "ID=on", "NAME=off"
    std::string target;                      ///< instruction set of the method `fast`; empty: the best there is
    std::optional<int> snap;                 ///< x, y to multiples of 2^-snap first [bits]
    bool floor_products = false;
    int threads = 0;  ///< 0: as many as the machine has
};

void add_draw_options(CLI::App& app, DrawOptions& options);

/// Fails with what was wrong and what there is instead.
Result<DrawSettings> draw_settings(const DrawOptions& options);

/// Rounds x and y of all corners where that was asked for.
void snap_scene(Scene& scene, const DrawOptions& options);

}  // namespace texelscope
