// Run time against error for every rung: how long a pixel takes, how far u and v are from exact arithmetic, and what is
// thereby beaten in both.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/measure/race.h"
#include "core/measure/rungs.h"

namespace texelscope {

/// One rung in one scene. Errors are against rational arithmetic, times are of drawing alone.
struct FrontPoint {
    std::string scene, rung, label, kind;                 ///< ids but for the label
    std::string numbers;                                  ///< id of the NumberFormat that u and v are computed in
    Integer triangles = 0;                                ///< drawn: a slow rung draws only the scene's first ones
    Integer pixels = 0;                                   ///< that these own, exactly
    double median_ns = 0, min_ns = 0;                     ///< a pixel, of the rounds; 0 where not timed
    Integer missing = 0, extra = 0;                       ///< samples; those written twice are extra
    Integer wrong = 0;                                    ///< owned and written samples with another texel
    Integer checked = 0;                                  ///< samples whose u and v were compared
    double max_error = 0, p99_error = 0, mean_error = 0;  ///< of the greater of |Δu|, |Δv| [texels]; may be infinite
    double bound = std::numeric_limits<double>::quiet_NaN();  ///< published for max_error [texels]; NaN: none
    std::string dominated_by;  ///< id of the fastest rung that is faster and not less exact; empty: on the front
    std::string behind;        ///< the same without `fast`

    [[nodiscard]] double wrong_rate() const {
        return pixels > 0 ? static_cast<double>(wrong) / static_cast<double>(pixels) : 0;
    }
};

/// Fills dominated_by and behind for the points of each scene, from min_ns and max_error.
void mark_dominated(std::span<FrontPoint> points);

struct FrontOptions {
    std::vector<const FrontSceneInfo*> scenes;
    std::optional<std::pair<std::string, FrontScene>> own;  ///< in place of `scenes`: a person's, with its name
    std::vector<const Rung*> rungs;
    int rounds = 5;          ///< that each rung is timed for, in turn with all others; 0 = no times
    std::uint64_t seed = 1;  ///< of the scenes
};
/// All rungs on the first four scenes.
[[nodiscard]] FrontOptions default_front();

/// A front in steps short enough for a window to stay alive. The same options give the same points but for the times.
class FrontRun {
public:
    using Clock = LapRun::Clock;

    explicit FrontRun(FrontOptions options, Clock clock = LapRun::monotonic_seconds);
    FrontRun(FrontRun&&) noexcept;
    FrontRun& operator=(FrontRun&&) = delete;
    ~FrontRun();

    /// One triangle's error, or one rung's drawing. @return whether all is done.
    bool step();
    /// Steps for about `seconds`.
    bool advance(double seconds);

    /// As far as it is known: scene by scene, rungs in order. A scene's points appear once its errors are known, their
    /// times once all rounds are over.
    [[nodiscard]] const std::vector<FrontPoint>& points() const { return points_; }
    [[nodiscard]] double share() const;       ///< of all steps [0, 1]
    [[nodiscard]] std::string doing() const;  ///< "near: float in tiles", for a person to see

private:
    class Reference;
    struct Tally;
    enum class Phase : std::uint8_t { reference, errors, times, over };

    [[nodiscard]] std::size_t scene_count() const { return options_.own ? 1 : options_.scenes.size(); }
    [[nodiscard]] std::string_view scene_id() const;
    [[nodiscard]] const Rung& rung() const { return *options_.rungs[rung_]; }
    void begin_scene();
    void measure_triangle();
    void time_rung();
    void end_scene();

    FrontOptions options_;
    Clock clock_;
    std::vector<FrontPoint> points_;
    std::unique_ptr<RungStage> stage_;
    std::unique_ptr<Reference> reference_;
    std::unique_ptr<Tally> tally_;
    Phase phase_ = Phase::reference;
    std::size_t scene_ = 0, rung_ = 0, triangle_ = 0, first_point_ = 0;
    int round_ = 0;                           ///< 0 warms up and is not counted
    std::vector<int> repeats_;                ///< of a rung's drawing in a round, so that the clock can tell
    std::vector<std::vector<double>> times_;  ///< [ns a pixel], of a rung's rounds
    std::size_t done_ = 0, of_ = 1;           ///< steps of this scene
};

/// One line a point after a line of names.
[[nodiscard]] std::string print_front(std::span<const FrontPoint> points);
/// Fails where a line is not one that print_front writes.
[[nodiscard]] Result<std::vector<FrontPoint>> parse_front(std::string_view csv, const std::string& name);

}  // namespace texelscope
