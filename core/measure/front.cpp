#include "core/measure/front.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/exact/triangle.h"
#include "core/measure/timing.h"
#include "core/method/barycentric.h"

namespace texelscope {
namespace {

constexpr std::size_t kScenes = 4;  ///< of default_front
constexpr int kChecked = 12;        ///< samples of a triangle whose u and v are compared
constexpr double kRound = 0.001;    ///< that a rung's drawing takes at least in a round [s]
constexpr int kMostRepeats = 256;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// u or v of one sample, without any rounding.
struct Place {
    Exact u, v;
};

[[nodiscard]] double size_of(const Exact& difference) { return std::abs(approximate(difference)); }

/// |given - exact|. `rational`: the rung's own number was rounded to `given` only to be handed over.
[[nodiscard]] double error_of(double given, const Exact& exact, bool rational) {
    if (!std::isfinite(given)) return kInfinite;
    if (rational && given == approximate(exact)) return 0;
    return size_of(Exact::from(given) - exact);
}

/// How far a place lies from the texel that was chosen, in the nearest of its repeats.
[[nodiscard]] double distance(const Exact& place, int texel) {
    if (wrap_index(floor(place), kFrontTexture, Wrap::repeat) == texel) return 0;
    const double size = kFrontTexture, u = approximate(place);
    const double above = u - texel - size * std::floor((u - texel) / size);  // [0, size): beyond its first side
    return std::min(above - 1, size - above);
}

}  // namespace

/// What exact arithmetic says of a scene: the owner and texel of every sample, and u and v of some.
class FrontRun::Reference {
public:
    struct Triangle {
        Rect box;
        std::vector<std::int32_t> texels;  ///< of the box, row after row: row * width + column; -1 where not owned
        std::vector<std::pair<std::int32_t, Place>> places;  ///< of some of them, by their number in `texels`
        Integer owned = 0;
    };

    void add(const FrontScene& scene) {
        const auto corners = scene.corners(triangles_.size());
        Triangle t;
        const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
        const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        t.box = intersection(scene.frame, {static_cast<int>(floor(left)), static_cast<int>(floor(top)),
                                           static_cast<int>(floor(right)) + 1, static_cast<int>(floor(bottom)) + 1});
        const ExactTriangle exact(corners);
        std::vector<std::int32_t> owned;
        for (int y = t.box.y0; y < t.box.y1; ++y) {
            const PixelRange row = exact.row(y, t.box.x0, t.box.x1);
            for (Integer x = t.box.x0; x < t.box.x1; ++x) {
                if (x >= row.x0 && x < row.x1) {
                    owned.push_back(static_cast<std::int32_t>(t.texels.size()));
                    t.texels.push_back(number_of(exact.texel(x, y)));
                } else {
                    t.texels.push_back(-1);
                }
            }
        }
        t.owned = static_cast<Integer>(owned.size());
        add_places(t, corners, owned);
        triangles_.push_back(std::move(t));
    }

    [[nodiscard]] std::size_t size() const { return triangles_.size(); }
    [[nodiscard]] const Triangle& operator[](std::size_t n) const { return triangles_[n]; }

    [[nodiscard]] static std::int32_t number_of(int column, int row) { return row * kFrontTexture + column; }

private:
    [[nodiscard]] static std::int32_t number_of(const TexelIndex& t) {
        return number_of(wrap_index(t.u, kFrontTexture, Wrap::repeat), wrap_index(t.v, kFrontTexture, Wrap::repeat));
    }
    /// By the weights of the corners in rational numbers: another formula than ExactTriangle's, which it confirms.
    static void add_places(Triangle& t, std::span<const Vertex, 3> corners, std::span<const std::int32_t> owned) {
        static const Texture texture{.texels = Image(1, 1)};
        const Barycentric<Exact, NoTrace> method{t.box, texture, 1, false, {}, {}, {}};
        const auto set_up = method.setup(corners);
        const std::size_t count = std::min(owned.size(), std::size_t{kChecked});
        for (std::size_t n = 0; n < count; ++n) {
            const std::int32_t at = owned[(2 * n + 1) * owned.size() / (2 * count)];
            const Integer x = t.box.x0 + at % t.box.width(), y = t.box.y0 + at / t.box.width();
            const auto pixel = method.pixel(set_up, x, y);
            TEXELSCOPE_ASSERT(pixel.fate == Fate::written);
            TEXELSCOPE_ASSERT(number_of(TexelIndex{floor(pixel.u), floor(pixel.v)}) ==
                              t.texels[static_cast<std::size_t>(at)]);
            t.places.emplace_back(at, Place{pixel.u, pixel.v});
        }
    }

