#include "app/lesson/random_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "app/lesson/questions.h"

namespace texelscope {
namespace {

constexpr std::size_t kShort = 3, kLong = 6;  ///< words

[[nodiscard]] std::optional<int> whole(std::string_view text, int low, int high) {
    const auto number = typed_number(text);
    if (!number || *number != std::floor(*number) || *number < low || *number > high) return std::nullopt;
    return static_cast<int>(*number);
}

}  // namespace

std::string text_of(const RandomTriangles& r, char separator) {
    std::string text = fmt::format("{}{}{}{}{}", r.count, separator, r.size, separator, r.seed);
    if (r.kind != RandomKind::plain || r.distance != 0 || r.waste != 0)
        text += fmt::format("{}{}{}{}{}{}", separator, kRandomKinds[static_cast<std::size_t>(r.kind)], separator,
                            r.distance, separator, r.waste);
    return text;
}

std::optional<RandomTriangles> parse_random(std::string_view text, char separator, int most_seed) {
    std::vector<std::string_view> words;
    for (;;) {
        const std::size_t end = text.find(separator);
        words.push_back(text.substr(0, end));
        if (end == text.npos) break;
        text.remove_prefix(end + 1);
    }
    if (words.size() != kShort && words.size() != kLong) return std::nullopt;
    const auto count = whole(words[0], 1, kMostTriangles), seed = whole(words[2], 0, most_seed);
    const auto size = typed_number(words[1]);
    if (!count || !seed || !size || *size < double{kLeastTriangleSide} || *size > double{kMostTriangleSide})
        return std::nullopt;
    RandomTriangles random{*count, static_cast<float>(*size), static_cast<std::uint32_t>(*seed)};
    if (words.size() == kShort) return random;
    const auto* const kind = std::find(kRandomKinds.begin(), kRandomKinds.end(), words[3]);
    const auto distance = whole(words[4], 0, kMaxDistance), waste = whole(words[5], 0, kMaxWaste);
    if (kind == kRandomKinds.end() || !distance || !waste) return std::nullopt;
    random.kind = static_cast<RandomKind>(kind - kRandomKinds.begin());
    random.distance = *distance, random.waste = *waste;
    return random;
}

std::string random_form() {
    return fmt::format(
        "TRIANGLES SIZE SEED: whole numbers of 1 to {}, {} to {} pixels, 0 to {}; behind them KIND DISTANCE WASTE may "
        "stand: plain, steep or slivers, 0 to {}, 0 to {} percent",
        kMostTriangles, kLeastTriangleSide, kMostTriangleSide, kMostSeed, kMaxDistance, kMaxWaste);
}

}  // namespace texelscope
