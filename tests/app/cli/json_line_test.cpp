#include "app/cli/json_line.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace texelscope {
namespace {

TEST(JsonLine, AnyTextComesBackFromAParser) {
    std::string every;
    for (char c = 1; c < 127; ++c) every += c;
    for (const std::string& text : {every, std::string("Δ ≤ \\\"{}"), std::string(), std::string("a\0b", 3)}) {
        const auto parsed = nlohmann::json::parse(json_text(text));
        EXPECT_EQ(parsed.get<std::string>(), text);
    }
}

TEST(JsonLine, ALineIsOneObjectWithItsMembersInOrder) {
    const std::string line = JsonLine().text("a", "x\ny").number("b", -3).raw("c", "[1,2]").line();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const auto parsed = nlohmann::ordered_json::parse(line);
    EXPECT_EQ(parsed.dump(), R"({"a":"x\ny","b":-3,"c":[1,2]})");
}

TEST(JsonLine, NumbersThatJsonLacksStandInQuotes) {
    for (const char* number : {"0", "-1.5", "1e+20", "2.5e-07"})
        EXPECT_TRUE(nlohmann::json::parse(json_number(number)).is_number());
    for (const char* text : {"nan", "inf", "-inf", "3/7", ""})
        EXPECT_EQ(nlohmann::json::parse(json_number(text)), text);
}

}  // namespace
}  // namespace texelscope
