#include "core/measure/stress.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

#include "core/measure/reference.h"
#include "core/measure/stress_methods.h"
#include "core/measure/stress_shapes.h"

namespace texelscope {
namespace {

constexpr std::string_view kFast = "fast", kExact = "exact";

/// What one triangle draws and where its samples lie on the texture, decided once for all methods.
struct Reference {
    Samples samples;
    std::optional<ExactCoordinates> coordinates;  ///< where there are samples
    std::vector<TexelIndex> places;               ///< of the samples, as `coordinates` has them
};
[[nodiscard]] Reference reference_of(std::span<const Vertex, 3> corners, const Rect& frame) {
    Reference reference{.samples = decided_samples(corners, frame), .coordinates = {}, .places = {}};
    if (reference.samples.empty()) return reference;
    reference.coordinates.emplace(corners);
    for (const DecidedSample& s : reference.samples) reference.places.push_back(reference.coordinates->at(s.x, s.y));
    return reference;
}

/// Errors of u and v, kept for their quantile.
class Errors {
public:
    void add(double error) { all_.push_back(error); }
    void finish(StressRow& row) {
        if (all_.empty()) return;
        double sum = 0;
        for (const double error : all_) sum += error;
        row.mean = sum / static_cast<double>(all_.size());
        const auto at = all_.begin() + static_cast<std::ptrdiff_t>(all_.size() * 99 / 100);
        std::nth_element(all_.begin(), at, all_.end());
        row.p99 = *at, row.worst = *std::max_element(at, all_.end());
    }

private:
    std::vector<double> all_;
};

/// One triangle's samples against those decided.
class Comparison {
public:
    Comparison(const HardShape& shape, const Job& job, StressRow& row, Errors& errors)
        : shape_(&shape), job_(&job), row_(&row), errors_(&errors) {}

    /// Both ascend by (y, x).
    void run(const Reference& reference, const std::vector<DrawnSample>& drawn) {
        const Samples& decided = reference.samples;
        const std::size_t before = faults();
        std::size_t d = 0;
        for (std::size_t n = 0; n < drawn.size(); ++n) {
            const DrawnSample& s = drawn[n];
            if (n > 0 && s.x == drawn[n - 1].x && s.y == drawn[n - 1].y) {
                row_->twice += !shape_->closed;  // else the coverage counts it
                continue;
            }
            for (; d < decided.size() && std::tie(decided[d].y, decided[d].x) < std::tie(s.y, s.x); ++d)
                ++row_->missing;
            if (d == decided.size() || decided[d].y != s.y || decided[d].x != s.x) {
                ++row_->extra;
                continue;
            }
            compare(reference, d++, s);
        }
        row_->missing += static_cast<std::int64_t>(decided.size() - d);
        if (row_->fault.empty() && faults() > before) row_->fault = text_of(job_->corners);
    }

private:
    /// What fails the run, if anything does.
    [[nodiscard]] std::size_t faults() const {
        const bool exact = row_->method == kExact;
        return static_cast<std::size_t>(row_->exceeded +
                                        (exact ? row_->missing + row_->extra + row_->twice + row_->wrong : 0));
    }
    void compare(const Reference& reference, std::size_t n, const DrawnSample& s) {
        const DecidedSample& is = reference.samples[n];
        const Texture& texture = *job_->texture;
        row_->wrong += s.column != wrap_index(is.texel.u, texture.width(), texture.wrap) ||
                       s.row != wrap_index(is.texel.v, texture.height(), texture.wrap);
        const auto [u, v] = reference.coordinates->distance(reference.places[n], s.u, s.v);
        row_->exceeded += u > s.u_bound || v > s.v_bound;
        for (const double bound : {s.u_bound, s.v_bound})
            if (bound < INFINITY) row_->bound = std::max(row_->bound, bound);
        errors_->add(std::max(u, v));
    }

