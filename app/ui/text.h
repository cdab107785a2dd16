// Lines of text: decoding, measuring, shortening, breaking and drawing.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/color.h"
#include "app/ui/fonts.h"
#include "app/ui/geometry.h"

namespace texelscope::ui {

inline constexpr std::string_view kEllipsis = "…";

/// Reads the code point at `at` and moves past it. A byte that belongs to no valid UTF-8 is U+FFFD.
[[nodiscard]] char32_t next_code_point(std::string_view text, std::size_t& at);
/// Start of the code point before `at`; 0 at the beginning.
[[nodiscard]] std::size_t previous_code_point(std::string_view text, std::size_t at);

[[nodiscard]] float text_width(const Font& font, std::string_view text);

/// `text`, or its longest beginning that fits into `width` with an ellipsis; empty where not even that fits.
[[nodiscard]] std::string elided(const Font& font, std::string_view text, float width);

/// The first `n` bytes that make a line of at most `width`: broken after a space, else within the word, at least one
/// code point. Trailing spaces belong to the line but do not count.
[[nodiscard]] std::size_t line_break(const Font& font, std::string_view text, float width);
[[nodiscard]] std::vector<std::string_view> wrapped(const Font& font, std::string_view text, float width);

/// Draws with the baseline's left end at `pen` (y is rounded to a whole pixel).
/// @return the advance [px].
float draw_text(ImDrawList& list, const Font& font, glm::vec2 pen, Color color, std::string_view text);

/// Height between baselines that suits running text.
[[nodiscard]] inline float line_height(const Font& font) { return font.em * 1.5F; }
/// Room for letters with their accents and descenders, and where the baseline lies in it.
[[nodiscard]] inline float text_ascent(const Font& font) { return font.em * 0.80F; }
[[nodiscard]] inline float text_descent(const Font& font) { return font.em * 0.24F; }
/// Baseline that centres capitals on `y`.
[[nodiscard]] float baseline_at_middle(const Font& font, float y);

}  // namespace texelscope::ui
