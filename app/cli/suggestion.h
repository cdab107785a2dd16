// Guesses which word was meant.
#pragma once

#include <span>
#include <string_view>

namespace texelscope {

/// The word that the fewest changes, insertions, removals and swaps of neighbours turn `word` into; empty where even
/// that is more than a slip of the keys.
[[nodiscard]] std::string_view nearest_word(std::string_view word, std::span<const std::string_view> words);

}  // namespace texelscope
