// Prints a line for each scene of tests/core/fast/determined_scenes.h: its hash, by the definition (--exact) or as
// core/fast draws it by every SIMD level that this machine has, with 1 to 5 threads, from each corner; a scene that is
// drawn in two ways has two lines.
#include <cinttypes>
#include <cstdio>
#include <set>
#include <string_view>

#include "tests/core/fast/determined_scenes.h"

int main(int count, char** words) {
    using namespace texelscope;
    const bool exact = count > 1 && std::string_view(words[1]) == "--exact";
    for (DeterminedScene& scene : determined_scenes()) {
        std::set<std::uint64_t> hashes;
        if (exact) {
            hashes.insert(hash_of_exact(scene));
        } else {
            for (int turn = 0; turn < 3; ++turn, turn_corners(scene))
                for (const SimdLevelInfo& level : kSimdLevels)
                    for (int threads = 1; threads <= 5 && is_supported(level.level); ++threads)
                        hashes.insert(hash_of_fast(scene, {.level = level.level, .threads = threads}));
        }
        for (const std::uint64_t hash : hashes) std::printf("{\"%s\", 0x%016" PRIX64 "},\n", scene.name.c_str(), hash);
    }
    return 0;
}
