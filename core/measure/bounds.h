// How far off u and v may be in each rung of core/measure/rungs.h: what each publishes, derived, never measured. All
// assume that no number overflows or becomes denormal, and pixels of fewer than 23 bits.
#pragma once

#include <span>

#include "core/geometry/vertex.h"

namespace texelscope::bounds {

inline constexpr double kFloat = 0x1p-24, kDouble = 0x1p-53;  ///< the greatest relative error of one operation

using Corners = std::span<const Vertex, 3>;
/// For every sample that the triangle owns: the greatest |Δu| or |Δv| [texels]; infinite where nothing can be promised,
/// as where the sign of the area is in doubt. Three corners that are not in line.
using Bound = double (*)(Corners);

/// u = X u_x + Y u_y + u_k: edge equations.
[[nodiscard]] double direct_float(Corners corners);
[[nodiscard]] double direct_double(Corners corners);
/// u = u_0 + (X − x_0) u_x + (Y − y_0) u_y.
[[nodiscard]] double based_float(Corners corners);
[[nodiscard]] double based_double(Corners corners);
/// The row's first sample as in direct_float, then u += u_x.
[[nodiscard]] double additions_float(Corners corners);
/// TileBased: based_double at a tile, what is left of it in float.
[[nodiscard]] double tile_float(Corners corners);
/// FixedSteps: a row's start and slope to the nearest 2^-16.
[[nodiscard]] double fixed_16_16(Corners corners);

/// Newton: the reciprocal of 1/w from an estimate of 12 bits.
[[nodiscard]] double newton_0(Corners corners);
[[nodiscard]] double newton_1(Corners corners);
[[nodiscard]] double newton_2(Corners corners);
/// Subdivided, in double.
[[nodiscard]] double every_8(Corners corners);
[[nodiscard]] double every_16(Corners corners);
[[nodiscard]] double every_32(Corners corners);
[[nodiscard]] double adaptive(Corners corners);

[[nodiscard]] double none(Corners corners);  ///< 0: exact

/// Affine for perspective where depths differ by the ratio r and u by `range`: at most range (√r − 1) / (√r + 1).
/// Derivation  Affine u is Σ b_i u_i, in perspective Σ p_i u_i with p_i = b_i q_i / Σ b q, q = 1/w: two distributions
///             over the corners. Their means differ by at most `range` times the share by which the distributions
///             differ, which is greatest where b sits on the nearest and the farthest corner: b (1 − b) (r − 1) /
///             (1 + b (r − 1)), greatest at b = 1 / (√r + 1).
[[nodiscard]] double affine_for_perspective(double range, double r);

}  // namespace texelscope::bounds
