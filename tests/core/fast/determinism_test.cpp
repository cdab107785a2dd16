// The same pixels whatever compiled the rasterizer, whatever instructions and threads it uses, and from whichever
// corner a triangle starts. The hashes are the definition's; `tests/determinism/compilers.py --exact` prints them.
#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "tests/core/fast/determined_scenes.h"

namespace texelscope::determinism_test {
namespace {

struct Known {
    std::string_view scene;
    std::uint64_t hash;
};
constexpr std::array<Known, 18> kKnown{{
    {"ties", 0xB543BFE3ADEF9DBE},
    {"ties in perspective", 0xA9A7D52172AE6B19},
    {"big", 0x389D766B9F046627},
    {"big, shaken", 0x6B054930F9C64BCB},
    {"hundred", 0x77DA0E0CC634BAD4},
    {"hundred, shaken", 0xC87ABB0C88D7BD8C},
    {"four", 0xFD7AE541DACC9B75},
    {"four, shaken", 0xEA7A5CD95643FCB5},
    {"mesh", 0xE6A9014227763245},
    {"mesh, shaken", 0x09F8D58D4E41B3F9},
    {"big-perspective", 0xB0CB5CB07004490B},
    {"big-perspective, shaken", 0x23776B294231D688},
    {"hundred-perspective", 0x162F11868A396F30},
    {"hundred-perspective, shaken", 0xE7FD2628FA0909AB},
    {"waste", 0x285353549BFCEC6E},
    {"waste, shaken", 0xFEBFA8B011E8B3E2},
    {"slivers", 0xD5745DCD392DBB10},
    {"slivers, shaken", 0x6616AF01ABAD5864},
}};

const std::vector<DeterminedScene>& scenes() {
    static const std::vector<DeterminedScene> all = determined_scenes();
    return all;
}

TEST(Determinism, TheDefinitionDrawsThePicturesOfTheseHashes) {
    ASSERT_EQ(scenes().size(), kKnown.size());
    for (std::size_t n = 0; n < kKnown.size(); ++n) {
        EXPECT_EQ(scenes()[n].name, kKnown[n].scene);
        EXPECT_EQ(hash_of_exact(scenes()[n]), kKnown[n].hash) << kKnown[n].scene;
    }
}

TEST(Determinism, EveryLevelThreadCountAndFirstCornerDrawsThem) {
    ASSERT_EQ(scenes().size(), kKnown.size());
    for (std::size_t n = 0; n < kKnown.size(); ++n) {
        DeterminedScene scene = scenes()[n];
        for (int turn = 0; turn < 3; ++turn, turn_corners(scene))
            for (const SimdLevelInfo& level : kSimdLevels)
                for (int threads = 1; threads <= 5 && is_supported(level.level); ++threads)
                    EXPECT_EQ(hash_of_fast(scene, {.level = level.level, .threads = threads}), kKnown[n].hash)
                        << scene.name << ", " << level.id << ", " << threads << " threads, corners turned by " << turn;
    }
}

}  // namespace
}  // namespace texelscope::determinism_test
