// What a method is, whatever its numbers and loops: how it is found, run over a shape, and visited step by step.
// One file a method registers itself; the command line, the window and the law tests pick it up unasked.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/geometry/vertex.h"
#include "core/image/texture.h"
#include "core/method/layer.h"
#include "core/number/format.h"
#include "core/number/real.h"
#include "core/trace/fate.h"
#include "core/trace/listing.h"
#include "core/trace/partial.h"
#include "core/trace/recording.h"
#include "core/trace/trace.h"

namespace texelscope {

enum class QuirkKind : std::uint8_t {
    printed,  ///< the source has it, and so has the variant as printed
    form,     ///< no fault: the same samples in another order of loops
    other,    ///< another choice that one may want to see
};

/// A named departure from the corrected method.
struct QuirkInfo {
    std::string_view id;        ///< "Q1" … as methods number them, or a word for a form
    std::string_view field;     ///< `quirk.field` in the source
    std::string_view title;     ///< a few words for a switch
    std::string_view sentence;  ///< what it does
    QuirkKind kind = QuirkKind::printed;
};

/// Bit n is quirk n of the method's list.
using QuirkSet = std::uint32_t;

struct VariantInfo {
    std::string_view id;  ///< "as-printed", "as-published", "corrected"
    QuirkSet quirks;
};

/// One shape to draw, and how.
struct Job {
    std::span<const Vertex> corners;  ///< three for methods over triangles; finite, w > 0
    const Texture* texture = nullptr;
    float light = 1;
    bool cull_back = false;
    Rect frame;
    QuirkSet quirks = 0;
    NumberMode mode;
    int shape = 0;                          ///< its number in the drawing
    bool half = false;                      ///< half-transparent: a layer blends its samples
    std::span<const glm::dvec2> unrounded;  ///< as Unrounded::corners, one for each of `corners`; or empty
    double unrounded_light = 1;             ///< the same of `light`; used where `unrounded` is not empty
};

/// What a method says of one sample, in plain numbers.
struct Sample {
    Integer x = 0, y = 0;  ///< absolute pixel
    Fate fate = Fate::written;
    Note note = Note::none;
    double u = 0, v = 0;      ///< before wrapping [texels]; where written
    int column = 0, row = 0;  ///< texel after wrapping; where written
    Rgb colour{};
};
using Put = std::function<void(const Sample&)>;

struct Method {
    std::string_view id, title, source;  ///< "edge-equations", "Edge equations", "S1"
    std::string_view listing;            ///< path of its source file, as embedded
    bool triangles = true;               ///< takes triangles; else whole convex polygons
    bool plane = false;     ///< takes the polygon as part of a plane: three corners say how the texture lies
    bool scatters = false;  ///< driven by the texture: holes, pixels written again, samples anywhere
    QuirkSet strays = 0;    ///< quirks under which a sample may lie outside the shape's box
    std::span<const QuirkInfo> quirks;
    std::span<const VariantInfo> variants;  ///< the last is the corrected one

    /// Draws into `picture` (its top left at job.frame's); the plain loop, nobody watching.
    Fate (*render)(NumberFormat, const Job&, Image& picture);
    /// Adds the written samples of a part of the layer's window, under those of later shapes; a half-transparent
    /// shape's blended with what stands there.
    Fate (*paint)(NumberFormat, const Job&, const Window& part, int shape, Layer&);
    /// Every sample visited inside the window, rejected ones too, in drawing order.
    Fate (*samples)(NumberFormat, const Job&, const Window&, const Put&);
    /// The same as far as `target` and no further, counting how often each line ran.
    LineCounts (*until)(NumberFormat, const Job&, const Window&, const Path& target, const Put&);
    /// One unit of the step tree, recorded.
    Visit (*visit)(NumberFormat, const Job&, const Path&);

    /// Whether a sample may lie outside the shape's box.
    [[nodiscard]] constexpr bool may_stray(QuirkSet switches) const { return scatters || (switches & strays) != 0; }
};

/// In order of their ids. Filled before main by RegisterMethod.
[[nodiscard]] std::span<const Method* const> methods();
/// Null where there is none of that id.
[[nodiscard]] const Method* find_method(std::string_view id);
/// What draws a scene for which nobody asks for another: edge equations.
[[nodiscard]] const Method& default_method();
[[nodiscard]] const VariantInfo* find_variant(const Method& method, std::string_view id);
/// The variant's quirks; those of the corrected one where it is unknown.
[[nodiscard]] QuirkSet quirks_of(const Method& method, std::string_view variant);

/// The line of the method's listing that causes the quirk: where `// Q1`, its id, stands at the end, else the first
/// line that asks for it. 0 where none does.
[[nodiscard]] int guilty_line(const Listing& listing, const QuirkInfo& quirk);
/// The line that a lesson or a person means: "quirk.FIELD" alone is that quirk's guilty line, other text stands where
/// it is found first. 0 where nowhere.
[[nodiscard]] int find_line(const Method& method, const Listing& listing, std::string_view text);

struct RegisterMethod {
    explicit RegisterMethod(const Method& method);
};

}  // namespace texelscope
