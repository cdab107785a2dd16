#include "core/measure/stress.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "core/geometry/polygon.h"
#include "core/measure/reference.h"
#include "core/measure/stress_methods.h"

namespace texelscope {
namespace {

using Samples = std::vector<DecidedSample>;
constexpr std::string_view kFast = "fast", kExact = "exact";

[[nodiscard]] std::span<const Vertex, 3> triangle_of(const HardShape& shape, std::size_t n) {
    return std::span<const Vertex, 3>(&shape.vertices[3 * n], 3);
}
[[nodiscard]] std::size_t triangles_of(const HardShape& shape) { return shape.vertices.size() / 3; }

/// How often each sample of a closed shape's frame was drawn.
class Coverage {
public:
    explicit Coverage(const HardShape& shape)
        : closed_(shape.closed),
          frame_(shape.frame),
          counts_(closed_ ? frame_.width() : 0, closed_ ? frame_.height() : 0) {}
    void add(Integer x, Integer y) {
        if (closed_) ++counts_.at(static_cast<int>(x) - frame_.x0, static_cast<int>(y) - frame_.y0);
    }
    void finish(StressRow& row) const {
        if (!closed_) return;
        bool leaky = false;
        for (const int* n = counts_.data(); n != counts_.data() + counts_.size(); ++n)
            row.twice += std::max(0, *n - 1), leaky = leaky || *n != 1;
        ++row.meshes, row.leaky += leaky ? 1 : 0;
    }

private:
    bool closed_;
    Rect frame_;
    Grid<int> counts_;
};

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
    void run(const Samples& decided, const std::vector<DrawnSample>& drawn) {
        const std::size_t before = faults();
        if (!decided.empty()) coordinates_.emplace(job_->corners.first<3>());
        std::size_t d = 0;
        for (std::size_t n = 0; n < drawn.size(); ++n) {
            const DrawnSample& s = drawn[n];
            if (n > 0 && s.x == drawn[n - 1].x && s.y == drawn[n - 1].y) {
                row_->twice += !shape_->closed;  // else the coverage counts it
                continue;
            }
            while (d < decided.size() && std::tie(decided[d].y, decided[d].x) < std::tie(s.y, s.x))
                ++d, ++row_->missing;
            if (d == decided.size() || decided[d].y != s.y || decided[d].x != s.x) {
                ++row_->extra;
                continue;
            }
            compare(decided[d++], s);
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
    void compare(const DecidedSample& is, const DrawnSample& s) {
        const Texture& texture = *job_->texture;
        row_->wrong += s.column != wrap_index(is.texel.u, texture.width(), texture.wrap) ||
                       s.row != wrap_index(is.texel.v, texture.height(), texture.wrap);
        const auto [u, v] = coordinates_->distance(is, s.u, s.v);
        row_->exceeded += u > s.u_bound || v > s.v_bound;
        for (const double bound : {s.u_bound, s.v_bound})
            if (bound < INFINITY) row_->bound = std::max(row_->bound, bound);
        errors_->add(std::max(u, v));
    }

    const HardShape* shape_;
    const Job* job_;
    StressRow* row_;
    Errors* errors_;
    std::optional<ExactCoordinates> coordinates_;
};

[[nodiscard]] bool is_drawable(std::span<const Vertex> corners) {
    return std::all_of(corners.begin(), corners.end(), [](const Vertex& v) { return is_finite(v) && v.w > 0; });
}

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

[[nodiscard]] HardShape shape_at(const Family& family, StressMode mode, std::uint64_t seed, int n) {
    return in_mode(family.make(seed_of(seed, family, n)), mode);
}

/// Triangles that share a frame and a texture, drawn in one call: the last one wins.
struct Together {
    Rect frame;
    int texture_width = 0, texture_height = 0;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> expected;
};

class FastRun {
public:
    FastRun(StressMode mode, StressRow& row) : perspective_(mode.perspective), row_(&row) {}

    void shape(const HardShape& shape) {
        ++row_->shapes;
        if (!is_served(shape)) return void(++row_->not_served);
        Coverage coverage(shape);
        for (std::size_t n = 0; n < triangles_of(shape); ++n) triangle(shape, n, coverage);
        coverage.finish(*row_);
    }
    void finish() {
        for (auto& [key, group] : groups_) check(group);
    }

private:
    /// What core/fast does not draw so far: frames and textures of other kinds, and numbers that are not finite.
    [[nodiscard]] static bool is_served(const HardShape& shape) {
        const auto power_of_two = [](int n) { return (n & (n - 1)) == 0; };
        return shape.frame.x0 == 0 && shape.frame.y0 == 0 && power_of_two(shape.texture_width) &&
               power_of_two(shape.texture_height) && is_drawable(shape.vertices);
    }
    static constexpr std::uint32_t kNone = ~0U;
    static constexpr int kGap = 16;
    static constexpr std::size_t kMostGroups = 16;

    [[nodiscard]] static int pitch(const Rect& frame) { return frame.x1 + kGap; }
    [[nodiscard]] static std::size_t pixels_of(const Rect& frame) {
        return static_cast<std::size_t>(pitch(frame)) * static_cast<std::size_t>(frame.y1);
    }
    [[nodiscard]] static std::uint32_t address(const HardShape& shape, const TexelIndex& texel) {
        return static_cast<std::uint32_t>(wrap_index(texel.v, shape.texture_height, Wrap::repeat) *
                                              shape.texture_width +
                                          wrap_index(texel.u, shape.texture_width, Wrap::repeat));
    }
    void draw_into(std::vector<std::uint32_t>& pixels, const Rect& frame, int width, int height,
                   std::span<const Vertex> vertices, RasterCounters& counters) {
        while (addresses_.size() < static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
            addresses_.push_back(static_cast<std::uint32_t>(addresses_.size()));
        draw({pixels.data(), pitch(frame), frame.x1, frame.y1}, {addresses_.data(), width, height},
             {.vertices = vertices, .perspective = perspective_}, {}, counters);
    }

    void triangle(const HardShape& shape, std::size_t n, Coverage& coverage) {
        const auto corners = triangle_of(shape, n);
        const Samples decided = decided_samples(corners, shape.frame);
        if (pixels_.size() < pixels_of(shape.frame)) pixels_.resize(pixels_of(shape.frame), kNone);
        draw_into(pixels_, shape.frame, shape.texture_width, shape.texture_height, corners, row_->counters);
        ++row_->triangles, row_->samples += static_cast<std::int64_t>(decided.size());
        const std::int64_t before = row_->missing + row_->extra + row_->wrong;
        for (const DecidedSample& s : decided) {
            std::uint32_t& pixel = pixels_[static_cast<std::size_t>(s.y * pitch(shape.frame) + s.x)];
            row_->missing += pixel == kNone, row_->wrong += pixel != kNone && pixel != address(shape, s.texel);
            if (pixel != kNone) coverage.add(s.x, s.y);
            pixel = kNone;
        }
        look_for_strays(shape, corners, coverage);
        if (row_->missing + row_->extra + row_->wrong > before && row_->fault.empty()) row_->fault = text_of(corners);
        remember(shape, corners, decided);
    }
    /// All that is left was drawn by mistake. Of large frames only the box and its neighbourhood is looked at.
    void look_for_strays(const HardShape& shape, std::span<const Vertex, 3> corners, Coverage& coverage) {
        Rect box = shape.frame;
        constexpr int kSmall = 4096, kRound = 8;
        if (pixels_of(shape.frame) > kSmall && is_drawable(corners)) {
            const auto within = [](float a, int most) { return static_cast<int>(std::clamp<double>(a, 0, most)); };
            const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
            const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
            box = intersection(box, {within(left, box.x1) - kRound, within(top, box.y1) - kRound,
                                     within(right, box.x1) + kRound, within(bottom, box.y1) + kRound});
        }
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x) {
                std::uint32_t& pixel = pixels_[static_cast<std::size_t>(y * pitch(shape.frame) + x)];
                if (pixel != kNone) ++row_->extra, coverage.add(x, y);
                pixel = kNone;
            }
    }
    void remember(const HardShape& shape, std::span<const Vertex, 3> corners, const Samples& decided) {
        const auto key = std::tuple(shape.frame.x1, shape.frame.y1, shape.texture_width, shape.texture_height);
        if (groups_.size() >= kMostGroups && !groups_.contains(key)) return;
        Together& group = groups_[key];
        if (group.expected.empty()) {
            group.frame = shape.frame;
            group.texture_width = shape.texture_width, group.texture_height = shape.texture_height;
            group.expected.assign(pixels_of(shape.frame), kNone);
        }
        group.vertices.insert(group.vertices.end(), corners.begin(), corners.end());
        for (const DecidedSample& s : decided)
            group.expected[static_cast<std::size_t>(s.y * pitch(shape.frame) + s.x)] = address(shape, s.texel);
    }
    void check(Together& group) {
        std::vector<std::uint32_t> pixels(group.expected.size(), kNone);
        RasterCounters counters;
        draw_into(pixels, group.frame, group.texture_width, group.texture_height, group.vertices, counters);
        for (std::size_t n = 0; n < pixels.size(); ++n) row_->together += pixels[n] != group.expected[n];
    }

    bool perspective_;
    StressRow* row_;
    std::vector<std::uint32_t> pixels_, addresses_;  ///< pixels_: all kNone between two triangles
    std::map<std::tuple<int, int, int, int>, Together> groups_;
};

[[nodiscard]] int shapes_of(const Family& family, int count) { return std::max(1, count / family.cost); }

}  // namespace

bool StressRow::failed() const {
    const bool all_zero = missing == 0 && extra == 0 && twice == 0 && wrong == 0 && leaky == 0 && together == 0;
    return exceeded != 0 || ((method == kFast || method == kExact) && !all_zero);
}

StressRow stress_method(const Family& family, StressMode mode, const DrawSettings& settings, std::uint64_t seed,
                        int shapes) {
    StressRow row{.family = &family, .mode = mode, .method = settings.method->id, .number = id_of(settings.format)};
    Errors errors;
    Textures textures;
    for (int k = 0; k < shapes; ++k) {
        const HardShape shape = shape_at(family, mode, seed, k);
        Coverage coverage(shape);
        ++row.shapes;
        for (std::size_t n = 0; n < triangles_of(shape); ++n) {
            const Job job{.corners = triangle_of(shape, n),
                          .texture = &textures.of(shape),
                          .frame = shape.frame,
                          .quirks = settings.quirks,
                          .mode = settings.mode};
            const Samples decided = decided_samples(triangle_of(shape, n), shape.frame);
            std::vector<DrawnSample> drawn;
            if (is_drawable(job.corners)) drawn = drawn_samples(*settings.method, settings.format, job);
            for (const DrawnSample& s : drawn) coverage.add(s.x, s.y);
            std::stable_sort(drawn.begin(), drawn.end(), [](const DrawnSample& a, const DrawnSample& b) {
                return std::tie(a.y, a.x) < std::tie(b.y, b.x);
            });
            ++row.triangles, row.samples += static_cast<std::int64_t>(decided.size());
            Comparison(shape, job, row, errors).run(decided, drawn);
        }
        coverage.finish(row);
    }
    errors.finish(row);
    return row;
}

StressRow stress_fast(const Family& family, StressMode mode, std::uint64_t seed, int shapes) {
    StressRow row{.family = &family, .mode = mode, .method = kFast, .number = ""};
    FastRun run(mode, row);
    for (int n = 0; n < shapes; ++n) run.shape(shape_at(family, mode, seed, n));
    run.finish();
    return row;
}

void stress(const StressSettings& settings, const std::function<void(const StressRow&)>& put) {
    for (const Family& family : families()) {
        if (settings.family != nullptr && settings.family != &family) continue;
        for (const StressMode mode : kStressModes) {
            if (family.depths && !mode.perspective) continue;
            const int shapes = shapes_of(family, settings.count);
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
                    put(stress_method(family, mode, drawn, settings.seed, std::min(shapes, most)));
                }
            }
        }
    }
}

}  // namespace texelscope
