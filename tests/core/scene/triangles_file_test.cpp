#include "core/scene/triangles_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/image/image.h"

namespace texelscope::triangles_file_test {
namespace {

// Where the header's numbers stand [bytes].
constexpr std::size_t kWidth = 8, kHeight = 12, kTriangles = 16, kFlags = 20, kTextureWidth = 24, kTextureHeight = 28,
                      kVertexBytes = 32, kReserved = 36, kLast = 56, kVertices = 64, kVertexSize = 24, kW = 12;

TrianglesFile two_triangles() {
    TrianglesFile file{.width = 5, .height = 7, .texture_width = 3, .texture_height = 16'384};
    file.seed = 0x0123456789ABCDEF, file.covered = 99;
    for (int n = 0; n < 6; ++n) {
        const auto f = static_cast<float>(n);
        file.vertices.push_back({f, -f, 0.25F * f, 1 + f, 1e-40F * f, -1e30F * f});
    }
    return file;
}

template <class Number>
std::string with(std::string bytes, std::size_t at, Number value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return bytes;
}

std::string error_of(std::string_view bytes) {
    const Result<TrianglesFile> file = parse_triangles(bytes, "x.tri");
    return file ? "none" : file.error().text();
}

TEST(TrianglesFile, IsReadAsItWasWritten) {
    for (unsigned flags = 0; flags < 16; ++flags) {
        TrianglesFile file = two_triangles();
        file.perspective = (flags & 1U) != 0, file.depth = (flags & 2U) != 0;
        file.cull_back = (flags & 4U) != 0, file.no_wrap = (flags & 8U) != 0;
        const std::string bytes = print_triangles(file);
        EXPECT_EQ(bytes.size(), kVertices + 6 * kVertexSize);
        EXPECT_EQ(bytes[kFlags], static_cast<char>(flags));
        const Result<TrianglesFile> again = parse_triangles(bytes, "x.tri");
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(*again, file);
    }
}

TEST(TrianglesFile, HasItsNumbersWhereTheFormatSays) {
    std::string bytes("TRIWL01\0", 8);
    for (const std::uint32_t number : {640U, 480U, 1U, 5U, 64U, 32U, 24U, 0U})
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    for (const std::uint64_t number : {7ULL, 8ULL, 0ULL})
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    for (int n = 0; n < 18; ++n) {
        const auto number = static_cast<float>(n + 1);
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    const Result<TrianglesFile> file = parse_triangles(bytes, "x.tri");
    ASSERT_TRUE(file) << file.error().text();
    const TrianglesFile expected{.width = 640,
                                 .height = 480,
                                 .perspective = true,
                                 .cull_back = true,
                                 .texture_width = 64,
                                 .texture_height = 32,
                                 .seed = 7,
                                 .covered = 8,
                                 .vertices = {{1, 2, 3, 4, 5, 6}, {7, 8, 9, 10, 11, 12}, {13, 14, 15, 16, 17, 18}}};
    EXPECT_EQ(*file, expected);
}

TEST(TrianglesFile, MayHoldNoTriangles) {
    TrianglesFile file = two_triangles();
    file.vertices.clear();
    const Result<TrianglesFile> again = parse_triangles(print_triangles(file), "x.tri");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(*again, file);
}

TEST(TrianglesFile, CutAnywhereIsAnError) {
    const std::string bytes = print_triangles(two_triangles());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const std::string error = error_of(std::string_view(bytes).substr(0, size));
        EXPECT_EQ(error, size < kVertices
                             ? "x.tri: it has " + std::to_string(size) + " bytes, expected a header of 64"
                             : "x.tri: it has " + std::to_string(size) + " bytes, expected 208 for 2 triangles");
    }
}

TEST(TrianglesFile, OneByteMoreIsAnError) {
    EXPECT_EQ(error_of(print_triangles(two_triangles()) + '\0'),
              "x.tri: it has 209 bytes, expected 208 for 2 triangles");
}

TEST(TrianglesFile, OtherFirstBytesAreAnError) {
    const std::string bytes = print_triangles(two_triangles());
    for (std::size_t at = 0; at < 8; ++at)
        EXPECT_EQ(error_of(with(bytes, at, '?')),
                  "x.tri: it does not begin with TRIWL01, expected triangles for measuring");
}

TEST(TrianglesFile, SizesOutsideTheirRangeAreErrors) {
    const std::string bytes = print_triangles(two_triangles());
    const auto most = static_cast<std::uint32_t>(kMaxSize);
    for (const std::size_t at : {kWidth, kHeight, kTextureWidth, kTextureHeight}) {
        const std::string what = at < kTriangles ? "x.tri: the framebuffer is " : "x.tri: the texture is ";
        for (const std::uint32_t bad : {0U, most + 1, 0x80000000U, 0xFFFFFFFFU})
            EXPECT_EQ(error_of(with(bytes, at, bad)).rfind(what, 0), 0U) << bad;
        for (const std::uint32_t good : {1U, most}) EXPECT_EQ(error_of(with(bytes, at, good)), "none") << good;
    }
}

TEST(TrianglesFile, MoreTrianglesThanBytesIsAnErrorBeforeAnythingIsAllocated) {
    const std::string bytes = print_triangles(two_triangles());
    EXPECT_EQ(error_of(with(bytes, kTriangles, 3U)), "x.tri: it has 208 bytes, expected 280 for 3 triangles");
    EXPECT_EQ(error_of(with(bytes, kTriangles, kMaxFileTriangles)),
              "x.tri: it has 208 bytes, expected 720000064 for 10000000 triangles");
    // The bytes of so many triangles, modulo 2^32, are those of the two there are.
    EXPECT_EQ(error_of(with(bytes, kTriangles, (1U << 29) + 2)),
              "x.tri: there are 536870914 triangles, expected at most 10000000");
    EXPECT_EQ(error_of(with(bytes, kTriangles, 0xFFFFFFFFU)),
              "x.tri: there are 4294967295 triangles, expected at most 10000000");
}

TEST(TrianglesFile, WhatThisVersionDoesNotKnowIsAnError) {
    const std::string bytes = print_triangles(two_triangles());
    for (const std::uint32_t flags : {16U, 0x80000000U, 0xFFFFFFFFU})
        EXPECT_EQ(error_of(with(bytes, kFlags, flags)),
                  "x.tri: flags are " + std::to_string(flags) + ", expected at most 15");
    for (const std::uint32_t size : {0U, 20U, 28U})
        EXPECT_EQ(error_of(with(bytes, kVertexBytes, size)),
                  "x.tri: a vertex has " + std::to_string(size) + " bytes, expected 24");
    for (const std::size_t at : {kReserved, kLast, kLast + 4})
        EXPECT_EQ(error_of(with(bytes, at, 1U)), "x.tri: a number that is kept for later is not 0");
}

TEST(TrianglesFile, ANumberThatIsNotFiniteIsAnErrorThatNamesItsCorner) {
    const std::string bytes = print_triangles(two_triangles());
    constexpr auto kInfinity = std::numeric_limits<float>::infinity();
    for (std::size_t vertex = 0; vertex < 6; ++vertex)
        for (std::size_t field = 0; field < 6; ++field)
            for (const float bad : {std::nanf(""), kInfinity, -kInfinity})
                EXPECT_EQ(error_of(with(bytes, kVertices + vertex * kVertexSize + field * sizeof(float), bad)),
                          "x.tri: corner " + std::to_string(vertex % 3) + " of triangle " + std::to_string(vertex / 3) +
                              " has a number that is not finite");
}

TEST(TrianglesFile, WThatIsNotPositiveIsAnErrorInPerspectiveOnly) {
    TrianglesFile file = two_triangles();
    const std::size_t at = kVertices + 4 * kVertexSize + kW;
    for (const float w : {0.0F, -0.0F, -1.0F, -1e-45F}) {
        file.perspective = false;
        EXPECT_EQ(error_of(with(print_triangles(file), at, w)), "none") << w;
        file.perspective = true;
        EXPECT_EQ(error_of(with(print_triangles(file), at, w)).rfind("x.tri: corner 1 of triangle 1 has w = ", 0), 0U);
    }
    EXPECT_EQ(error_of(with(print_triangles(file), at, 1e-45F)), "none");
}

}  // namespace
}  // namespace texelscope::triangles_file_test
