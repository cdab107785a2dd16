#include "app/cli/output.h"

#include <gtest/gtest.h>

#include "core/base/file.h"

namespace texelscope {
namespace {

namespace fs = std::filesystem;

class OutputTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  ("texelscope_output_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string file() const { return (folder_ / "out.csv").string(); }
    [[nodiscard]] std::string content() const {
        auto text = read_file(file(), 1 << 20);
        return text ? *text : "(" + text.error().text() + ")";
    }
    [[nodiscard]] long entries() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }
    void put(const std::string& text) { ASSERT_FALSE(write_file_atomically(file(), bytes_of(text))); }

    fs::path folder_;
};

TEST_F(OutputTest, OldContentStaysUntilTheNewIsWhole) {
    put("old");
    auto output = Output::open(file());
    ASSERT_TRUE(output);
    output->write("ne");
    EXPECT_EQ(content(), "old");
    output->write("w");
    EXPECT_FALSE(output->finish());
    EXPECT_EQ(content(), "new");
    EXPECT_EQ(entries(), 1);
}

TEST_F(OutputTest, GivenUpLeavesTheOldContentAndNothingElse) {
    put("old");
    {
        auto output = Output::open(file());
        ASSERT_TRUE(output);
        output->write("half");
    }
    EXPECT_EQ(content(), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(OutputTest, ALinkKeepsPointingToItsFile) {
    put("old");
    const fs::path link = folder_ / "link";
    fs::create_symlink(file(), link);
    auto output = Output::open(link.string());
    ASSERT_TRUE(output);
    output->write("new");
    EXPECT_FALSE(output->finish());
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(content(), "new");
}

TEST_F(OutputTest, WhatCannotBeWrittenIsAnErrorThatNamesIt) {
    for (const fs::path& bad : {folder_, folder_ / "no folder" / "out.csv"}) {
        auto output = Output::open(bad.string());
        ASSERT_FALSE(output);
        EXPECT_EQ(output.error().where, bad.string());
    }
}

TEST_F(OutputTest, AFullDeviceIsAnError) {
    auto output = Output::open("/dev/full");
    ASSERT_TRUE(output);
    for (int n = 0; n < 100 && !output->failed(); ++n) output->write(std::string(65536, 'x'));
    const auto error = output->finish();
    ASSERT_TRUE(error);
    EXPECT_EQ(error->where, "/dev/full");
}

}  // namespace
}  // namespace texelscope
