// A triangle's u and v in 128-bit whole numbers: between double and core/exact/triangle.h, thirty times as fast as
// that, for corners whose numbers are not too unlike. Also how far from a texel's border a sample is that does not lie
// on it.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/exact/triangle.h"

namespace texelscope {

class WideTriangle {
public:
    /// Nothing where 128 bits are not enough. Parameters as ExactTriangle's; pixel (0, 0) is at (x0, y0).
    [[nodiscard]] static std::optional<WideTriangle> make(std::span<const Vertex, 3> corners, int u_texels,
                                                          int v_texels, int x0, int y0);

    [[nodiscard]] TexelIndex texel(int x, int y) const;

    /// u, and v, of all samples inside either lie on a border of texels or are at least so far from it [texels]. 0
    /// where that is not known: finding out would take long, and the gap would be too small to be of use.
    struct Gaps {
        double u = 0, v = 0;
    };
    [[nodiscard]] Gaps gaps() const;

private:
    __extension__ using Wide = __int128;
    /// x i + y j + one at pixel (i, j).
    struct Plane {
        Wide x = 0, y = 0, one = 0;
        [[nodiscard]] Wide at(int column, int line) const { return x * column + y * line + one; }
    };
    [[nodiscard]] static double gap(const Plane& top, const Plane& bottom, Wide most);

    Plane u_, v_;                   ///< over u_one_ and v_one_: texels
    Plane u_one_, v_one_;           ///< positive inside
    Wide u_most_ = 0, v_most_ = 0;  ///< of u_one_ and v_one_, at the corners
};

}  // namespace texelscope
