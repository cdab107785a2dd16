#include "core/measure/skip_bill.h"

#include <algorithm>
#include <limits>

#include "core/geometry/polygon.h"
#include "core/image/packed.h"

namespace texelscope {
namespace {

constexpr int kGap = 16;     ///< behind a row, so that rows are no power of two apart [px]
constexpr int kRounds = 12;  ///< that count

}  // namespace

SkipScene::SkipScene(const Scene& scene)
    : frame_(scene.framebuffer), depth_(scene.depth == Depth::less), cull_(scene.cull == Cull::back) {
    textures_.reserve(scene.textures.size());
    for (const auto& texture : scene.textures) {
        const Image& texels = texture->texels;
        const auto power = [](int size) { return (size & (size - 1)) == 0; };
        const bool masks = texture->wrap == Wrap::mask && power(texels.width()) && power(texels.height());
        const Wrap wrap = texture->wrap == Wrap::mask && !masks ? Wrap::repeat : texture->wrap;
        textures_.emplace_back(texels, wrap);
    }
    for (const Polygon& polygon : scene.polygons) {
        if (!is_drawable(polygon)) continue;
        if (parts_.empty() || parts_.back().texture != polygon.texture)
            parts_.push_back({polygon.texture, vertices_.size(), 0});
        const std::vector<Vertex>& corners = polygon.vertices;
        for (std::size_t k = 2; k < corners.size(); ++k) {
            vertices_.insert(vertices_.end(), {corners[0], corners[k - 1], corners[k]});
            parts_.back().count += 3;
        }
    }
    const auto size = static_cast<std::size_t>(frame_.width + kGap) * static_cast<std::size_t>(frame_.height);
    pixels_.resize(size);
    if (depth_) nearest_.resize(size);
}

void SkipScene::clear() {
    std::fill(pixels_.begin(), pixels_.end(), packed(frame_.clear));
    std::fill(nearest_.begin(), nearest_.end(), 1.0F);
}

RasterCounters SkipScene::draw(std::uint32_t skips) {
    RasterTarget target{.pixels = pixels_.data(), .pitch = frame_.width + kGap};
    target.width = frame_.width, target.height = frame_.height;
    target.x0 = frame_.origin_x, target.y0 = frame_.origin_y;
    if (depth_) target.depth = nearest_.data();
    RasterCounters counters;
    for (const Part& part : parts_) {
        // u and v are in texels here: one unit is one texel.
        const RasterJob job{.vertices = std::span(vertices_).subspan(part.first, part.count),
                            .perspective = true,
                            .cull_back = cull_,
                            .depth = depth_};
        texelscope::draw(target, textures_[static_cast<std::size_t>(part.texture)].texture(), job, {.skips = skips},
                         counters);
    }
    return counters;
}

SkipCount count_skips(const Scene& scene, std::uint32_t skips) {
    SkipScene drawn(scene);
    SkipCount count;
    drawn.clear();
    count.all = drawn.draw(kAllSkips);
    const std::vector<std::uint32_t> reference = drawn.pixels();
    drawn.clear();
    count.counters = drawn.draw(skips);
    for (std::size_t n = 0; n < reference.size(); ++n) count.differs += reference[n] != drawn.pixels()[n];
    return count;
}

SkipRun::SkipRun(const Scene& scene, std::uint32_t skips, Clock clock) : scene_(scene), clock_(std::move(clock)) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    best_.push_back({kAllSkips, kNever});
    for (const RasterSkipInfo& info : kRasterSkips) best_.push_back({without(info.skip), kNever});
    best_.push_back({0, kNever});
    const std::uint32_t asked = skips & kAllSkips;
    if (std::none_of(best_.begin(), best_.end(), [&](const SkipTime& t) { return t.skips == asked; }))
        best_.push_back({asked, kNever});
}

bool SkipRun::advance(double seconds) {
    const double begin = clock_();
    while (round_ <= kRounds && clock_() - begin <= seconds) {
        scene_.clear();
        const double start = clock_();
        (void)scene_.draw(best_[next_].skips);
        const double took = clock_() - start;
        if (round_ > 0) best_[next_].seconds = std::min(best_[next_].seconds, took);
        if (++next_ < best_.size()) continue;
        next_ = 0, ++round_;
        if (round_ > 1) times_ = best_;
    }
    return round_ > kRounds;
}

double SkipRun::share() const {
    const double done = static_cast<double>(round_) + static_cast<double>(next_) / static_cast<double>(best_.size());
    return std::min(1.0, done / (kRounds + 1));
}

}  // namespace texelscope
