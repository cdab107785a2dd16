// texelscope stress as scripts use it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/cli/program.h"

namespace texelscope::stress_test {
namespace {

std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(StressCommand, PrintsATableAndSucceedsWhereAllIsRight) {
    const Ran ran = run_program("stress --family random --count 20");
    EXPECT_EQ(ran.code, 0) << ran.err;
    for (const char* word : {"fast", "random", "in double", "edge-equations", "fx16.16", "bound there"})
        EXPECT_NE(ran.out.find(word), std::string::npos) << word;
    EXPECT_EQ(ran.err, "random\n");
}

TEST(StressCommand, JsonHasARowForEveryModeAndNumberFormat) {
    const Ran ran = run_program("stress --family slivers --count 4 --method barycentric --json");
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(lines(ran.out), 4U * 5);
    const auto row = nlohmann::json::parse(ran.out.substr(0, ran.out.find('\n')));
    EXPECT_EQ(row.at("family"), "slivers");
    EXPECT_EQ(row.at("method"), "barycentric");
    EXPECT_EQ(row.at("shapes"), 4);
    EXPECT_GT(row.at("samples"), 0);
}

TEST(StressCommand, TheSameSeedPrintsTheSame) {
    const std::string call = "stress --family tiny --count 9 --json --seed ";
    EXPECT_EQ(run_program(call + "5").out, run_program(call + "5").out);
    EXPECT_NE(run_program(call + "5").out, run_program(call + "6").out);
}

TEST(StressCommand, WrongUseIsNamed) {
    for (const char* wrong :
         {"--family no-such", "--method two-pass", "--count 0", "--seed x", "-o /no/such/folder/a.csv"}) {
        const Ran ran = run_program(std::string("stress --count 1 --method fast ") + wrong);
        EXPECT_EQ(ran.code, 2) << wrong;
        EXPECT_EQ(lines(ran.err), 1U) << ran.err;
    }
}

}  // namespace
}  // namespace texelscope::stress_test
