#include "core/base/file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

namespace texelscope {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed afterwards.
class WriteFileAtomically : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("texelscope-file-test-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }
    fs::path folder_;
};

TEST_F(WriteFileAtomically, ReadsBackWhatWasWritten) {
    const std::string bytes("a\0b\r\n\xff", 6);
    ASSERT_FALSE(write_file_atomically(folder_ / "f", bytes_of(bytes)));
    EXPECT_EQ(*read_file(folder_ / "f", 100), bytes);
    EXPECT_EQ(files(), 1);
}

TEST_F(WriteFileAtomically, ReplacesAndKeepsPermissions) {
    ASSERT_FALSE(write_file_atomically(folder_ / "f", bytes_of("old and longer")));
    fs::permissions(folder_ / "f", fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_FALSE(write_file_atomically(folder_ / "f", bytes_of("new")));
    EXPECT_EQ(*read_file(folder_ / "f", 100), "new");
    EXPECT_EQ(fs::status(folder_ / "f").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(files(), 1);
}

TEST_F(WriteFileAtomically, LeavesTheOldFileOnFailure) {
    const fs::path path = folder_ / std::string(252, 'f');  // no room in the name for the new file's ending
    std::ofstream(path) << "old";
    const auto error = write_file_atomically(path, bytes_of("new"));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->where, path.string());
    EXPECT_EQ(*read_file(path, 100), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(WriteFileAtomically, RefusesFoldersAndMissingFolders) {
    EXPECT_TRUE(write_file_atomically(folder_, bytes_of("x")));
    EXPECT_TRUE(write_file_atomically(folder_ / "none" / "f", bytes_of("x")));
    EXPECT_EQ(files(), 0);
}

TEST_F(WriteFileAtomically, LinkKeepsPointingToItsFile) {
    std::ofstream(folder_ / "f") << "old";
    fs::create_symlink("f", folder_ / "link");
    ASSERT_FALSE(write_file_atomically(folder_ / "link", bytes_of("new")));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(*read_file(folder_ / "f", 100), "new");
}

TEST_F(WriteFileAtomically, DeviceIsWrittenNotReplaced) {
    ASSERT_FALSE(write_file_atomically("/dev/null", bytes_of("x")));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(ReadFile, IsBounded) {
    EXPECT_FALSE(read_file("/dev/zero", 1000));
    const auto nothing = read_file("/dev/null", 0);
    ASSERT_TRUE(nothing);
    EXPECT_TRUE(nothing->empty());
}

TEST(ReadFile, ErrorNamesTheFile) {
    EXPECT_EQ(read_file("/no/such/file", 10).error().where, "/no/such/file");
    EXPECT_EQ(read_file("/", 10).error().text(), "/: is a folder, expected a file");
}

}  // namespace
}  // namespace texelscope
