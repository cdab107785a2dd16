// Random triangles as lessons, links and files of measurements spell them: "500 32 40", or with all they have "48 64 7
// steep 16 0".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/lesson/lesson.h"
#include "core/scene/random.h"

namespace texelscope {

/// Triangles, size and seed; behind these kind, distance and waste where they are not the usual ones.
[[nodiscard]] std::string text_of(const RandomTriangles& random, char separator = ' ');
/// Nothing where it is not such a text, or beyond the limits of app/lesson/lesson.h.
[[nodiscard]] std::optional<RandomTriangles> parse_random(std::string_view text, char separator = ' ',
                                                          int most_seed = kMostSeed);
/// What parse_random wants, for a message.
[[nodiscard]] std::string random_form();

}  // namespace texelscope
