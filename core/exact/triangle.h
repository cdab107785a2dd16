// Which samples a triangle owns, which texel each reads and how deep it lies, decided exactly from float32 corners: the
// reference for every error figure, and where the fast rasterizer goes with what it cannot decide. Slow and obvious:
// all of it is whole numbers, the corners' coordinates in units of the smallest of their last bits.
#pragma once

#include <array>
#include <span>

#include <boost/multiprecision/cpp_int.hpp>

#include "core/geometry/vertex.h"
#include "core/number/real.h"

namespace texelscope {

/// A texel before wrapping: (floor(u), floor(v)); beyond 64 bits the nearest end.
struct TexelIndex {
    Integer u = 0, v = 0;
    friend bool operator==(const TexelIndex&, const TexelIndex&) = default;
};

/// Pixels [x0, x1) of a row; x0 >= x1: none.
struct PixelRange {
    Integer x0 = 0, x1 = 0;
    [[nodiscard]] bool empty() const { return x0 >= x1; }
    friend bool operator==(const PixelRange&, const PixelRange&) = default;
};

class ExactTriangle {
public:
    /// Requires finite numbers and w > 0. `u_texels` and `v_texels`: how many texels one unit of u and v is.
    explicit ExactTriangle(std::span<const Vertex, 3> corners, int u_texels = 1, int v_texels = 1);

    /// The sign of the doubled area: 1 for a front face (core/conventions.h), 0 for corners in line.
    [[nodiscard]] int winding() const { return winding_; }

    /// The samples of row `y` that the triangle owns by the top-left rule, inside [x0, x1). All that is empty where the
    /// winding is 0.
    [[nodiscard]] PixelRange row(Integer y, Integer x0, Integer x1) const;

    /// The texel of a sample inside the triangle or on its sides. Perspective where the corners' w differ.
    [[nodiscard]] TexelIndex texel(Integer x, Integer y) const;

    /// z of any sample, affine over the screen, rounded to the nearest float32, halves to even.
    [[nodiscard]] float depth(Integer x, Integer y) const;

private:
    /// Coordinates of 5 words and products of four of them stay inside without touching the heap.
    using Whole =
        boost::multiprecision::number<boost::multiprecision::cpp_int_backend<1024>, boost::multiprecision::et_off>;
    /// a = x X + y Y + one at the sample (X/2, Y/2), X and Y odd.
    struct Plane {
        Whole x, y, one;
        [[nodiscard]] Whole at(Integer column, Integer line) const;
    };

    /// The plane that has `value[n]` times the doubled area at corner n: the sides' planes, weighted.
    [[nodiscard]] Plane weighted(const std::array<Whole, 3>& value) const;

    int winding_ = 0;
    std::array<Plane, 3> side_;   ///< doubled area with the sample across from corner n, positive inside
    std::array<bool, 3> owns_{};  ///< the samples on that side
    Whole area_;                  ///< doubled, in the unit of side_; positive
    Plane u_, v_, one_;           ///< u/w, v/w and 1/w, in one unit: u = u_ / one_ * 2^u_exponent_
    Plane z_;                     ///< z = z_ / area_ * 2^z_exponent_
    int u_exponent_ = 0, v_exponent_ = 0, z_exponent_ = 0;
};

}  // namespace texelscope
