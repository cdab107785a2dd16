#include "core/measure/race.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace texelscope {
namespace {

// One pixel, far from everything: shapes are set up and then found to lie elsewhere.
constexpr int kElsewhere = -(1 << 20);
constexpr Rect kNowhere{kElsewhere, kElsewhere, kElsewhere + 1, kElsewhere + 1};
constexpr double kSetUpShare = 0.25;  ///< of the lap's time
constexpr double kGlance = 0.001;     ///< between two looks at the clock, where shapes are small [s]
constexpr int kMostBatch = 4096;

}  // namespace

double LapRun::monotonic_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

LapRun::LapRun(Scene scene, const DrawSettings& settings, double seconds, Clock clock)
    : scene_(std::make_unique<const Scene>(std::move(scene))),
      drawing_(*scene_, settings),
      clock_(std::move(clock)),
      seconds_(seconds),
      picture_(scene_->framebuffer.width, scene_->framebuffer.height, scene_->framebuffer.clear),
      dot_(1, 1) {
    lap_.method = settings.method;
    lap_.triangles = drawing_.shape_count();
}

void LapRun::do_shape(int n) {
    if (drawing_.refusal(n) != Fate::written) return;
    const Rect frame = scene_->framebuffer.rect();
    if (phase_ == Phase::counting) {
        each_sample(drawing_, n, n + 1, {frame, 1},
                    [&](int, const Sample& s) { lap_.pixels += s.fate == Fate::written; });
        return;
    }
    Job job = drawing_.job(n);
    job.frame = phase_ == Phase::drawing ? frame : kNowhere;
    const DrawSettings& settings = drawing_.settings();
    (void)settings.method->render(settings.format, job, phase_ == Phase::drawing ? picture_ : dot_);
}

void LapRun::end_round() {
    spent_ += round_;
    best_ = best_ < 0 ? round_ : std::min(best_, round_);
    next_ = 0, round_ = 0;
    const double wanted = phase_ == Phase::counting ? 0 : phase_ == Phase::drawing ? seconds_ : seconds_ * kSetUpShare;
    if (spent_ < wanted) return;
    if (phase_ == Phase::drawing) lap_.seconds = best_;
    if (phase_ == Phase::set_up) lap_.set_up = std::min(lap_.seconds, best_);
    phase_ = static_cast<Phase>(static_cast<int>(phase_) + 1);
    spent_ = 0, best_ = -1;
}

bool LapRun::advance(double seconds) {
    const double begin = clock_();
    for (double last = begin; phase_ != Phase::over && last - begin <= seconds;) {
        const int end = std::min(drawing_.shape_count(), next_ + batch_);
        for (; next_ < end; ++next_) do_shape(next_);
        const double now = clock_();
        round_ += now - last;
        if (now - last < kGlance)
            batch_ = std::min(2 * batch_, kMostBatch);
        else
            batch_ = std::max(1, batch_ / 2);
        last = now;
        if (next_ == drawing_.shape_count()) end_round();
    }
    return phase_ == Phase::over;
}

Lap lap(const Scene& scene, const DrawSettings& settings, double seconds) {
    LapRun run(scene, settings, seconds);
    (void)run.advance(std::numeric_limits<double>::infinity());
    return run.lap();
}

}  // namespace texelscope
