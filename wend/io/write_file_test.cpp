#include "wend/io/write_file.hpp"

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
