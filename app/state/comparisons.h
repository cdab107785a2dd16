// A method beside another: its error against perspective, its operations, its picture.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>

#include "core/measure/bill.h"
#include "core/method/drawing.h"

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

/// Why two runs read different texels for a pixel. Whether it is rounding is asked of the same two runs in numbers
/// that do not round: exact ones, or double in a window of more than kMaxExact pixels.
enum class Cause : std::uint8_t {
    nothing,   ///< neither draws it
    same,      ///< both read the same texel
    coverage,  ///< only one of them draws it, without rounding too
    rounding,  ///< without rounding both draw it or neither, with (u, v) less than kRounding apart; of a method driven
               ///< by its texture, which rounds the place of a texel to a pixel, no farther than half a pixel
    offset,    ///< without rounding (u, v) are as far apart as in all pixels of the polygon
    warp,      ///< that distance changes from pixel to pixel: another plane, or perspective against affine
};
inline constexpr std::size_t kCauses = 6;
inline constexpr double kRounding = 1e-6;      ///< [texels]
inline constexpr Integer kMaxExact = 1 << 10;  ///< [px]; exact numbers are slow

struct DifferenceCell {
    Cause cause = Cause::nothing;
    std::optional<Rgb> own, others;  ///< the two pictures; nothing where the run draws nothing
    double u = 0, v = 0;             ///< (u, v) of the state's run minus the other's [texels]; where both draw it
};
/// The pictures of two runs over one scene, each pixel as its last write left it.
struct Difference {
    Window window;
    DrawSettings other;
    Grid<DifferenceCell> cells;
    std::array<int, kCauses> count{};  ///< cells of each cause

    [[nodiscard]] int of(Cause cause) const { return count[static_cast<std::size_t>(cause)]; }
};
/// @param window  its part inside the frame is compared.
[[nodiscard]] Difference compare(const Drawing& own, const DrawSettings& other, const Window& window);

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
