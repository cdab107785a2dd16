#include "core/image/wrap.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace texelscope {
namespace {

constexpr std::array<std::int64_t, 10> kFar{std::numeric_limits<std::int64_t>::min(),
                                            std::numeric_limits<std::int64_t>::min() + 1,
                                            -1'000'000'007,
                                            -16385,
                                            -1,
                                            0,
                                            1,
                                            16384,
                                            1'000'000'007,
                                            std::numeric_limits<std::int64_t>::max()};

TEST(Wrap, IsInsideForEveryIndexSizeAndMode) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::mask, Wrap::clamp})
        for (int size = 1; size <= 130; ++size)
            for (const std::int64_t index : kFar) {
                const int texel = wrap_index(index, size, wrap);
                EXPECT_TRUE(texel >= 0 && texel < size) << index << " of " << size << " gives " << texel;
            }
}

TEST(Wrap, RepeatIsPeriodic) {
    for (int size = 1; size <= 40; ++size)
        for (int index = -100; index <= 100; ++index)
            EXPECT_EQ(wrap_index(index, size, Wrap::repeat), wrap_index(index + size, size, Wrap::repeat));
}

TEST(Wrap, EveryModeIsTheIdentityInside) {
    for (int size = 1; size <= 64; size *= 2)
        for (int index = 0; index < size; ++index)
            for (const Wrap wrap : {Wrap::repeat, Wrap::mask, Wrap::clamp})
                EXPECT_EQ(wrap_index(index, size, wrap), index);
}

TEST(Wrap, MaskIsRepeatForPowersOfTwo) {
    for (int size = 1; size <= 16384; size *= 2)
        for (const std::int64_t index : kFar)
            EXPECT_EQ(wrap_index(index, size, Wrap::mask), wrap_index(index, size, Wrap::repeat));
}

TEST(Wrap, ClampGivesTheNearestTexel) {
    for (int size = 1; size <= 5; ++size)
        for (int index = -9; index <= 9; ++index)
            EXPECT_EQ(wrap_index(index, size, Wrap::clamp), index < 0 ? 0 : index >= size ? size - 1 : index);
}

}  // namespace
}  // namespace texelscope
