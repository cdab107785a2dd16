// How long each method takes for one scene, and how much of it is set-up: what S3's demonstration counted.
#pragma once

#include <functional>
#include <memory>

#include "core/method/drawing.h"

namespace texelscope {

/// One method's run.
struct Lap {
    const Method* method = nullptr;
    Integer triangles = 0;  ///< shapes drawn; polygons for a method that takes them whole
    Integer pixels = 0;     ///< samples written, those written again counted again
    double seconds = 0;     ///< for the whole scene: the least of the rounds
    double set_up = 0;      ///< of these, what the same shapes take when no pixel of them is on the screen [s]
};

/// A lap in slices, so that a window stays alive while it runs. First the pixels are counted, then the scene is drawn
/// as often as fits into the lap's time, at least once, then its set-up is. The fastest round counts; a pause between
/// two slices belongs to no round. Timings differ from run to run: show them, never decide by them.
class LapRun {
public:
    using Clock = std::function<double()>;  ///< [s], from any moment on

    /// @param seconds  for drawing; set-up gets a quarter of it.
    LapRun(Scene scene, const DrawSettings& settings, double seconds, Clock clock = monotonic_seconds);
    /// Goes on for about `seconds`; a shape that is begun is finished. @return whether the lap is over.
    bool advance(double seconds);
    [[nodiscard]] const Lap& lap() const { return lap_; }

    [[nodiscard]] static double monotonic_seconds();

private:
    enum class Phase { counting, drawing, set_up, over };
    void do_shape(int n);
    void end_round();

    std::unique_ptr<const Scene> scene_;
    Drawing drawing_;
    Clock clock_;
    double seconds_;
    Lap lap_;
    Image picture_, dot_;
    Phase phase_ = Phase::counting;
    int next_ = 0;      ///< shape of the round
    int batch_ = 1;     ///< shapes between two looks at the clock
    double round_ = 0;  ///< of the round under way [s]
    double spent_ = 0;  ///< on all rounds of the phase [s]
    double best_ = -1;  ///< of the phase's rounds [s]; negative before the first has ended
};

/// The whole lap at once.
[[nodiscard]] Lap lap(const Scene& scene, const DrawSettings& settings, double seconds);

}  // namespace texelscope
