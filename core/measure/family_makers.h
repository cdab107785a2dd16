// The makers of the families: what each is for stands in families.cpp. For that file alone.
#pragma once

#include <cstdint>

#include "core/measure/families.h"

namespace texelscope::family {

// family_triangles.cpp
[[nodiscard]] HardShape random(std::uint64_t seed);
[[nodiscard]] HardShape on_a_grid(std::uint64_t seed);
[[nodiscard]] HardShape on_centres(std::uint64_t seed);
[[nodiscard]] HardShape through_centres(std::uint64_t seed);
[[nodiscard]] HardShape near_ties(std::uint64_t seed);
[[nodiscard]] HardShape ratios(std::uint64_t seed);
[[nodiscard]] HardShape denormal(std::uint64_t seed);
[[nodiscard]] HardShape opened_lines(std::uint64_t seed);
[[nodiscard]] HardShape thin(std::uint64_t seed);
[[nodiscard]] HardShape tiny(std::uint64_t seed);
[[nodiscard]] HardShape nearly_in_line(std::uint64_t seed);
[[nodiscard]] HardShape without_area(std::uint64_t seed);
[[nodiscard]] HardShape truncated(std::uint64_t seed);
[[nodiscard]] HardShape not_finite(std::uint64_t seed);
[[nodiscard]] HardShape huge(std::uint64_t seed);
[[nodiscard]] HardShape long_legs(std::uint64_t seed);
[[nodiscard]] HardShape offset(std::uint64_t seed);
[[nodiscard]] HardShape far_offset(std::uint64_t seed);
[[nodiscard]] HardShape long_rows(std::uint64_t seed);
[[nodiscard]] HardShape steep(std::uint64_t seed);
[[nodiscard]] HardShape extreme_depths(std::uint64_t seed);
[[nodiscard]] HardShape equal_depths(std::uint64_t seed);
[[nodiscard]] HardShape nearly_equal_depths(std::uint64_t seed);
[[nodiscard]] HardShape whole_depths(std::uint64_t seed);
[[nodiscard]] HardShape big_indices(std::uint64_t seed);
[[nodiscard]] HardShape any_texture(std::uint64_t seed);
[[nodiscard]] HardShape small_textures(std::uint64_t seed);
[[nodiscard]] HardShape minified(std::uint64_t seed);
[[nodiscard]] HardShape magnified(std::uint64_t seed);
[[nodiscard]] HardShape level_texture(std::uint64_t seed);
[[nodiscard]] HardShape borders(std::uint64_t seed);
[[nodiscard]] HardShape class_limits(std::uint64_t seed);
[[nodiscard]] HardShape orders(std::uint64_t seed);
[[nodiscard]] HardShape layers(std::uint64_t seed);
// family_meshes.cpp
[[nodiscard]] HardShape blit(std::uint64_t seed);
[[nodiscard]] HardShape fan(std::uint64_t seed);
[[nodiscard]] HardShape grid(std::uint64_t seed);
[[nodiscard]] HardShape fine_grid(std::uint64_t seed);

}  // namespace texelscope::family
