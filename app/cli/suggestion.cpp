#include "app/cli/suggestion.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace texelscope {
namespace {

/// Damerau's distance between neighbours-only transpositions, row by row.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = above[j - 1] + (a[i - 1] != b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = std::exchange(above, row);
    }
    return above[b.size()];
}

}  // namespace

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> words) {
    constexpr std::size_t kLongest = 64;
    if (word.size() > kLongest) return {};
    std::string_view best;
    std::size_t least = 3;  // two slips at most
    for (const std::string_view candidate : words) {
        if (candidate.starts_with(word) && word.size() > 1) return candidate;
        const std::size_t d = distance(word, candidate);
        if (d < least && d < candidate.size() / 2 + 1) least = d, best = candidate;
    }
    return best;
}

}  // namespace texelscope
