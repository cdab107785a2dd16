// Why a unit ended as it did: a sample, or a whole shape.
#pragma once

#include <cstdint>
#include <string_view>

namespace texelscope {

enum class Fate : std::uint8_t {
    written,         ///< the sample's colour went to the framebuffer; of a shape: it was drawn
    outside_edge_a,  ///< rejected by side A, from P0 to P1
    outside_edge_b,  ///< rejected by side B, from P1 to P2
    outside_edge_c,  ///< rejected by side C, from P2 to P0
    outside_box,     ///< never visited: it lies outside every range that the method walks
    depth_failed,    ///< something nearer was there
    zero_area,       ///< Δ = 0: the corners lie on a line
    culled,          ///< a back face
    off_screen,      ///< no part of it reaches the framebuffer
    not_finite,      ///< a coordinate is NaN or infinite
    behind_eye,      ///< w <= 0
    undefined,       ///< a result has no value: NaN, or x / 0
    too_large,       ///< it repeats its texture too often for a method that runs over all its texels
};

/// "written", "outside A", …: one string for the screen, `trace` and the tests.
[[nodiscard]] std::string_view text_of(Fate fate);

[[nodiscard]] constexpr Fate outside_edge(int side) noexcept {
    return static_cast<Fate>(static_cast<int>(Fate::outside_edge_a) + side);
}

/// A quirk's mark on a sample.
enum class Note : std::uint8_t {
    none,
    ghost,  ///< a stale slot of the row buffer was drawn (sections, Q1)
};
[[nodiscard]] std::string_view text_of(Note note);

}  // namespace texelscope
