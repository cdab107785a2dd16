// Colours as numbers: contrast, difference and colour-vision deficiencies, for the theme's promises.
#pragma once

#include <array>
#include <cstdint>

#include <imgui.h>

namespace texelscope::ui {

using Color = ImU32;  ///< red in the lowest byte, alpha in the highest, not premultiplied

/// The opaque colour written 0xRRGGBB.
[[nodiscard]] constexpr Color hex(std::uint32_t rgb) {
    return 0xFF000000U | ((rgb & 0xFFU) << 16U) | (rgb & 0xFF00U) | ((rgb >> 16U) & 0xFFU);
}

/// `c` with its alpha multiplied by `alpha` [0, 1].
[[nodiscard]] constexpr Color with_alpha(Color c, float alpha) {
    const auto a = static_cast<std::uint32_t>(static_cast<float>(c >> 24U) * alpha + 0.5F);
    return (c & 0xFFFFFFU) | (a << 24U);
}

/// What is seen of `c` with `alpha` [0, 1] over an opaque ground; opaque.
[[nodiscard]] Color over(Color c, float alpha, Color ground);

/// WCAG 2 contrast of two opaque colours, 1 to 21.
[[nodiscard]] double contrast(Color a, Color b);

struct Lab {
    double l = 0, a = 0, b = 0;  ///< CIE 1976, white D65
};

enum class Sight : std::uint8_t { normal, protan, deutan, tritan };
inline constexpr std::array kSights{Sight::normal, Sight::protan, Sight::deutan, Sight::tritan};

/// The opaque colour as an eye with this sight has it.
/// Source: Machado, Oliveira, Fernandes 2009, severity 1, applied in linear light.
[[nodiscard]] Lab seen(Color c, Sight sight);

/// CIEDE2000, all weights 1. Source: Sharma, Wu, Dalal 2005.
[[nodiscard]] double difference(const Lab& x, const Lab& y);

}  // namespace texelscope::ui
