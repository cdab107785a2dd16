#include "app/views/code_text.h"

#include <algorithm>
#include <cctype>
#include <set>

#include <gtest/gtest.h>

namespace texelscope {
namespace {

const std::vector<std::string> kListings{"core/method/edge_equations.h", "core/method/sections.h"};

[[nodiscard]] std::string without_spaces(std::string text) {
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text;
}

[[nodiscard]] bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

TEST(CodeText, TokensOfALineAreTheLine) {
    for (const std::string& path : kListings) {
        for (const std::string& line : load_listing(path).lines) {
            std::string joined;
            for (const Token& token : tokens_of(line)) joined += token.text;
            EXPECT_EQ(joined, line);
        }
    }
}

TEST(CodeText, WordsHaveTheirKinds) {
    const auto tokens = tokens_of("const T u = \"a b\"; // u");
    EXPECT_EQ(tokens.front().kind, TokenKind::keyword);
    EXPECT_EQ(tokens.back().kind, TokenKind::comment);
    const auto has = [&](TokenKind kind, std::string_view text) {
        return std::any_of(tokens.begin(), tokens.end(),
                           [&](const Token& t) { return t.kind == kind && t.text == text; });
    };
    EXPECT_TRUE(has(TokenKind::u, "u"));
    EXPECT_TRUE(has(TokenKind::string, "\"a b\""));
}

TEST(CodeText, FunctionsOfTheMethodsAreFound) {
    for (const std::string& path : kListings) {
        const Listing listing = load_listing(path);
        const auto functions = functions_of(listing);
        std::set<std::string> names;
        int last = 0;
        for (const CodeFunction& f : functions) {
            EXPECT_GT(f.first, last);
            EXPECT_GE(f.last, f.first);
            EXPECT_NE(listing.lines[static_cast<std::size_t>(f.last) - 1].find('}'), std::string::npos) << f.name;
            last = f.last;
            names.insert(f.name);
        }
        EXPECT_TRUE(names.contains("draw")) << path;
        EXPECT_TRUE(names.contains("pixel")) << path;
        EXPECT_EQ(names.contains("draw_row"), path.find("sections") != std::string::npos) << path;
        EXPECT_FALSE(names.contains("trace")) << path;
    }
}

TEST(CodeText, CallersCall) {
    const Listing listing = load_listing(kListings[0]);
    const auto functions = functions_of(listing);
    const int plane = function_at(functions, line_with(listing, "Plane plane("));
    ASSERT_GE(plane, 0);
    const auto callers = callers_of(listing, functions, plane);
    ASSERT_EQ(callers.size(), 1U);
    EXPECT_EQ(functions[static_cast<std::size_t>(callers[0])].name, "setup");
}

TEST(CodeText, BrokenLinesKeepEveryLetterAndFit) {
    for (const std::string& path : kListings) {
        for (const std::string& line : load_listing(path).lines) {
            for (const int columns : {20, 44, 69, 200}) {
                std::string joined;
                for (const std::string& part : broken(line, columns)) {
                    EXPECT_LE(static_cast<int>(part.size()), columns);
                    joined += part;
                }
                EXPECT_EQ(without_spaces(joined), without_spaces(line));
            }
        }
    }
}

TEST(CodeText, NoWordOfTheMethodsIsBroken) {
    for (const std::string& path : kListings) {
        for (const std::string& line : load_listing(path).lines) {
            for (const int columns : {44, 60, 69}) {
                std::size_t at = 0;
                for (const std::string& part : broken(line, columns)) {
                    const std::string text = part.substr(std::min(part.find_first_not_of(' '), part.size()));
                    at = line.find(text, at);
                    ASSERT_NE(at, std::string::npos) << text;
                    EXPECT_FALSE(at > 0 && is_word(line[at - 1]) && is_word(line[at])) << columns << ": " << line;
                    at += text.size();
                }
            }
        }
    }
}

TEST(CodeText, BreaksAfterABracketRatherThanInAWord) {
    EXPECT_EQ(broken("f(aaaaaaaaaaaa(bbbbbbbbbbbbbbbb(p.texel.column)));", 40),
              (std::vector<std::string>{"f(aaaaaaaaaaaa(bbbbbbbbbbbbbbbb(", "        p.texel.column)));"}));
}

TEST(CodeText, BreaksOutsideOfBracketsAndBeforeComments) {
    EXPECT_EQ(broken("d = (a + b) * (c - d) - (e - f) * (g - h);", 32),
              (std::vector<std::string>{"d = (a + b) * (c - d)", "        - (e - f) * (g - h);"}));
    EXPECT_EQ(broken("if (a != (b && plain(c))) {  // turn it", 32),
              (std::vector<std::string>{"if (a != (b && plain(c))) { ", "        // turn it"}));
}

TEST(CodeText, WhatIsFarToTheRightMovesLeftRatherThanBreaking) {
    EXPECT_EQ(broken(std::string(50, ' ') + ": (p.x - row.l.x);", 40),
              (std::vector<std::string>{std::string(22, ' ') + ": (p.x - row.l.x);"}));
}

TEST(CodeText, AContinuedCommentIsAComment) {
    const Listing listing{"f", {"    int f() {  // one two three four five six", "        return 1;", "    }"}};
    const auto functions = functions_of(listing);
    const auto rows = rows_of(listing, functions, {.functions = {0}, .columns = 20});
    ASSERT_GE(rows.size(), 4U);
    EXPECT_FALSE(rows[0].comment);
    EXPECT_TRUE(rows[2].comment);
    EXPECT_TRUE(rows[2].continued);
    EXPECT_FALSE(rows.back().comment);
}

TEST(CodeText, EveryLineIsShownOrFoldedOnce) {
    for (const std::string& path : kListings) {
        const Listing listing = load_listing(path);
        const auto functions = functions_of(listing);
        for (int f = 0; f < static_cast<int>(functions.size()); ++f) {
            int next = 1;
            for (const CodeRow& row : rows_of(listing, functions, {.functions = {f}})) {
                if (row.continued) continue;
                EXPECT_EQ(row.line, next);
                next += row.folded > 0 ? row.folded : 1;
                if (functions[static_cast<std::size_t>(f)].has(row.line)) {
                    EXPECT_EQ(row.folded, 0);
                }
            }
            EXPECT_EQ(next, static_cast<int>(listing.lines.size()) + 1);
        }
    }
}

TEST(CodeText, AnOpenedFoldShowsItsLines) {
    const Listing listing = load_listing(kListings[0]);
    const auto functions = functions_of(listing);
    const auto rows = rows_of(listing, functions, {.functions = {3}});
    const auto fold = std::find_if(rows.begin(), rows.end(), [](const CodeRow& r) { return r.folded > 0; });
    ASSERT_NE(fold, rows.end());
    const auto open = rows_of(listing, functions, {.functions = {3}, .unfolded = {fold->line}});
    EXPECT_GT(open.size(), rows.size());
    EXPECT_TRUE(
        std::any_of(open.begin(), open.end(), [&](const CodeRow& r) { return r.line == fold->line && r.folded == 0; }));
}

TEST(CodeText, PlainRowsHaveNoTrace) {
    const Listing listing = load_listing(kListings[0]);
    const auto functions = functions_of(listing);
    const int plane = function_at(functions, line_with(listing, "Plane plane("));
    for (const CodeRow& row : rows_of(listing, functions, {.functions = {plane}}))
        EXPECT_EQ(row.text.find("trace("), std::string::npos);
}

}  // namespace
}  // namespace texelscope
