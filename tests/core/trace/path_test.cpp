#include "core/trace/path.h"

#include <gtest/gtest.h>

namespace texelscope {
namespace {

TEST(Path, TextParsedIsThePathAgain) {
    for (const char* text :
         {"t0", "t12/s3", "t0/s3/y-11", "t0/s3/y11/x7", "t0/s3/y11/x7/e2", "t0/s3/e2", "t1/s0/v3/u-5/e10"}) {
        const auto path = parse_path(text);
        ASSERT_TRUE(path) << text;
        EXPECT_EQ(path->text(), text);
        EXPECT_EQ(parse_path(path->text()), path);
    }
}

TEST(Path, AnythingElseIsNoPath) {
    for (const char* text : {"", "x3", "t", "t/s0", "t0/", "/t0", "t0//s1", "t0/y3", "t0/s1/e2/e3", "t0/s1/e2/x3",
                             "t0/s1/Y3", "t0 /s1", "t0/s1/y1.5", "t0/s-", "t1234567890123",
                             "t99999999999999999999999999/s0", "t0/s0/a0/b0/c0/d0/f0/g0/h0", "t0/s0\n"}) {
        EXPECT_FALSE(parse_path(text)) << text;
    }
}

TEST(Path, AnExpressionCountsAsItsUnit) {
    const Path path = *parse_path("t0/s3/y11/x7/e2");
    EXPECT_EQ(path.depth(), 4);
    EXPECT_EQ(path.unit().text(), "t0/s3/y11/x7");
    EXPECT_EQ(path.unit().depth(), 4);
    EXPECT_EQ(path.prefix(2).text(), "t0/s3");
    EXPECT_EQ(path.prefix(99), path);
    EXPECT_EQ(path.index_of('y'), 11);
    EXPECT_FALSE(path.index_of('v'));
}

TEST(Level, IdsAreReadBack) {
    for (int n = 0; n < kLevels; ++n) EXPECT_EQ(level_from(id_of(static_cast<Level>(n))), static_cast<Level>(n));
    EXPECT_FALSE(level_from("row"));
}

}  // namespace
}  // namespace texelscope
