// What questions look up in a drawing and its steps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/method/steps.h"

namespace texelscope {

/// The first step at which the shape visits the pixel; nothing where it never does.
[[nodiscard]] std::optional<Path> pixel_step(Steps& steps, int shape, Integer x, Integer y);
/// The first expression of that name in the shape's stages, outside of their loops.
[[nodiscard]] std::optional<Path> expression_step(Steps& steps, int shape, std::string_view name);
/// The first step in which a line of the listing makes a value: a stage, or else the first round of its loops.
[[nodiscard]] std::optional<Path> line_step(Steps& steps, int shape, int line);
/// The unit's own last value of that name, or else the last on the way to it.
[[nodiscard]] std::optional<Value> value_named(const Visit& visit, std::string_view name);
/// The values are the same, NaN the same as NaN.
[[nodiscard]] bool same_value(const std::optional<Value>& a, const std::optional<Value>& b);

/// "u = 8.25", or "u \approx 8.2503" where the value has more decimals than are shown.
[[nodiscard]] std::string equation(std::string_view name, double value, int decimals);

/// What of a path is not there, in words: "t0/s5/y5/x6 has e0 to e14". Nothing where the step exists.
[[nodiscard]] std::optional<std::string> missing_part(Steps& steps, const Path& path);

/// What becomes of a pixel of the frame.
enum class Coverage : std::uint8_t { never_visited, rejected, written };
/// Of one shape, over the framebuffer; top left at the frame's.
[[nodiscard]] Grid<Coverage> coverage(const Drawing& drawing, int shape);
/// What each shape does at one pixel, in drawing order.
[[nodiscard]] std::vector<std::pair<int, Sample>> samples_at(const Drawing& drawing, Integer x, Integer y);
/// How often each pixel of the framebuffer is written, up to 255; top left at the frame's.
[[nodiscard]] Grid<std::uint8_t> write_counts(const Drawing& drawing);

/// The drawing's settings with quirks switched; what is not one of the method's is passed over.
[[nodiscard]] DrawSettings with_quirks(const Drawing& drawing, const std::vector<std::pair<std::string, bool>>& quirks);
/// The quirk's place in the method's list; nothing where it has none of that id or field.
[[nodiscard]] std::optional<int> quirk_number(const Method& method, std::string_view id);

}  // namespace texelscope
