#include "core/measure/rungs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/assert.h"
#include "core/exact/triangle.h"
#include "core/image/packed.h"
#include "core/image/patterns.h"
#include "core/measure/bill.h"
#include "core/measure/rung_kernels.h"
#include "core/method/run.h"

namespace texelscope {
namespace {

constexpr std::array<std::string_view, 4> kKinds{"method", "kernel", "exact", "fast"};
constexpr std::size_t kSlow = 6;        ///< triangles of a rung that computes with fractions
constexpr std::size_t kQuiteSlow = 60;  ///< triangles of `exact`
constexpr std::uint8_t kMark = 255;     ///< blue of the texture, so that no texel is 0
constexpr int kPadding = 16;            ///< a pitch that is no power of two [px]

template <class Kernel>
[[gnu::flatten]] Fate render_kernel(const Job& job, Image& picture) {
    return run::draw_into(picture, job, Kernel{job.frame, *job.texture});
}
template <class Kernel>
Fate samples_of_kernel(const Job& job, const Window& window, const Put& put) {
    return Kernel{job.frame, *job.texture}.draw(job.corners, run::put_inside(window, put));
}
template <class Kernel>
[[nodiscard]] Rung kernel(std::string id, std::string label, NumberFormat format, bounds::Bound bound) {
    Rung rung{.id = std::move(id), .label = std::move(label), .kind = RungKind::kernel, .bound = bound};
    rung.format = format;
    rung.render = render_kernel<Kernel>;
    rung.samples = samples_of_kernel<Kernel>;
    return rung;
}

/// A method's variant that is a rung of its own.
struct Variant {
    std::string_view method;
    NumberFormat format;
    std::string_view quirk, label;
    bounds::Bound bound;
};
constexpr std::array<Variant, 5> kVariants{{
    {"edge-equations", NumberFormat::f32, "based", "float, corner", bounds::based_float},
    {"edge-equations", NumberFormat::f32, "additions", "float, additions", bounds::additions_float},
    {"subdivided", NumberFormat::f64, "every_8", "every 8 px", bounds::every_8},
    {"subdivided", NumberFormat::f64, "every_32", "every 32 px", bounds::every_32},
    {"subdivided", NumberFormat::f64, "adaptive", "adaptive", bounds::adaptive},
}};
/// Corrected methods that are rungs of the ladder, too.
constexpr std::array<Variant, 3> kNamed{{
    {"edge-equations", NumberFormat::f64, "", "double", bounds::direct_double},
    {"edge-equations", NumberFormat::f32, "", "float", bounds::direct_float},
    {"subdivided", NumberFormat::f64, "", "every 16 px", bounds::every_16},
}};

[[nodiscard]] Rung rung_of(const Method& method, NumberFormat format) {
    Rung rung{.format = format, .method = &method, .quirks = method.variants.back().quirks};
    rung.id = std::string(method.id) + ":" + std::string(id_of(format));
    rung.label = std::string(method.id) + " " + std::string(id_of(format));
    if (format == NumberFormat::exact) rung.most = kSlow;
    for (const Variant& named : kNamed)
        if (named.method == method.id && named.format == format) rung.label = named.label, rung.bound = named.bound;
    return rung;
}
[[nodiscard]] Rung rung_of(const Variant& variant) {
    const Method* const method = find_method(variant.method);
    TEXELSCOPE_ASSERT(method != nullptr);
    Rung rung = rung_of(*method, variant.format);
    for (std::size_t n = 0; n < method->quirks.size(); ++n)
        if (method->quirks[n].id == variant.quirk) rung.quirks |= QuirkSet{1} << n;
    rung.id += ":" + std::string(variant.quirk);
    rung.label = variant.label, rung.bound = variant.bound;
    return rung;
}

[[nodiscard]] const Rung* find_in(const std::vector<Rung>& all, std::string_view id) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Rung& r) { return r.id == id; });
    return found != all.end() ? &*found : nullptr;
}

[[nodiscard]] std::vector<Rung> all_rungs() {
    std::vector<Rung> all;
    Rung fast{.id = "fast", .label = "fast", .kind = RungKind::fast, .bound = bounds::none};
    Rung exact{.id = "exact", .label = "exact", .kind = RungKind::exact, .bound = bounds::none, .most = kQuiteSlow};
    fast.format = exact.format = NumberFormat::exact;
    all.push_back(std::move(fast));
    all.push_back(std::move(exact));
    for (const Variant& variant : kVariants) all.push_back(rung_of(variant));
    all.push_back(kernel<TileBased<float>>("tile-based", "float, tiles", NumberFormat::f32, bounds::tile_float));
    all.push_back(kernel<FixedSteps>("fixed-steps", "16.16 additions", NumberFormat::fx16_16, bounds::fixed_16_16));
    all.push_back(kernel<Coverage24_8>("coverage-24.8", "24.8 coverage", NumberFormat::f64, bounds::direct_double));
    all.push_back(kernel<Newton<0>>("newton-0", "1/w to 12 bits", NumberFormat::f64, bounds::newton_0));
    all.push_back(kernel<Newton<1>>("newton-1", "1/w, 1 Newton step", NumberFormat::f64, bounds::newton_1));
    all.push_back(kernel<Newton<2>>("newton-2", "1/w, 2 Newton steps", NumberFormat::f64, bounds::newton_2));
    for (const Method* method : racers()) {
        if (find_in(all, method->id)) continue;  // `fast` and `exact` stand above as they are, not as methods
        for (const NumberFormatInfo& number : kNumberFormats) all.push_back(rung_of(*method, number.format));
    }
    return all;
}

}  // namespace

