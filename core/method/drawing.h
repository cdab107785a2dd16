// A scene together with the method that draws it: shapes in order, pictures, samples, steps.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/method/method.h"
#include "core/scene/scene.h"

namespace texelscope {

/// How a scene is drawn. A value: the window keeps one in its state.
struct DrawSettings {
    const Method* method = nullptr;
    NumberFormat format = NumberFormat::f64;
    QuirkSet quirks = 0;
    NumberMode mode;
    friend bool operator==(const DrawSettings&, const DrawSettings&) = default;
};

/// A scene cut into the shapes that the method takes. Refers to the scene, which must outlive it.
class Drawing {
public:
    Drawing(const Scene& scene, const DrawSettings& settings);

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const DrawSettings& settings() const { return settings_; }
    [[nodiscard]] int shape_count() const { return static_cast<int>(shapes_.size()); }
    /// Index of the polygon that shape `shape` was cut from.
    [[nodiscard]] int polygon_of(int shape) const { return shapes_[static_cast<std::size_t>(shape)].polygon; }
    /// The first shape cut from a polygon; shape_count() where it has none.
    [[nodiscard]] int first_shape_of(int polygon) const;
    [[nodiscard]] std::span<const Vertex> corners(int shape) const;
    /// For each corner of a shape, which vertex of its polygon it is.
    [[nodiscard]] int vertex_of(int shape, int corner) const;
    [[nodiscard]] Job job(int shape) const;
    /// Why the shape is not handed to the method at all, or `written`.
    [[nodiscard]] Fate refusal(int shape) const;
    /// The part of the frame that the shape's samples may lie in.
    [[nodiscard]] Rect reach(int shape) const;
    /// The shape is half-transparent: its samples blend with what stands in the picture (core/method/blend.h).
    [[nodiscard]] bool is_half(int shape) const {
        return scene_->polygons[static_cast<std::size_t>(polygon_of(shape))].half;
    }
    /// Some shape is, so that a pixel may show more than the last sample written to it.
    [[nodiscard]] bool has_half() const { return has_half_; }
    /// Whether any sample of the shape can lie in `rect`.
    [[nodiscard]] bool touches(int shape, const Rect& rect) const;

private:
    struct Shape {
        int polygon = 0;
        std::size_t first = 0, count = 0;  ///< in corners_
    };
    [[nodiscard]] std::span<const glm::dvec2> unrounded(int shape) const;

    const Scene* scene_;
    DrawSettings settings_;
    std::vector<Shape> shapes_;
    std::vector<Vertex> corners_;
    std::vector<glm::dvec2> unrounded_;  ///< at the same places, of polygons that have them
    bool has_half_ = false;
};

/// The whole picture.
[[nodiscard]] Image render(const Drawing& drawing);
/// The same over what stands in `picture`, which is as large as the frame.
void draw_into(const Drawing& drawing, Image& picture);
/// One shape over what stands in `picture`, by its own method's loops. Not for a scene with a depth test.
void draw_shape(const Drawing& drawing, int shape, Image& picture);

using PutInShape = std::function<void(int shape, const Sample&)>;
/// Every sample of shapes [first, last) inside the window, in drawing order, the depth test applied (it needs
/// all earlier shapes, so `first` is 0 where the scene has one).
void each_sample(const Drawing& drawing, int first, int last, const Window& window, const PutInShape& put);

/// The same from shape `first` to the one in `path`, and that one as far as the path's unit and no further.
/// @return  how often each line of the listing ran in the last shape.
LineCounts each_sample_until(const Drawing& drawing, int first, const Path& path, const Window& window,
                             const PutInShape& put);

/// Puts a written sample of the layer's window over what stands there.
void add_sample(const Drawing& drawing, int shape, const Sample& s, Layer& layer);

/// One unit, recorded. A path whose shape does not exist is not found.
[[nodiscard]] Visit visit(const Drawing& drawing, const Path& path);

}  // namespace texelscope
