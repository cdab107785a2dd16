#include "app/cli/suggestion.h"

#include <gtest/gtest.h>

#include <array>

namespace texelscope {
namespace {

constexpr std::array<std::string_view, 4> kWords{"list", "pixels", "render", "trace"};

TEST(Suggestion, EveryWordIsNearestToItself) {
    for (const std::string_view word : kWords) EXPECT_EQ(nearest_word(word, kWords), word);
}

TEST(Suggestion, OneSlipIsForgiven) {
    for (const std::string_view word : kWords) {
        for (std::size_t at = 0; at < word.size(); ++at) {
            std::string without(word), doubled(word), swapped(word);
            without.erase(at, 1);
            doubled.insert(at, 1, word[at]);
            if (at > 0) std::swap(swapped[at - 1], swapped[at]);
            EXPECT_EQ(nearest_word(without, kWords), word) << without;
            EXPECT_EQ(nearest_word(doubled, kWords), word) << doubled;
            EXPECT_EQ(nearest_word(swapped, kWords), word) << swapped;
        }
    }
}

TEST(Suggestion, FarWordsHaveNone) {
    EXPECT_EQ(nearest_word("banana", kWords), "");
    EXPECT_EQ(nearest_word("", kWords), "");
    EXPECT_EQ(nearest_word(std::string(100000, 'a'), kWords), "");
}

}  // namespace
}  // namespace texelscope
