#include "core/method/drawing.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/polygon.h"
#include "core/method/blend.h"
#include "core/method/depth.h"
#include "core/method/fast_picture.h"
#include "core/method/shortcut.h"

namespace texelscope {
namespace {

/// Depths of what has been drawn so far, over a window.
class DepthBuffer {
public:
    explicit DepthBuffer(const Rect& rect) : rect_(rect), nearest_(rect.width(), rect.height(), 1.0F) {}
    [[nodiscard]] bool passes(const DepthPlane& plane, Integer x, Integer y) {
        float& nearest = nearest_.at(static_cast<int>(x) - rect_.x0, static_cast<int>(y) - rect_.y0);
        const float z = plane.at(x, y);
        if (!(z < nearest)) return false;
        nearest = z;
        return true;
    }

private:
    Rect rect_;
    Grid<float> nearest_;
};

/// The samples of a window that lie in the frame: its stride still counts from the window's own corner.
[[nodiscard]] Window inside_frame(const Window& window, const Rect& frame) {
    const auto start = [&](int low, int edge) {
        const int missing = low < edge ? (edge - low) % window.stride : 0;
        return std::max(low, edge) + (missing > 0 ? window.stride - missing : 0);
    };
    Rect rect = intersection(window.rect, frame);
    rect.x0 = start(window.rect.x0, frame.x0), rect.y0 = start(window.rect.y0, frame.y0);
    return {rect, window.stride};
}

/// Draws shapes inside a window one after the other, with the scene's depth test.
class WindowRun {
public:
    WindowRun(const Drawing& drawing, const Window& window)
        : drawing_(&drawing),
          window_(inside_frame(window, drawing.scene().framebuffer.rect())),
          depth_(drawing.scene().depth == Depth::less),
          buffer_(depth_ ? window_.rect : Rect{}) {}

    void shape(int n, const PutInShape& put) {
        if (window_.rect.empty() || drawing_->refusal(n) != Fate::written || !drawing_->touches(n, window_.rect))
            return;
        const Job job = drawing_->job(n);
        drawing_->settings().method->samples(drawing_->settings().format, job, window_, tested(n, job, put));
    }
    LineCounts shape_until(int n, const Path& path, const PutInShape& put) {
        if (window_.rect.empty() || drawing_->refusal(n) != Fate::written) return {};
        const Job job = drawing_->job(n);
        return drawing_->settings().method->until(drawing_->settings().format, job, window_, path, tested(n, job, put));
    }

private:
    [[nodiscard]] Put tested(int n, const Job& job, const PutInShape& put) {
        if (!depth_) return [n, &put](const Sample& s) { put(n, s); };
        return [this, n, &put, plane = depth_plane(job.corners)](const Sample& s) {
            if (s.fate != Fate::written || buffer_.passes(plane, s.x, s.y)) return put(n, s);
            Sample hidden = s;
            hidden.fate = Fate::depth_failed;
            put(n, hidden);
        };
    }

