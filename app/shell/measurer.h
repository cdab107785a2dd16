// Runs the measuring that a state asks for, a slice in each frame.
#pragma once

#include <memory>
#include <optional>

#include "app/state/action.h"
#include "core/scene/scene.h"

namespace texelscope {

class Measurer {
public:
    explicit Measurer(LapRun::Clock clock = LapRun::monotonic_seconds) : clock_(std::move(clock)) {}

    /// Goes on for a slice; begins anew where the scene is another, lets go where nothing is measured. What was found
    /// before stays in the state until there is something better.
    /// @return how far it is, and in the end what was found.
    [[nodiscard]] std::optional<action::MeasureOn> advance(const State& state, const Scene& scene);

    static constexpr double kSlice = 0.03;  ///< [s]; one drawing or one triangle's error may take longer
    static constexpr int kRounds = 5;       ///< that each rung is timed for

private:
    [[nodiscard]] bool is_current(const State& state) const;
    void begin(const State& state, const Scene& scene);

    LapRun::Clock clock_;
    std::shared_ptr<const Document> document_;  ///< what is being measured
    Work work_;
    std::uint32_t skips_ = 0;
    std::unique_ptr<FrontRun> front_;
    std::unique_ptr<SkipRun> skip_run_;
};

}  // namespace texelscope