    std::vector<Triangle> triangles_;
};

/// What is found of one rung.
struct FrontRun::Tally {
    FrontPoint point;
    std::vector<double> errors;

    void measure(RungStage& stage, const Rung& rung, std::size_t n, const Reference::Triangle& t) {
        std::vector<bool> seen(t.texels.size());
        const bool rational = rung.format == NumberFormat::exact;
        stage.each_sample(rung, n, [&](const Sample& s) {
            if (!t.box.contains(s.x, s.y)) return void(++point.extra);
            const auto at = static_cast<std::size_t>((s.y - t.box.y0) * t.box.width() + (s.x - t.box.x0));
            if (t.texels[at] < 0 || seen[at]) return void(++point.extra);
            seen[at] = true;
            point.wrong += Reference::number_of(s.column, s.row) != t.texels[at];
            const auto place =
                std::lower_bound(t.places.begin(), t.places.end(), static_cast<std::int32_t>(at),
                                 [](const auto& entry, std::int32_t number) { return entry.first < number; });
            if (place == t.places.end() || place->first != static_cast<std::int32_t>(at)) return;
            const Place& p = place->second;
            const bool texels_only = rung.kind == RungKind::exact || rung.kind == RungKind::fast;
            errors.push_back(texels_only ? std::max(distance(p.u, s.column), distance(p.v, s.row))
                                         : std::max(error_of(s.u, p.u, rational), error_of(s.v, p.v, rational)));
        });
        ++point.triangles;
        point.pixels += t.owned;
        point.missing += t.owned - std::count(seen.begin(), seen.end(), true);
        if (rung.bound != nullptr && t.owned > 0) {
            const double bound = rung.bound(stage.scene().corners(n));
            point.bound = std::isnan(point.bound) ? bound : std::max(point.bound, bound);
        }
    }
    void finish() {
        std::sort(errors.begin(), errors.end());
        point.checked = static_cast<Integer>(errors.size());
        if (errors.empty()) return;
        point.max_error = errors.back();
        point.p99_error = errors[(errors.size() - 1) * 99 / 100];
        double sum = 0;
        for (const double error : errors) sum += error;
        point.mean_error = sum / static_cast<double>(errors.size());
    }
};

FrontOptions default_front() {
    FrontOptions options;
    for (const FrontSceneInfo& scene : front_scenes().first(kScenes)) options.scenes.push_back(&scene);
    for (const Rung& rung : rungs()) options.rungs.push_back(&rung);
    return options;
}

FrontRun::FrontRun(FrontOptions options, Clock clock) : options_(std::move(options)), clock_(std::move(clock)) {
    if (scene_count() == 0 || options_.rungs.empty() || (options_.own && options_.own->second.triangles() == 0))
        phase_ = Phase::over;
    else
        begin_scene();
}
FrontRun::FrontRun(FrontRun&&) noexcept = default;
FrontRun::~FrontRun() = default;

void FrontRun::begin_scene() {
    phase_ = Phase::reference;
    stage_ =
        std::make_unique<RungStage>(options_.own ? options_.own->second : options_.scenes[scene_]->make(options_.seed));
    reference_ = std::make_unique<Reference>();
    rung_ = triangle_ = 0, round_ = 0, done_ = 0;
    first_point_ = points_.size();
    repeats_.assign(options_.rungs.size(), 1);
    times_.assign(options_.rungs.size(), {});
    of_ = stage_->scene().triangles();
    for (const Rung* rung : options_.rungs) of_ += stage_->count(*rung);
    if (options_.rounds > 0) of_ += options_.rungs.size() * static_cast<std::size_t>(options_.rounds + 1);
}

bool FrontRun::step() {
    if (phase_ == Phase::over) return true;
    ++done_;
    switch (phase_) {
        case Phase::reference:
            reference_->add(stage_->scene());
            if (reference_->size() == stage_->scene().triangles()) phase_ = Phase::errors;
            break;
        case Phase::errors: measure_triangle(); break;
        case Phase::times: time_rung(); break;
        case Phase::over: break;
    }
    return phase_ == Phase::over;
}

void FrontRun::measure_triangle() {
    if (triangle_ == 0) {
        tally_ = std::make_unique<Tally>();
        FrontPoint& point = tally_->point;
        point.scene = scene_id(), point.rung = rung().id;
        point.label = rung().label, point.kind = id_of(rung().kind);
        point.numbers = id_of(rung().format);
    }
    tally_->measure(*stage_, rung(), triangle_, (*reference_)[triangle_]);
    if (++triangle_ < stage_->count(rung())) return;
    tally_->finish();
    points_.push_back(std::move(tally_->point));
    triangle_ = 0;
    if (++rung_ < options_.rungs.size()) return;
    rung_ = 0;
    if (options_.rounds > 0)
        phase_ = Phase::times;
    else
        end_scene();
}

void FrontRun::time_rung() {
    const int repeats = repeats_[rung_];
    const double begin = clock_();
    for (int n = 0; n < repeats; ++n) stage_->draw(rung());
    const double seconds = (clock_() - begin) / repeats;
    const FrontPoint& point = points_[first_point_ + rung_];
    if (round_ == 0)
        repeats_[rung_] = std::clamp(static_cast<int>(std::ceil(kRound / std::max(seconds, 1e-9))), 1, kMostRepeats);
    else
        times_[rung_].push_back(point.pixels > 0 ? seconds * 1e9 / static_cast<double>(point.pixels) : 0);
    if (++rung_ < options_.rungs.size()) return;
    rung_ = 0;
    if (++round_ > options_.rounds) end_scene();
}

void FrontRun::end_scene() {
    for (std::size_t n = 0; n < options_.rungs.size() && options_.rounds > 0; ++n) {
        FrontPoint& point = points_[first_point_ + n];
        point.median_ns = median_of(times_[n]);
        point.min_ns = *std::min_element(times_[n].begin(), times_[n].end());
    }
    mark_dominated(std::span(points_).subspan(first_point_));
    if (++scene_ < scene_count())
        begin_scene();
    else
        phase_ = Phase::over;
}

std::string_view FrontRun::scene_id() const {
    return options_.own ? std::string_view(options_.own->first) : options_.scenes[scene_]->id;
}

bool FrontRun::advance(double seconds) {
    const double begin = clock_();
    bool over = phase_ == Phase::over;
    while (!over && clock_() - begin <= seconds) over = step();
    return over;
}

double FrontRun::share() const {
    if (phase_ == Phase::over) return 1;
    const double here = static_cast<double>(done_) / static_cast<double>(of_);
    return (static_cast<double>(scene_) + here) / static_cast<double>(scene_count());
}
std::string FrontRun::doing() const {
    if (phase_ == Phase::over) return {};
    const std::string scene(scene_id());
    if (phase_ == Phase::reference) return scene + ": exact arithmetic";
    if (phase_ == Phase::errors) return scene + ": error of " + rung().label;
    return scene + ": time of " + rung().label;
}

void mark_dominated(std::span<FrontPoint> points) {
    const auto dominator = [&](const FrontPoint& p, bool without_fast) {
        const FrontPoint* best = nullptr;
        for (const FrontPoint& q : points) {
            if (q.scene != p.scene || (without_fast && q.kind == id_of(RungKind::fast))) continue;
            if (q.min_ns < p.min_ns && q.max_error <= p.max_error && (best == nullptr || q.min_ns < best->min_ns))
                best = &q;
        }
        return best != nullptr ? best->rung : std::string();
    };
    for (FrontPoint& p : points) p.dominated_by = dominator(p, false), p.behind = dominator(p, true);
}

}  // namespace texelscope