std::string_view id_of(RungKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

const std::vector<Rung>& rungs() {
    static const std::vector<Rung> all = all_rungs();
    return all;
}
const Rung* find_rung(std::string_view id) { return find_in(rungs(), id); }

RungStage::RungStage(FrontScene scene)
    : scene_(std::move(scene)), picture_(scene_.frame.width(), scene_.frame.height()) {
    texture_.texels = make_pattern(Pattern::address, kFrontTexture, kFrontTexture, kMark);
    texels_ = RasterTexels(texture_.texels, Wrap::repeat);
    pixels_.resize(static_cast<std::size_t>(picture_.width() + kPadding) * static_cast<std::size_t>(picture_.height()));
    const std::vector<Vertex>& corners = scene_.vertices;
    perspective_ = std::any_of(corners.begin(), corners.end(), [&](const Vertex& c) { return c.w != corners[0].w; });
}

std::size_t RungStage::count(const Rung& rung) const {
    return rung.most == 0 ? scene_.triangles() : std::min(rung.most, scene_.triangles());
}

Job RungStage::job(std::size_t triangle) const {
    return {.corners = scene_.corners(triangle), .texture = &texture_, .frame = scene_.frame};
}

void RungStage::draw_exact(std::size_t triangle) {
    const ExactTriangle exact(scene_.corners(triangle));
    const Rect& frame = scene_.frame;
    const auto corners = scene_.corners(triangle);
    const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    for (Integer y = floor(top); y <= floor(bottom) && y < frame.y1; ++y) {
        const PixelRange row = exact.row(y, frame.x0, frame.x1);
        for (Integer x = row.x0; x < row.x1; ++x) {
            const TexelIndex t = exact.texel(x, y);
            picture_.at(static_cast<int>(x) - frame.x0, static_cast<int>(y) - frame.y0) = texture_.texels.at(
                wrap_index(t.u, kFrontTexture, Wrap::repeat), wrap_index(t.v, kFrontTexture, Wrap::repeat));
        }
    }
}

void RungStage::draw_fast(std::span<const Vertex> vertices) {
    const int width = picture_.width(), height = picture_.height();
    const RasterTarget target{.pixels = pixels_.data(),
                              .pitch = width + kPadding,
                              .width = width,
                              .height = height,
                              .x0 = scene_.frame.x0,
                              .y0 = scene_.frame.y0};
    const RasterJob job{.vertices = vertices, .perspective = perspective_};
    RasterCounters counters;
    texelscope::draw(target, texels_.texture(), job, {}, counters);
}

void RungStage::draw(const Rung& rung) {
    const std::size_t triangles = count(rung);
    if (rung.kind == RungKind::fast) return draw_fast(std::span(scene_.vertices).first(3 * triangles));
    for (std::size_t n = 0; n < triangles; ++n) {
        if (rung.kind == RungKind::exact) {
            draw_exact(n);
        } else if (rung.kind == RungKind::kernel) {
            (void)rung.render(job(n), picture_);
        } else {
            Job one = job(n);
            one.quirks = rung.quirks;
            (void)rung.method->render(rung.format, one, picture_);
        }
    }
}

void RungStage::samples_of_pixels(std::size_t triangle, const Put& put) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const Rect& frame = scene_.frame;
    const std::span<const Vertex> one = std::span(scene_.vertices).subspan(3 * triangle, 3);
    std::fill(pixels_.begin(), pixels_.end(), 0);
    draw_fast(one);
    const std::uint32_t* pixel = pixels_.data();
    for (int y = frame.y0; y < frame.y1; ++y, pixel += kPadding)
        for (int x = frame.x0; x < frame.x1; ++x, ++pixel) {
            if (*pixel == 0) continue;
            Sample s{.x = x, .y = y, .u = kNone, .v = kNone};
            s.column = static_cast<int>(*pixel & 255U), s.row = static_cast<int>(*pixel >> 8U & 255U);
            put(s);
        }
}

void RungStage::each_sample(const Rung& rung, std::size_t triangle, const Put& put) {
    if (rung.kind == RungKind::fast) return samples_of_pixels(triangle, put);
    const Window whole{scene_.frame, 1};
    const Put written = [&](const Sample& s) {
        if (s.fate == Fate::written) put(s);
    };
    if (rung.kind == RungKind::exact) {
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        const ExactTriangle exact(scene_.corners(triangle));
        for (Integer y = scene_.frame.y0; y < scene_.frame.y1; ++y) {
            const PixelRange row = exact.row(y, scene_.frame.x0, scene_.frame.x1);
            for (Integer x = row.x0; x < row.x1; ++x) {
                const TexelIndex t = exact.texel(x, y);
                Sample s{.x = x, .y = y, .u = kNone, .v = kNone};
                s.column = wrap_index(t.u, kFrontTexture, Wrap::repeat);
                s.row = wrap_index(t.v, kFrontTexture, Wrap::repeat);
                put(s);
            }
        }
        return;
    }
    Job one = job(triangle);
    if (rung.kind == RungKind::kernel) return (void)rung.samples(one, whole, written);
    one.quirks = rung.quirks;
    (void)rung.method->samples(rung.format, one, whole, written);
}

}  // namespace texelscope
