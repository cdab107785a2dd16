// Runs the race that a state asks for, a slice in each frame.
#pragma once

#include <memory>
#include <optional>

#include "app/state/action.h"
#include "core/scene/scene.h"

namespace texelscope {

class Racer {
public:
    explicit Racer(LapRun::Clock clock = LapRun::monotonic_seconds) : clock_(std::move(clock)) {}

    /// Goes on with the lap under way; lets go of it where no race runs. Takes up to kSlice, or one shape's drawing.
    /// @return the lap, once it is over.
    [[nodiscard]] std::optional<action::FinishLap> advance(const State& state, const Scene& scene);

    static constexpr double kSlice = 0.05;  ///< [s]
    static constexpr double kLap = 0.2;     ///< what a lap's drawing may take, or one round where that is longer [s]

private:
    LapRun::Clock clock_;
    std::unique_ptr<LapRun> lap_;
    std::size_t number_ = 0;  ///< of the lap, among racers()
};

}  // namespace texelscope
