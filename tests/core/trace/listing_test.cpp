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
    EXPECT_EQ(without_trace("// as trace(\"a\", b) does"), "// as trace(\"a\", b) does");
}

TEST(Listing, WithoutTraceFoldsCallsOverSeveralLines) {
    EXPECT_EQ(without_trace("p.s = trace(\"s\", q ? a(b)\n                 : c(d));  // ) \nx = trace(\"x\", 1);"),
              "p.s = q ? a(b)\n      : c(d);  // ) \nx = 1;");
    EXPECT_EQ(without_trace("a = trace(\"a\", b  // (\n  + c);"), "a = b  // (\n+ c;");
}

TEST(Listing, WithoutTraceNoStatementIsThrownAway) {
    EXPECT_EQ(without_trace("{\n  trace(\"left\", Integer(s.left));"), "{\n  left = Integer(s.left);");
    EXPECT_EQ(without_trace("if (f(x))  // why\n  trace(\"a\", b + c);"), "if (f(x))  // why\n  a = b + c;");
    EXPECT_EQ(without_trace("a = 1;\ns.y_beg = trace(\"y_beg\", s.y_beg);"), "a = 1;\ny_beg = s.y_beg;");
    EXPECT_EQ(without_trace("x = trace(\"x\", 1);\ntrace(\"x\", x);"), "x = 1;\ntrace(\"x\", x);");
    EXPECT_EQ(without_trace("return trace(\"a\", b);"), "return b;");
}

TEST(Listing, WithoutTraceKeepsTheLinesOfTheMethods) {
    for (const Method* method : methods()) {
        const Listing listing = load_listing(method->listing), plain = without_trace(listing);
        ASSERT_EQ(plain.lines.size(), listing.lines.size()) << method->listing;
        for (std::size_t n = 0; n < plain.lines.size(); ++n) {
            const std::string& line = plain.lines[n];
            const bool names_itself = line == listing.lines[n];
            EXPECT_TRUE(names_itself || line.find("trace(\"") == std::string::npos) << method->listing << ":" << n + 1;
            const std::size_t equals = line.find(" = ");
            if (equals == std::string::npos) continue;
            const std::size_t first = line.find_first_not_of(' ');
            EXPECT_NE(line.substr(first, equals - first) + ";", line.substr(equals + 3)) << method->listing << ":" << n;
        }
    }
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