    const HardShape* shape_;
    const Job* job_;
    StressRow* row_;
    Errors* errors_;
};

/// Blank textures by size: only addresses are looked at.
class Textures {
public:
    const Texture& of(const HardShape& shape) {
        auto& kept = all_[{shape.texture_width, shape.texture_height}];
        if (!kept) {
            kept = std::make_unique<Texture>();
            kept->texels = Image(shape.texture_width, shape.texture_height);
        }
        return *kept;
    }

private:
    std::map<std::pair<int, int>, std::unique_ptr<Texture>> all_;
};

/// A family's shapes in one mode with what they draw, kept for all methods.
class HardShapes {
public:
    struct Entry {
        HardShape shape;
        std::vector<Reference> triangles;
    };
    HardShapes(const Family& family, StressMode mode, std::uint64_t seed)
        : family_(&family), mode_(mode), seed_(seed) {}
    [[nodiscard]] const Family& family() const { return *family_; }
    [[nodiscard]] StressMode mode() const { return mode_; }
    [[nodiscard]] const Entry& at(int n) {
        while (static_cast<int>(entries_.size()) <= n) {
            Entry entry{shape_at(*family_, mode_, seed_, static_cast<int>(entries_.size())), {}};
            for (std::size_t k = 0; k < triangles_of(entry.shape); ++k)
                entry.triangles.push_back(reference_of(triangle_of(entry.shape, k), entry.shape.frame));
            entries_.push_back(std::move(entry));
        }
        return entries_[static_cast<std::size_t>(n)];
    }

private:
    const Family* family_;
    StressMode mode_;
    std::uint64_t seed_;
    std::vector<Entry> entries_;
};

[[nodiscard]] int shapes_of(const Family& family, int count) { return std::max(1, count / family.cost); }

[[nodiscard]] StressRow row_of(HardShapes& hard, const DrawSettings& settings, int shapes) {
    StressRow row{
        .family = &hard.family(), .mode = hard.mode(), .method = settings.method->id, .number = id_of(settings.format)};
    Errors errors;
    Textures textures;
    for (int k = 0; k < shapes; ++k) {
        const auto& [shape, triangles] = hard.at(k);
        Coverage coverage(shape);
        ++row.shapes;
        for (std::size_t n = 0; n < triangles.size(); ++n) {
            const Job job{.corners = triangle_of(shape, n),
                          .texture = &textures.of(shape),
                          .frame = shape.frame,
                          .quirks = settings.quirks,
                          .mode = settings.mode};
            std::vector<DrawnSample> drawn;
            if (is_drawable(job.corners)) drawn = drawn_samples(*settings.method, settings.format, job);
            for (const DrawnSample& s : drawn) coverage.add(s.x, s.y);
            std::stable_sort(drawn.begin(), drawn.end(), [](const DrawnSample& a, const DrawnSample& b) {
                return std::tie(a.y, a.x) < std::tie(b.y, b.x);
            });
            ++row.triangles, row.samples += static_cast<std::int64_t>(triangles[n].samples.size());
            Comparison(shape, job, row, errors).run(triangles[n], drawn);
        }
        coverage.finish(row);
    }
    errors.finish(row);
    return row;
}

}  // namespace

bool StressRow::failed() const {
    const bool all_zero = missing == 0 && extra == 0 && twice == 0 && wrong == 0 && leaky == 0 && together == 0;
    return exceeded != 0 || ((method == kFast || method == kExact) && !all_zero);
}

StressRow stress_method(const Family& family, StressMode mode, const DrawSettings& settings, std::uint64_t seed,
                        int shapes) {
    HardShapes hard(family, mode, seed);
    return row_of(hard, settings, shapes);
}

void stress(const StressSettings& settings, const std::function<void(const StressRow&)>& put) {
    for (const Family& family : families()) {
        if (settings.family != nullptr && settings.family != &family) continue;
        for (const StressMode mode : kStressModes) {
            if (family.depths && !mode.perspective) continue;
            const int shapes = shapes_of(family, settings.count);
            HardShapes hard(family, mode, settings.seed);
            for (const StressedMethod& stressed : stressed_methods()) {
                if (!settings.method.empty() && settings.method != stressed.id) continue;
                if (!(mode.perspective ? stressed.perspective : stressed.affine)) continue;
                if (stressed.id == kFast) {
                    put(stress_fast(family, mode, settings.seed, shapes));
                    continue;
                }
                const Method* const method = find_method(stressed.id);
                TEXELSCOPE_ASSERT(method != nullptr);
                for (const NumberFormatInfo& info : kNumberFormats) {
                    const bool exact = info.format == NumberFormat::exact;
                    if (!exact && stressed.id == kExact) continue;
                    DrawSettings drawn;
                    drawn.method = method, drawn.format = info.format;
                    const int most = exact ? kMostForExactNumbers : shapes_of(family, kMostForMethods);
                    put(row_of(hard, drawn, std::min(shapes, most)));
                }
            }
        }
    }
}

}  // namespace texelscope
