// What can be wrong with one beat, seen from where the lesson has come to it.
#pragma once

#include <string>
#include <vector>

#include "app/state/store.h"

namespace texelscope {

struct BeatFault {
    int line = 0;  ///< of the lesson file
    std::string what;
};

/// Of the beat that the store stands on: its step and level, what it pins, its prediction.
[[nodiscard]] std::vector<BeatFault> beat_faults(Store& store);

/// Why a lesson of this method cannot show the view; empty where it can.
[[nodiscard]] std::string view_fault(std::string_view view, const Method& method);
/// Why it cannot in this scene; empty where it can.
[[nodiscard]] std::string view_fault(std::string_view view, const Scene& scene);

}  // namespace texelscope
