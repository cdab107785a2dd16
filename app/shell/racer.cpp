#include "app/shell/racer.h"

#include "core/measure/bill.h"

namespace texelscope {

std::optional<action::FinishLap> Racer::advance(const State& state, const Scene& scene) {
    const std::vector<const Method*> methods = racers();
    const std::size_t number = state.race.laps.size();
    if (!state.race.running || number >= methods.size()) return lap_.reset(), std::nullopt;
    if (!lap_ || number_ != number) {
        const Method* method = methods[number];
        const DrawSettings settings{method, state.work.format, method->variants.back().quirks, state.work.mode};
        lap_ = std::make_unique<LapRun>(scene, settings, kLap, clock_);
        number_ = number;
    }
    if (!lap_->advance(kSlice)) return std::nullopt;
    const action::FinishLap done{lap_->lap(), number + 1 == methods.size()};
    lap_.reset();
    return done;
}

}  // namespace texelscope
