#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/fast/raster_texels.h"
#include "core/measure/stress_shapes.h"

namespace texelscope {
namespace {

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
        Coverage coverage(shape);
        for (std::size_t n = 0; n < triangles_of(shape); ++n) triangle(shape, n, coverage);
        coverage.finish(*row_);
    }
    void finish() {
        for (auto& [key, group] : groups_) check(group);
    }

private:
    static constexpr std::uint32_t kNone = ~0U;
    static constexpr int kGap = 16;
    static constexpr std::size_t kMostGroups = 16;

    [[nodiscard]] static int pitch(const Rect& frame) { return frame.width() + kGap; }
    [[nodiscard]] static std::size_t pixels_of(const Rect& frame) {
        return static_cast<std::size_t>(pitch(frame)) * static_cast<std::size_t>(frame.height());
    }
    /// Where a frame's pixel is.
    [[nodiscard]] static std::size_t at(const Rect& frame, Integer x, Integer y) {
        return static_cast<std::size_t>((y - frame.y0) * pitch(frame) + x - frame.x0);
    }
    [[nodiscard]] static std::uint32_t address(const HardShape& shape, const TexelIndex& texel) {
        return static_cast<std::uint32_t>(wrap_index(texel.v, shape.texture_height, Wrap::repeat) *
                                              shape.texture_width +
                                          wrap_index(texel.u, shape.texture_width, Wrap::repeat));
    }
    /// Texels that are their own addresses.
    [[nodiscard]] RasterTexture addresses(int width, int height) {
        RasterTexels& texels = addresses_[{width, height}];
        if (texels.texture().width == 0) {
            std::vector<std::uint32_t> own(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
            std::iota(own.begin(), own.end(), 0U);
            texels = RasterTexels({own.data(), width, height, Wrap::repeat});
        }
        return texels.texture();
    }
    void draw_into(std::vector<std::uint32_t>& pixels, const Rect& frame, int width, int height,
                   std::span<const Vertex> vertices, RasterCounters& counters) {
        draw({.pixels = pixels.data(),
              .pitch = pitch(frame),
              .width = frame.width(),
              .height = frame.height(),
              .x0 = frame.x0,
              .y0 = frame.y0},
             addresses(width, height), {.vertices = vertices, .perspective = perspective_}, {}, counters);
    }

    void triangle(const HardShape& shape, std::size_t n, Coverage& coverage) {
        const auto corners = triangle_of(shape, n);
        const Samples decided = decided_samples(corners, shape.frame);
        if (pixels_.size() < pixels_of(shape.frame)) pixels_.resize(pixels_of(shape.frame), kNone);
        draw_into(pixels_, shape.frame, shape.texture_width, shape.texture_height, corners, row_->counters);
        ++row_->triangles, row_->samples += static_cast<std::int64_t>(decided.size());
        const std::int64_t before = row_->missing + row_->extra + row_->wrong;
        for (const DecidedSample& s : decided) {
            std::uint32_t& pixel = pixels_[at(shape.frame, s.x, s.y)];
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
            const auto within = [](float a, int most) { return static_cast<int>(std::clamp<double>(a, -most, most)); };
            const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
            const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
            constexpr int kMost = 1 << 30;
            box = intersection(box, {within(left, kMost) - kRound, within(top, kMost) - kRound,
                                     within(right, kMost) + kRound, within(bottom, kMost) + kRound});
        }
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x) {
                std::uint32_t& pixel = pixels_[at(shape.frame, x, y)];
                if (pixel != kNone) ++row_->extra, coverage.add(x, y);
                pixel = kNone;
            }
    }
    void remember(const HardShape& shape, std::span<const Vertex, 3> corners, const Samples& decided) {
        const Rect& f = shape.frame;
        const auto key = std::tuple(f.x0, f.y0, f.x1, f.y1, shape.texture_width, shape.texture_height);
        if (groups_.size() >= kMostGroups && !groups_.contains(key)) return;
        Together& group = groups_[key];
        if (group.expected.empty()) {
            group.frame = shape.frame;
            group.texture_width = shape.texture_width, group.texture_height = shape.texture_height;
            group.expected.assign(pixels_of(shape.frame), kNone);
        }
        group.vertices.insert(group.vertices.end(), corners.begin(), corners.end());
        for (const DecidedSample& s : decided) group.expected[at(shape.frame, s.x, s.y)] = address(shape, s.texel);
    }
    void check(Together& group) {
        std::vector<std::uint32_t> pixels(group.expected.size(), kNone);
        RasterCounters counters;
        draw_into(pixels, group.frame, group.texture_width, group.texture_height, group.vertices, counters);
        for (std::size_t n = 0; n < pixels.size(); ++n) row_->together += pixels[n] != group.expected[n];
    }

    bool perspective_;
    StressRow* row_;
    std::vector<std::uint32_t> pixels_;  ///< all kNone between two triangles
    std::map<std::pair<int, int>, RasterTexels> addresses_;
    std::map<std::tuple<int, int, int, int, int, int>, Together> groups_;
};

}  // namespace

StressRow stress_fast(const Family& family, StressMode mode, std::uint64_t seed, int shapes) {
    StressRow row{.family = &family, .mode = mode, .method = "fast", .number = ""};
    FastRun run(mode, row);
    for (int n = 0; n < shapes; ++n) run.shape(shape_at(family, mode, seed, n));
    run.finish();
    return row;
}

}  // namespace texelscope
