#include "core/scene/json_tree.h"

#include <gtest/gtest.h>

namespace texelscope::json_tree_test {
namespace {

std::string error_of(std::string_view text) {
    const Result<JsonTree> tree = JsonTree::parse(text, "f");
    return tree ? "none" : tree.error().text();
}

TEST(JsonTree, EveryValueAndKeyKnowsItsLine) {
    const Result<JsonTree> tree =
        JsonTree::parse("\n{ \"a\":\n1, \"b\"\n:\n[ 2\n, 3.5\n, true, null,\n\"t\" ]\n}", "f");
    ASSERT_TRUE(tree);
    std::vector<int> keys, values, items;
    for (const JsonValue member : tree->root()) {
        keys.push_back(member.key_line());
        values.push_back(member.line());
        for (const JsonValue item : member) items.push_back(item.line());
    }
    EXPECT_EQ(tree->root().line(), 2);
    EXPECT_EQ(keys, (std::vector{2, 3}));
    EXPECT_EQ(values, (std::vector{3, 5}));
    EXPECT_EQ(items, (std::vector{5, 6, 7, 7, 8}));
}

TEST(JsonTree, NumberBeforeALineEndIsOnItsOwnLine) {
    for (const std::string_view text : {"[1\n,2]", "[1\r\n,2]", "[1 \n,2]", "[1,\n2\n\n]"}) {
        const Result<JsonTree> tree = JsonTree::parse(text, "f");
        EXPECT_EQ((*tree->root().begin()).line(), 1);
        EXPECT_EQ(tree->root().size(), 2u);
    }
}

TEST(JsonTree, LinesStartWhereTold) {
    EXPECT_EQ(JsonTree::parse("\n[1]", "f", 10)->root().line(), 11);
    EXPECT_EQ(JsonTree::parse("\n[1", "f", 10).error().where, "f:11");
}

TEST(JsonTree, KeepsTheOrderAndTheTexts) {
    const Result<JsonTree> tree = JsonTree::parse(R"({"z": "\u00e4\"\n", "a": {"": []}})", "f");
    std::string keys;
    for (const JsonValue member : tree->root()) keys += std::string(member.key()) + ";";
    EXPECT_EQ(keys, "z;a;");
    EXPECT_EQ((*tree->root().begin()).text(), "\xc3\xa4\"\n");
}

TEST(JsonTree, ErrorsAreOneLineWithThePlace) {
    EXPECT_EQ(error_of("{\"a\": 1,\n \"b\" 2}").substr(0, 3), "f:2");
    EXPECT_EQ(error_of("{\"a\": 1,\n\n \"a\": 2}"), "f:3: key 'a' is given twice");
    EXPECT_EQ(error_of("[1e999]").substr(0, 22), "f:1: a number is too l");
    for (const std::string_view text :
         {"", " ", "{", "[1,]", "[1] 2", "nul", "\"\n\"", "\"\xff\"", "{\"a\"}", "[01]", "\"\\x\"", "// c\n1"}) {
        const std::string error = error_of(text);
        EXPECT_EQ(error.rfind("f:", 0), 0u) << text;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
}

TEST(JsonTree, DeepNestingIsAnError) {
    EXPECT_EQ(error_of(std::string(1'000'000, '[')), "f:1: is nested more than 32 deep");
    EXPECT_EQ(error_of(std::string(32, '[') + std::string(32, ']')), "none");
}

TEST(JsonTree, TooManyValuesAreAnError) {
    std::string text = "[0";
    for (std::size_t i = 0; i < kMaxJsonValues; ++i) text += ",0";
    EXPECT_EQ(error_of(text + "]"), "f:1: has more than 8388608 values");
}

TEST(InQuotes, IsShortAndOneLineAndCutsBetweenCharacters) {
    EXPECT_EQ(in_quotes("a\nb"), "'a?b'");
    const std::string cut = in_quotes("x" + std::string(100, '\xc3') + "");
    EXPECT_LT(cut.size(), 70u);
    std::string umlauts = "x";
    for (int i = 0; i < 50; ++i) umlauts += "\xc3\xa4";
    EXPECT_EQ(in_quotes(umlauts), "'" + umlauts.substr(0, 59) + "...'");
}

}  // namespace
}  // namespace texelscope::json_tree_test