    const Drawing* drawing_;
    Window window_;
    bool depth_;
    DepthBuffer buffer_;
};

}  // namespace

Drawing::Drawing(const Scene& scene, const DrawSettings& settings) : scene_(&scene), settings_(settings) {
    if (shortcut_of(*settings.method) != nullptr) settings_.format = NumberFormat::exact;
    for (std::size_t n = 0; n < scene.polygons.size(); ++n) {
        const std::vector<Vertex>& vertices = scene.polygons[n].vertices;
        const std::vector<glm::dvec2>& places = scene.polygons[n].unrounded.corners;
        if (vertices.size() < 3) continue;
        has_half_ = has_half_ || scene.polygons[n].half;
        if (!places.empty()) unrounded_.resize(corners_.size());
        if (!settings.method->triangles) {
            shapes_.push_back({static_cast<int>(n), corners_.size(), vertices.size()});
            corners_.insert(corners_.end(), vertices.begin(), vertices.end());
            unrounded_.insert(unrounded_.end(), places.begin(), places.end());
            continue;
        }
        for (std::size_t k = 2; k < vertices.size(); ++k) {
            shapes_.push_back({static_cast<int>(n), corners_.size(), 3});
            corners_.insert(corners_.end(), {vertices[0], vertices[k - 1], vertices[k]});
            if (!places.empty()) unrounded_.insert(unrounded_.end(), {places[0], places[k - 1], places[k]});
        }
    }
}

std::span<const glm::dvec2> Drawing::unrounded(int shape) const {
    const Shape& s = shapes_[static_cast<std::size_t>(shape)];
    if (scene_->polygons[static_cast<std::size_t>(s.polygon)].unrounded.corners.empty()) return {};
    return std::span(unrounded_).subspan(s.first, s.count);
}

int Drawing::first_shape_of(int polygon) const {
    const auto found = std::lower_bound(shapes_.begin(), shapes_.end(), polygon,
                                        [](const Shape& shape, int wanted) { return shape.polygon < wanted; });
    return static_cast<int>(found - shapes_.begin());
}

std::span<const Vertex> Drawing::corners(int shape) const {
    const Shape& s = shapes_[static_cast<std::size_t>(shape)];
    return std::span(corners_).subspan(s.first, s.count);
}

int Drawing::vertex_of(int shape, int corner) const {
    if (!settings_.method->triangles || corner == 0) return corner;
    return shape - first_shape_of(polygon_of(shape)) + corner;
}

Job Drawing::job(int shape) const {
    const Polygon& polygon = scene_->polygons[static_cast<std::size_t>(polygon_of(shape))];
    return {.corners = corners(shape),
            .texture = scene_->textures[static_cast<std::size_t>(polygon.texture)].get(),
            .light = polygon.light,
            .cull_back = scene_->cull == Cull::back,
            .frame = scene_->framebuffer.rect(),
            .quirks = settings_.quirks,
            .mode = settings_.mode,
            .shape = shape,
            .half = polygon.half,
            .unrounded = unrounded(shape),
            .unrounded_light = polygon.unrounded.light};
}

Fate Drawing::refusal(int shape) const {
    const Polygon& polygon = scene_->polygons[static_cast<std::size_t>(polygon_of(shape))];
    if (!std::isfinite(polygon.light)) return Fate::not_finite;
    for (const Vertex& corner : polygon.vertices) {
        if (!is_finite(corner)) return Fate::not_finite;
        if (!(corner.w > 0)) return Fate::behind_eye;
    }
    return Fate::written;
}

Rect Drawing::reach(int shape) const {
    const Rect frame = scene_->framebuffer.rect();
    if (settings_.method->may_stray(settings_.quirks)) return frame;
    float x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
    for (const Vertex& p : corners(shape)) {
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    // One pixel more on each side: methods as printed round outward, and coarse number formats move corners.
    const auto within = [](double a, int low, int high) { return static_cast<int>(std::clamp<double>(a, low, high)); };
    return {within(std::floor(x0) - 1, frame.x0, frame.x1), within(std::floor(y0) - 1, frame.y0, frame.y1),
            within(std::floor(x1) + 2, frame.x0, frame.x1), within(std::floor(y1) + 2, frame.y0, frame.y1)};
}

bool Drawing::touches(int shape, const Rect& rect) const { return !intersection(reach(shape), rect).empty(); }

Image render(const Drawing& drawing) {
    const Framebuffer& frame = drawing.scene().framebuffer;
    Image picture(frame.width, frame.height, frame.clear);
    draw_into(drawing, picture);
    return picture;
}

namespace {

/// Shapes [first, last) by their samples.
void draw_samples(const Drawing& drawing, int first, int last, Image& picture) {
    const Rect frame = drawing.scene().framebuffer.rect();
    each_sample(drawing, first, last, {frame, 1}, [&](int shape, const Sample& s) {
        if (s.fate != Fate::written) return;
        Rgb& pixel = picture.at(static_cast<int>(s.x) - frame.x0, static_cast<int>(s.y) - frame.y0);
        pixel = blended(pixel, s.colour, drawing.is_half(shape));
    });
}

}  // namespace

void draw_into(const Drawing& drawing, Image& picture) {
    TEXELSCOPE_ASSERT(picture.width() == drawing.scene().framebuffer.width);
    TEXELSCOPE_ASSERT(picture.height() == drawing.scene().framebuffer.height);
    if (drawing.scene().depth == Depth::less) return draw_samples(drawing, 0, drawing.shape_count(), picture);
    if (draws_the_same_as_fast(drawing.settings())) return draw_fast(drawing, picture);
    for (int n = 0; n < drawing.shape_count(); ++n) draw_shape(drawing, n, picture);
}

void draw_shape(const Drawing& drawing, int shape, Image& picture) {
    if (drawing.is_half(shape)) return draw_samples(drawing, shape, shape + 1, picture);
    if (drawing.refusal(shape) != Fate::written || !drawing.touches(shape, drawing.scene().framebuffer.rect())) return;
    drawing.settings().method->render(drawing.settings().format, drawing.job(shape), picture);
}

void each_sample(const Drawing& drawing, int first, int last, const Window& window, const PutInShape& put) {
    WindowRun run(drawing, window);
    for (int n = first; n < last; ++n) run.shape(n, put);
}

LineCounts each_sample_until(const Drawing& drawing, int first, const Path& path, const Window& window,
                             const PutInShape& put) {
    if (path.empty()) return {};
    WindowRun run(drawing, window);
    const int shape = static_cast<int>(std::clamp<Integer>(path.parts[0].index, 0, drawing.shape_count()));
    for (int n = first; n < shape; ++n) run.shape(n, put);
    return shape < drawing.shape_count() ? run.shape_until(shape, path, put) : LineCounts{};
}

Visit visit(const Drawing& drawing, const Path& path) {
    Visit nowhere;
    nowhere.path = path.unit();
    nowhere.units.resize(1);
    nowhere.found =
        !path.empty() && path.depth() == 1 && path.parts[0].index >= 0 && path.parts[0].index < drawing.shape_count();
    if (path.empty() || path.parts[0].index < 0 || path.parts[0].index >= drawing.shape_count()) return nowhere;
    const int shape = static_cast<int>(path.parts[0].index);
    nowhere.shape_fate = drawing.refusal(shape);
    if (nowhere.shape_fate != Fate::written) return nowhere;
    Visit found = drawing.settings().method->visit(drawing.settings().format, drawing.job(shape), path);
    const bool drawn = found.shape_fate != Fate::written || drawing.touches(shape, drawing.scene().framebuffer.rect());
    if (!drawn) found.shape_fate = Fate::off_screen;
    return found;
}

}  // namespace texelscope
