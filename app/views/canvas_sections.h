// The sections of a convex polygon, as its method's stages tell them: for the canvas and for the face beside it.
#pragma once

#include <vector>

#include "app/state/derived.h"

namespace texelscope::canvas {

/// A corner of the ring as the method took it.
struct RingCorner {
    double x = 0, y = 0, u = 0, v = 0;
};

/// Where a row meets a side: x on the screen and (u, v) on the texture.
struct RingPoint {
    double x = 0, u = 0, v = 0;
};

struct SectionShape {
    int stage = 0;                                             ///< of the shape's stages
    Integer first = 0, last = 0;                               ///< rows, half-open
    RingPoint left_top, right_top, left_bottom, right_bottom;  ///< where its first and its last height meet the sides
    bool current = false;                                      ///< the cursor stands in it
    bool begun = false;                                        ///< the cursor has come to it
};

struct SectionPicture {
    std::vector<RingCorner> ring;
    std::vector<SectionShape> sections;
};

/// At most kMostSections of them; none where the method has no sections.
inline constexpr std::size_t kMostSections = 32;
[[nodiscard]] SectionPicture sections_of(const Derived& derived);

/// Whether the pointer called "left" runs down the right side of the current section.
[[nodiscard]] bool runs_leftward(const SectionPicture& picture);

/// The point of the straight side from `a` to `b` at height `y`, kept between them.
[[nodiscard]] RingPoint at_height(const RingCorner& a, const RingCorner& b, double y);

}  // namespace texelscope::canvas
