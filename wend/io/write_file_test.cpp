#include "wend/io/write_file.hpp"

#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

TEST(WriteFile, WritesTheBytesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n", 4);
  ASSERT_TRUE(write_file(folder / "file", bytes));
  EXPECT_EQ(bytes_of(folder / "file"), bytes);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFile, ReplacesAFile) {
  const TemporaryFolder folder;
  folder.write("file", "a long old text");
  ASSERT_TRUE(write_file(folder / "file", "new"));
  EXPECT_EQ(bytes_of(folder / "file"), "new");
}

/// Runs in its own process, because it limits the size of files to `limit` bytes.
void write_with_a_limit(const fs::path& file, const std::string& bytes, rlim_t limit) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit most{limit, limit};
  setrlimit(RLIMIT_FSIZE, &most);
  const auto written = write_file(file, bytes);
  std::_Exit(written ? 1 : 0);
}

TEST(WriteFile, LeavesTheOldFileWhereTheNewOneDoesNotFit) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  EXPECT_EXIT(write_with_a_limit(folder / "file", std::string(1'000'000, 'x'), 100'000),
              testing::ExitedWithCode(0), "");
  EXPECT_EQ(bytes_of(folder / "file"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFile, ReplacesTheFileAndDoesNotWriteIntoIt) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  std::ifstream reader(folder / "file");  // still reads what it opened
  ASSERT_TRUE(write_file(folder / "file", "new text"));
  std::string read;
  reader >> read;
  EXPECT_EQ(read, "old");
}

TEST(WriteFile, SaysWhyAFileCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of(write_file(folder / "missing/file", "x")),
            (folder / "missing/file").string() + ": cannot be written: No such file or directory");
}

TEST(WriteFile, ReplacesTheTargetOfASymbolicLink) {
  const TemporaryFolder folder;
  folder.write("target", "old");
  fs::create_symlink(folder / "target", folder / "link");
  ASSERT_TRUE(write_file(folder / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(bytes_of(folder / "target"), "new");
}

TEST(WriteFile, WritesADeviceStraight) {
  ASSERT_TRUE(write_file("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteFile, RefusesAFolder) {
  const TemporaryFolder folder;
  EXPECT_FALSE(write_file(folder.path(), "x"));
  EXPECT_TRUE(fs::is_directory(folder.path()));
}

}  // namespace
}  // namespace wend
