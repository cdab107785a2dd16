// What Derived tells of a method beside another: its error against perspective, its operations, its picture.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>

#include "core/measure/bill.h"
#include "core/method/method.h"

namespace texelscope {

/// How far the texel coordinates of a pixel lie from those in perspective.
struct UvError {
    enum class Kind : std::uint8_t { nothing, one_only, both };
    Kind kind = Kind::nothing;  ///< who draws the pixel: neither, one of the two runs, or both
    double u = 0, v = 0;        ///< the settings' minus the reference's [texels]; where both draw it

    [[nodiscard]] double length() const;  ///< [texels]
};

/// The error of every pixel of a window against the reference: barycentric weights in perspective, in double, whose
/// own error is far below what a colour shows. With barycentric itself its other quirks stay as they are.
struct ErrorMap {
    Window window;
    Grid<UvError> cells;
    std::optional<glm::ivec2> worst;  ///< the absolute pixel; nothing where no pixel is drawn by both
    UvError error;                    ///< there, the reference run in exact numbers
    double v_most = 0;                ///< greatest |v| of all cells [texels]
};

/// Why two methods read different texels for a pixel. The first that fits is the cause.
enum class Cause : std::uint8_t {
    nothing,   ///< neither draws it
    same,      ///< both read the same texel
    coverage,  ///< only one of them draws it
    rounding,  ///< (u, v) are less than kRounding apart, on two sides of a texel's border
    offset,    ///< (u, v) are as far apart as in all pixels of the polygon
    warp,      ///< the distance changes from pixel to pixel: another plane, or perspective against affine
};
inline constexpr std::size_t kCauses = 6;
inline constexpr double kRounding = 1e-6;  ///< [texels]

struct DifferenceCell {
    Cause cause = Cause::nothing;
    Rgb own{}, others{};  ///< the two pictures
    double u = 0, v = 0;  ///< (u, v) of the state's method minus the other's [texels]; where both draw it
};
/// The pictures of two methods over one scene, each pixel as its last write left it.
struct Difference {
    Window window;
    const Method* other = nullptr;
    Grid<DifferenceCell> cells;
    std::array<int, kCauses> count{};  ///< cells of each cause
};

/// What a method does to draw the cursor's polygon, counted on the tape of one pixel: every pixel and every line of
/// samples does the same. Of pixels it is known what they add, so the sums are what the whole run does.
struct MethodCost {
    const Method* method = nullptr;
    bool current = false;               ///< the state's own, with its quirks; others run corrected
    bool columns = false;               ///< its lines of samples are columns
    OperationCount pixel, line, setup;  ///< of one pixel; of one line without its pixels; before all lines
    Integer line_pixels = 0;            ///< in the cursor's line, or one in the middle
    Integer lines = 0, pixels = 0;      ///< of the polygon

    [[nodiscard]] OperationCount whole_line() const { return line + line_pixels * pixel; }
    [[nodiscard]] OperationCount whole() const { return setup + lines * line + pixels * pixel; }
};

}  // namespace texelscope
