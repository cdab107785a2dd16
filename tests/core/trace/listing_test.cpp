#include "core/trace/listing.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/method/method.h"

namespace texelscope {
namespace {

TEST(Listing, IsTheSourceFileItself) {
    for (const Method* method : methods()) {
        std::ifstream file(std::string(TEXELSCOPE_SOURCE_DIR "/") + std::string(method->listing));
        const std::string source{std::istreambuf_iterator<char>(file), {}};
        std::string embedded;
        for (const std::string& line : load_listing(method->listing).lines) embedded += line + "\n";
        EXPECT_EQ(embedded, source) << method->listing;
        EXPECT_FALSE(source.empty()) << method->listing;
    }
    EXPECT_TRUE(load_listing("no/such/file.h").lines.empty());
}

TEST(Listing, WithoutTraceIsPlainMathematics) {
    EXPECT_EQ(without_trace("    c.x = trace({\"x\", n}, f(a, b) + 1);"), "    c.x = f(a, b) + 1;");
    EXPECT_EQ(without_trace("x = trace(\"k (,\", -(p * q));"), "x = -(p * q);");
    EXPECT_EQ(without_trace("T y = trace(Name::side(\"E\", e), a) + trace(\"b\", c);"), "T y = a + c;");
    EXPECT_EQ(without_trace("return trace.fate(fate);"), "return trace.fate(fate);");
    EXPECT_EQ(without_trace("trace(\"open\", (a"), "trace(\"open\", (a");
}

TEST(Listing, NoLineCallsTheTraceTwice) {
    for (const Method* method : methods()) {
        const Listing listing = load_listing(method->listing);
        for (std::size_t n = 0; n < listing.lines.size(); ++n) {
            const std::string& line = listing.lines[n];
            const std::size_t first = line.find("trace(");
            EXPECT_TRUE(first == std::string::npos || line.find("trace(", first + 1) == std::string::npos)
                << method->listing << ":" << n + 1 << ": compilers differ in the order of two operands";
        }
    }
}

TEST(Listing, LinesAreFoundByTheirText) {
    const Listing listing{"f", {"one", "two", "one two"}};
    EXPECT_EQ(line_with(listing, "two"), 2);
    EXPECT_EQ(line_with(listing, "e t"), 3);
    EXPECT_EQ(line_with(listing, "three"), 0);
}

}  // namespace
}  // namespace texelscope
