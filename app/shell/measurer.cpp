#include "app/shell/measurer.h"

#include "app/state/derived.h"
#include "app/state/front_key.h"

namespace texelscope {

bool Measurer::is_current(const State& state) const {
    if (document_ != state.document || !same_scene(work_, state.work)) return false;
    if (state.measure.what == Measure::What::front) return front_ != nullptr;
    return skip_run_ != nullptr && skips_ == state.look.skips;
}

void Measurer::begin(const State& state, const Scene& scene) {
    document_ = state.document, work_ = state.work, skips_ = state.look.skips;
    front_.reset(), skip_run_.reset();
    if (state.measure.what == Measure::What::skips) {
        skip_run_ = std::make_unique<SkipRun>(scene, skips_, clock_);
        return;
    }
    FrontOptions options = default_front();
    options.own.emplace(front_key(scene, state.work), front_scene_of(scene));
    options.rounds = kRounds;
    front_ = std::make_unique<FrontRun>(std::move(options), clock_);
}

std::optional<action::MeasureOn> Measurer::advance(const State& state, const Scene& scene) {
    if (!state.measure.running || !state.document) {
        front_.reset(), skip_run_.reset(), document_.reset();
        return std::nullopt;
    }
    if (!is_current(state)) begin(state, scene);
    Measure found = state.measure;
    const bool over = front_ ? front_->advance(kSlice) : skip_run_->advance(kSlice);
    found.running = !over;
    found.share = front_ ? front_->share() : skip_run_->share();
    found.doing = front_ ? front_->doing() : std::string();
    if (front_ && over) found.front = front_->points();
    if (skip_run_ && !skip_run_->times().empty()) found.skips = skip_run_->times();
    if (over) front_.reset(), skip_run_.reset(), document_.reset();
    return action::MeasureOn{std::move(found)};
}

}  // namespace texelscope
